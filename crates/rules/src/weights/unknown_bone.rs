//! Weights must be for bones of the skeleton
//! (`docs/loaders/makehuman2/weights.md#faults-of-weights`,
//! `docs/loaders/makehuman1/weights.md#faults-of-weights`,
//! `docs/loaders/mpfb/weights.md#faults-of-weights`).

use std::collections::BTreeSet;

use super::super::cause::groups::{self, Groups};
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::readable_own;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_repo::{Body, BodyWeights, FileFacts, Rig};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `KeyError` when pose mode is entered",
        ),
        (
            Makehuman1,
            "drops the weights of the bone with a warning, which pulls their vertices \
            towards the origin",
        ),
        (Mpfb, "silently drops the weights of the bone"),
    ],
    levels: &[(Makehuman1, Level::Warning), (Mpfb, Level::Warning)],
    docs: include_str!("unknown_bone.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "weights-unknown-bone",
        Level::Error,
        "weights for a bone that the skeleton \
        does not have",
    )
});

const NEVER_APPLIED: Case = &[(
    Makehuman2,
    Level::Warning,
    "never applies these weights: another skeleton poses the base",
)];

const NOTHING_MOVES: Case = &[(
    Mpfb,
    Level::Error,
    "makes the rig without any weights: the body does not move with it",
)];

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let users = body
        .rigs
        .iter()
        .filter_map(|rig| Some((std::ptr::from_ref(rig.weights_file()?), rig)));
    let users = grouped(users);
    for (BodyWeights { file, .. }, weights) in readable_own(body) {
        let users = users.get(&std::ptr::from_ref(*file));
        let Some(Binding {
            known,
            takers,
            is_posed,
            skeleton,
        }) = users.and_then(|users| binding(users))
        else {
            continue;
        };
        let leads = |group: &str| known.contains(group) || takers.iter().any(|own| own.take(group));
        let unknown = weights
            .bones
            .iter()
            .filter(|bone| bone.listed > 0 && !leads(&bone.name));
        let unknown: Vec<&str> = unknown.map(|bone| bone.name.as_str()).collect();
        let Some(first) = unknown.first() else {
            continue;
        };
        let of = if body.is_mpfb() { "rig" } else { "skeleton" };
        let message = match unknown.len() {
            1 => format!("bone `{first}` does not exist in the {of}"),
            count => {
                format!(
                    "{count} of {} bones do not exist in the {of}, first `{first}`",
                    weights.bones.len()
                )
            }
        };
        let help = did_you_mean(
            cx.suggestions.nearest(first, known.iter().copied()),
            match unknown.len() {
                1 => {
                    format!(
                        "name a bone of the {of} that uses these weights, or remove it if its \
                            vertices have others"
                    )
                }
                _ => format!("use the weights that were made for this {of}, or rename the bones"),
            },
        );
        let finding = RULE
            .at(file, Place::key(["weights", first]), message)
            .help(help)
            .against(&skeleton.path)
            .evidence(Evidence::of_cases(&unknown).out_of(weights.bones.len()));
        let is_all = unknown.len() == weights.bones.iter().filter(|bone| bone.listed > 0).count();
        let finding = if is_all {
            finding.case(NOTHING_MOVES)
        } else {
            finding
        };
        out.push(if is_posed || body.is_mpfb() {
            finding
        } else {
            finding.case(NEVER_APPLIED)
        });
    }
}

/// Bones that the weights may be for, and whether the body is posed with them.
struct Binding<'a> {
    known: BTreeSet<&'a str>,
    /// What takes weights for other names than those of its bones.
    takers: Vec<Groups<'a>>,
    is_posed: bool,
    skeleton: &'a FileFacts,
}

/// Of the rigs that use a weights file the one for poses alone, if it is among them; else all.
fn binding<'v>(users: &[&Rig<'v>]) -> Option<Binding<'v>> {
    let default = users.iter().find(|rig| rig.is_default);
    let (chosen, is_posed) = (
        default.map_or(users, std::slice::from_ref),
        default.is_some(),
    );
    let skeleton = chosen.first()?.file;
    let (mut known, mut takers) = (BTreeSet::new(), Vec::new());
    for user in chosen {
        if let Some(rig) = groups::of(user.file) {
            known.extend(rig.names());
            takers.push(rig);
            continue;
        }
        // Without the bones of every user nothing can be said.
        let skeleton = user
            .skeleton()
            .filter(|skeleton| !skeleton.bones.is_empty())?;
        known.extend(skeleton.bones.iter().map(|bone| bone.name.as_str()));
        // A bone that is missing as a parent is reported as such (`skeleton-unknown-parent`).
        known.extend(
            skeleton
                .bones
                .iter()
                .filter_map(|bone| bone.parent.as_deref()),
        );
    }
    (!known.is_empty()).then_some(Binding {
        known,
        takers,
        is_posed,
        skeleton,
    })
}
