//! Bone collections are declared before bones are put into them.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::{STOPS, at_bones, stops, subject};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::rig::{Rig, RigBone};
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("unknown_collection.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-unknown-collection",
        Level::Error,
        "a bone collection that the rig does not declare",
    )
});

const EMPTY: Case = &[(
    Mpfb,
    Level::Warning,
    "silently makes an empty reference of it",
)];
/// Blender keeps this many bytes of a name.
const LONGEST: usize = 63;

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let declared: BTreeSet<&str> = rig.collections.iter().map(String::as_str).collect();
        let is_known = |name: &String| declared.contains(name.as_str()) && name.len() <= LONGEST;
        let of_bones = rig
            .bones
            .iter()
            .flat_map(|bone| bone.collections.iter().map(move |name| (bone, name)));
        let unknown: Vec<(&RigBone, &String)> =
            of_bones.filter(|(_, name)| !is_known(name)).collect();
        out.extend(of_bone(file, rig, &unknown, cx).map(|finding| stops(file, finding)));
        out.extend(in_panel(file, rig, cx).map(|finding| stops(file, finding)));
        let references = rig
            .bones
            .iter()
            .flat_map(|bone| &bone.collection_references);
        let lost: Vec<&(String, String)> = references
            .filter(|(_, name)| !declared.contains(name.as_str()))
            .collect();
        out.extend(reference(file, rig, &lost, cx));
    }
}

fn of_bone(
    file: &RigFile<'_>,
    rig: &Rig,
    unknown: &[(&RigBone, &String)],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let (bone, name) = unknown.first()?;
    let more = such(unknown.len(), "entries");
    let message = if name.len() > LONGEST {
        format!(
            "the name of a collection of bone `{}` has {} bytes, more than {LONGEST}{more}",
            bone.name,
            name.len()
        )
    } else {
        format!(
            "collection `{name}` of bone `{}` is not declared{more}",
            bone.name
        )
    };
    let mut bones: Vec<&str> = unknown.iter().map(|(bone, _)| bone.name.as_str()).collect();
    bones.dedup();
    Some(
        at_bones(&RULE, file, rig, &bones, "collections", message)?
            .key("bone")
            .help(help(rig, name, cx)),
    )
}

fn in_panel(file: &RigFile<'_>, rig: &Rig, cx: &RuleCx<'_>) -> Option<Finding> {
    let all = &rig.faults.panel_collections;
    let (pointer, name) = all.first()?;
    let message = format!(
        "collection `{name}` of `rigify_ui` is not declared{}",
        such(all.len(), "collections")
    );
    let finding = RULE
        .at(file.file, Place::Key(pointer.clone()), message)
        .key("panel")
        .help(help(rig, name, cx));
    Some(finding.evidence(Evidence::of_cases(all.iter().map(|(_, name)| name))))
}

fn reference(
    file: &RigFile<'_>,
    rig: &Rig,
    lost: &[&(String, String)],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let (pointer, name) = lost.first()?;
    let message = format!(
        "collection `{name}` in {} is not declared{}",
        subject(pointer),
        such(lost.len(), "references")
    );
    let finding = RULE
        .at(file.file, Place::Pointer(pointer.clone()), message)
        .key("reference")
        .case(EMPTY);
    Some(
        finding
            .help(help(rig, name, cx))
            .evidence(Evidence::of_cases(lost.iter().map(|(pointer, _)| pointer))),
    )
}

fn help(rig: &Rig, name: &str, cx: &RuleCx<'_>) -> String {
    let near = cx
        .suggestions
        .nearest(name, rig.collections.iter().map(String::as_str));
    did_you_mean(near, format!("add `{name}` to `collections` of the rig"))
}
