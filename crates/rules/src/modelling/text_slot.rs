//! A status text needs a line of its own, 1 to 5.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

/// Lines of the status area.
const SLOTS: std::ops::RangeInclusive<f64> = 1.0..=5.0;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "does not show the text")],
    docs: include_str!("text_slot.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-text-slot",
        Level::Warning,
        "`display.slot` is outside 1 to 5, or used twice",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut by_slot: BTreeMap<i64, Vec<&BoundSlider<'_>>> = BTreeMap::new();
    for bound in &base.sliders {
        let Some(display) = &bound.slider.display else {
            continue;
        };
        let Some(slot) = display.slot else { continue };
        if display.slot_is_float {
            out.push(float(bound, slot));
            continue;
        }
        if slot.fract() != 0.0 {
            // Not an integer: the schema's finding.
            continue;
        }
        if SLOTS.contains(&slot) {
            #[expect(clippy::cast_possible_truncation, reason = "an integer from 1 to 5")]
            by_slot.entry(slot as i64).or_default().push(bound);
        } else {
            let key = bound.slider.key.as_str();
            let message =
                format!("`{key}` writes to line {slot} of the status area, which has lines 1 to 5");
            let help = "choose a free line from 1 to 5";
            out.push(
                RULE.at(bound.file, place(bound), message)
                    .key(key)
                    .help(help),
            );
        }
    }
    for (slot, sliders) in by_slot {
        let [.., hidden, last] = sliders.as_slice() else {
            continue;
        };
        let (key, winner) = (hidden.slider.key.as_str(), last.slider.key.as_str());
        let message =
            format!("`{key}` and `{winner}` both write to line {slot} of the status area");
        let finding = RULE
            .at(last.file, place(last), message)
            .key(format!("slot {slot}"));
        let finding = finding
            .asset(last.file.root())
            .parts(sliders.iter().map(|slider| &slider.slider.key));
        out.push(
            finding
                .related(hidden.file.path.clone(), place(hidden), "is not shown")
                .help("give each slider its own line"),
        );
    }
}

/// A line number that is a float.
fn float(bound: &BoundSlider<'_>, slot: f64) -> Finding {
    let key = bound.slider.key.as_str();
    let message = format!("`display.slot` of `{key}` is {slot:.1}, which has a decimal point");
    let finding = RULE
        .at(bound.file, place(bound), message)
        .key(format!("{key} float"));
    finding
        .level(Level::Error)
        .effect("crashes at start with `TypeError`")
        .help(format!("write `{slot}`"))
}

fn place(bound: &BoundSlider<'_>) -> Place {
    Place::pointer([&bound.slider.key, "display", "slot"])
}
