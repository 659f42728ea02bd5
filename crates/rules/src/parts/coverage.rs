//! An end of a setting that no part covers.

use std::slice;

use super::super::{Check, Rule, RuleCx};
use super::stretch::{THESE_VALUES, checked, effect, level, shown, whole, without_dead};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo, pointer};
use mhlint_eval::mpfb::cover::Hole;
use mhlint_formats::macro_parts::Setting;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "drops all targets that need the setting at this end of the slider",
    )],
    docs: include_str!("coverage.md").trim_ascii_end(),
    ..RuleInfo::new(
        "parts-coverage",
        Level::Error,
        "an end of a setting is not covered by any part",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = checked(view) else { return };
    for setting in whole(parts) {
        let ends = without_dead(setting).into_iter();
        out.extend(ends.filter_map(|end| finding(parts.file, setting, &end)));
    }
}

/// Nothing for a hole between two parts.
fn finding(file: &FileFacts, setting: &Setting, hole: &Hole) -> Option<Finding> {
    let part = |number: Option<usize>| number.and_then(|number| setting.parts.get(number));
    let name = setting.name();
    let from_to = shown(hole);
    let uncovered = format!("no part of `{name}` covers {from_to}");
    let (place, message, help, end) = match (part(hole.before), part(hole.after)) {
        (Some(_), Some(_)) => return None,
        (None, Some(first)) => (
            setting.pointer(first, "lowest"),
            uncovered,
            "write a `lowest` below 0",
            " 0",
        ),
        (Some(last), None) => (
            setting.pointer(last, "highest"),
            uncovered,
            "write a `highest` above 1",
            " 1",
        ),
        (None, None) => {
            let is_empty = setting.parts.is_empty();
            let message = if is_empty {
                format!("`{name}` has no parts")
            } else {
                uncovered
            };
            let help = if is_empty {
                "add the parts"
            } else {
                "write parts that cover 0 to 1"
            };
            (pointer(&["macrotargets", name, "parts"]), message, help, "")
        }
    };
    let level = level(setting, slice::from_ref(hole));
    let finding = RULE
        .at(file, Place::Pointer(place), message)
        .level(level)
        .effect(effect(setting, level, THESE_VALUES));
    Some(finding.key(format!("{name}{end}")).help(help))
}
