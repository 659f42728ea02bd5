//! Markdown, for the summary of a workflow step, a comment on a pull request, or a page in a wiki.

use std::io::{self, Write};

use super::files::{by_file, for_page};
use super::matrix::Matrix;
use super::phrase::{self, Piece, pieces};
use super::snippet::{Snippet, snippet};
use super::unchecked::unchecked;
use super::{View, count, printable, taken, verdict};
use mhlint_diag::{Finding, Level, Outcome};

/// Columns of quoted source lines.
const WIDTH: usize = 100;

/// Room kept for the words on what was left out.
const RESERVE: usize = 400;

/// The last line of a report with findings.
const EXPLAIN: &str = "\n`mhlint explain RULE` explains a rule.\n";

/// Writes the report.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    out.write_all(summary(outcome, view, usize::MAX).as_bytes())
}

/// The Markdown report in at most `room` bytes. Where not all of it fits, the gravest findings are
/// kept and the number of the others is said. Empty if there is no room for anything.
pub fn summary(outcome: &Outcome, view: &View<'_>, room: usize) -> String {
    let mut text = head(outcome, view);
    let explain = if outcome.findings.is_empty() {
        ""
    } else {
        EXPLAIN
    };
    let tail = notes(outcome) + explain;
    let fixed = text.len() + tail.len() + RESERVE;
    if fixed > room {
        return if text.len() <= room {
            text
        } else {
            String::new()
        };
    }
    let (all, mut left) = for_page(&outcome.findings);
    let body = Body::of(&all);
    if body.length() <= room - fixed {
        text.push_str(&body.text());
    } else {
        let mut gravest = all;
        gravest.sort_by_key(|finding| std::cmp::Reverse(finding.level));
        let kept = fitting(&blocks(&gravest), room - fixed);
        gravest.truncate(kept);
        text.push_str(&Body::of(&gravest).text());
        left = outcome.findings.len() - kept;
    }
    if left > 0 {
        text.push_str(&left_out(left));
    }
    text.push_str(&tail);
    text
}

/// The findings: errors and warnings, and infos to be unfolded.
struct Body {
    loud: Vec<String>,
    infos: Vec<String>,
    count: usize,
}

impl Body {
    fn of(findings: &[&Finding]) -> Self {
        let (infos, loud): (Vec<&Finding>, Vec<&Finding>) = findings
            .iter()
            .copied()
            .partition(|finding| finding.level == Level::Info);
        let ordered = |findings: &[&Finding]| blocks(&by_file(findings).concat());
        Self {
            loud: ordered(&loud),
            infos: ordered(&infos),
            count: infos.len(),
        }
    }

    fn length(&self) -> usize {
        self.loud.iter().chain(&self.infos).map(String::len).sum()
    }

    fn text(&self) -> String {
        let loud = self.loud.concat();
        if self.infos.is_empty() {
            return loud;
        }
        let title = count(self.count, "info");
        format!(
            "{loud}\n<details><summary>{title}</summary>\n{}\n</details>\n",
            self.infos.concat()
        )
    }
}

fn left_out(number: usize) -> String {
    format!(
        "\n**{number} more findings** do not fit here; the gravest are shown, the other reports \
            list all.\n"
    )
}

/// How many blocks fit, from the first on.
fn fitting(blocks: &[String], room: usize) -> usize {
    let mut used = 0;
    let fits = |block: &&String| {
        used += block.len();
        used <= room
    };
    blocks.iter().take_while(fits).count()
}

fn head(outcome: &Outcome, view: &View<'_>) -> String {
    let summary = &outcome.summary;
    let hidden = verdict::hidden(outcome);
    let [mut title, mut rule, mut numbers] = [String::new(), String::new(), String::new()];
    for (number, what) in hidden {
        title = format!("{title} {what} |");
        rule += "---:|";
        numbers = format!("{numbers} {number} |");
    }
    let table = format!(
        "## mhlint: {}\n\n{}\n\n| errors | warnings | infos |{title} files \
         |\n|---:|---:|---:|{rule}---:|\n| {} | {} | {} |{numbers} {} |\n",
        if view.pass { "passed" } else { "failed" },
        inline(&verdict::words(outcome, view)),
        summary.error,
        summary.warning,
        summary.info,
        verdict::files(summary),
    );
    let roots: Vec<String> = verdict::roots(outcome)
        .iter()
        .map(|root| inline(&printable(root)))
        .collect();
    let checked = if roots.is_empty() {
        String::new()
    } else {
        format!("\nChecked: {}\n", roots.join(", "))
    };
    let taken: Vec<String> = taken::lines(outcome, false)
        .iter()
        .map(|line| inline(&printable(line)))
        .collect();
    let taken = if taken.is_empty() {
        String::new()
    } else {
        format!("\n{}\n", taken.join("\n\n"))
    };
    table + &checked + &taken + &matrix(outcome)
}

