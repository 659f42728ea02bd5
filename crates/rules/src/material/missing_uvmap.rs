//! A map of texture coordinates must exist.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use mhlint_repo::{ReferenceKind, Resolution, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails with `FileNotFoundError` when the material is used",
    )],
    docs: include_str!("missing_uvmap.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-missing-uvmap",
        Level::Error,
        "a material names a map of texture coordinates that does not exist",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = view
        .references()
        .iter()
        .filter(|one| one.kind == ReferenceKind::UvMap);
    for reference in own.filter(|one| view.layers().is_checked(one.from)) {
        let what = match reference.resolution {
            Resolution::Missing => "does not exist",
            Resolution::Unusable => "cannot be opened as a file",
            _ => continue,
        };
        let finding = RULE.at(
            reference.from,
            reference.place.clone(),
            format!("`uvMap {}` {what}", reference.text),
        );
        out.push(
            finding
                .key(reference.text)
                .help("correct the name, add the file, or remove the line"),
        );
    }
}
