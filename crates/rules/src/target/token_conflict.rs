//! A path has one value of each category.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use mhlint_repo::makehuman1::{PathClash, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "shows no modelling sliders at all: looking for targets ends with `RuntimeError`",
    )],
    docs: include_str!("token_conflict.md").trim_ascii_end(),
    ..RuleInfo::new(
        "target-token-conflict",
        Level::Error,
        "a path with two values of one category",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.layers.checks_system() {
        out.extend(
            view.targets
                .clashes
                .iter()
                .map(|clash| finding(view, clash)),
        );
    }
}

fn finding(view: &View<'_>, found: &PathClash<'_>) -> Finding {
    let clash = found.clash;
    let (category, one, other) = (clash.category, clash.first, clash.second);
    let message = format!(
        "`{}` has `{one}` and `{other}`, two values of one category ({category})",
        found.rel
    );
    let what = if found.file.is_some() {
        "target"
    } else {
        "folder"
    };
    let finding = RULE
        .in_layer(view.layers.checked, found.rel, message)
        .key(category);
    finding.help(format!("rename the {what} without `{one}` or `{other}`"))
}
