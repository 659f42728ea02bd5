//! Lines of a model that MPFB does not see, or takes for something else
//! (`docs/loaders/mpfb/models.md#the-model-file`, `docs/loaders/mpfb/models.md#lines-of-a-model`).

use super::super::{Rule, such};
use super::unparted::{Unparted, unparted};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_formats::mhm::columns::{Columns, SETTING};
use mhlint_formats::mhm::{CATEGORIES, Model, Word};
use mhlint_repo::FileFacts;

const NOT_SET: Case = &[(
    Mpfb,
    Level::Warning,
    "silently passes over the line: what it sets is missing",
)];
const NOT_WORN: Case = &[(
    Mpfb,
    Level::Error,
    "silently passes over the line: the asset is missing",
)];
const NO_NAME: Case = &[(Mpfb, Level::Info, "imports a character with an empty name")];
const OTHER_RIG: Case = &[(Mpfb, Level::Warning, "silently adds the rig `default`")];

/// MPFB picks the rig by which of these words the name of the skeleton contains.
const RIGS: [&str; 4] = ["default", "toes", "game", "cmu"];

/// A finding on keywords that MPFB does not see, because they are not at the start of the line or
/// have other capitals.
pub(super) fn displaced(rule: &Rule, file: &FileFacts, columns: &Columns) -> Option<Finding> {
    let all = &columns.displaced;
    let is_worn = |one: &&Word| {
        CATEGORIES
            .iter()
            .any(|known| known.eq_ignore_ascii_case(&one.text))
    };
    let worn = all.iter().find(is_worn);
    let first = worn.or(all.first())?;
    let (keyword, more) = (&*first.text, such(all.len(), "lines"));
    let (message, help) = if SETTING
        .iter()
        .chain(&CATEGORIES)
        .any(|known| *known == keyword)
    {
        (
            format!("a blank stands before `{keyword}`{more}"),
            "begin the line with its keyword",
        )
    } else {
        let message = format!("`{keyword}` has other capitals than the keyword of models{more}");
        (message, "write the keyword in its own capitals")
    };
    let is_name = all.iter().all(|one| one.text.eq_ignore_ascii_case("name"));
    let case = if worn.is_some() { NOT_WORN } else { NOT_SET };
    let finding = rule
        .at(file, Place::Span(first.span.clone()), message)
        .key("displaced");
    let finding = finding
        .case(if is_name { NO_NAME } else { case })
        .help(help);
    Some(finding.evidence(Evidence::of_cases(all.iter().map(|one| &*one.text))))
}

/// A finding on keywords that are joined with their values to one word, so that MPFB does not know
/// them.
pub(super) fn without_blank(
    rule: &Rule,
    file: &FileFacts,
    all: &[Unparted<'_>],
) -> Option<Finding> {
    let first = all.iter().find(|one| one.is_worn()).or(all.first())?;
    let message = format!("{}{}", first.message(), such(all.len(), "lines"));
    let finding = rule
        .at(file, Place::Span(first.line.keyword.span.clone()), message)
        .key("unparted");
    let finding = finding.evidence(Evidence::of_cases(
        all.iter().map(|one| &*one.line.keyword.text),
    ));
    let finding = finding.help(first.help());
    Some(match () {
        () if first.is_worn() => finding.case(NOT_WORN),
        () if all.iter().all(|one| one.keyword == "name") => finding.case(NO_NAME),
        () => finding.case(NOT_SET),
    })
}

/// The lines with joined words whose keywords MPFB reads.
pub(super) fn read_unparted(model: &Model) -> Vec<Unparted<'_>> {
    unparted(&model.lines)
        .filter(|one| SETTING.contains(&one.keyword) || one.is_worn())
        .collect()
}

/// A finding if the name of the skeleton contains no word by which MPFB picks a rig.
pub(super) fn rig(rule: &Rule, file: &FileFacts, columns: &Columns) -> Option<Finding> {
    let name = columns.skeleton.as_ref()?;
    let lower = name.text.to_lowercase();
    if RIGS.iter().any(|known| lower.contains(known)) {
        return None;
    }
    let message = format!("MPFB knows no rig for the skeleton `{}`", name.text);
    let finding = rule
        .at(file, Place::Span(name.span.clone()), message)
        .key("skeleton")
        .case(OTHER_RIG);
    Some(finding.help(
        "name `default.mhskel`, `default_no_toes.mhskel`, `game_engine.mhskel` or `cmu_mb.mhskel`",
    ))
}
