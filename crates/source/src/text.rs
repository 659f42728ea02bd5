//! What a text file is before any format looks at it: encoding, byte order mark, stand-ins.

use super::lines::lines;

/// First bytes of the stand-in that Git LFS leaves when the content was not fetched.
const LFS_POINTER: &[u8] = b"version https://git-lfs.github.com/spec/";
pub const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Facts on the bytes of a file.
#[expect(
    clippy::struct_excessive_bools,
    reason = "independent facts on one text, not states of something"
)]
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Encoding {
    /// Starts with a UTF-8 byte order mark.
    pub byte_order_mark: bool,
    /// Offset of the first byte that is not UTF-8.
    pub invalid_utf8_at: Option<usize>,
    /// The content is a Git LFS pointer.
    pub lfs_pointer: bool,
    /// Nothing but white space, byte order mark aside.
    pub blank: bool,
    /// Nothing but lines that begin with `#`, at least one of them, byte order mark aside.
    pub only_comments: bool,
    /// Nothing but lines that begin with `#` have bytes that are not UTF-8.
    pub only_comments_invalid: bool,
    /// What the bytes probably are, where they are no UTF-8.
    pub guess: Option<Guess>,
    /// Words of the first line behind a byte order mark; what is read wrongly because of it.
    pub marked_words: Vec<String>,
    /// Offset of the first of the lines that git leaves around both sides of a merge conflict.
    pub conflict_at: Option<usize>,
}

/// Words of a marked line that are kept.
const MARKED_WORDS: usize = 8;

impl Encoding {
    /// Looks at all bytes once.
    pub fn of(bytes: &[u8]) -> Self {
        let byte_order_mark = bytes.starts_with(BYTE_ORDER_MARK);
        let invalid_utf8_at = std::str::from_utf8(bytes)
            .err()
            .map(|error| error.valid_up_to());
        let content = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        let blank = content.iter().all(u8::is_ascii_whitespace);
        let says_nothing = |line: &[u8]| line.is_empty() || line.starts_with(b"#");
        Self {
            byte_order_mark,
            invalid_utf8_at,
            lfs_pointer: bytes.starts_with(LFS_POINTER),
            blank,
            only_comments: !blank
                && lines(content).all(|(_, line)| says_nothing(line.trim_ascii())),
            only_comments_invalid: invalid_utf8_at.is_some()
                && lines(content).all(|(_, line)| is_comment_or_valid(line)),
            guess: invalid_utf8_at.map(|_| guess(bytes)),
            marked_words: if byte_order_mark {
                marked_words(content)
            } else {
                Vec::new()
            },
            conflict_at: conflict(bytes),
        }
    }

    /// Whether both sides of a merge are in it.
    pub fn is_unmerged(&self) -> bool {
        self.conflict_at.is_some()
    }
}

/// What bytes are that are no UTF-8.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Guess {
    /// Text in UTF-16.
    Utf16,
    /// Packed with gzip.
    Gzip,
    /// No text.
    Binary,
    /// Text in Latin-1 or a code page of Windows.
    SingleByte,
}

/// UTF-16 shows by its mark or by the zeros between Latin letters; the rest is some single-byte
/// code.
fn guess(bytes: &[u8]) -> Guess {
    let zeros: usize = bytes.iter().map(|byte| usize::from(*byte == 0)).sum();
    if bytes.starts_with(b"\x1f\x8b\x08") {
        Guess::Gzip
    } else if bytes.starts_with(b"\xff\xfe")
        || bytes.starts_with(b"\xfe\xff")
        || zeros > bytes.len() / 4
    {
        Guess::Utf16
    } else if zeros > 0 {
        Guess::Binary
    } else {
        Guess::SingleByte
    }
}

fn is_comment_or_valid(line: &[u8]) -> bool {
    line.trim_ascii_start().starts_with(b"#") || std::str::from_utf8(line).is_ok()
}

fn marked_words(content: &[u8]) -> Vec<String> {
    let first = lines(content)
        .map(|(_, line)| String::from_utf8_lossy(line))
        .next()
        .unwrap_or_default();
    first
        .split_whitespace()
        .take(MARKED_WORDS)
        .map(str::to_owned)
        .collect()
}

/// What git puts in front of the first side of a conflict, between both, and behind the second.
const MARKERS: [&[u8]; 3] = [b"<<<<<<< ", b"=======", b">>>>>>> "];

/// Where a conflict begins of which all three lines are there.
fn conflict(bytes: &[u8]) -> Option<usize> {
    // Few files have such a letter at all, and this is fast.
    if !bytes.contains(&b'<') {
        return None;
    }
    let mut lines = lines(bytes).map(|(_, line)| line);
    let places = MARKERS.map(|marker| lines.find(|line| line.starts_with(marker)));
    let [Some(first), Some(_), Some(_)] = places else {
        return None;
    };
    Some(first.as_ptr() as usize - bytes.as_ptr() as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn guesses_name_the_usual_culprits() {
        for (bytes, guess) in [
            (&b"J\xf6rg"[..], Some(Guess::SingleByte)),
            (b"\xff\xfea\0b\0", Some(Guess::Utf16)),
            (b"\x89PNG\0data data data", Some(Guess::Binary)),
            (b"\x1f\x8b\x08\0\0\xff", Some(Guess::Gzip)),
            ("Jörg".as_bytes(), None),
            (b"a\0", None),
        ] {
            assert_eq!(Encoding::of(bytes).guess, guess);
        }
    }

    #[test]
    fn comments_alone_are_not_blank_and_hold_nothing() {
        let seen = |text: &str| {
            (
                Encoding::of(text.as_bytes()).blank,
                Encoding::of(text.as_bytes()).only_comments,
            )
        };
        assert_eq!(seen(" \r\n"), (true, false));
        assert_eq!(seen("# a\r\n\n  # b"), (false, true));
        assert_eq!(seen("# a\n1 0 0 1"), (false, false));
        assert_eq!(
            (seen("\u{feff}"), seen("\u{feff}# a")),
            ((true, false), (false, true))
        );
    }

    #[test]
    fn a_conflict_has_three_markers() {
        assert_eq!(
            Encoding::of(b"a\n<<<<<<< HEAD\nb\n=======\nc\n>>>>>>> other\n").conflict_at,
            Some(2)
        );
        assert_eq!(Encoding::of(b"<<<<<<< HEAD\n=======\n").conflict_at, None);
        assert_eq!(
            Encoding::of(b"# <<<<<<< a\n=======\n>>>>>>> b\n").conflict_at,
            None
        );
    }

    #[test]
    fn words_behind_the_mark_are_kept() {
        assert_eq!(
            Encoding::of("\u{feff}# a b\nc".as_bytes()).marked_words,
            ["#", "a", "b"]
        );
        assert_eq!(Encoding::of(b"# a").marked_words, Vec::<String>::new());
    }
}
