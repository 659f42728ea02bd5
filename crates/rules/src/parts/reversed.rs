//! Names of a setting that run against its slider.

use super::super::{Check, Rule, RuleCx};
use super::stretch::{checked, whole};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use mhlint_eval::mpfb::cover::is_live;
use mhlint_formats::macro_parts::{Part, Setting};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "silently shows the opposite shape, also of all saved characters",
    )],
    docs: include_str!("reversed.md").trim_ascii_end(),
    ..RuleInfo::new(
        "parts-reversed",
        Level::Warning,
        "the names of a setting run against its slider",
    )
});

/// The names of each setting, by its place, from 0 to 1.
const USUAL: [&[&str]; 8] = [
    &["female", "male"],
    &["baby", "child", "young", "old"],
    &["minmuscle", "averagemuscle", "maxmuscle"],
    &["minweight", "averageweight", "maxweight"],
    &["uncommonproportions", "idealproportions"],
    &["minheight", "maxheight"],
    &["mincup", "averagecup", "maxcup"],
    &["minfirmness", "averagefirmness", "maxfirmness"],
];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = checked(view) else { return };
    for setting in whole(parts) {
        let Some(usual) = USUAL.get(setting.place) else {
            continue;
        };
        let places = places(setting, usual);
        let is_falling = places
            .windows(2)
            .all(|pair| matches!(pair, [(one, _), (next, _)] if one >= next));
        let (Some((first, part)), Some((last, _))) = (places.first(), places.last()) else {
            continue;
        };
        if is_falling && first > last {
            let name = |at: usize| usual.get(at).copied().unwrap_or_default();
            let message = format!(
                "`{}` runs from `{}` to `{}`",
                setting.name(),
                name(*first),
                name(*last)
            );
            let place = Place::Pointer(setting.pointer(part, "low"));
            let finding = RULE.at(parts.file, place, message).key(setting.name());
            out.push(finding.help(format!(
                "exchange the names: `{}` belongs at 0",
                name(*last)
            )));
        }
    }
}

/// Where the names of the parts stand among the usual ones, in the order of the slider.
fn places<'s>(setting: &'s Setting, usual: &[&str]) -> Vec<(usize, &'s Part)> {
    let mut sorted: Vec<&Part> = setting
        .parts
        .iter()
        .filter(|part| is_live((part.lowest, part.highest)))
        .collect();
    sorted.sort_by(|one, other| one.lowest.total_cmp(&other.lowest));
    let names = sorted
        .into_iter()
        .flat_map(|part| [(&part.low, part), (&part.high, part)]);
    let known = names.filter_map(|(name, part)| Some((name.as_deref()?, part)));
    known
        .filter_map(|(name, part)| Some((usual.iter().position(|own| *own == name)?, part)))
        .collect()
}
