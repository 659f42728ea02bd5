//! Findings in words that every format for people uses: places, evidence, and the whole as lines of
//! plain text.

use std::borrow::Cow;

use super::{count, printable};
use mhlint_diag::{
    Confidence, Evidence, Finding, Fix, FixKind, Grown, IgnoredFiles, Location, MeasureKind,
    NewParts, Related, Worst,
};

/// Related places that a text names; formats with room for more have their own bound.
pub(super) const RELATED: usize = 5;

/// One line below the message of a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Line {
    /// What it is: an application, `seen`, `see`, `help`.
    pub(super) label: String,
    /// The words, harmless for a terminal, in Markdown-like quotes where a name is meant.
    pub(super) text: String,
}

/// Everything below the message: consequence for each application, evidence, other places, help.
pub(super) fn lines(finding: &Finding) -> Vec<Line> {
    let line = |label: &str, text: &str| Line {
        label: label.to_owned(),
        text: printable(text),
    };
    let mut lines: Vec<Line> = finding
        .breaks
        .iter()
        .map(|one| line(one.application.title(), &one.effect))
        .collect();
    if let Some(evidence) = evidence_of(finding) {
        lines.push(line("seen", &evidence));
    }
    for related in finding.related.iter().take(RELATED) {
        lines.push(line("see", &note(finding, related)));
    }
    if finding.related.len() > RELATED {
        lines.push(line(
            "see",
            &count(finding.related.len() - RELATED, "more place"),
        ));
    }
    if let Some(help) = &finding.help {
        lines.push(line("help", help));
    }
    if let Some(fix) = &finding.fix {
        lines.push(line("fix", &fixed_by(fix)));
    }
    lines
}

/// Whether another place is no other: the words are about the file of the finding as a whole.
pub(super) fn is_note(finding: &Finding, related: &Related) -> bool {
    related.path == finding.path && colons(&related.location).is_empty()
}

/// Another place and what is there.
fn note(finding: &Finding, related: &Related) -> String {
    let place = || {
        format!(
            "{}{}",
            path(&related.path, &related.location),
            colons(&related.location)
        )
    };
    if is_note(finding, related) {
        related.message.clone()
    } else {
        format!("{}: {}", place(), related.message)
    }
}

/// The evidence in words, without a number and a worst case that the message names.
pub(super) fn evidence_of(finding: &Finding) -> Option<String> {
    let evidence = finding.evidence.as_ref()?;
    let number = counted(evidence);
    let things = if finding.counts.is_empty() {
        String::new()
    } else {
        format!(" {}", finding.counts)
    };
    let number = (!counts(&message(finding), &number)).then(|| number + &things);
    // Of one case the message says how bad it is.
    let worst = evidence.worst.as_ref().filter(|_| evidence.count > 1);
    let mut texts = finding
        .related
        .iter()
        .map(|one| &one.message)
        .chain([&finding.message]);
    evidence_line(
        evidence,
        number,
        worst.filter(|worst| !texts.any(|text| names(text, &worst.place))),
    )
}

/// `108 of 216`.
fn counted(evidence: &Evidence) -> String {
    let of = evidence
        .of
        .map_or_else(String::new, |of| format!(" of {of}"));
    format!("{}{of}", evidence.count)
}

/// Whether a text has a number that is not part of a larger one.
fn counts(text: &str, number: &str) -> bool {
    let is_part = |next: char| next.is_ascii_alphanumeric() || matches!(next, '.' | '-' | '_');
    let behind = |text: &str| {
        let text = text.strip_prefix('.').unwrap_or(text);
        text.starts_with(is_part)
    };
    let found = text.match_indices(number);
    let mut sides = found.map(|(at, _)| (text.get(..at), text.get(at + number.len()..)));
    sides.any(|(before, after)| {
        !before.is_some_and(|text| text.ends_with(is_part)) && !after.is_some_and(behind)
    })
}

/// Whether a text names a place: `vertex 17`, not only `vertex 170`.
fn names(text: &str, place: &str) -> bool {
    let ends = |behind: &str| !behind.starts_with(|next: char| next.is_ascii_digit());
    !place.is_empty()
        && text
            .match_indices(place)
            .any(|(at, _)| text.get(at + place.len()..).is_some_and(ends))
}

/// Which option fixes it, and how.
pub(super) fn fixed_by(fix: &Fix) -> String {
    let option = if fix.kind == FixKind::Safe {
        "`--fix`"
    } else {
        "`--fix --unsafe-fixes`"
    };
    format!("{} ({option})", fix.title)
}

/// What is wrong; how much of it is new, how much more of it there is, or how many of the files
/// that have it are ignored.
pub(super) fn message(finding: &Finding) -> Cow<'_, str> {
    let be = |count: u64| if count == 1 { "is" } else { "are" };
    let message = &finding.message;
    if let Some(grown) = &finding.grown {
        return Cow::Owned(format!("{message}; {}", worse(grown)));
    }
    match (&finding.new_parts, &finding.ignored) {
        (Some(NewParts { count, of }), _) if count < of => Cow::Owned(format!(
            "{message}; {count} of these {of} {} new",
            be(*count)
        )),
        (_, Some(IgnoredFiles { files, of })) => {
            let count = files.len();
            Cow::Owned(format!(
                "{message}; {count} of these {of} files {} ignored",
                be(count as u64)
            ))
        }
        _ => Cow::Borrowed(message),
    }
}

