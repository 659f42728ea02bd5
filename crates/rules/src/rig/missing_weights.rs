//! A rig has weights.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, enumerated};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::extension;
use mhlint_repo::mpfb::{RigFile, RigPart, View, lost_rigs};
use mhlint_repo::{FileFacts, Layer};
use mhlint_source::{file_name, parent};

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
    // A rig that is not found because of its capitals is reported for those.
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
        // If two rigs look for the same file its name is the smallest among the names of both, so
        // that they get one finding.
        if let Some(rel) = rig.wanted_weights.iter().min() {
            by_weights.entry(rel).or_default().push(rig);
        }
    }
    let mut folders: BTreeMap<(&str, &str), Names<'_>> = BTreeMap::new();
    for (rel, rigs) in by_weights {
        let Some(first) = rigs.first() else { continue };
        let names = folders
            .entry((first.layer.path.as_str(), parent(rel)))
            .or_insert_with(|| Names::of(first.layer, parent(rel)));
        out.extend(finding(rel, &rigs, names, cx));
    }
}

/// The names of the files below a folder.
struct Names<'l> {
    /// All names, by their form in small letters; of several names with the same form the first.
    all: BTreeMap<String, &'l str>,
    /// Names of files with weights for which there is no rig of the same name.
    free: Vec<&'l str>,
}

impl<'l> Names<'l> {
    fn of(layer: &'l Layer, folder: &str) -> Self {
        let names = || layer.below(folder).map(FileFacts::file_name);
        let mut all = BTreeMap::new();
        for name in names() {
            all.entry(name.to_ascii_lowercase()).or_insert(name);
        }
        let is_weights = |name: &&str| name.starts_with("weight") && extension(name) == "json";
        let is_taken = |name: &str| {
            let rig = name.trim_start_matches("weights.");
            layer.file(&format!("{folder}/rig.{rig}")).is_some()
        };
        let free = names().filter(is_weights).filter(|name| !is_taken(name));
        Self {
            free: free.collect(),
            all,
        }
    }
}

fn finding(
    rel: &str,
    rigs: &[&RigFile<'_>],
    names_of: &Names<'_>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let first = rigs.first()?;
    let file_name = |rel: &str| file_name(rel).to_owned();
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
    let own = format!("{}.weights.json", first.name);
    let in_other_case = names_of.all.get(&name.to_ascii_lowercase());
    let misnamed = || names_of.all.get(&own.to_ascii_lowercase());
    let misnamed = || misnamed().filter(|other| **other == own);
    // Only weights without a rig are suggested: weights of other rigs have similar names.
    let near = in_other_case
        .or_else(misnamed)
        .copied()
        .or_else(|| cx.suggestions.nearest(&name, names_of.free.iter().copied()));
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
