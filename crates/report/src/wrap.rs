//! Plain text broken into lines of a given width. Words are never cut: a path stays one piece.

/// Breaks `text` at white space; the first line starts with `first`, the others with as many
/// blanks.
pub fn hang(first: &str, text: &str, width: usize) -> String {
    let indent = first.chars().count();
    let mut lines = String::from(first);
    let mut column = indent;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if column > indent && column + 1 + length > width {
            lines.push('\n');
            lines.push_str(&" ".repeat(indent));
            column = indent;
        } else if column > indent {
            lines.push(' ');
            column += 1;
        }
        lines.push_str(word);
        column += length;
    }
    lines
}

/// Paragraphs, separated by empty lines, each broken and indented.
pub fn paragraphs(text: &str, indent: &str, width: usize) -> String {
    let parts: Vec<String> = text
        .split("\n\n")
        .map(|part| hang(indent, part, width))
        .collect();
    parts.join("\n\n")
}

/// `1 error`, `2 errors`.
pub fn count(number: usize, noun: &str) -> String {
    if number == 1 {
        format!("1 {noun}")
    } else {
        format!("{number} {noun}s")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_hang_below_the_first_word() {
        assert_eq!(
            hang("  help: ", "one two three", 16),
            "  help: one two\n        three"
        );
    }

    #[test]
    fn a_long_word_stays_whole() {
        assert_eq!(
            hang("", "a data/target/figure/macro.json b", 10),
            "a\ndata/target/figure/macro.json\nb"
        );
    }

    #[test]
    fn one_is_singular() {
        assert_eq!(
            (count(1, "error"), count(0, "error")),
            ("1 error".to_owned(), "0 errors".to_owned())
        );
    }
}
