//! Ignores in comments of text formats: `# mhlint: ignore RULE reason`.

use mhlint_source::lines;

/// Ignores of one file that are kept; a file with more has another problem.
const MOST: usize = 64;

/// An ignore of the file that it stands in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InlineIgnore {
    /// Line of the comment, counted from 1.
    pub line: u32,
    /// The rule, or a glob of rules; empty where the comment is not written as an ignore has to be.
    pub rule: String,
    /// Why; empty where nothing is said. The whole comment where no rule is named.
    pub reason: String,
}

/// Notes the ignore in a comment, `#` included, if it is one.
pub fn note(line: u32, comment: &[u8], ignores: &mut Vec<InlineIgnore>) {
    if ignores.len() < MOST {
        ignores.extend(
            comment
                .trim_ascii()
                .strip_prefix(b"#")
                .and_then(|text| parse(line, text)),
        );
    }
}

/// The ignores in a text whose comments are lines that begin with one of `marks`.
pub fn of_lines(text: &[u8], marks: &[&str]) -> Vec<InlineIgnore> {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let comments = (1..).zip(lines(text)).filter_map(|(number, (_, line))| {
        let comment = marks
            .iter()
            .find_map(|mark| line.trim_ascii().strip_prefix(mark.as_bytes()))?;
        parse(number, comment)
    });
    comments.take(MOST).collect()
}

/// What speaks to mhlint and is no ignore is kept as well, so that somebody can say so.
fn parse(line: u32, comment: &[u8]) -> Option<InlineIgnore> {
    let text = comment.trim_ascii().strip_prefix(b"mhlint")?;
    let text = String::from_utf8_lossy(text);
    let mut words = text
        .strip_prefix(':')
        .unwrap_or_default()
        .split_whitespace();
    if let (Some("ignore"), Some(rule)) = (words.next(), words.next()) {
        let reason = words.collect::<Vec<_>>().join(" ");
        return Some(InlineIgnore {
            line,
            rule: rule.to_owned(),
            reason,
        });
    }
    let speaks_to_us = text.starts_with(':')
        || text
            .trim_start_matches([' ', '\t', '-'])
            .starts_with("ignore");
    let words = String::from_utf8_lossy(comment)
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    speaks_to_us.then(|| InlineIgnore {
        line,
        rule: String::new(),
        reason: words,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rule_and_reason(comment: &str) -> Option<(String, String)> {
        let mut found = Vec::new();
        note(1, comment.as_bytes(), &mut found);
        found.pop().map(|found| (found.rule, found.reason))
    }

    #[test]
    fn an_ignore_has_a_rule_and_a_reason() {
        let pair = |rule: &str, reason: &str| Some((rule.to_owned(), reason.to_owned()));
        assert_eq!(
            rule_and_reason("# mhlint: ignore target-zero-delta  as   painted\r"),
            pair("target-zero-delta", "as painted")
        );
        assert_eq!(rule_and_reason("#mhlint:ignore a-*"), pair("a-*", ""));
        assert_eq!(rule_and_reason("# basemesh hm08"), None);
        assert_eq!(rule_and_reason("# about mhlint: ignore a b"), None);
    }

    #[test]
    fn what_speaks_to_us_and_is_no_ignore_is_kept_without_a_rule() {
        let malformed = |said: &str| Some((String::new(), said.to_owned()));
        assert_eq!(
            rule_and_reason("# mhlint: ignore"),
            malformed("mhlint: ignore")
        );
        assert_eq!(
            rule_and_reason("# mhlint: disable  a-b"),
            malformed("mhlint: disable a-b")
        );
        assert_eq!(
            rule_and_reason("# mhlint ignore a-b why"),
            malformed("mhlint ignore a-b why")
        );
        assert_eq!(
            rule_and_reason("# mhlint-ignore a-b"),
            malformed("mhlint-ignore a-b")
        );
        assert_eq!(rule_and_reason("# mhlint finds nothing here"), None);
    }

    #[test]
    fn each_format_has_its_marks_and_lines_end_as_python_ends_them() {
        let lines = |text: &str, marks: &[&str]| {
            let found = of_lines(text.as_bytes(), marks);
            found
                .into_iter()
                .map(|found| (found.line, found.rule))
                .collect::<Vec<_>>()
        };
        let text =
            "\u{feff}# mhlint: ignore a x\nname n # mhlint: ignore b x\n // mhlint: ignore c x\n";
        assert_eq!(lines(text, &["#"]), [(1, "a".to_owned())]);
        assert_eq!(
            lines(text, &["#", "//"]),
            [(1, "a".to_owned()), (3, "c".to_owned())]
        );
        assert_eq!(
            lines(&text.replace('\n', "\r\n"), &["#"]),
            [(1, "a".to_owned())]
        );
        assert_eq!(
            lines("x\r# mhlint: ignore a x\r", &["#"]),
            [(2, "a".to_owned())]
        );
        assert!(lines(text, &[]).is_empty());
    }
}
