//! A target has a name besides values of macros.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "never reads it: no modifier can name it")],
    docs: include_str!("without_group.md").trim_ascii_end(),
    ..RuleInfo::new(
        "target-without-group",
        Level::Warning,
        "a target without a name of its own",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() || view.targets.is_packed {
        return;
    }
    let bare = view
        .targets
        .of_group("")
        .iter()
        .filter_map(|place| view.targets.at(*place));
    out.extend(bare.filter(|target| target.name.is_macro()).map(|target| {
        let message = "its path has nothing but values of macros";
        RULE.at(target.file, Place::File, message)
            .help("add a word to its name and a modifier for it, or keep it outside of the data")
    }));
}
