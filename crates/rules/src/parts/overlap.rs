//! Values that are in two parts of a setting.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::stretch::{DEFAULT, checked, ranges, whole};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use mhlint_eval::mpfb::cover::overlaps;
use mhlint_formats::macro_parts::Part;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "adds the targets of both parts up at these values")],
    docs: include_str!("overlap.md").trim_ascii_end(),
    ..RuleInfo::new(
        "parts-overlap",
        Level::Warning,
        "values that are in two parts of a setting",
    )
});

const AT_DEFAULT: &str =
    "adds the targets of both parts up at these values, also in each new character: that has 0.5";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(parts) = checked(view) else { return };
    for setting in whole(parts) {
        for overlap in overlaps(&ranges(setting)) {
            let [one, other] = overlap.ranges.map(|number| setting.parts.get(number));
            let (Some(one), Some(other)) = (one, other) else {
                continue;
            };
            let (from, to) = (overlap.from.max(0.0), overlap.to.min(1.0));
            let most = sum(one, other, from).max(sum(one, other, to));
            let sums = if most > 1.0 {
                format!("; the shares add up to {most:.4}")
            } else {
                String::new()
            };
            let name = setting.name();
            let (first, second) = (one.index, other.index);
            let message = format!(
                "parts[{first}] and parts[{second}] of `{name}` both cover {from} to {to}{sums}"
            );
            let names = [&one.low, &one.high, &other.low, &other.high]
                .map(|name| name.as_deref().unwrap_or_default());
            let finding = RULE.at(
                parts.file,
                Place::Pointer(setting.pointer(other, "lowest")),
                message,
            );
            let finding = finding.key(format!("{name} {}", names.join("-")));
            let has_default = (from..=to).contains(&DEFAULT);
            let finding = if has_default {
                finding.effect(AT_DEFAULT)
            } else {
                finding
            };
            out.push(finding.help(format!("end parts[{first}] where parts[{second}] begins")));
        }
    }
}

/// Shares of all names of two parts at a value; of a name that both have, that of the one which
/// stands later in the file.
fn sum(one: &Part, other: &Part, value: f64) -> f64 {
    let mut in_order = [one, other];
    in_order.sort_by_key(|part| part.index);
    let mut shares = BTreeMap::new();
    for part in in_order {
        let share = (value - part.lowest) / (part.highest - part.lowest);
        let named = [(&part.low, 1.0 - share), (&part.high, share)];
        shares.extend(
            named
                .into_iter()
                .filter_map(|(name, share)| Some((name.as_deref()?, share))),
        );
    }
    shares.values().sum()
}
