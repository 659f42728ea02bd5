//! Two neighbouring parts with different names where they meet.

use super::super::{Check, Rule, RuleCx};
use super::stretch::{checked, whole};
use super::wanted::lost_names;
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use mhlint_eval::mpfb::cover::is_live;
use mhlint_formats::macro_parts::{Part, Setting};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "jumps from one shape to another at this value of the slider",
    )],
    docs: include_str!("discontinuity.md").trim_ascii_end(),
    ..RuleInfo::new(
        "parts-discontinuity",
        Level::Warning,
        "neighbouring parts have different names where they meet",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = checked(view) else { return };
    let lost = lost_names(parts);
    for setting in whole(parts) {
        let is_lost = |name: &Option<String>| {
            name.as_ref()
                .is_some_and(|name| lost.contains(&(setting.place, name)))
        };
        let mut sorted: Vec<&Part> = setting
            .parts
            .iter()
            .filter(|part| is_live((part.lowest, part.highest)))
            .collect();
        sorted.sort_by(|one, other| one.lowest.total_cmp(&other.lowest));
        for pair in sorted.windows(2) {
            let [one, next] = pair else { continue };
            let is_apart = one.highest <= next.lowest && one.highest < 1.0 && next.lowest > 0.0;
            if is_apart && one.high != next.low && !is_lost(&one.high) && !is_lost(&next.low) {
                out.push(finding(parts.file, setting, one, next));
            }
        }
    }
}

fn finding(file: &FileFacts, setting: &Setting, one: &Part, next: &Part) -> Finding {
    let name = |name: &Option<String>| {
        name.as_ref()
            .map_or("no name".to_owned(), |name| format!("`{name}`"))
    };
    let (high, low) = (name(&one.high), name(&next.low));
    let key = setting.name();
    let message = format!(
        "parts[{}] of `{key}` ends with {high}, parts[{}] begins with {low}",
        one.index, next.index
    );
    let help = format!(
        "write the same name for `high` of parts[{}] and `low` of parts[{}]",
        one.index, next.index
    );
    let place = Place::Pointer(setting.pointer(next, "low"));
    RULE.at(file, place, message)
        .key(format!("{key} {high} {low}"))
        .help(help)
}
