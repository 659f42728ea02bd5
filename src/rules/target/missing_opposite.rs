//! A target for one direction of a slider without the other direction.

use super::super::{Check, Rule, RuleCx};
use super::{parent, usage};
use crate::diag::{Application, Finding, Level, Place, RuleInfo, Sight};
use crate::repo::{Base, FileFacts, Repository, TargetFolder};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        sight: Some(Sight::Folder),
        breaks: &[(
            Application::Makehuman2,
            "makes a slider of one side; of a single `-decr` target it makes one that grows where it should shrink",
        )],
        docs: "Targets come in pairs such as `-decr` and `-incr` (`target-opposites` of base.json says which), one for each \
            half of a slider. Here one of them is missing, in a folder that has complete pairs of the same kind.\n\n\
            MakeHuman 2 makes the sliders of user targets from the file names: a pair becomes one slider with two halves, a \
            single file becomes a slider with one half.\n\nMake the other direction, or give the file a name without the \
            ending. Where modelling.json lists a target as single, it is meant to be single and nothing is reported.",
        ..RuleInfo::new("target-missing-opposite", Level::Warning, "a target for one direction without its opposite")
    },
    check: Check::Base(run),
};

fn run(repository: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let pairs = pairs(base);
    let unlisted = base.modelling.winner().is_none() && !base.modelling.is_broken();
    let folders = [base.user_targets, base.targets.filter(|_| unlisted)];
    for folder in folders.into_iter().flatten().filter(|folder| std::ptr::eq(folder.layer, repository.judged)) {
        for file in folder.targets() {
            let Some((opposite, pair)) = opposite_of(file, &pairs) else { continue };
            let rel = format!("{}/{opposite}.target", parent(&file.rel));
            let exists = folder.layer.file(&rel).is_some() || folder.layer.file_ignoring_case(&rel).is_some();
            if !exists && has_pair(folder, parent(&file.rel), pair) && !usage::is_missed(repository, base, &rel) {
                out.push(finding(file, &opposite));
            }
        }
    }
}

fn finding(file: &FileFacts, opposite: &str) -> Finding {
    let message = format!("`{}` has no opposite `{opposite}`", file.stem());
    RULE.at(file, Place::File, message).help(format!(
        "add `{opposite}.target`, or give the file a name without the ending if it has only one direction"
    ))
}

/// Pairs of endings, negative first. The scan of user targets knows decr and incr without being told.
fn pairs<'a>(base: &Base<'a>) -> Vec<(&'a str, &'a str)> {
    let opposites = base.settings().map(|(_, settings)| settings.opposites.as_slice()).unwrap_or_default();
    let mut pairs: Vec<(&str, &str)> = opposites.iter().map(|(decr, incr)| (decr.as_str(), incr.as_str())).collect();
    if base.settings().is_none() {
        pairs.push(("decr", "incr"));
    }
    pairs
}

/// The name of the opposite target and the pair of endings, if the name has such an ending.
fn opposite_of<'a>(file: &FileFacts, pairs: &[(&'a str, &'a str)]) -> Option<(String, (&'a str, &'a str))> {
    let stem = file.stem();
    pairs.iter().find_map(|pair| {
        let (decr, incr) = *pair;
        let swap = |from: &str, to: &str| Some(format!("{}-{to}", stem.strip_suffix(from)?.strip_suffix('-')?));
        Some((swap(decr, incr).or_else(|| swap(incr, decr))?, *pair))
    })
}

/// Whether a folder holds both targets of a pair.
fn has_pair(folder: TargetFolder<'_>, path: &str, (decr, incr): (&str, &str)) -> bool {
    let own = folder.layer.below(path).filter(|file| parent(&file.rel) == path);
    let mut stems = own.filter_map(|file| file.rel.strip_suffix(&format!("-{decr}.target")));
    stems.any(|stem| folder.layer.file(&format!("{stem}-{incr}.target")).is_some())
}
