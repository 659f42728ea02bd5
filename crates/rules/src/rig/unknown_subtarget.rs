//! The bones that constraints name exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::at_bones;
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use mhlint_formats::rig::{Constraint, Rig, RigBone, Target};
use mhlint_repo::mpfb::{RigFile, RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "makes the constraint, which Blender marks as invalid: it does nothing",
    )],
    docs: include_str!("unknown_subtarget.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-unknown-subtarget",
        Level::Warning,
        "a constraint that is bound to no bone",
    )
});

/// Why a constraint is bound to no bone.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Lack<'r> {
    Target,
    Subtarget,
    Unknown(&'r str),
    OfParent(&'r str),
    Itself,
}

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let parents = bones_of_parents(view);
    for (file, rig) in view.own_rigs() {
        let bones = rig.bones.iter().map(|bone| bone.name.as_str());
        // Rigify makes the `extra_bones` later.
        let known: BTreeSet<&str> = bones
            .chain(rig.extra_bones.iter().map(String::as_str))
            .collect();
        let of_bone = |bone: &'_ RigBone| bone.constraints.len();
        let bound = rig.bones.iter().filter(|bone| of_bone(bone) > 0);
        let found: Vec<(&RigBone, &Constraint, Lack<'_>)> = bound
            .flat_map(|bone| bone.constraints.iter().map(move |one| (bone, one)))
            .filter_map(|(bone, one)| Some((bone, one, lack(bone, one, &known, parents.as_ref())?)))
            .collect();
        out.extend(finding(file, rig, &found, (&known, parents.as_ref()), cx));
    }
}

/// The names of the bones in all rigs that a sub-rig may be added to; `None` if one of the rigs
/// cannot be read.
fn bones_of_parents<'v>(view: &'v View<'_>) -> Option<BTreeSet<&'v str>> {
    let mut bones = BTreeSet::new();
    for file in view.rigs.iter().filter(|file| file.part != RigPart::Asset) {
        let rig = file.definition()?;
        bones.extend(
            rig.bones
                .iter()
                .map(|bone| bone.name.as_str())
                .chain(rig.extra_bones.iter().map(String::as_str)),
        );
    }
    Some(bones).filter(|bones| !bones.is_empty())
}

fn lack<'r>(
    bone: &RigBone,
    constraint: &'r Constraint,
    known: &BTreeSet<&str>,
    parents: Option<&BTreeSet<&str>>,
) -> Option<Lack<'r>> {
    constraint
        .targets
        .iter()
        .find_map(|(target, subtarget)| match (target, subtarget.as_deref()) {
            (Target::Missing, _) => Some(Lack::Target),
            (Target::Own, None | Some("")) | (Target::Span(..) | Target::Parent, None) => {
                Some(Lack::Subtarget)
            }
            (Target::Own, Some(name)) if !known.contains(name) => Some(Lack::Unknown(name)),
            (Target::Parent, Some(name)) if parents.is_some_and(|bones| !bones.contains(name)) => {
                Some(Lack::OfParent(name))
            }
            (Target::Own, Some(name)) if name == bone.name && constraint.kind != "ARMATURE" => {
                Some(Lack::Itself)
            }
            _ => None,
        })
}

fn finding(
    file: &RigFile<'_>,
    rig: &Rig,
    found: &[(&RigBone, &Constraint, Lack<'_>)],
    (known, of_parents): (&BTreeSet<&str>, Option<&BTreeSet<&str>>),
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let names = || {
        known
            .iter()
            .chain(of_parents.into_iter().flatten())
            .copied()
    };
    let near = |name: &str| cx.suggestions.nearest(name, names());
    let (bone, constraint, lack) = found.first()?;
    let subject = format!("{} of bone `{}`", constraint.kind, bone.name);
    let more = such(found.len(), "constraints");
    let (message, help) = match lack {
        Lack::Target => (
            format!("{subject} has no target{more}"),
            "write `\"target\": true` for the rig itself".to_owned(),
        ),
        Lack::Subtarget => (
            format!("{subject} has no `subtarget`{more}"),
            "name a bone of the rig".to_owned(),
        ),
        Lack::Unknown(name) => {
            let near = near(name);
            (
                format!("{subject} is bound to bone `{name}`, which does not exist{more}"),
                did_you_mean(near, "name a bone of the rig"),
            )
        }
        Lack::OfParent(name) => {
            let near = near(name);
            (
                format!(
                    "{subject} is bound to bone `{name}` of the rig of the body, which no rig \
                        has{more}"
                ),
                did_you_mean(near, "name a bone of the rig that the asset is made for"),
            )
        }
        Lack::Itself => (
            format!("{subject} is bound to the bone itself{more}"),
            "name another bone".to_owned(),
        ),
    };
    let bones: Vec<&str> = found.iter().map(|(bone, ..)| bone.name.as_str()).collect();
    let mut finding = at_bones(&RULE, file, rig, &bones, "constraints", message)?;
    for (_, other, _) in found.iter().skip(1).take(mhlint_diag::EXAMPLES - 1) {
        finding = finding.related(
            file.file.path.clone(),
            Place::Pointer(other.pointer.clone()),
            "so is this one",
        );
    }
    Some(finding.help(help))
}
