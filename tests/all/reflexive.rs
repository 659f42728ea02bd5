//! Nothing changed is nothing new: whatever is damaged, compared with itself there is no finding,
//! and a baseline hides all that one may hide.

use std::fs;
use std::path::PathBuf;

use mhlint::{Config, Outcome};
use rayon::prelude::*;

use crate::scratch::memory::{Asked, Memory, concise};
use crate::scratch::{Case, folders, project};

/// Trees of all three applications with several damages each.
const MIXED: u64 = 150;

#[test]
fn a_case_compared_with_itself_has_nothing_new() {
    let only = std::env::var("CASE").unwrap_or_default();
    let cases: Vec<PathBuf> = folders(&project("fixtures/rules"))
        .iter()
        .flat_map(|rule| folders(rule))
        .collect();
    let chosen = cases
        .par_iter()
        .filter(|case| case.join("expected.txt").exists());
    let chosen = chosen.filter(|case| case.to_str().unwrap().contains(&only));
    let told = |folder: &PathBuf| {
        let case = Case::read(folder);
        let asked = Asked::of(&case)?;
        let mut now = Memory::example(&case);
        now.apply(&case);
        let told = lasting(&asked.lint_beside(&now, &now));
        (!told.is_empty()).then(|| format!("{}\n  {}", folder.display(), told.join("\n  ")))
    };
    let faults: Vec<String> = chosen.filter_map(told).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn damaged_trees_of_several_applications_compared_with_themselves_have_nothing_new() {
    let faults: Vec<String> = (0..MIXED)
        .into_par_iter()
        .filter_map(not_reflexive)
        .collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// A tree with data of all applications, in one folder or beside each other, that is not itself.
fn not_reflexive(seed: u64) -> Option<String> {
    let mut chance = Chance(seed);
    let mut tree = Memory::default();
    let is_one_folder = chance.below(2) == 0;
    for name in ["makehuman1", "mpfb", "makehuman2"] {
        let folder = if is_one_folder {
            String::new()
        } else {
            format!("{name}/")
        };
        tree.add(&Memory::of(name), &folder);
    }
    (0..2 + chance.below(6)).for_each(|_| damage(&mut tree, &mut chance));
    let asked = Asked::of_all(Config::default());
    let told = lasting(&asked.lint_beside(&tree, &tree));
    let hidden = in_baseline(&tree);
    let told = [told, hidden].concat();
    (!told.is_empty()).then(|| format!("seed {seed}\n  {}", told.join("\n  ")))
}

/// What a baseline that was just written does not hide.
fn in_baseline(tree: &Memory) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("known.json");
    let config = |write_baseline| Config {
        baseline: Some(path.clone()),
        write_baseline,
        ..Config::default()
    };
    let written = Asked::of_all(config(true)).lint(tree);
    fs::write(&path, written.baseline.unwrap().text()).unwrap();
    let again = Asked::of_all(config(false)).lint(tree);
    let stale = again
        .compared_with_baseline
        .iter()
        .map(|compared| compared.gone)
        .sum::<usize>();
    let mut told = lasting(&again);
    if stale > 0 {
        told.push(format!("{stale} gone"));
    }
    told
}

/// Findings without those that nobody can hide.
fn lasting(outcome: &Outcome) -> Vec<String> {
    let rules = mhlint::rule_infos();
    let is_lasting = |line: &String| {
        let rule = line
            .split_once('[')
            .and_then(|(_, rest)| rest.split_once(']'))
            .map(|(rule, _)| rule);
        rule.is_some_and(|rule| {
            rules
                .iter()
                .any(|one| one.id == rule && one.cannot_be_ignored)
        })
    };
    concise(outcome)
        .into_iter()
        .filter(|line| !is_lasting(line))
        .collect()
}

/// Lines that loaders read in different ways, or not at all.
const LINES: [&str; 9] = [
    "00012 -1 -1 .3.5e38",
    "99999 .1 .1 .1",
    "8 0 0 0",
    "x y z w",
    "12 nan inf -inf",
    "verts 0",
    "material missing.mhmat",
    "{\"a\": [1, }",
    "\u{feff}\u{fffd} name",
];

fn damage(tree: &mut Memory, chance: &mut Chance) {
    let paths = tree.paths();
    let Some(path) = chance.of(&paths).cloned() else {
        return;
    };
    let text = String::from_utf8_lossy(tree.bytes(&path)).into_owned();
    let mut lines: Vec<&str> = text.lines().collect();
    let at = chance.below(lines.len() + 1);
    match chance.below(6) {
        0 => lines.insert(at, chance.of(&LINES).unwrap()),
        1 if at < lines.len() => drop(lines.remove(at)),
        2 if at < lines.len() => lines.insert(at, lines[at]),
        3 => lines.truncate(at),
        4 => return tree.move_away(&path, &format!("{path}.bak")),
        _ => {
            let other = chance.of(&paths).cloned().unwrap();
            let bytes = tree.bytes(&other).to_vec();
            return tree.write(&path, bytes);
        }
    }
    tree.write(&path, (lines.join("\n") + "\n").into_bytes());
}

/// The same numbers in each run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, most: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % most
    }

    fn of<'a, T>(&mut self, all: &'a [T]) -> Option<&'a T> {
        all.get(self.below(all.len().max(1)))
    }
}