/// `12 now, 7 before`.
fn worse(grown: &Grown) -> String {
    let of = match grown.of {
        MeasureKind::Count => return format!("{} now, {} before", grown.to, grown.from),
        MeasureKind::Distance => "distance",
        MeasureKind::Gap => "gap",
        MeasureKind::Share => "share",
        MeasureKind::Factor => "factor",
        MeasureKind::Length => "length",
        MeasureKind::Weight => "weight",
        MeasureKind::Sine => "sine of the angle",
    };
    format!(
        "{of} {} now, {} before",
        figure(grown.to),
        figure(grown.from)
    )
}

/// With four digits that count, and seven behind the point at most.
fn figure(value: f64) -> String {
    const LEAST: [f64; 7] = [1000.0, 100.0, 10.0, 1.0, 0.1, 0.01, 0.001];
    let digits = LEAST
        .iter()
        .take_while(|least| value.abs() < **least)
        .count();
    format!("{value:.digits$}")
}

/// Message and lines as plain text, each on its own line.
pub(super) fn plain(finding: &Finding) -> String {
    let mut text = format!(
        "{}{}",
        printable(&message(finding)),
        doubt(finding.confidence)
    );
    for line in lines(finding) {
        text.push('\n');
        text.push_str(&line.label);
        text.push_str(": ");
        text.push_str(&line.text);
    }
    text
}

/// How sure the rule is, where it is not.
pub(super) const fn doubt(confidence: Confidence) -> &'static str {
    match confidence {
        Confidence::High => "",
        Confidence::Medium => " (likely)",
        Confidence::Low => " (a guess)",
    }
}

/// A piece of a text: outside or inside of the back quotes that mark names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Piece<'a> {
    /// Ordinary words.
    Words(&'a str),
    /// A name.
    Name(&'a str),
}

/// Takes a text apart at its back quotes. A name that holds one itself only shifts what counts as a
/// name, so both kinds have to be escaped.
pub(super) fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some((words, behind)) = rest.split_once('`')
        && let Some((name, next)) = behind.split_once('`')
    {
        pieces.extend([Piece::Words(words), Piece::Name(name)]);
        rest = next;
    }
    pieces.push(Piece::Words(rest));
    pieces.retain(|piece| *piece != Piece::Words(""));
    pieces
}

/// The path of a place; the working directory has a name as well, and a folder ends in a slash.
pub(super) fn path(path: &str, location: &Location) -> String {
    let path = if path.is_empty() { "." } else { path };
    let slash = if location.folder.is_some() && !path.ends_with('/') {
        "/"
    } else {
        ""
    };
    printable(&format!("{path}{slash}"))
}

/// The path of a finding.
pub(super) fn path_of(finding: &Finding) -> String {
    path(&finding.path, &finding.location)
}

