//! Names of members: how they are read, and which of them lead out of the pack.

use super::directory::Record;
use super::{LONGEST, MemberFault};

/// A name, read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Name {
    /// The path that whoever packed it meant: with `/` and the letters of UTF-8.
    pub(super) path: String,
    /// The path as Python reads it, where that has other letters.
    pub(super) read_as: Option<String>,
    pub(super) has_backslash: bool,
    pub(super) is_folder: bool,
}

/// The letters of bytes from 128 on in names that are not marked as UTF-8, whatever system has
/// written them.
const CODE_PAGE_437: &str = "\
    ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒ\
    áíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐\
    └┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀\
    αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u{a0}";

/// The name as Python reads it: for people, where nothing else can be made of it.
pub(super) fn shown(record: &Record) -> String {
    if record.is_utf8 {
        String::from_utf8_lossy(&record.name).into_owned()
    } else {
        in_code_page(&record.name)
    }
}

/// The path of a member.
pub(super) fn name(record: &Record) -> Result<Name, MemberFault> {
    let text = std::str::from_utf8(&record.name);
    let (meant, read) = match text {
        Ok(text) if record.is_utf8 || text.is_ascii() => (text.to_owned(), None),
        Ok(text) => (text.to_owned(), Some(in_code_page(&record.name))),
        Err(_) if record.is_utf8 => return Err(MemberFault::NameNotUtf8),
        Err(_) => (in_code_page(&record.name), None),
    };
    if meant.len() as u64 > LONGEST {
        return Err(MemberFault::Damaged("its name is too long"));
    }
    if meant.contains('\0') {
        return Err(MemberFault::Damaged("its name has a null character in it"));
    }
    let has_backslash = meant.contains('\\');
    let slashed = meant.replace('\\', "/");
    if leads_out(&slashed) {
        return Err(MemberFault::Escapes);
    }
    let is_folder = slashed.ends_with('/');
    let path = plain(&slashed);
    if path.is_empty() && !is_folder {
        return Err(MemberFault::Damaged("it has no name"));
    }
    let read_as = read.map(|read| plain(&read.replace('\\', "/")));
    Ok(Name {
        path,
        read_as,
        has_backslash,
        is_folder,
    })
}

/// Whether a path begins at a root or a drive, or has `..` in it.
fn leads_out(slashed: &str) -> bool {
    slashed.starts_with('/')
        || slashed.get(1..2) == Some(":")
        || slashed.split('/').any(|part| part == "..")
}

fn plain(slashed: &str) -> String {
    slashed
        .split('/')
        .filter(|part| !part.is_empty() && *part != ".")
        .collect::<Vec<_>>()
        .join("/")
}

fn in_code_page(bytes: &[u8]) -> String {
    let letter = |byte: &u8| match byte.checked_sub(128) {
        None => char::from(*byte),
        Some(place) => CODE_PAGE_437
            .chars()
            .nth(usize::from(place))
            .unwrap_or(char::REPLACEMENT_CHARACTER),
    };
    bytes.iter().map(letter).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(bytes: &[u8], is_utf8: bool) -> Result<Name, MemberFault> {
        let record = Record {
            name: bytes.to_vec(),
            is_utf8,
            is_encrypted: false,
            is_link: false,
            method: 0,
            crc: 0,
            packed: 0,
            size: 0,
            at: 0,
        };
        name(&record)
    }

    #[test]
    fn every_byte_has_a_letter() {
        assert_eq!(CODE_PAGE_437.chars().count(), 128);
        assert_eq!(in_code_page(b"h\x81t\xff"), "h\u{fc}t\u{a0}");
    }

    #[test]
    fn names_are_what_was_meant_and_what_is_read() {
        let path =
            |bytes: &[u8], is_utf8| named(bytes, is_utf8).map(|name| (name.path, name.read_as));
        assert_eq!(
            path("a/h\u{fc}t".as_bytes(), true),
            Ok(("a/h\u{fc}t".to_owned(), None))
        );
        assert_eq!(
            path(b"a/h\x81t", false),
            Ok(("a/h\u{fc}t".to_owned(), None))
        );
        let read_as = Some("a/h\u{251c}\u{255d}t".to_owned());
        assert_eq!(
            path("a/h\u{fc}t".as_bytes(), false),
            Ok(("a/h\u{fc}t".to_owned(), read_as))
        );
        assert_eq!(path(b"a/h\x81t", true), Err(MemberFault::NameNotUtf8));
        assert_eq!(path(b"./a//b\\c/", true), Ok(("a/b/c".to_owned(), None)));
        assert!(named(b"a\\b", true).unwrap().has_backslash);
        for name in [
            &b"../a"[..],
            b"a/../../b",
            b"/a",
            b"C:\\a",
            b"c:a",
            b"..\\a",
        ] {
            assert_eq!(path(name, false), Err(MemberFault::Escapes), "{name:?}");
        }
        assert!(matches!(path(b"", false), Err(MemberFault::Damaged(_))));
        assert!(matches!(path(b"a\0b", false), Err(MemberFault::Damaged(_))));
    }
}
