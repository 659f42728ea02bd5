//! Mutes in comments of text formats: `# mhlint: ignore RULE reason`.

/// Mutes of one file that are kept; a file with more has another problem.
const MOST: usize = 64;

/// A mute of the file that it stands in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InlineIgnore {
    /// Line of the comment, counted from 1.
    pub line: u32,
    /// The rule, or a glob of rules.
    pub rule: String,
    /// Why; empty where nothing is said.
    pub reason: String,
}

/// Notes the mute in a comment, `#` included, if it is one.
pub fn note(line: u32, comment: &[u8], ignores: &mut Vec<InlineIgnore>) {
    if ignores.len() < MOST {
        ignores.extend(parse(line, comment));
    }
}

fn parse(line: u32, comment: &[u8]) -> Option<InlineIgnore> {
    let text = comment.trim_ascii().strip_prefix(b"#")?.trim_ascii().strip_prefix(b"mhlint:")?;
    let text = String::from_utf8_lossy(text);
    let mut words = text.split_whitespace();
    if words.next() != Some("ignore") {
        return None;
    }
    let rule = words.next()?.to_owned();
    Some(InlineIgnore { line, rule, reason: words.collect::<Vec<_>>().join(" ") })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rule_and_reason(comment: &str) -> Option<(String, String)> {
        parse(1, comment.as_bytes()).map(|found| (found.rule, found.reason))
    }

    #[test]
    fn a_mute_has_a_rule_and_a_reason() {
        let pair = |rule: &str, reason: &str| Some((rule.to_owned(), reason.to_owned()));
        assert_eq!(
            rule_and_reason("# mhlint: ignore target-zero-delta  as   painted\r"),
            pair("target-zero-delta", "as painted")
        );
        assert_eq!(rule_and_reason("#mhlint:ignore a-*"), pair("a-*", ""));
        assert_eq!(rule_and_reason("# mhlint: ignore"), None);
        assert_eq!(rule_and_reason("# basemesh hm08"), None);
        assert_eq!(rule_and_reason("# about mhlint: ignore a b"), None);
    }
}
