//! The catalogue of MPFB must name targets that exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, counted, such};
use super::neighbours::Neighbours;
use super::{checked, forgotten_ends, leftovers, sliders};
use mhlint_diag::{
    Application::Mpfb, Evidence, Finding, Grouped, Level, Place, RuleInfo, grouped, steps,
};
use mhlint_repo::mpfb::View;
use mhlint_repo::{Reference, ReferenceKind, Resolution};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails when the slider moves: the slider jumps back, and only the console shows why",
    )],
    docs: include_str!("missing_target.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-missing-target",
        Level::Error,
        "a slider of `target.json` names a target that does not exist",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    let neighbours = Neighbours::of(view, &catalog);
    // A slider without its two ends has a finding of its own.
    let forgotten: BTreeSet<&str> = sliders(&catalog)
        .filter(|(section, category)| forgotten_ends(&catalog, section, category).is_some())
        .map(|(_, category)| category.name.as_str())
        .collect();
    let is_told = |one: &&Reference<'_>| {
        one.kind == ReferenceKind::SliderName && forgotten.contains(one.owner)
    };
    // What materials and assets name has rules of its own.
    let is_lost = |one: &&Reference<'_>| {
        one.kind.is_target() && matches!(one.resolution, Resolution::Missing) && !is_told(one)
    };
    let missing = view.references.iter().filter(is_lost);
    let folders: BTreeSet<&str> = catalog.layer.files.keys().map(|rel| parent(rel)).collect();
    let by_cause = grouped(missing.map(|reference| (cause(&folders, reference), reference)));
    let by_cause = many_of_folder(by_cause);
    out.extend(
        by_cause
            .into_iter()
            .filter_map(|(cause, references)| told(&cause, &references, &neighbours)),
    );
    let sections = catalog.sliders.sections.iter();
    out.extend(sections.filter_map(|section| leftovers::finding(&RULE, &catalog, section)));
}

/// What several references are missing for: a folder with nothing in it, a slider with empty slots,
/// or one file.
fn cause(folders: &BTreeSet<&str>, reference: &Reference<'_>) -> String {
    let folder = parent(&reference.rel);
    if !folders.contains(folder) {
        folder.to_owned()
    } else if reference.text.is_empty() {
        reference.owner.to_owned()
    } else {
        reference.rel.clone()
    }
}

/// Files of one folder from which on they are missing for one cause.
const MANY: usize = 4;

/// Many files of one folder are one cause.
fn many_of_folder<'r, 'a>(
    by_cause: Grouped<String, &'r Reference<'a>>,
) -> Grouped<String, &'r Reference<'a>> {
    let folder = |cause: &str, references: &[&Reference<'_>]| {
        let rel = &references.first()?.rel;
        (cause == rel).then(|| parent(rel).to_owned())
    };
    let by_folder = grouped(
        by_cause
            .iter()
            .filter_map(|(cause, references)| Some((folder(cause, references)?, cause))),
    );
    let many: BTreeSet<String> = by_folder
        .iter()
        .filter(|(_, causes)| causes.len() >= MANY)
        .map(|(folder, _)| format!("{folder}/"))
        .collect();
    let merged = by_cause.into_iter().flat_map(|(cause, references)| {
        let folder = folder(&cause, &references)
            .map(|folder| format!("{folder}/"))
            .filter(|one| many.contains(one));
        let cause = folder.unwrap_or(cause);
        references.into_iter().map(move |one| (cause.clone(), one))
    });
    grouped(merged)
}

fn told(
    cause: &str,
    references: &[&Reference<'_>],
    neighbours: &Neighbours<'_, '_>,
) -> Option<Finding> {
    let (first, count) = (references.first()?, references.len());
    let owner = first.owner;
    let message = if let Some(folder) = cause.strip_suffix('/') {
        let files: BTreeSet<&str> = references.iter().map(|one| one.rel.as_str()).collect();
        format!(
            "{} targets of `{folder}` that sliders use do not exist, first `{}`",
            files.len(),
            first.text
        )
    } else if cause == parent(&first.rel) {
        format!(
            "`{cause}` contains no targets, but sliders use {} from it",
            counted(count, "target")
        )
    } else if first.text.is_empty() {
        let slot = slot_of(&first.place);
        let more = such(count, "slots");
        format!("`{slot}` of `{owner}` has no target{more}")
    } else if count > 1 {
        format!(
            "`{}` does not exist, but sliders use it {count} times",
            first.rel
        )
    } else {
        format!("`{owner}` uses `{}`, which does not exist", first.rel)
    };
    let finding = RULE
        .at(first.from, first.place.clone(), message)
        .key(cause)
        .help(neighbours.help(first));
    Some(
        finding.evidence(Evidence::of_cases(
            references
                .iter()
                .map(|one| format!("{} {}", one.owner, one.rel)),
        )),
    )
}

/// The key of a slot.
fn slot_of(place: &Place) -> String {
    let Place::Pointer(pointer) = place else {
        return String::new();
    };
    steps(pointer).last().unwrap_or_default()
}
