//! User targets deeper than the application looks for sliders.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, counted};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};
use crate::repo::{FileFacts, Resolution};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "packs the targets into its archive but offers no slider for them")],
        docs: "For the user's own targets MakeHuman 2 makes sliders from the files in `target/<base>/` and in the folders \
            directly below it. It does not look deeper. Files further down are still read and packed at every start, and a \
            malformed one still stops the program, but no slider moves them. The folder `icons` is for pictures: no sliders are \
            made of targets in it either.\n\nMove the files up: one folder level below \
            `target/<base>/` is one group of sliders.",
        ..RuleInfo::new("overlay-user-target-too-deep", Level::Warning, "user targets too deep to become sliders")
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(folder) = base.user_targets else { return };
    let used: BTreeSet<&str> = view
        .references_of(base)
        .filter_map(|reference| if let Resolution::Found(file) = reference.resolution { Some(file) } else { None })
        .map(|file| file.path.as_str())
        .collect();
    let is_deep = |file: &&FileFacts| {
        folder.name_of(file).is_some_and(|name| name.matches('/').count() > 1 || name.starts_with("icons/"))
    };
    let deep: Vec<&FileFacts> =
        folder.targets().filter(is_deep).filter(|file| !used.contains(file.path.as_str())).collect();
    let Some(first) = deep.first() else { return };
    let is_icon = |file: &&FileFacts| folder.name_of(file).is_some_and(|name| name.starts_with("icons/"));
    let place = if deep.iter().all(is_icon) { "among the icons of" } else { "deeper than one folder below" };
    let message = format!(
        "{} {place} `{}`: no slider is made for {}",
        counted(deep.len(), "user target"),
        folder.rel(),
        if deep.len() == 1 { "it" } else { "them" },
    );
    let finding = RULE.at(first, Place::File, message).key(base.name).asset(first.root());
    let finding = finding.parts_in(deep.iter().map(|file| (file.shown(), &file.path)));
    let help = format!("move them to `{}/<group>/`", folder.rel());
    let evidence = Evidence::of_cases(deep.iter().map(|file| file.shown())).out_of(folder.targets().count());
    out.push(finding.help(help).evidence(evidence));
}
