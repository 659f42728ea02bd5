//! `icon` must name a picture that exists.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::missing;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, RuleInfo};
use mhlint_repo::ReferenceKind;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "shows a button of zero size, which cannot be clicked",
    )],
    docs: include_str!("missing_icon.md").trim_ascii_end(),
    counts: "icons",
    ..RuleInfo::new(
        "modelling-missing-icon",
        Level::Warning,
        "`icon` names a picture that does not exist",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // The sliders of another base are one fault (`modelling-missing-target`).
    if base.has_foreign_sliders() {
        return;
    }
    for group in missing::groups(view, base, |kind| kind == ReferenceKind::Icon) {
        let Some(first) = group.references.first() else {
            continue;
        };
        // Written anew by MakeHuman 2 whenever a target or a picture changes.
        if base
            .user_modelling
            .file()
            .is_some_and(|file| std::ptr::eq(file, first.from))
        {
            continue;
        }
        let (message, key) = match &group.folder {
            Some(folder) => (
                format!(
                    "`{folder}` is missing or empty, but {} icons are read from it",
                    group.references.len()
                ),
                &**folder,
            ),
            None => (
                format!("icon `{}` of `{}` does not exist", first.text, first.owner),
                first.owner,
            ),
        };
        let near = missing::nearest(view, first, &cx.suggestions);
        let help = did_you_mean(
            near,
            "add the picture, or remove `icon` to get the neutral one",
        );
        let evidence = Evidence::of_cases(group.references.iter().map(|reference| reference.text));
        out.push(
            RULE.at(first.from, first.place.clone(), message)
                .key(key)
                .help(help)
                .evidence(evidence),
        );
    }
}
