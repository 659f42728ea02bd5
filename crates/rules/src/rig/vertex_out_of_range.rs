//! The vertices at which bones end exist.

use super::super::{Check, Rule, RuleCx, such};
use super::ends::{AT_DEFAULT, ends, has_place, is_negative, listed};
use super::{STOPS, at_bones, stops};
use mhlint_diag::{Application::Mpfb, Case, Finding, Grouped, Level, RuleInfo, grouped};
use mhlint_formats::rig::{End, Rig, RigBone};
use mhlint_repo::Worn;
use mhlint_repo::mpfb::{RigFile, RigPart, View};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("vertex_out_of_range.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-vertex-out-of-range",
        Level::Error,
        "a bone ends at a vertex that the mesh does not have",
    )
});

const FROM_THE_END: Case = &[(
    Mpfb,
    Level::Warning,
    "silently counts from the last vertex: the bone ends somewhere else",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let assets = view.worn_anywhere();
    let assets = assets.map(|worn| ((parent(&worn.file.rel), worn.file.stem()), worn));
    let assets: Assets<'_> = grouped(assets);
    for (file, rig) in view.own_rigs() {
        let Some(count) = vertices(view, &assets, file).and_then(|count| i64::try_from(count).ok())
        else {
            continue;
        };
        for key in ["without default", "default", "negative"] {
            let found = ends(rig).filter(|(.., end)| sort(end, count) == Some(key));
            let found: Vec<(&RigBone, &'static str, &End)> = found.collect();
            out.extend(finding(file, rig, &found, key, count));
        }
    }
}

/// The fault of the vertices of an end, which is part of the key of the finding.
fn sort(end: &End, count: i64) -> Option<&'static str> {
    match (is_beyond(end, count), has_place(end)) {
        (true, false) => Some("without default"),
        (true, true) => Some("default"),
        (false, _) => is_negative(end).then_some("negative"),
    }
}

/// Worn assets by folder and name.
type Assets<'a> = Grouped<(&'a str, &'a str), &'a Worn<'a>>;

/// The number of vertices of the mesh that a rig refers to.
fn vertices(view: &View<'_>, assets: &Assets<'_>, file: &RigFile<'_>) -> Option<usize> {
    if file.part != RigPart::Asset {
        let (_, mesh) = view
            .mesh
            .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0)?;
        return Some(mesh.facts.vertices);
    }
    let own = assets.get(&(parent(&file.file.rel), file.file.stem()))?;
    Some(own.first()?.mesh()?.1.facts.vertices)
}

fn is_beyond(end: &End, count: i64) -> bool {
    listed(end).any(|vertex| vertex >= count || vertex < -count)
}

fn finding(
    file: &RigFile<'_>,
    rig: &Rig,
    found: &[(&RigBone, &'static str, &End)],
    key: &'static str,
    count: i64,
) -> Option<Finding> {
    let (bone, which, end) = found.first()?;
    let is_negative = key == "negative";
    let vertex = listed(end).find(|vertex| {
        if is_negative {
            *vertex < 0
        } else {
            *vertex >= count || *vertex < -count
        }
    })?;
    let (more, last) = (such(found.len(), "ends"), count.saturating_sub(1));
    let whose = if file.part == RigPart::Asset {
        "the asset"
    } else {
        "the base mesh"
    };
    let message = if is_negative {
        format!(
            "vertex {vertex} of `{which}` of bone `{}` is negative{more}",
            bone.name
        )
    } else {
        format!(
            "vertex {vertex} of `{which}` of bone `{}` does not exist; {whose} has vertices 0 to \
                {last}{more}",
            bone.name
        )
    };
    let bones: Vec<&str> = found.iter().map(|(bone, ..)| bone.name.as_str()).collect();
    let finding = at_bones(&RULE, file, rig, &bones, which, message)?.key(key);
    let finding = finding.help(format!("name a vertex of {whose}, counted from 0"));
    Some(match key {
        "negative" => finding.case(FROM_THE_END),
        "default" => finding.case(AT_DEFAULT),
        _ => stops(file, finding),
    })
}
