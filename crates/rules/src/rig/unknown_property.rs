//! Keys of constraints and of bendy bones are properties that Blender has.

use super::super::unfit::findings_in;
use super::super::{Check, Rule, RuleCx};
use super::{IN_BONES, STOPS, stops};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("unknown_property.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-unknown-property",
        Level::Error,
        "a key of a constraint or a bendy bone that Blender does not have",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.properties, cx);
        out.extend(found.map(|(_, finding)| stops(file, finding)));
    }
}
