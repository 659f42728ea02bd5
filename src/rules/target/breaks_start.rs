//! A target that nothing uses and that stops the program all the same.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::{targets, unreadable_fields};
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops at start with a ValueError although nothing uses the file, and leaves an empty compressedtargets.npz \
             behind, which stops every later start",
        )],
        docs: "A target that no slider and no macro uses, and that cannot be parsed.\n\nIt looks harmless and is not: to make \
            its archive, MakeHuman 2 parses every file ending in `.target` below the folder, at any depth, before \
            anything is shown. One that it cannot read ends the program, and the empty archive that stays behind ends \
            every later start, too, until somebody deletes it by hand.\n\nMend the file, or move it out of the target folder \
            (another ending such as `.target.bak` does as well), and delete a compressedtargets.npz of 0 bytes. While a \
            sound archive lies in the folder the file is not parsed; then this is a warning.",
        ..RuleInfo::new("target-breaks-start", Level::Error, "a target nobody uses stops the program at start")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body).filter(|(target, ..)| target.is_unused) {
        let Some(mut finding) = unreadable_fields::finding(&RULE, file, facts) else { continue };
        finding.message.push_str(", and MakeHuman 2 parses this file at start although nothing uses it");
        out.push(weigh(target, finding).help("mend the row, or move the file out of the target folder"));
    }
}
