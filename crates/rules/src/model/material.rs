//! Each material line of a model must belong to an asset that the model wears, and name a file that
//! exists.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::offered::Offered;
use super::{makehuman1, own};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhm::MaterialLine;
use mhlint_repo::makehuman2::{Base, SavedModel, View};
use mhlint_repo::{Reference, ReferenceKind, Resolution};
use mhlint_source::{file_name, parent};

pub(crate) static RULE: Rule = Check::EachBase(
    run,
    |view, cx, out| makehuman1::material::faults(&RULE, view, cx, out),
    |_, _, _| {},
)
.rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "silently shows the asset with its default material",
        ),
        (
            Makehuman1,
            "logs an error, and shows the asset with its own material",
        ),
    ],
    docs: include_str!("material.md").trim_ascii_end(),
    ..RuleInfo::new(
        "model-material",
        Level::Warning,
        "a material line of a model without effect",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut offered: BTreeMap<&str, Offered<'_>> = BTreeMap::new();
    for saved in own(view, base) {
        // Lines with an unknown category count as well, since `model-category` reports these. A
        // line without a uuid stops the loader, so that then nothing is reported here.
        let lines = saved.model.worn.iter().chain(&saved.model.unknown);
        let worn: BTreeSet<(&str, &str)> = lines.map(|one| (&*one.name.text, &*one.uuid)).collect();
        let mut by_uuid: BTreeMap<&str, &str> = BTreeMap::new();
        for (name, uuid) in &worn {
            by_uuid.entry(uuid).or_insert(name);
        }
        let fits = |line: &MaterialLine| worn.contains(&(&*line.name.text, &*line.uuid));
        let lost = saved
            .model
            .materials
            .iter()
            .filter(|line| !fits(line) && saved.model.short.is_empty());
        let is_right = |line: &MaterialLine| {
            view.library
                .worn(base.name, &line.name.text, &line.uuid)
                .is_some_and(|asset| asset.uuid == *line.uuid)
        };
        out.extend(lost.map(|line| stray(saved, line, (&worn, &by_uuid), is_right(line))));
        if view.is_open(base) {
            continue;
        }
        let is_missing = |one: &&Reference<'_>| {
            one.kind == ReferenceKind::ModelMaterial
                && matches!(one.resolution, Resolution::Missing)
        };
        let lines = saved.model.materials.iter().filter(|line| fits(line));
        let by_start: BTreeMap<usize, &MaterialLine> =
            lines.map(|line| (line.path.span.start, line)).collect();
        for reference in view.references.of_file(saved.file).filter(is_missing) {
            let Place::Span(span) = &reference.place else {
                continue;
            };
            if let Some(line) = by_start.get(&span.start) {
                let folder = folder(reference);
                let offered = offered
                    .entry(folder)
                    .or_insert_with(|| Offered::below(view, folder));
                out.push(missing(reference, line, offered, cx));
            }
        }
    }
}

/// A finding on a material line whose asset the model does not wear.
fn stray(
    saved: &SavedModel<'_>,
    line: &MaterialLine,
    (worn, by_uuid): (&BTreeSet<(&str, &str)>, &BTreeMap<&str, &str>),
    is_right: bool,
) -> Finding {
    let (name, uuid) = (&*line.name.text, &*line.uuid);
    let same = worn
        .range((name, "")..)
        .next()
        .filter(|(other, _)| *other == name);
    let (message, help) = match same {
        Some(_) if is_right => (
            format!(
                "the model wears `{name}` with another uuid than this one, which is that of the \
                    asset"
            ),
            format!("write `{uuid}` in the line that puts `{name}` on"),
        ),
        Some((_, other)) => (
            format!("the uuid differs from that in the line that puts on `{name}`"),
            format!("write `{other}` in place of `{uuid}`"),
        ),
        None => {
            let renamed = by_uuid.get(uuid);
            let help = renamed.map_or_else(
                || "remove the line, or put the asset on with a line of its own".to_owned(),
                |other| format!("write `{other}` in place of `{name}`"),
            );
            (format!("the model wears no asset `{name}`"), help)
        }
    };
    let finding = RULE
        .at(saved.file, Place::Span(line.name.span.clone()), message)
        .key(format!("stray {name} {uuid}"));
    let finding = if same.is_some() {
        finding
    } else {
        finding.effect("silently ignores the line")
    };
    finding.help(help)
}

/// The folder of the asset that a material line is for.
fn folder<'r>(reference: &'r Reference<'_>) -> &'r str {
    reference
        .rel
        .strip_suffix(reference.text)
        .unwrap_or(parent(&reference.rel))
        .trim_end_matches('/')
}

fn missing(
    reference: &Reference<'_>,
    line: &MaterialLine,
    offered: &Offered<'_>,
    cx: &RuleCx<'_>,
) -> Finding {
    let near = offered.by_last.get(file_name(reference.text)).copied();
    let near = near.or_else(|| {
        cx.suggestions
            .nearest_file(reference.text, offered.names.iter().copied())
    });
    let folder = offered.folder;
    let (message, help) = if line.surplus == 0 {
        let help = did_you_mean(
            near,
            format!("name a material in `{folder}`, or remove the line"),
        );
        (
            format!(
                "material `{}` of `{}` does not exist",
                reference.text, line.name.text
            ),
            help,
        )
    } else {
        let message = format!(
            "the path has a space and is cut there: `{}` does not exist",
            reference.text
        );
        (
            message,
            "rename the material without spaces, and write the new name here".to_owned(),
        )
    };
    RULE.at(reference.from, reference.place.clone(), message)
        .key(format!("file {}", line.name.text))
        .help(help)
}
