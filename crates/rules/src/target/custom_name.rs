//! Saved models find the user's own targets.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::makehuman1::{CustomTarget, View};
use mhlint_source::file_name;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "loses the value of the slider in saved models")],
    docs: include_str!("custom_name.md").trim_ascii_end(),
    ..RuleInfo::new(
        "target-custom-name",
        Level::Warning,
        "a blank in the name of a user's target",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = view
        .targets
        .custom
        .iter()
        .filter(|one| view.layers.is_checked(one.file));
    let blank = own.filter(|one| has_blank(&one.name));
    for (folder, targets) in grouped(blank.map(|one| (blank_folder(&one.file.rel), one))) {
        match folder {
            Some(folder) => out.push(in_folder(view, folder, &targets)),
            None => out.extend(targets.into_iter().map(alone)),
        }
    }
}

fn alone(one: &CustomTarget<'_>) -> Finding {
    let message = format!("`{}` has a blank in its name", one.name);
    RULE.at(one.file, Place::File, message)
        .help(format!("rename it to `{}`", dashed(one.file.file_name())))
}

/// However many targets are in it, one name is at fault.
fn in_folder(view: &View<'_>, folder: &str, targets: &[&CustomTarget<'_>]) -> Finding {
    let count = counted(targets.len(), "target");
    let finding = RULE.in_layer(
        view.layers.checked,
        folder,
        format!("folder `{folder}` of {count} has a blank in its name"),
    );
    let finding = finding
        .key(folder)
        .parts_in(targets.iter().map(|one| (one.file.shown(), &one.file.path)));
    let finding = finding.evidence(Evidence::of_cases(
        targets.iter().map(|one| one.file.shown()),
    ));
    let right = dashed(file_name(folder));
    let below = |one: &&CustomTarget<'_>| one.file.rel.get(folder.len()..).is_some_and(has_blank);
    let more = if targets.iter().any(below) {
        ", and what is in it without blanks, too"
    } else {
        ""
    };
    finding.help(format!("rename it to `{right}`{more}"))
}

/// The first folder of a path with a blank in its name.
fn blank_folder(rel: &str) -> Option<&str> {
    let ends = rel.match_indices('/').filter_map(|(end, _)| rel.get(..end));
    ends.into_iter().find(|folder| has_blank(folder))
}

fn has_blank(name: &str) -> bool {
    name.contains(char::is_whitespace)
}

fn dashed(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("-")
}