/// Who loads what, where several applications do.
fn matrix(outcome: &Outcome) -> String {
    let Some(matrix) = Matrix::of(outcome) else {
        return String::new();
    };
    let titles: Vec<&str> = matrix
        .applications
        .iter()
        .map(|application| application.title())
        .collect();
    let row =
        |(title, cells): &(&str, Vec<String>)| format!("| {title} | {} |\n", cells.join(" | "));
    let rows: Vec<String> = matrix.rows.iter().map(row).collect();
    format!(
        "\n| loaded by | {} |\n|---|{}\n{}",
        titles.join(" | "),
        "---|".repeat(titles.len()),
        rows.concat()
    )
}

fn notes(outcome: &Outcome) -> String {
    let list = |title: &str, lines: &mut dyn Iterator<Item = String>| {
        let lines = lines
            .map(|line| format!("- {}\n", inline(&printable(&line))))
            .collect::<Vec<_>>()
            .concat();
        if lines.is_empty() {
            String::new()
        } else {
            format!("\n### {title}\n\n{lines}")
        }
    };
    let notes = list("Notes", &mut outcome.notes.iter().map(super::note));
    notes + &list("Not checked", &mut unchecked(outcome))
}

/// A block for each finding, with the heading of its file where that changes.
fn blocks(findings: &[&Finding]) -> Vec<String> {
    let mut path: Option<&str> = None;
    let mut blocks = Vec::with_capacity(findings.len());
    for finding in findings {
        let is_new = path.replace(&finding.path) != Some(finding.path.as_str());
        let heading = if is_new {
            format!("\n### {}\n\n", code(&phrase::path_of(finding)))
        } else {
            String::new()
        };
        blocks.push(heading + &item(finding));
    }
    blocks
}

fn item(finding: &Finding) -> String {
    let place = phrase::bare_place(&finding.location).map_or_else(String::new, |place| {
        let place = inline(&printable(&place));
        format!(" at {place}")
    });
    let message = format!(
        "- **{}** {}{}  \n  {}{place}\n",
        finding.level,
        inline(&printable(&phrase::message(finding))),
        phrase::doubt(finding.confidence),
        code(finding.rule)
    );
    let lines = phrase::lines(finding).into_iter();
    let lines = lines.map(|line| format!("  - {}: {}\n", line.label, inline(&line.text)));
    [message, quoted(finding)]
        .into_iter()
        .chain(lines)
        .collect::<Vec<_>>()
        .concat()
}

/// The source lines as a block of code, its fence longer than any in them. Infos are folded and do
/// without.
fn quoted(finding: &Finding) -> String {
    let excerpt = finding
        .location
        .excerpt
        .as_ref()
        .filter(|_| finding.level > Level::Info);
    let Some(found) = excerpt.and_then(|excerpt| snippet(excerpt, WIDTH)) else {
        return String::new();
    };
    let fence = "`".repeat(longest_run(&found.text).max(2) + 1);
    let (marked, mark) = mark(&found);
    let numbered = |(at, line): (usize, &str)| {
        let below = if at == marked {
            format!("  {:>5} | {mark}\n", "")
        } else {
            String::new()
        };
        format!("  {:>5} | {line}\n{below}", found.first_line + at)
    };
    let lines: Vec<String> = found.text.split('\n').enumerate().map(numbered).collect();
    format!("\n  {fence}text\n{}  {fence}\n\n", lines.concat())
}

