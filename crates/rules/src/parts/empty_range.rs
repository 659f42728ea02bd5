//! A part that no value is in.

use super::super::{Check, Rule, RuleCx};
use super::stretch::{checked, dead, effect, harmful, level, shown, touched, whole};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use mhlint_eval::mpfb::cover::Hole;
use mhlint_formats::macro_parts::{Part, Setting};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "never uses the part")],
    docs: include_str!("empty_range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "parts-empty-range",
        Level::Error,
        "a part that no value is in",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = checked(view) else { return };
    for setting in whole(parts) {
        let holes = harmful(setting);
        out.extend(dead(setting).map(|part| finding(parts.file, setting, part, &holes)));
    }
}

fn finding(file: &FileFacts, setting: &Setting, part: &Part, holes: &[Hole]) -> Finding {
    let (lowest, highest) = (part.lowest, part.highest);
    let (member, why, help) = if !lowest.is_finite() {
        (
            "lowest",
            "`lowest` is not a finite number".to_owned(),
            "write a number",
        )
    } else if !highest.is_finite() {
        (
            "highest",
            "`highest` is not a finite number".to_owned(),
            "write a number",
        )
    } else if lowest > highest {
        (
            "lowest",
            format!("`lowest` {lowest} is above `highest` {highest}"),
            "exchange `lowest` and `highest`",
        )
    } else {
        (
            "lowest",
            format!("`lowest` and `highest` are both {lowest}"),
            "write a `lowest` below `highest`",
        )
    };
    let name = |name: &Option<String>| name.clone().unwrap_or_default();
    let message = format!(
        "parts[{}] of `{}` never matches: {why}",
        part.index,
        setting.name()
    );
    let lost = holes.get(touched(part, holes)).unwrap_or_default();
    let level = level(setting, lost);
    let finding = RULE
        .at(file, Place::Pointer(setting.pointer(part, member)), message)
        .level(level)
        .help(help);
    let finding = finding.key(format!(
        "{} {}-{}",
        setting.name(),
        name(&part.low),
        name(&part.high)
    ));
    match lost {
        [] => finding,
        [hole, ..] => finding.effect(effect(setting, level, &shown(hole))),
    }
}
