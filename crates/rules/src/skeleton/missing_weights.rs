//! The weights of a skeleton must be found.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::{Rig, rigs};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, RuleInfo,
};
use mhlint_repo::{Body, Reference, Resolution};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "rejects the skeleton and logs a line"),
        (
            Makehuman1,
            "fails with `FileNotFoundError` when the skeleton is chosen, at start for \
            the base skeleton",
        ),
    ],
    docs: include_str!("missing_weights.md").trim_ascii_end(),
    ..RuleInfo::new(
        "skeleton-missing-weights",
        Level::Error,
        "the weights file of a skeleton is not where MakeHuman 2 looks for it",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let weights = body.weights.iter().map(|own| own.file.rel.as_str());
    let weights: BTreeSet<&str> = weights.collect();
    for rig in rigs(body) {
        let missing =
            |reference: &&Reference<'_>| matches!(reference.resolution, Resolution::Missing);
        let Some(reference) = rig.own.weights.as_ref().filter(missing) else {
            continue;
        };
        let folder = reference
            .rel
            .strip_suffix(reference.text)
            .unwrap_or_default();
        let unnamed = if rig.skeleton.weights_file.is_some() {
            ""
        } else {
            "no `weights_file` is named, and "
        };
        let message = format!(
            "{unnamed}weights file `{}` does not exist in `{folder}`",
            reference.text
        );
        let help = help(&weights, &rig, (folder, reference.text), cx);
        out.push(
            RULE.at(rig.file, reference.place.clone(), message)
                .help(help),
        );
    }
}

fn help(
    weights: &BTreeSet<&str>,
    rig: &Rig<'_>,
    (root, text): (&str, &str),
    cx: &RuleCx<'_>,
) -> String {
    let below = rig
        .file
        .rel
        .strip_prefix(root)
        .and_then(|rest| rest.rsplit_once('/'));
    if let Some((folder, _)) = below
        && weights.contains(&*format!("{root}{folder}/{text}"))
    {
        return format!("write `{folder}/{text}`: the file is in the folder of the skeleton");
    }
    let below_root = weights
        .range(root..)
        .map_while(|rel| rel.strip_prefix(root));
    did_you_mean(
        cx.suggestions.nearest(text, below_root),
        format!("move the file into `{root}`, or name a file that exists there"),
    )
}
