//! User targets deeper than the application looks for sliders.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Reference};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "packs the targets into its archive, but shows no slider for them",
    )],
    docs: include_str!("user_target_too_deep.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "overlay-user-target-too-deep",
        Level::Warning,
        "user targets too deep to become sliders",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(folder) = base.user_targets else {
        return;
    };
    let used: BTreeSet<&str> = view
        .references_of(base)
        .filter_map(Reference::found)
        .map(|file| file.path.as_str())
        .collect();
    let is_deep = |file: &&FileFacts| {
        folder
            .name_of(file)
            .is_some_and(|name| name.matches('/').count() > 1 || name.starts_with("icons/"))
    };
    let deep: Vec<&FileFacts> = folder
        .targets()
        .filter(is_deep)
        .filter(|file| !used.contains(file.path.as_str()))
        .collect();
    let Some(first) = deep.first() else { return };
    let is_icon = |file: &&FileFacts| {
        folder
            .name_of(file)
            .is_some_and(|name| name.starts_with("icons/"))
    };
    let place = if deep.iter().all(is_icon) {
        "in the icon folder of"
    } else {
        "more than one folder below"
    };
    let (be, have) = if deep.len() == 1 {
        ("is", "has")
    } else {
        ("are", "have")
    };
    let count = counted(deep.len(), "user target");
    let message = format!(
        "{count} {be} {place} `{}` and {have} no slider",
        folder.rel()
    );
    let finding = RULE
        .at(first, Place::File, message)
        .key(base.name)
        .asset(first.root());
    let finding = finding.parts_in(deep.iter().map(|file| (file.shown(), &file.path)));
    let help = format!(
        "move {} to `{}/<group>/`",
        if deep.len() == 1 { "it" } else { "them" },
        folder.rel()
    );
    let evidence =
        Evidence::of_cases(deep.iter().map(|file| file.shown())).out_of(folder.targets().count());
    out.push(finding.help(help).evidence(evidence));
}
