//! Values between two parts of a setting that neither of them covers.

use std::slice;

use super::super::{Check, Rule, RuleCx, counted};
use super::stretch::{THESE_VALUES, checked, effect, level, shown, whole, without_dead};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_eval::mpfb::cover::{Hole, unreachable_near, values_in};
use mhlint_formats::macro_parts::Setting;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "drops all targets that need the setting at these values",
    )],
    docs: include_str!("gap.md").trim_ascii_end(),
    counts: "slider values",
    ..RuleInfo::new(
        "parts-gap",
        Level::Warning,
        "values between two parts that neither covers",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = checked(view) else { return };
    for setting in whole(parts) {
        let gaps = without_dead(setting).into_iter();
        out.extend(gaps.filter_map(|gap| finding(parts.file, setting, &gap)));
    }
}

/// A wider gap is a mistyped number: only one of the two has to be corrected.
const WIDE: f64 = 0.001;

/// A bound itself if no slider has this value, else the nearest number that none has on the side of
/// `sign`.
fn beyond(bound: f64, sign: f64) -> f64 {
    const STEPS: f64 = 1e9;
    if values_in(bound, bound) == 0 {
        bound
    } else {
        (bound * STEPS + sign).round() / STEPS
    }
}

/// Nothing for a hole at an end of the slider.
fn finding(file: &FileFacts, setting: &Setting, gap: &Hole) -> Option<Finding> {
    let (before, after) = (
        setting.parts.get(gap.before?)?,
        setting.parts.get(gap.after?)?,
    );
    let values = values_in(gap.from, gap.to);
    let from_to = shown(gap);
    let message = format!(
        "no part of `{}` covers {from_to} ({})",
        setting.name(),
        counted(values, "slider value")
    );
    let level = level(setting, slice::from_ref(gap));
    // With a name on one side only the gap belongs to what has no shape: what jumps is told as
    // that.
    if level == Level::Warning && before.high.is_none() != after.low.is_none() {
        return None;
    }
    let name = before
        .high
        .as_ref()
        .or(after.low.as_ref())
        .map_or("", String::as_str);
    let (one, next) = (before.index, after.index);
    let help = if gap.to - gap.from > WIDE {
        let (ends, begins) = (beyond(gap.to, 1.0), beyond(gap.from, -1.0));
        format!(
            "write {ends} for `highest` of parts[{one}], or {begins} for `lowest` of parts[{next}]"
        )
    } else {
        let both = unreachable_near(gap.from, gap.to);
        format!(
            "write {both} for both `highest` of parts[{one}] and `lowest` of parts[{next}]: no \
                slider has this value"
        )
    };
    let evidence = Evidence::counted(usize::try_from(values).unwrap_or(usize::MAX));
    let finding = RULE
        .at(
            file,
            Place::Pointer(setting.pointer(after, "lowest")),
            message,
        )
        .level(level);
    let finding = finding
        .key(format!("{} {name}", setting.name()))
        .effect(effect(setting, level, THESE_VALUES));
    Some(finding.help(help).evidence(evidence))
}
