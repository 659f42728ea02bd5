//! A user's target is where MPFB looks for it, once.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo};
use mhlint_formats::face_expression::UNITS;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{View, is_custom};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "shows no slider for it")],
    docs: include_str!("no_slider.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-no-slider",
        Level::Warning,
        "a user's target without a slider of its own",
    )
});

const TWICE: Case = &[(
    Mpfb,
    Level::Warning,
    "finds it twice: its section shows the slider twice",
)];
const BY_NAME: Case = &[(
    Mpfb,
    Level::Error,
    "shows no slider for it; saved characters find it by name",
)];
const UNSEEN: Case = &[(Mpfb, Level::Error, "does not see the file on Linux")];
const OTHER: Case = &[(Mpfb, Level::Error, "does not see the file")];
const BY_HAND: Case = &[(
    Mpfb,
    Level::Warning,
    "shows no slider for it: such a file is only loaded by hand",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.layers.checks_system() {
        return;
    }
    let files = view
        .layers
        .checked
        .below("targets")
        .chain(view.layers.checked.below("custom"));
    out.extend(files.filter_map(of));
}

fn of(file: &FileFacts) -> Option<Finding> {
    let name = file.file_name();
    if let Some(right) = name
        .strip_suffix(".txt")
        .filter(|right| suffixes(right).is_some())
    {
        let finding = RULE
            .at(file, Place::File, format!("`{name}` has a second suffix"))
            .key("place")
            .case(OTHER);
        return Some(finding.help(format!("rename it to `{right}`")));
    }
    let stem = suffixes(name)?;
    let suffix = name.get(stem.len()..).unwrap_or_default();
    let is_packed = suffix.len() == ".target.gz".len();
    let (message, case, help) = if suffix.to_ascii_lowercase().starts_with(".p") {
        let message = format!("`{name}` is a target of another mesh than the body");
        (message, BY_HAND, "move it out of the folders of targets")
    } else if suffix != suffix.to_ascii_lowercase() {
        (
            format!("`{name}` has a suffix in capitals"),
            UNSEEN,
            "write the suffix in small letters",
        )
    } else if !is_custom(&file.rel)
        && is_packed
        && !UNITS.iter().any(|unit| unit.eq_ignore_ascii_case(stem))
    {
        (
            format!("the packed target `{name}` is not in `custom`"),
            BY_NAME,
            "move it to `custom/`, or unpack it",
        )
    } else if file.rel.starts_with("targets/custom/") && !is_packed {
        (
            format!("`{name}` is in `targets/custom`"),
            TWICE,
            "move it to `custom/`",
        )
    } else {
        return None;
    };
    Some(
        RULE.at(file, Place::File, message)
            .key("place")
            .case(case)
            .help(help),
    )
}

/// The name without the suffix of a target, in whatever capitals; `None` for another file.
fn suffixes(name: &str) -> Option<&str> {
    let is_at = |at: usize, suffix: &str| {
        name.get(at..)
            .is_some_and(|end| end.eq_ignore_ascii_case(suffix))
    };
    let longest_first = [".ptarget.gz", ".target.gz", ".ptarget", ".target"];
    let at = longest_first.iter().find_map(|suffix| {
        let at = name.len().checked_sub(suffix.len())?;
        is_at(at, suffix).then_some(at)
    })?;
    name.get(..at)
}
