//! Names of user targets, and patterns, must not hold a space.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, counted};
use super::groups;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View, user_scan};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `ValueError` when it loads a model that was saved with the slider moved",
    )],
    docs: include_str!("blank_in_name.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "modelling-blank-in-name",
        Level::Error,
        "the name of a user target contains a space",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    user_files(base, out);
    patterns(base, out);
}

fn user_files(base: &Base<'_>, out: &mut Vec<Finding>) {
    let mut folders: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for target in user_scan::targets(base) {
        if let Some(folder) = target.folder.filter(|folder| has_blank(folder)) {
            folders.entry(folder).or_default().push(target.stem);
        } else if has_blank(target.stem) {
            let message = format!("user target `{}` has a space in its name", target.stem);
            out.push(
                RULE.at(target.file, Place::File, message)
                    .key(target.stem)
                    .help(rename(target.stem)),
            );
        }
    }
    let Some(user) = base.user_targets else {
        return;
    };
    for (folder, stems) in folders {
        let message = format!(
            "folder `{folder}` of {} has a space in its name",
            counted(stems.len(), "user target")
        );
        let finding = RULE.in_layer(user.layer, &format!("{}/{folder}", user.rel()), message);
        out.push(
            finding
                .key(folder)
                .help(rename(folder))
                .evidence(Evidence::of_cases(stems)),
        );
    }
}

/// Patterns of hand-made entries; those of generated ones come from file names.
fn patterns(base: &Base<'_>, out: &mut Vec<Finding>) {
    for slider in groups::hand_made(base).filter(|slider| !slider.slider.user) {
        let Some(pattern) = slider.pattern.names().iter().find(|name| has_blank(name)) else {
            continue;
        };
        let key = slider.slider.key.as_str();
        let message = format!("pattern `{pattern}` of `{key}` contains a space");
        out.push(
            RULE.at(slider.file, Place::key([key]), message)
                .key(key)
                .help(format!(
                    "rename the file of the target, then {}",
                    rename(pattern).replacen("rename it to", "write", 1)
                )),
        );
    }
}

fn has_blank(name: &str) -> bool {
    name.contains(char::is_whitespace)
}

fn rename(name: &str) -> String {
    format!(
        "rename it to `{}`",
        name.split_whitespace().collect::<Vec<_>>().join("-")
    )
}
