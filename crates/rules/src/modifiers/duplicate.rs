//! A name has one modifier.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::LOST_FILE;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, LOST_FILE)],
    docs: include_str!("duplicate.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-duplicate",
        Level::Error,
        "two modifiers with one name",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.layers.checks_system() {
        let mut first: BTreeMap<&str, (&FileFacts, &str)> = BTreeMap::new();
        for one in &view.modifiers.all {
            let pointer = one.modifier.pointer.as_str();
            let Some((file, earlier)) = first.get(one.name.as_str()) else {
                first.insert(&one.name, (one.file, pointer));
                continue;
            };
            let message = format!("modifier `{}` exists already", one.name);
            let finding = RULE
                .at(one.file, Place::Pointer(pointer.to_owned()), message)
                .key(&one.name);
            let finding = finding.related(
                file.path.clone(),
                Place::Pointer((*earlier).to_owned()),
                "the first of that name",
            );
            out.push(finding.help("remove one of them"));
        }
        return;
    }
    let mut first: BTreeMap<&str, &FileFacts> = BTreeMap::new();
    for one in view
        .targets
        .custom
        .iter()
        .filter(|one| view.layers.is_checked(one.file))
    {
        let Some(earlier) = first.get(one.name.as_str()) else {
            first.insert(&one.name, one.file);
            continue;
        };
        let message = format!("has the name `{}`, like `{}`", one.name, earlier.rel);
        let finding = RULE.at(one.file, Place::File, message).key(&one.name);
        let finding = finding.related(earlier.path.clone(), Place::File, "the other target");
        out.push(
            finding
                .effect("shows no sliders for the user's own targets")
                .help("rename one of the files"),
        );
    }
}
