//! What is wrong with a configuration file, with the lines that it stands in.

use std::fmt;
use std::ops::Range;

use mhlint_source::Lines;

/// Why a configuration cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    /// The file.
    pub path: String,
    /// All that is wrong with it, in order of the file.
    pub faults: Vec<Fault>,
}

/// One thing that is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// What.
    pub message: String,
    /// What to do.
    pub help: String,
    /// Line and column, counted from 1, where there is a text.
    pub place: Option<(u32, u32)>,
    /// The line with the place marked below it.
    pub quoted: String,
}

impl Error {
    /// A file that cannot be read at all.
    pub(super) fn unreadable(path: &str, reason: &str) -> Self {
        let fault = Fault {
            message: format!("cannot be read: {reason}"),
            help: "use an existing file with `--config`, or create one with `mhlint init`"
                .to_owned(),
            place: None,
            quoted: String::new(),
        };
        Self {
            path: path.to_owned(),
            faults: vec![fault],
        }
    }
}

impl Fault {
    pub(super) fn new(
        lines: &Lines<'_>,
        span: Range<usize>,
        message: String,
        help: String,
    ) -> Self {
        let at = lines.position(span.start);
        let quoted = quote(lines, span).unwrap_or_default();
        // A name in quotes may hold line breaks, and what stands behind one must not look like a
        // line of its own.
        let [message, help] = [message, help].map(|text| text.replace(['\n', '\r'], " "));
        Self {
            message,
            help,
            place: Some((at.line, at.column)),
            quoted,
        }
    }
}

fn quote(lines: &Lines<'_>, span: Range<usize>) -> Option<String> {
    let found = lines.excerpt(span.clone())?;
    let before = found.text.get(..found.mark.start)?;
    let start = before.rfind('\n').map_or(0, |at| at + 1);
    let line = found.text.get(start..)?.lines().next()?.replace('\t', " ");
    let indent = found.text.get(start..found.mark.start)?.chars().count();
    let marked = found
        .text
        .get(found.mark)?
        .chars()
        .take_while(|c| *c != '\n')
        .count()
        .max(1);
    let number = lines.position(span.start).line.to_string();
    let margin = " ".repeat(number.len());
    Some(format!(
        "  {number} | {line}\n  {margin} | {}{}",
        " ".repeat(indent),
        "^".repeat(marked)
    ))
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, fault) in self.faults.iter().enumerate() {
            if number > 0 {
                f.write_str("\n")?;
            }
            f.write_str(&self.path)?;
            if let Some((line, column)) = fault.place {
                write!(f, ":{line}:{column}")?;
            }
            write!(f, ": {}", fault.message)?;
            if !fault.quoted.is_empty() {
                write!(f, "\n{}", fault.quoted)?;
            }
            write!(f, "\n  help: {}", fault.help)?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use crate::Config;
    use mhlint_source::PASSED;

    #[test]
    fn the_lines_of_a_file_are_found_once_however_many_faults_it_has() {
        let text = "[[ignore]]\n".repeat(10_000);
        let before = PASSED.get();
        let faults = Config::parse(&text, "mhlint.toml", &[]).unwrap_err().faults;
        assert!(faults.len() >= 10_000);
        assert!(
            faults
                .iter()
                .any(|fault| fault.place.is_some_and(|(line, _)| line == 10_000))
        );
        // The text twice, and a few thousand bytes for each fault.
        let passed = PASSED.get() - before;
        assert!(
            passed < 2 * text.len() + faults.len() * 5 * 4100,
            "{passed} bytes for {} faults",
            faults.len()
        );
    }
}
