//! Each material line stands below the line that puts its asset on, and names a file that exists.

use std::collections::{BTreeMap, BTreeSet};

use super::super::super::{Rule, RuleCx, did_you_mean};
use super::own;
use mhlint_diag::{Finding, Place};
use mhlint_formats::mhm::{CATEGORIES, Word};
use mhlint_repo::makehuman1::{SavedModel, View, material, uuid_of};
use mhlint_repo::{FileFacts, Reference, ReferenceKind, Resolution};
use mhlint_source::parent;

pub(in super::super) fn faults(
    rule: &Rule,
    view: &View<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    let shared = shared_uuids(view);
    let mut offered: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for model in own(view) {
        out.extend(astray(rule, model));
        if view.layers.system.is_none() {
            continue;
        }
        let lines = model
            .lines
            .all
            .iter()
            .filter(|line| &*line.keyword.text == "material")
            .filter_map(material);
        let unsure: BTreeSet<&str> = lines
            .filter(|(_, uuid, _)| shared.contains(*uuid))
            .map(|(.., path)| &*path.text)
            .collect();
        let named = view
            .references
            .of_file(model.file)
            .filter(|one| one.kind == ReferenceKind::ModelMaterial);
        let missing = named.filter(|one| {
            matches!(one.resolution, Resolution::Missing) && !unsure.contains(one.text)
        });
        for one in missing {
            let folder = parent(&one.rel);
            let below = offered
                .entry(folder)
                .or_insert_with(|| materials_below(view, folder));
            out.push(unfound(rule, one, below, cx));
        }
    }
}

/// The uuids that several assets have. It is not known which of the assets a material line means
/// then; another rule reports the uuid.
fn shared_uuids<'v>(view: &'v View<'_>) -> BTreeSet<&'v str> {
    let mut seen = BTreeSet::new();
    view.worn()
        .iter()
        .filter_map(uuid_of)
        .filter(|uuid| !seen.insert(*uuid))
        .collect()
}

/// Findings on material lines whose asset the model does not wear, or puts on only further below.
fn astray(rule: &Rule, model: &SavedModel<'_>) -> Vec<Finding> {
    let lines = &model.lines.all;
    let worn = lines
        .iter()
        .enumerate()
        .filter(|(_, line)| CATEGORIES.contains(&&*line.keyword.text));
    let (mut by_uuid, mut by_name) = (BTreeMap::new(), BTreeMap::new());
    for (at, line) in worn {
        let ends = by_uuid.entry(line.value(1)).or_insert((at, at));
        ends.1 = at;
        by_name.entry(line.value(0)).or_insert(line);
    }
    let mut found = Vec::new();
    for (at, line) in lines
        .iter()
        .enumerate()
        .filter(|(_, line)| &*line.keyword.text == "material")
    {
        let Some((_, uuid, path)) = material(line) else {
            continue;
        };
        let ends = by_uuid.get(uuid);
        if ends.is_some_and(|(first, _)| *first < at) {
            continue;
        }
        let later = ends.is_some_and(|(_, last)| *last > at);
        let name = if line.values.len() > 2 {
            line.value(0)
        } else {
            uuid
        };
        let (message, help) = match by_name.get(name) {
            _ if later => (
                format!("the material of `{name}` stands above the line that puts it on"),
                "move the line below it".to_owned(),
            ),
            Some(worn) => (
                format!("the uuid differs from that in the line that puts on `{name}`"),
                format!("write `{}` in place of `{uuid}`", worn.value(1)),
            ),
            None => (
                format!("the model does not wear `{name}`"),
                "remove the line, or put the asset on with a line of its own".to_owned(),
            ),
        };
        found.push(
            at_word(rule, model, line.values.first().unwrap_or(path), message)
                .key(format!("stray {uuid}"))
                .help(help),
        );
    }
    found
}

fn at_word(rule: &Rule, model: &SavedModel<'_>, word: &Word, message: String) -> Finding {
    rule.at(model.file, Place::Span(word.span.clone()), message)
}

/// The names of the materials below a folder.
fn materials_below<'v>(view: &View<'v>, folder: &str) -> Vec<&'v str> {
    let layers = view.layers.strongest_first();
    let files = layers.flat_map(|layer| layer.below(folder));
    let materials = files.filter(|file| file.rel.ends_with(".mhmat"));
    materials.map(FileFacts::file_name).collect()
}

fn unfound(rule: &Rule, reference: &Reference<'_>, names: &[&str], cx: &RuleCx<'_>) -> Finding {
    let near = cx
        .suggestions
        .nearest_file(reference.text, names.iter().copied());
    let message = format!(
        "material `{}` of `{}` does not exist",
        reference.text, reference.owner
    );
    let finding = rule
        .at(reference.from, reference.place.clone(), message)
        .key(format!("file {}", reference.owner));
    let finding =
        finding.effect("logs an error, and shows the asset with the default white material");
    finding.help(did_you_mean(
        near,
        "name a material that exists, or remove the line",
    ))
}
