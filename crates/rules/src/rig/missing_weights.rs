//! A rig has weights.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, enumerated};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::extension;
use mhlint_repo::mpfb::{RigFile, RigPart, View, lost_rigs};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "makes the rig without weights and without a message: the body does not move with it",
    )],
    docs: include_str!("missing_weights.md").trim_ascii_end(),
    counts: "rigs",
    of_whole: true,
    ..RuleInfo::new(
        "rig-missing-weights",
        Level::Error,
        "the weights of a rig are missing",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_without = |rig: &&RigFile<'_>| {
        rig.weights().is_none()
            && !rig
                .wanted_weights
                .iter()
                .any(|rel| rig.layer.has_unusable(rel))
    };
    // One that is not found for its capitals is told for these.
    let is_lost = |rig: &RigFile<'_>| {
        lost_rigs(rig.layer).any(|lost| lost.eq_ignore_ascii_case(&rig.file.rel))
    };
    let of_body = view
        .own_rigs()
        .filter(|(file, rig)| file.part != RigPart::Asset && !rig.bones.is_empty());
    let mut by_weights: BTreeMap<&str, Vec<&RigFile<'_>>> = BTreeMap::new();
    for rig in of_body
        .map(|(file, _)| file)
        .filter(is_without)
        .filter(|rig| !is_lost(rig))
    {
        // What two rigs both look for comes first among their names.
        if let Some(rel) = rig.wanted_weights.iter().min() {
            by_weights.entry(rel).or_default().push(rig);
        }
    }
    out.extend(
        by_weights
            .into_iter()
            .filter_map(|(rel, rigs)| finding(rel, &rigs, cx)),
    );
}

fn finding(rel: &str, rigs: &[&RigFile<'_>], cx: &RuleCx<'_>) -> Option<Finding> {
    let first = rigs.first()?;
    let file_name = |rel: &str| rel.rsplit('/').next().unwrap_or(rel).to_owned();
    let name = file_name(rel);
    let names: Vec<String> = rigs.iter().map(|rig| format!("`{}`", rig.name)).collect();
    let (word, need) = if names.len() == 1 {
        ("rig", "needs")
    } else {
        ("rigs", "need")
    };
    let message = format!(
        "`{name}` does not exist, which {word} {} {need}",
        enumerated(&names)
    );
    let folder = rel.rsplit_once('/').map_or("", |(folder, _)| folder);
    let others = || {
        first
            .layer
            .below(folder)
            .map(mhlint_repo::FileFacts::file_name)
    };
    let in_other_case = others()
        .find(|other| other.eq_ignore_ascii_case(&name))
        .map(str::to_owned);
    let misnamed = others()
        .find(|other| **other == *format!("{}.weights.json", first.name))
        .map(str::to_owned);
    // Weights of another rig have similar names.
    let near = in_other_case.or(misnamed).or_else(|| {
        let unused =
            others().filter(|other| other.starts_with("weight") && extension(other) == "json");
        let taken = |other: &str| {
            first
                .layer
                .file(&format!(
                    "{folder}/rig.{}",
                    other.trim_start_matches("weights.")
                ))
                .is_some()
        };
        cx.suggestions
            .nearest(&name, unused.filter(|other| !taken(other)))
            .map(str::to_owned)
    });
    let help = near.map_or_else(
        || "add the weights".to_owned(),
        |near| format!("rename `{near}` to `{name}`"),
    );
    let finding = RULE
        .at(first.file, Place::File, message)
        .key(rel)
        .help(help);
    Some(
        finding
            .parts_in(rigs.iter().map(|rig| (rig.name, rig.file.path.as_str())))
            .evidence(Evidence::counted(rigs.len())),
    )
}
