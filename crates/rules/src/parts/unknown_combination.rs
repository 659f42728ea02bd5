//! `combinations` that MPFB does not make.

use super::super::{Check, Rule, RuleCx, enumerated};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::macro_parts::SETTINGS;
use mhlint_repo::mpfb::View;
use mhlint_repo::mpfb::loops::{Axis, LOOPS};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "ignores `combinations` and makes its own five")],
    docs: include_str!("unknown_combination.md").trim_ascii_end(),
    counts: "combinations",
    ..RuleInfo::new(
        "parts-unknown-combination",
        Level::Info,
        "`combinations` differ from those that MPFB makes",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = view
        .parts
        .as_ref()
        .filter(|parts| view.layers.is_checked(parts.file))
    else {
        return;
    };
    let listed = &parts.settings.combinations;
    if listed.is_empty() {
        return;
    }
    let made: Vec<Vec<&str>> = LOOPS
        .iter()
        .map(|own| sorted(own.axes.iter().map(setting)))
        .collect();
    let written: Vec<Vec<&str>> = listed
        .iter()
        .map(|(_, names)| sorted(names.iter().map(String::as_str)))
        .collect();
    let unknown = listed
        .iter()
        .zip(&written)
        .filter(|(_, names)| !made.contains(names))
        .map(|((key, _), _)| key);
    let unknown: Vec<&String> = unknown.collect();
    let missing: Vec<&str> = LOOPS
        .iter()
        .zip(&made)
        .filter(|(_, names)| !written.contains(names))
        .map(|(own, _)| own.title)
        .collect();
    let message = match (unknown.as_slice(), missing.as_slice()) {
        ([], []) => return,
        ([], missing) => format!(
            "`combinations` lacks those of the {} targets",
            enumerated(missing)
        ),
        ([only], _) => format!("MPFB does not make the combination `{only}`"),
        (several, _) => {
            let keys: Vec<String> = several.iter().map(|key| format!("`{key}`")).collect();
            format!("MPFB does not make the combinations {}", enumerated(&keys))
        }
    };
    let cases = unknown
        .iter()
        .map(|key| (*key).clone())
        .chain(missing.iter().map(|title| (*title).to_owned()));
    let finding = RULE
        .at(parts.file, Place::pointer(["combinations"]), message)
        .key("combinations");
    out.push(
        finding
            .evidence(Evidence::of_cases(cases))
            .help("write the five combinations that MPFB makes"),
    );
}

fn setting(axis: &Axis) -> &'static str {
    match axis {
        Axis::Race => "race",
        Axis::Setting(place) | Axis::Only(place, _) => {
            SETTINGS.get(*place).copied().unwrap_or_default()
        }
    }
}

fn sorted<'n>(names: impl Iterator<Item = &'n str>) -> Vec<&'n str> {
    let mut names: Vec<&str> = names.collect();
    names.sort_unstable();
    names
}
