//! A pair of user targets needs a folder.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View, user_scan};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `UnboundLocalError` whenever it scans the user targets, for example at start",
    )],
    docs: "Two user targets named `…-incr` and `…-decr` are directly in `target/<base>/`.\n\nMakeHuman 2 makes \
        one slider of such a pair, but crashes if it is not in a subfolder. A single target outside a subfolder \
        works, and so does a pair in a subfolder.\n\nMove both files into a subfolder.",
    ..RuleInfo::new("modelling-user-pair-at-top", Level::Error, "a pair of user targets is not in a subfolder")
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let targets = user_scan::targets(base);
    for (file, other) in user_scan::pairs_at_top(&targets) {
        let message = format!("`{}` and `{other}` form a pair but are not in a subfolder", file.stem());
        let help = "move both into a subfolder, such as `shape/`";
        out.push(RULE.at(file, Place::File, message).parts([file.stem(), other.as_str()]).help(help));
    }
}
