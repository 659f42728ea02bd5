//! Two files are not one target.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_formats::target::name::TargetName;
use mhlint_repo::makehuman1::{NamedTarget, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "applies both: the slider moves twice as far")],
    docs: include_str!("doubled.md").trim_ascii_end(),
    ..RuleInfo::new(
        "target-doubled",
        Level::Warning,
        "two files that are one target",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() || view.targets.is_packed {
        return;
    }
    let used = &view.modifiers.uses;
    let mut first: BTreeMap<&TargetName, &NamedTarget<'_>> = BTreeMap::new();
    for (_, target) in view
        .targets
        .shipped
        .iter()
        .enumerate()
        .filter(|(place, _)| used.contains_key(place))
    {
        let Some(earlier) = first.get(&target.name) else {
            first.insert(&target.name, target);
            continue;
        };
        let message = format!("is the same target as `{}`", earlier.file.rel);
        let finding = RULE.at(target.file, Place::File, message).key("name");
        let finding = finding.related(earlier.file.path.clone(), Place::File, "the other file");
        out.push(finding.help("remove or rename one of them"));
    }
}