/// The line of the mark, from 0, and what stands below it.
fn mark(found: &Snippet) -> (usize, String) {
    let before = found.text.get(..found.mark.start).unwrap_or_default();
    let lead = before.rsplit('\n').next().unwrap_or_default();
    let marked = found.text.get(found.mark.clone()).unwrap_or_default();
    let length = |text: &str| text.chars().count();
    (
        before.matches('\n').count(),
        format!(
            "{}{}",
            " ".repeat(length(lead)),
            "^".repeat(length(marked).max(1))
        ),
    )
}

fn longest_run(text: &str) -> usize {
    text.split(|character| character != '`')
        .map(str::len)
        .max()
        .unwrap_or(0)
}

/// A name as code: nothing inside is read as Markdown.
fn code(name: &str) -> String {
    let fence = "`".repeat(longest_run(name) + 1);
    let pad = if name.contains('`') || name.trim().len() < name.len() || name.is_empty() {
        " "
    } else {
        ""
    };
    format!("{fence}{pad}{name}{pad}{fence}")
}

/// Words with names in back quotes.
fn inline(text: &str) -> String {
    let mut shown = String::new();
    for piece in pieces(text) {
        match piece {
            Piece::Words(words) => shown.push_str(&escape(words)),
            Piece::Name(name) => {
                // Two runs of back quotes side by side would be read as one.
                let gap = if shown.ends_with('`') { " " } else { "" };
                shown.push_str(gap);
                shown.push_str(&code(name));
            }
        }
    }
    shown
}

/// Words in which nothing is read as Markdown, HTML, a link or the name of a user.
fn escape(words: &str) -> String {
    let mut escaped = String::with_capacity(words.len());
    for (at, character) in words.char_indices() {
        let before = words.get(..at).unwrap_or_default();
        let links = (character == ':' && words[at..].starts_with("://"))
            || (character == '.' && before.ends_with("www"));
        if links || "\\`*_[]<>&|~#!$".contains(character) {
            escaped.push('\\');
        }
        escaped.push(character);
        if character == '@' {
            escaped.push('\u{200b}');
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Place, RuleInfo};

    #[test]
    fn words_stay_words() {
        assert_eq!(
            inline("a `b*` <i> [x](y) _z_"),
            "a `b*` \\<i\\> \\[x\\](y) \\_z\\_"
        );
        assert_eq!(
            inline("see http://x and www.y for @me"),
            "see http\\://x and www\\.y for @\u{200b}me"
        );
        assert_eq!(inline("`a``b`"), "`a` `b`");
    }

    #[test]
    fn code_keeps_its_back_quotes_inside() {
        assert_eq!(code("plain"), "`plain`");
        assert_eq!(code("a``b`"), "``` a``b` ```");
    }

    #[test]
    fn the_mark_stands_below_its_text() {
        let marked = |text: &str, range: std::ops::Range<usize>| {
            mark(&Snippet {
                text: text.to_owned(),
                first_line: 1,
                mark: range,
            })
        };
        assert_eq!(marked("a\n\u{e4}bc\nd", 4..6), (1, " ^^".to_owned()));
        assert_eq!(
            marked("ab", 2..2),
            (0, "  ^".to_owned()),
            "the end of a line"
        );
    }

    fn outcome(count: usize) -> Outcome {
        let finding = |number| {
            let level = if number % 10 == 0 {
                Level::Error
            } else {
                Level::Info
            };
            Finding::new(
                &RuleInfo::new("a-rule", level, ""),
                format!("f{number}"),
                Place::File,
                "it is so",
            )
        };
        let mut outcome = Outcome {
            findings: (0..count).map(finding).collect(),
            ..Outcome::default()
        };
        outcome.summary.info = count;
        outcome
    }

    #[test]
    fn a_bounded_summary_keeps_the_gravest_and_counts_the_rest() {
        let all = summary(&outcome(100), &View::PLAIN, usize::MAX);
        assert_eq!(all.matches("**info**").count(), 90);
        let room = all.len() / 2;
        let some = summary(&outcome(100), &View::PLAIN, room);
        assert!(
            some.len() <= room && some.len() > room / 2,
            "{} of {room}",
            some.len()
        );
        assert_eq!(some.matches("**error**").count(), 10);
        let left = 90 - some.matches("**info**").count();
        assert!(
            some.contains(&format!("**{left} more findings**")),
            "{some}"
        );
        assert_eq!(summary(&outcome(100), &View::PLAIN, 10), "");
    }
}