/// A place without source text: line and element.
pub(super) fn bare_place(location: &Location) -> Option<String> {
    let line = location.line.map(|line| match location.column {
        Some(column) => format!("line {line}, column {column}"),
        None => format!("line {line}"),
    });
    let element = location
        .element
        .map(|element| format!("{} {}", element.kind, element.index));
    let pointer = location
        .pointer
        .clone()
        .filter(|pointer| line.is_none() && !pointer.is_empty());
    let parts: Vec<String> = [line, element, pointer].into_iter().flatten().collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// `path:line:column: level[rule] message`.
pub(super) fn one_line(finding: &Finding) -> String {
    let place = format!("{}{}", path_of(finding), colons(&finding.location));
    format!(
        "{place}: {}[{}] {}",
        finding.level,
        finding.rule,
        printable(&message(finding))
    )
}

/// `:line:column` behind a path.
pub(super) fn colons(location: &Location) -> String {
    match (location.line, location.column) {
        (Some(line), Some(column)) => format!(":{line}:{column}"),
        (Some(line), None) => format!(":{line}"),
        _ => String::new(),
    }
}

/// `108 of 216: a, b, c and 105 more; worst 0.5 at vertex 7`. Nothing for a single case: the
/// message says it.
fn evidence_line(
    evidence: &Evidence,
    count: Option<String>,
    worst: Option<&Worst>,
) -> Option<String> {
    if evidence.count < 2 {
        return None;
    }
    let left = evidence
        .groups
        .unwrap_or(evidence.count)
        .saturating_sub(evidence.examples.len() as u64);
    let examples = match (evidence.examples.is_empty(), left) {
        (true, _) => None,
        (false, 0) => Some(evidence.examples.join(", ")),
        (false, left) => Some(format!("{} and {left} more", evidence.examples.join(", "))),
    };
    let cases: Vec<String> = [count, examples].into_iter().flatten().collect();
    let worst = worst.map(|worst| format!("worst {} at {}", number(worst.value), worst.place));
    let parts: Vec<String> = [Some(cases.join(": ")), worst]
        .into_iter()
        .flatten()
        .filter(|part| !part.is_empty())
        .collect();
    (!parts.is_empty()).then(|| parts.join("; "))
}

/// A number with about four digits that matter.
fn number(value: f64) -> String {
    let size = value.abs();
    if value.fract() == 0.0 && size < 1e9 {
        return format!("{value}");
    }
    if !(1e-3..1e7).contains(&size) {
        let text = format!("{value:.3e}");
        // What is not finite has no power.
        let Some((digits, power)) = text.split_once('e') else {
            return text;
        };
        return format!(
            "{}e{power}",
            digits.trim_end_matches('0').trim_end_matches('.')
        );
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Application, Level, Place, RuleInfo};

    #[test]
    fn groups_of_elements_are_not_taken_for_elements() {
        let named = Evidence::of_groups(["a-*", "b-*"], 108).out_of(216);
        assert_eq!(said("it", named).as_deref(), Some("108 of 216: a-*, b-*"));
        let cut = Evidence::of_groups(["a"; 7], 99);
        assert_eq!(
            said("it", cut).as_deref(),
            Some("99: a, a, a, a, a and 2 more")
        );
        let single = Evidence::counted(1).with_worst(0.5, "vertex 3");
        assert_eq!(said("it", single), None);
    }

    #[test]
    fn what_is_counted_has_a_noun_where_the_rule_has_one() {
        let rule = RuleInfo {
            counts: "rows",
            ..RuleInfo::new("a-rule", Level::Error, "")
        };
        let finding = Finding::new(&rule, "a", Place::File, "it")
            .evidence(Evidence::of_unnamed(["x", "y"]).out_of(9));
        assert_eq!(evidence_of(&finding).as_deref(), Some("2 of 9 rows: x, y"));
        let noted =
            finding
                .related("a", Place::File, "set it")
                .related("b", Place::File, "the other");
        assert!(
            plain(&noted).ends_with("see: set it\nsee: b: the other"),
            "{}",
            plain(&noted)
        );
    }

    fn said(message: &str, evidence: Evidence) -> Option<String> {
        let finding = Finding::new(
            &RuleInfo::new("a-rule", Level::Error, ""),
            "a",
            Place::File,
            message,
        );
        evidence_of(&finding.evidence(evidence))
    }

    #[test]
    fn a_number_that_the_message_says_is_not_repeated() {
        let rows = || Evidence::counted(3).out_of(20);
        assert_eq!(said("3 of 20 rows are empty", rows()), None);
        assert_eq!(said("3 rows are empty", rows()).as_deref(), Some("3 of 20"));
        assert_eq!(
            said("13 of 20 rows, 3 of 200, 3 of 20.5, a-3 of 20", rows()).as_deref(),
            Some("3 of 20")
        );
        let worst = || rows().with_worst(0.5, "vertex 7");
        assert_eq!(
            said("3 of 20 rows are empty", worst()).as_deref(),
            Some("worst 0.5 at vertex 7")
        );
        let named = || Evidence::of_unnamed(["a", "b", "c"]);
        assert_eq!(said("there are 3.", named()).as_deref(), Some("a, b, c"));
    }

    #[test]
    fn a_finding_in_plain_words() {
        let rule = RuleInfo {
            breaks: &[(Application::Mpfb, "stops")],
            ..RuleInfo::new("a-rule", Level::Error, "")
        };
        let finding = Finding::new(&rule, "a", Place::File, "it is\nso")
            .confidence(Confidence::Low)
            .related("b", Place::File, "the other")
            .help("mend it");
        assert_eq!(
            plain(&finding),
            "it is so (a guess)\nMPFB: stops\nsee: b: the other\nhelp: mend it"
        );
    }

    #[test]
    fn names_stand_between_back_quotes() {
        use Piece::{Name, Words};
        assert_eq!(
            pieces("`a` and `b`"),
            [Name("a"), Words(" and "), Name("b")]
        );
        assert_eq!(pieces("one ` only"), [Words("one ` only")]);
        assert_eq!(pieces("`a`b`c"), [Name("a"), Words("b`c")]);
        assert_eq!(pieces(""), []);
    }

    #[test]
    fn related_places_are_bounded() {
        let mut finding = Finding::new(
            &RuleInfo::new("a-rule", Level::Error, ""),
            "a",
            Place::File,
            "it",
        );
        for _ in 0..RELATED + 2 {
            finding = finding.related("b", Place::File, "there");
        }
        assert_eq!(lines(&finding).len(), RELATED + 1);
        assert!(plain(&finding).ends_with("see: 2 more places"));
    }

    #[test]
    fn numbers_keep_the_digits_that_matter() {
        let shown = [2.0, 0.25, 1.0 / 3.0, 1e-7, f64::NAN, -12.5].map(number);
        assert_eq!(shown, ["2", "0.25", "0.3333", "1e-7", "NaN", "-12.5"]);
    }
}
