//! Names of folders count as names of targets.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use crate::repo::makehuman1::View;

pub(in crate::rules) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "shows no modelling sliders at all: looking for targets ends with `RuntimeError`")],
    docs: "MakeHuman 1 looks for targets in all of the data of the program, and takes the words in the names of folders for \
        what a target is for: `male`, `young`, `maxmuscle` and so on. A folder with two such words for one thing, such as \
        `clothes/male_female_shirt`, or `hair/old/young`, ends the search, even if it is empty.\n\n\
        Words are separated by `-`, `_` and `.`. Folders of a user are not searched, and none is while there is a \
        `targets.npz`. Targets themselves are not checked yet.\n\n\
        Rename the folder, such as `unisex_shirt`.",
    ..RuleInfo::new("target-token-conflict", Level::Error, "a folder whose name has two values of one category")
});

/// What a word stands for (formats/makehuman1.md §5).
#[rustfmt::skip]
const WORDS: [(&str, &[&str]); 9] = [
    ("gender", &["male", "female"]),
    ("age", &["baby", "child", "young", "old"]),
    ("race", &["caucasian", "asian", "african"]),
    ("muscle", &["maxmuscle", "averagemuscle", "minmuscle"]),
    ("weight", &["minweight", "averageweight", "maxweight"]),
    ("height", &["minheight", "averageheight", "maxheight"]),
    ("breast size", &["mincup", "averagecup", "maxcup"]),
    ("breast firmness", &["minfirmness", "averagefirmness", "maxfirmness"]),
    ("proportions", &["uncommonproportions", "regularproportions", "idealproportions"]),
];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    if !view.layers.checks_system() || layer.file("targets.npz").is_some() {
        return;
    }
    let mut told: Option<&str> = None;
    for folder in layer.folders.iter().filter(|folder| !folder.starts_with("targets/")) {
        // What is below such a folder has the same words.
        if told.is_some_and(|above| crate::source::is_below(folder, above)) {
            continue;
        }
        let Some((category, one, other)) = conflict(folder) else { continue };
        told = Some(folder);
        let message = format!("`{folder}` has `{one}` and `{other}`, two values of one category ({category})");
        let finding = RULE.in_layer(layer, folder, message).key(category);
        out.push(finding.help(format!("rename the folder without `{one}` or `{other}`")));
    }
}

fn conflict(folder: &str) -> Option<(&'static str, &str, &str)> {
    let mut known: BTreeMap<&str, &str> = BTreeMap::new();
    for word in folder.split(['/', '-', '_', '.']) {
        let Some((category, _)) = WORDS.iter().find(|(_, words)| words.contains(&word)) else { continue };
        match known.insert(category, word) {
            Some(before) if before != word => return Some((category, before, word)),
            _ => {}
        }
    }
    None
}
