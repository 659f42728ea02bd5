//! The weights of a skeleton must be found.

use super::super::{Check, Rule, RuleCx};
use super::{Rig, rigs};
use crate::diag::{Application, Finding, Level, RuleInfo, nearest};
use crate::repo::{Base, Reference, ReferenceKind, Repository, Resolution};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "refuses the skeleton with a line in its log")],
        docs: "`weights_file` (without the key: `default_weights.mhw`) is looked for in `rigs/<base>/` of the \
            user's data, then of the system's, and never beside the skeleton.\n\nWhen it is not there MakeHuman \
            2 refuses the whole skeleton. A skeleton in a sub-folder has to name the sub-folder: \
            `sub/file.mhw`.\n\nCorrect the name, or move the file.",
        ..RuleInfo::new(
            "skeleton-missing-weights",
            Level::Error,
            "the weights file of a skeleton is not where MakeHuman 2 looks for it",
        )
    },
    check: Check::Base(run),
};

fn run(repository: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(repository, base) {
        let own = |reference: &&Reference<'_>| {
            reference.kind == ReferenceKind::WeightsFile && std::ptr::eq(reference.from, rig.file)
        };
        let Some(reference) = repository.references_of(base).find(own) else { continue };
        if !matches!(reference.resolution, Resolution::Missing) {
            continue;
        }
        let named = if rig.skeleton.weights_file.is_some() { "" } else { ", used because no `weights_file` is named," };
        let message = format!("weights `{}`{named} do not exist in `rigs/{}/`", reference.text, base.name);
        out.push(RULE.at(rig.file, reference.place.clone(), message).help(help(base, &rig, reference.text)));
    }
}

fn help(base: &Base<'_>, rig: &Rig<'_>, text: &str) -> String {
    let root = format!("rigs/{}/", base.name);
    let below = rig.file.rel.strip_prefix(root.as_str()).and_then(|rest| rest.rsplit_once('/'));
    let all: Vec<&str> = base.weights.iter().filter_map(|file| file.rel.strip_prefix(root.as_str())).collect();
    if let Some((folder, _)) = below
        && all.iter().any(|name| *name == format!("{folder}/{text}"))
    {
        return format!("the file lies beside the skeleton: write `{folder}/{text}`");
    }
    match nearest(text, all.iter().copied()) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("put the file into `{root}`, or name one that is there"),
    }
}
