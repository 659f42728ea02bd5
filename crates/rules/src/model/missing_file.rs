//! Skins and skeletons that models name and that do not exist.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Rule, RuleCx, did_you_mean};
use super::own;
use mhlint_diag::{EXAMPLES, Evidence, Finding, grouped};
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Reference, ReferenceKind, Resolution};
use mhlint_source::{depth, file_name};

/// Findings on the models of a base mesh. A missing file is one mistake, in however many models it
/// is named.
pub(super) fn faults(
    rule: &Rule,
    view: &View<'_>,
    base: &Base<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    let is_missing = |one: &&Reference<'_>| matches!(one.resolution, Resolution::Missing);
    // The skeleton for poses, if it is missing, is reported by `base-missing-file`.
    let told: BTreeSet<&str> = base
        .named
        .iter()
        .filter(is_missing)
        .map(|one| one.rel.as_str())
        .collect();
    let missing = own(view, base)
        .flat_map(|saved| view.references.of_file(saved.file))
        .filter(is_missing)
        .filter(|one| one.base == base.name && !told.contains(one.rel.as_str()));
    let by_file = grouped(missing.map(|one| ((one.kind, one.rel.as_str()), one)));
    if by_file.is_empty() {
        return;
    }
    let shelves = [
        Shelf::of(view, base, "skin", "skins", ".mhmat"),
        Shelf::of(view, base, "skeleton", "rigs", ".mhskel"),
    ];
    let [skins, skeletons] = &shelves;
    out.extend(by_file.into_values().filter_map(|references| {
        let shelf = match references.first()?.kind {
            ReferenceKind::Skin => skins,
            ReferenceKind::ModelSkeleton => skeletons,
            _ => return None,
        };
        finding(rule, shelf, &references, cx)
    }));
}

/// The folder in which a model looks for files of a sort, with what is there.
struct Shelf<'v> {
    what: &'static str,
    rel: String,
    /// Files of the sort, as a model names them.
    names: Vec<&'v str>,
    /// The first file of each name in a folder of its own.
    deeper: BTreeMap<&'v str, &'v FileFacts>,
}

impl<'v> Shelf<'v> {
    fn of(
        view: &'v View<'_>,
        base: &Base<'_>,
        what: &'static str,
        folder: &str,
        suffix: &str,
    ) -> Self {
        let rel = format!("{folder}/{}", base.name);
        let (mut names, mut deeper) = (Vec::new(), BTreeMap::new());
        for file in view
            .layers
            .strongest_first()
            .flat_map(|layer| layer.below(&rel))
        {
            let below = file.rel.strip_prefix(&rel);
            let below = below.and_then(|below| below.strip_prefix('/'));
            names.extend(below.filter(|below| below.ends_with(suffix)));
            if depth(&file.rel) > 3 {
                deeper.entry(file.file_name()).or_insert(file);
            }
        }
        Self {
            what,
            rel,
            names,
            deeper,
        }
    }

    fn help(&self, reference: &Reference<'_>, cx: &RuleCx<'_>) -> String {
        let rel = &self.rel;
        let name = file_name(reference.text);
        if let Some(file) = self.deeper.get(name).filter(|_| self.what == "skeleton") {
            return format!(
                "move `{}` to `{rel}`: a model finds skeletons only there",
                file.rel
            );
        }
        let own = reference
            .rel
            .strip_prefix(rel)
            .unwrap_or(reference.text)
            .trim_start_matches('/');
        let near = cx.suggestions.nearest_file(own, self.names.iter().copied());
        did_you_mean(
            near,
            format!("add the file to `{rel}`, or name one that exists"),
        )
    }
}

fn finding(
    rule: &Rule,
    shelf: &Shelf<'_>,
    references: &[&Reference<'_>],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let reference = references.first()?;
    let what = shelf.what;
    let more = if references.len() > 1 {
        format!(" ({} models)", references.len())
    } else {
        String::new()
    };
    let message = format!("{what} `{}` does not exist{more}", reference.rel);
    let mut finding = rule
        .at(reference.from, reference.place.clone(), message)
        .key(reference.text)
        .help(shelf.help(reference, cx));
    for other in references.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(other.from.path.clone(), other.place.clone(), "also here");
    }
    let parts = references
        .iter()
        .map(|one| (one.from.shown(), &one.from.path, one.place.clone()));
    let finding = finding.parts_at(parts);
    let finding = finding.evidence(Evidence::of_cases(
        references.iter().map(|one| one.from.shown()),
    ));
    Some(finding.effect(match what {
        "skin" => "silently shows the default skin",
        _ => "silently loads the model without a skeleton",
    }))
}
