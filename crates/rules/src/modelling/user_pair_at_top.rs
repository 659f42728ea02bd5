//! A pair of user targets needs a folder.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View, user_scan};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `UnboundLocalError` whenever it scans the user targets, for example at start",
    )],
    docs: include_str!("user_pair_at_top.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-user-pair-at-top",
        Level::Error,
        "a pair of user targets is not in a subfolder",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let targets = user_scan::targets(base);
    for (file, other) in user_scan::pairs_at_top(&targets) {
        let message = format!(
            "`{}` and `{other}` form a pair but are not in a subfolder",
            file.stem()
        );
        let help = "move both into a subfolder, such as `shape/`";
        out.push(
            RULE.at(file, Place::File, message)
                .parts([file.stem(), other.as_str()])
                .help(help),
        );
    }
}
