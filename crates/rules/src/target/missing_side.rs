//! What is made for the left is made for the right.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use super::endings::Endings;
use super::{asked_for, parent};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_eval::side;
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Reference};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "offers a slider for one side only, which symmetry cannot mirror",
    )],
    docs: include_str!("missing_side.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "target-missing-side",
        Level::Warning,
        "a target has no left/right counterpart",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let unused: BTreeSet<&str> = view
        .unused(base)
        .iter()
        .map(|file| file.path.as_str())
        .collect();
    let asked = asked_for(view, base);
    let paired = paired(view, base);
    let endings = Endings::of(base, Some(("decr", "incr")));
    let mut lone: BTreeMap<(&str, String), Vec<(&FileFacts, String)>> = BTreeMap::new();
    for file in view.own_targets(base) {
        let Some((_, partner)) = side::of_target(file.stem()) else {
            continue;
        };
        let folder = parent(&file.rel);
        let rel = format!("{folder}/{partner}.target");
        let exists = view.layers.checked.file(&rel).is_some()
            || view.layers.checked.file_ignoring_case(&rel).is_some();
        // A partner that a slider asks for is a missing file; a target that nothing uses has
        // nothing to mirror.
        let is_lone =
            !exists && !unused.contains(file.path.as_str()) && !asked.contains(rel.as_str());
        if is_lone && !paired.contains(file.path.as_str()) {
            lone.entry((folder, without_ending(&endings, &partner)))
                .or_default()
                .push((file, partner));
        }
    }
    out.extend(
        lone.iter()
            .filter_map(|((_, stem), files)| finding(stem, files)),
    );
}

/// Printed paths of the targets whose sliders name a partner that is there: symmetry goes by these
/// names.
fn paired<'v>(view: &'v View<'_>, base: &'v Base<'_>) -> BTreeSet<&'v str> {
    let has_partner = |key: &str| {
        let slider = base.entry(key).map(|bound| bound.slider);
        let partner = slider.and_then(|slider| slider.lsym.as_deref().or(slider.rsym.as_deref()));
        partner.is_some_and(|partner| base.slider(partner).is_some())
    };
    let references = view
        .references_of(base)
        .filter(|one| one.kind.is_target() && has_partner(one.owner));
    references
        .filter_map(Reference::found)
        .map(|file| file.path.as_str())
        .collect()
}

/// Both halves of a slider lack their partners for one reason.
fn finding(stem: &str, files: &[(&FileFacts, String)]) -> Option<Finding> {
    let (first, partner) = files.first()?;
    let message = match files {
        [_] => format!("`{}` has no counterpart `{partner}`", first.stem()),
        _ => format!(
            "{} targets have no left/right counterpart, first missing `{}`",
            files.len(),
            partner
        ),
    };
    let mut finding = RULE
        .at(first, Place::File, message)
        .key(stem)
        .asset(first.folder());
    finding = finding.parts_in(files.iter().map(|(file, partner)| (partner, &file.path)));
    for (file, partner) in files.iter().skip(1) {
        finding = finding.related(
            &file.path,
            Place::File,
            format!("`{partner}` is also missing"),
        );
    }
    let evidence = Evidence::of_cases(files.iter().map(|(_, partner)| partner));
    Some(
        finding
            .help("mirror the target and save it under the name of its counterpart")
            .evidence(evidence),
    )
}

fn without_ending(endings: &Endings<'_>, stem: &str) -> String {
    let split = endings.split(stem);
    split.map_or(stem, |(begin, ..)| begin).to_owned()
}
