//! A target has a name besides values of macros.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "never reads it: no modifier can name it")],
    docs: "The words of a target's path that are not values of macros make the group by which modifiers name it. A target whose \
        path has such values alone, `targets/female-young.target`, is in no group.\n\nGive it another word, or put it into a \
        folder.",
    ..RuleInfo::new("target-without-group", Level::Warning, "a target without a name of its own")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() || view.targets.is_packed {
        return;
    }
    let bare = view.targets.of_group("").iter().filter_map(|place| view.targets.at(*place));
    out.extend(bare.filter(|target| target.name.is_macro()).map(|target| {
        let message = "its path has nothing but values of macros";
        RULE.at(target.file, Place::File, message)
            .help("add a word to its name and a modifier for it, or keep it outside of the data")
    }));
}
