//! So many components blend at once that no combination is strong enough.

use super::super::cause::component::{SMALLEST_WEIGHT, too_many_at_once};
use super::super::{Check, Rule, RuleCx};
use super::space::Space;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "drops every combination between the steps, so that the shape of the macrodef disappears \
            there",
    )],
    docs: include_str!("too_many_active.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-too-many-active",
        Level::Warning,
        "a macrodef blends so many values at once that no combination has enough weight",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    for macrodef in &macros.macrodefs {
        let active =
            too_many_at_once(macros, macrodef).filter(|_| Space::of(macros, macrodef).is_some());
        let Some(active) = active else { continue };
        let count = macrodef.components.len();
        let message = format!(
            "{count} components make {active} combinations active at once, each with the weight \
             {:.4}; the limit is {SMALLEST_WEIGHT}",
            1.0 / active
        );
        let place = Place::pointer(["macrodef", &macrodef.index.to_string(), "comp"]);
        let finding = RULE
            .at(file, place, message)
            .key(macrodef.components.join("-"));
        out.push(finding.help("split the macrodef into several with fewer components each"));
    }
}
