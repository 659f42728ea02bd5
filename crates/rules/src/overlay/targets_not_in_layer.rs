//! Targets that exist only in the layer that lost.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, are, counted};
use super::{has_misnamed_override, in_other_layer, lacks_folder};
use mhlint_diag::{Application::Makehuman2, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::Reference;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "cannot load the targets and crashes with `AttributeError`: at start if the default \
         character uses one, otherwise as soon as a slider uses one",
    )],
    docs: include_str!("targets_not_in_layer.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "overlay-targets-not-in-layer",
        Level::Error,
        "targets that exist only in the folder that is not in use",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // A macro.json that is rejected is the cause, and `overlay-broken-override` says so; without
    // any folder to load from the program does not get as far as the targets
    // (`overlay-partial-override`).
    if base.macros.contarget.is_refused()
        || has_misnamed_override(view, base)
        || lacks_folder(view, base)
    {
        return;
    }
    let lost: Vec<&Reference<'_>> = in_other_layer(view, base).collect();
    let (Some(used), Some(other)) = (base.targets, base.other_targets) else {
        return;
    };
    if lost.is_empty() {
        return;
    }
    let count = lost
        .iter()
        .map(|lost| lost.rel.as_str())
        .collect::<BTreeSet<_>>()
        .len();
    let message = format!(
        "{} {} not in `{}`, the folder in use, but only in `{}`",
        counted(count, "target"),
        are(count),
        used.layer.display(&used.rel()),
        other.layer.display(&other.rel()),
    );
    let mut finding = finding_where_to_act(view, base, &lost, message).key(base.name);
    finding = finding.asset(&view.layers.checked.path);
    for reference in lost.iter().take(EXAMPLES) {
        let text = format!("needs `{}`", reference.rel);
        finding = finding.related(reference.from.path.clone(), reference.place.clone(), text);
    }
    let targets = view
        .references_of(base)
        .filter(|reference| reference.kind.is_target());
    let of = targets
        .map(|reference| reference.rel.as_str())
        .collect::<BTreeSet<_>>()
        .len();
    let cases: BTreeSet<&str> = lost.iter().map(|lost| lost.rel.as_str()).collect();
    out.push(finding.evidence(Evidence::of_cases(cases).out_of(of)));
}

/// At the `macro.json` that moved the folder, or at the sliders that count on a folder nothing
/// moved to.
fn finding_where_to_act(
    view: &View<'_>,
    base: &Base<'_>,
    lost: &[&Reference<'_>],
    message: String,
) -> Finding {
    if let Some((file, _)) = base.macros.contarget.accepted() {
        let help = "copy the missing targets to contarget: its macro.json makes it the folder for \
            all targets";
        let first = lost
            .iter()
            .find(|reference| std::ptr::eq(reference.from, file));
        let place = first.map_or_else(
            || Place::key(["macrodef"]),
            |reference| reference.place.clone(),
        );
        return RULE.at(file, place, message).help(help);
    }
    let help = "add a macro.json to contarget, such as that of the system data: without it, \
        contarget's targets are not read";
    if let Some(first) = lost
        .iter()
        .find(|reference| view.layers.is_checked(reference.from))
    {
        return RULE.at(first.from, first.place.clone(), message).help(help);
    }
    let folder = base.other_targets.or(base.targets);
    let rel = folder.map(|folder| folder.rel()).unwrap_or_default();
    RULE.in_layer(view.layers.checked, &rel, message).help(help)
}
