//! The bone weights of an asset are for bones of the skeleton.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::texts;
use crate::diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{Body, ReferenceKind, Rig};

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes with `KeyError` in every pose, and in the glTF export of a model with a skeleton")],
    docs: "The bone weights of an asset (`vertexboneweights_file`) name a bone that the skeleton for poses does not \
        have.\n\n\
        MakeHuman 2 puts the asset on. Posing the figure then crashes with `KeyError`, and so does every glTF export of \
        a model with a skeleton. A bone with an empty list does no harm.\n\n\
        The skeleton is the one that `pose-skeleton` of `base.json` names, whatever skeleton the model has.\n\n\
        Rename the bone, or export the weights for the skeleton of the base.",
    ..RuleInfo::new("proxy-custom-weights", Level::Error, "bone weights of an asset name an unknown bone")
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(skeleton) = body.default_rig().and_then(Rig::skeleton).filter(|skeleton| skeleton.is_object) else {
        return;
    };
    let known: BTreeSet<&str> = skeleton.bones.iter().map(|bone| &*bone.name).collect();
    for text in texts(body) {
        let Some(file) = text.worn.reference(ReferenceKind::AssetWeights).and_then(|one| one.meant()) else { continue };
        let Some(weights) = file.weights().filter(|weights| weights.has_weights) else { continue };
        let is_known = |name: &str| known.contains(name);
        let unknown: Vec<&str> = weights
            .bones
            .iter()
            .filter(|bone| bone.listed > 0 && !is_known(&bone.name))
            .map(|bone| &*bone.name)
            .collect();
        let Some(first) = unknown.first() else { continue };
        let message = match unknown.len() {
            1 => format!("bone `{first}` does not exist in the skeleton for poses"),
            count => format!("{count} bones do not exist in the skeleton for poses, first `{first}`"),
        };
        let near = cx.suggestions.nearest(first, skeleton.bones.iter().map(|bone| &*bone.name));
        let help = did_you_mean(near, "export the weights for the skeleton that `pose-skeleton` names");
        let finding = RULE.at(file, Place::Key(pointer(first)), message);
        out.push(finding.help(help).evidence(Evidence::of_cases(unknown.iter().copied())));
    }
}

fn pointer(bone: &str) -> String {
    match Place::pointer(["weights", bone]) {
        Place::Pointer(pointer) => pointer,
        _ => String::new(),
    }
}
