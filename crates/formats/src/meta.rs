//! `.meta`: name, author and tags of a motion, line by line
//! (`docs/loaders/makehuman2/poses.md#meta-files`).

use super::fields::fields;
use mhlint_source::lines;

/// The file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Meta {
    /// The words behind `name`, in small letters and joined by `_`, and what the list shows of
    /// them: ASCII alone.
    pub name: Option<Name>,
    /// Tags, each a line.
    pub tags: Vec<String>,
    /// The first of the lines that begin with a known keyword written otherwise, and how many there
    /// are.
    pub misspelt: Option<Misspelt>,
}

/// A name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Name {
    /// As it is written.
    pub written: Box<str>,
    /// As it is listed.
    pub listed: Box<str>,
    /// Its line, from 1.
    pub line: u32,
}

/// Keywords that are not recognised.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Misspelt {
    /// The first as it is written.
    pub word: Box<str>,
    /// The keyword that is meant.
    pub meant: &'static str,
    /// Its line, from 1.
    pub line: u32,
    /// How many lines.
    pub count: usize,
}

const KEYWORDS: [&str; 3] = ["name", "tag", "author"];
/// More tags than anybody gives: the rest is passed over.
const MOST: usize = 1000;

/// Reads all lines.
pub fn read(text: &[u8]) -> Meta {
    let mut meta = Meta::default();
    for (number, (_, line)) in (1..).zip(lines(text)) {
        let words = fields(line);
        let Some(((_, first), rest)) = words.split_first() else {
            continue;
        };
        let rest = || rest.iter().map(|(_, word)| String::from_utf8_lossy(word));
        match *first {
            // Without a value the line is passed over.
            b"name" | b"tag" | b"author" if words.len() < 2 => {}
            b"name" => meta.name = Some(name(&rest().collect::<Vec<_>>().join("_"), number)),
            b"tag" if meta.tags.len() < MOST => {
                meta.tags.push(rest().collect::<Vec<_>>().join(" "));
            }
            word => {
                let Some(meant) = meant(word) else { continue };
                let word = String::from_utf8_lossy(word).into();
                meta.misspelt
                    .get_or_insert(Misspelt {
                        word,
                        meant,
                        line: number,
                        count: 0,
                    })
                    .count += 1;
            }
        }
    }
    meta
}

fn name(written: &str, line: u32) -> Name {
    let listed: String = written
        .to_lowercase()
        .chars()
        .filter(char::is_ascii)
        .collect();
    Name {
        written: written.into(),
        listed: listed.into(),
        line,
    }
}

/// The keyword that a word is but for its capitals, or a colon or equals sign with what is glued to
/// it.
fn meant(word: &[u8]) -> Option<&'static str> {
    let end = word
        .iter()
        .position(|byte| matches!(byte, b':' | b'='))
        .unwrap_or(word.len());
    let bare = word.get(..end).unwrap_or(word);
    let known = KEYWORDS
        .into_iter()
        .find(|known| bare.eq_ignore_ascii_case(known.as_bytes()));
    known
        .or_else(|| bare.eq_ignore_ascii_case(b"tags").then_some("tag"))
        .filter(|known| known.as_bytes() != word)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_name_is_listed_in_small_ascii_letters() {
        let meta = read("# note\r\nname Größe  Zwei\ntag a b\ntag c".as_bytes());
        let name = meta.name.unwrap();
        assert_eq!(
            (&*name.written, &*name.listed, name.line),
            ("Größe_Zwei", "gre_zwei", 2)
        );
        assert_eq!(meta.tags, ["a b", "c"]);
        assert_eq!(meta.misspelt, None);
    }

    #[test]
    fn keywords_with_colons_or_capitals_are_not_recognised() {
        let meta = read(b"name: Wave\nTags x\nauthor me\nnames x\n");
        assert_eq!(
            meta.misspelt,
            Some(Misspelt {
                word: "name:".into(),
                meant: "name",
                line: 1,
                count: 2
            })
        );
        assert!(meta.name.is_none() && meta.tags.is_empty());
    }

    proptest! {
        #[test]
        fn no_bytes_stop_the_reader(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let meta = read(&[b"name ".as_slice(), &bytes].concat());
            prop_assert!(meta.name.is_none_or(|name| name.listed.is_ascii()));
        }
    }
}
