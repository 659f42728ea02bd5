//! Bones have all keys, of the types that Blender takes.

use super::super::unfit::findings_in;
use super::super::{Check, Rule, RuleCx};
use super::{IN_BONES, STOPS, stops};
use crate::diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo};
use crate::repo::mpfb::{RigPart, View};

pub(in crate::rules) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: "A bone needs `head`, `tail`, `roll`, `parent`, `use_connect`, `use_inherit_rotation`, `use_local_location`, \
        `inherit_scale` and `rigify` (`{}` where there is nothing to say). A constraint needs `type` and `name`.\n\n\
        MPFB raises an exception when the rig is added if one of them is missing, or of another type: `null` for an angle, a \
        list for `head`, 2 for a switch. A rig in `rigs/rigify/` needs `rigify_ui`, too: without it there are neither weights \
        nor parenting.\n\n\
        Add the key, or write a value of its type.",
    ..RuleInfo::new("rig-missing-key", Level::Error, "a key of a rig is missing or of another type")
});

const NO_PANEL: Case =
    &[(Mpfb, Level::Error, "fails with an exception after the rig is made: there are neither weights nor parenting")];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.keys, cx);
        out.extend(found.map(|(_, finding)| stops(file, finding)));
        if file.part == RigPart::Rigify && rig.has_header && !rig.has_rigify_ui {
            let finding = RULE.at(file.file, Place::File, "the rig has no `rigify_ui`").key("rigify_ui").case(NO_PANEL);
            out.push(finding.help("add `rigify_ui` with the colours and collections of its panel"));
        }
    }
}
