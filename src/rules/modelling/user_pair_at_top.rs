//! A pair of user targets needs a folder.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View, user_scan};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops with an UnboundLocalError whenever it scans the targets of the user, at start for one",
        )],
        docs: "MakeHuman 2 makes one slider of two user targets that are called `…-incr` and `…-decr`. For a pair directly in \
            `target/<base>/`, without a folder, it stops with an UnboundLocalError instead, at every scan of the targets. A single \
            target without a folder is fine, and so is a pair in a folder below.\n\nMove both files into a folder.",
        ..RuleInfo::new("modelling-user-pair-at-top", Level::Error, "a pair of user targets without a folder")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let targets = user_scan::targets(base);
    for (file, other) in user_scan::pairs_at_top(&targets) {
        let message = format!("`{}` and `{other}` are a pair without a folder", file.stem());
        let help = "move both into a folder below, such as `shape/`";
        out.push(RULE.at(file, Place::File, message).parts([file.stem(), other.as_str()]).help(help));
    }
}
