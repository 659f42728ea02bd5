//! Keys of constraints and of bendy bones are properties that Blender has.

use super::super::unfit::findings_in;
use super::super::{Check, Rule, RuleCx};
use super::{IN_BONES, STOPS, stops};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: "Each key of a constraint but `type`, `name`, `target` and `targets` is set as a property of Blender's constraint of \
        that type, and each key of `bendy_bone` as one of the bone.\n\n\
        A key that Blender does not have, often one of an older version such as `scaleinx`, raises an exception when the rig \
        is added. So does `custom_handle_start` or `custom_handle_end` with anything but a text: leave the key out where there \
        is no handle. A `target` is refused by constraints without one.\n\n\
        Correct the key, or remove it.",
    ..RuleInfo::new("rig-unknown-property", Level::Error, "a key of a constraint or a bendy bone that Blender does not have")
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.properties, cx);
        out.extend(found.map(|(_, finding)| stops(file, finding)));
    }
}
