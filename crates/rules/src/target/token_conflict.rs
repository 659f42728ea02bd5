//! A path has one value of each category.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use mhlint_repo::makehuman1::{PathClash, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "shows no modelling sliders at all: looking for targets ends with `RuntimeError`")],
    docs: "MakeHuman 1 looks for targets in all of the data of the program, and takes the words in the names of folders and \
        targets for what a target is for: `male`, `young`, `maxmuscle` and so on. A path with two such words for one thing, \
        such as `male-female-old.target`, a folder `clothes/male_female_shirt`, or `hair/old/young`, ends the search, even if \
        the folder is empty.\n\n\
        Words are separated by `-`, `_` and `.`; the names of other files do not count. Folders of a user are not searched, \
        and none is while there is a `targets.npz`.\n\n\
        Rename the target or the folder, such as `unisex_shirt`.",
    ..RuleInfo::new("target-token-conflict", Level::Error, "a path with two values of one category")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.layers.checks_system() {
        out.extend(view.targets.clashes.iter().map(|clash| finding(view, clash)));
    }
}

fn finding(view: &View<'_>, found: &PathClash<'_>) -> Finding {
    let clash = found.clash;
    let (category, one, other) = (clash.category, clash.first, clash.second);
    let message = format!("`{}` has `{one}` and `{other}`, two values of one category ({category})", found.rel);
    let what = if found.file.is_some() { "target" } else { "folder" };
    let finding = RULE.in_layer(view.layers.checked, found.rel, message).key(category);
    finding.help(format!("rename the {what} without `{one}` or `{other}`"))
}
