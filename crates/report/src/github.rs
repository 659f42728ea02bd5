//! Workflow commands of GitHub Actions: each becomes an annotation at its line in a pull request.
//!
//! GitHub shows a bounded number for each step and drops the rest without a word; this writer keeps
//! to the bound, gravest first, and says what it left out.

use std::io::{self, Write};

use super::matrix::Matrix;
use super::standing::{Standing, folder};
use super::{View, count, phrase, printable, unchecked_line, verdict};
use mhlint_diag::{Finding, Level, Outcome};

/// Annotations of one level that GitHub shows for one step.
const SHOWN: usize = 10;

/// Writes the annotations, then a line on those left out, then the verdict.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut left = Vec::new();
    for level in [Level::Error, Level::Warning, Level::Info] {
        let of_level: Vec<&Finding> = outcome
            .findings
            .iter()
            .filter(|finding| finding.level == level)
            .collect();
        for finding in of_level.iter().take(SHOWN) {
            writeln!(out, "{}", command(finding))?;
        }
        if of_level.len() > SHOWN {
            left.push(count(of_level.len() - SHOWN, level.word()));
        }
    }
    if !left.is_empty() {
        let left = left.join(", ");
        writeln!(
            out,
            "{left} more: GitHub shows {SHOWN} of each level; the other reports list all"
        )?;
    }
    if view.quiet {
        return Ok(());
    }
    writeln!(
        out,
        "{} in {}",
        verdict::tally(outcome),
        verdict::files(&outcome.summary)
    )?;
    writeln!(out, "{}", verdict::words(outcome, view))?;
    for line in Matrix::of(outcome).iter().flat_map(Matrix::lines) {
        writeln!(out, "{line}")?;
    }
    match unchecked_line(outcome) {
        Some(line) => writeln!(out, "::notice title=mhlint::{}", data(&printable(&line))),
        None => Ok(()),
    }
}

fn command(finding: &Finding) -> String {
    let word = match finding.level {
        Level::Error => "error",
        Level::Warning => "warning",
        Level::Info => "notice",
    };
    let Standing { file, location } = Standing::of(finding);
    let file = file
        .map(|file| format!("file={},", property(&phrase::path(file, location))))
        .unwrap_or_default();
    let numbers = [("line", location.line), ("col", location.column)];
    let place: Vec<String> = numbers
        .into_iter()
        .filter_map(|(name, number)| Some(format!("{name}={},", number?)))
        .collect();
    format!(
        "::{word} {file}{}title={}::{}",
        place.concat(),
        property(&format!("mhlint: {}", finding.rule)),
        data(&format!("{}{}", folder(finding), phrase::plain(finding)))
    )
}

/// The message of a command: the runner decodes exactly these.
fn data(text: &str) -> String {
    text.replace('%', "%25")
        .replace('\r', "%0D")
        .replace('\n', "%0A")
}

/// A property of a command ends at a comma or colon as well.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Place, RuleInfo};

    #[test]
    fn nothing_in_a_name_ends_the_command() {
        let rule = RuleInfo::new("a-rule", Level::Info, "");
        let mut finding = Finding::new(&rule, "a,b:c%\nd", Place::File, "50% of\n::error::x");
        (finding.location.line, finding.location.column) = (Some(3), Some(4));
        assert_eq!(
            command(&finding),
            "::notice file=a%2Cb%3Ac%25 d,line=3,col=4,title=mhlint%3A a-rule::50%25 of \
                \u{fffd}::error::x"
        );
    }
}
