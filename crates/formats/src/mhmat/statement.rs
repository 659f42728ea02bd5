//! The lines of a material as one reads them that takes a word of letters and all that is behind it
//! (`docs/loaders/mpfb/materials.md#lines-of-a-material`).

use std::ops::Range;

use super::{MOST_LINES, Word};
use mhlint_source::lines;

/// A line of a word of letters and a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// The word, in the capitals that it has.
    pub key: Word,
    /// All that is behind it, without white space around it.
    pub value: Word,
    /// Its number, from 1.
    pub number: u32,
    /// Whether white space stands in front of it.
    pub is_indented: bool,
    /// Whether it is the last line and has no line end.
    pub ends_file: bool,
}

/// All lines of that form that are no comments, up to a bound.
pub(super) fn statements(text: &[u8]) -> Vec<Statement> {
    let all = (1..).zip(lines(text));
    let statements = all.filter_map(|(number, (Range { start, .. }, line))| {
        let ends_file = start + line.len() >= text.len();
        let own = statement(start, line)?;
        Some(Statement {
            number,
            ends_file,
            ..own
        })
    });
    statements.take(MOST_LINES).collect()
}

fn statement(start: usize, line: &[u8]) -> Option<Statement> {
    let indent = line.len() - line.trim_ascii_start().len();
    let rest = line.get(indent..)?;
    if rest.starts_with(b"#") || rest.starts_with(b"/") {
        return None;
    }
    let length = rest
        .iter()
        .take_while(|byte| byte.is_ascii_alphabetic())
        .count();
    let (key, behind) = rest.split_at_checked(length)?;
    // A digit or a dash in it makes it no word of letters.
    if key.is_empty() || !behind.first().is_none_or(u8::is_ascii_whitespace) {
        return None;
    }
    let value = behind.trim_ascii();
    let at = start + indent + length + (behind.len() - behind.trim_ascii_start().len());
    Some(Statement {
        key: word(start + indent, key),
        value: word(
            if value.is_empty() {
                start + indent + length
            } else {
                at
            },
            value,
        ),
        number: 0,
        is_indented: indent > 0,
        ends_file: false,
    })
}

fn word(at: usize, bytes: &[u8]) -> Word {
    Word {
        text: String::from_utf8_lossy(bytes).into(),
        span: at..at + bytes.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_a_word_and_the_rest() {
        let text = "# a\n/b c\nname my shirt \r\n diffuseTexture a b.png # c\nshader_config \
            x\nopacity\nsss1 2\nshadeless";
        let all: Vec<_> = statements(text.as_bytes())
            .into_iter()
            .map(|one| {
                (
                    one.number,
                    one.key.text.to_string(),
                    one.value.text.to_string(),
                    one.is_indented,
                    one.ends_file,
                )
            })
            .collect();
        let own = |number, key: &str, value: &str, indented, last| {
            (number, key.to_owned(), value.to_owned(), indented, last)
        };
        assert_eq!(
            all,
            [
                own(3, "name", "my shirt", false, false),
                own(4, "diffuseTexture", "a b.png # c", true, false),
                own(6, "opacity", "", false, false),
                own(8, "shadeless", "", false, true),
            ]
        );
        for one in statements(text.as_bytes()) {
            assert_eq!(text.get(one.value.span.clone()), Some(&*one.value.text));
        }
    }
}
