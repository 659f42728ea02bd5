//! Damage done to a real repository, one thing at a time: each case must show the finding that names the
//! cause, and nothing behind it. Findings are compared by fingerprint with those of the undamaged data.
//!
//! Runs where `MHLINT_CORPORA` names the folder that holds the corpora; passes with a word on it elsewhere.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop where it fails")]
#![allow(clippy::print_stderr, reason = "a test that is left out must say so")]

#[path = "damage/cases.rs"]
mod cases;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cases::{CASES, Case, Edit, NUMERIC};
use mhlint::{Config, Finding, Outcome, Tree, lint_trees};

/// Files by path below the corpus; the bytes are shared by all cases.
type Files = BTreeMap<String, Arc<[u8]>>;

fn corpus() -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("MHLINT_CORPORA").map(PathBuf::from) else {
        eprintln!("skipped: MHLINT_CORPORA does not name a folder with `makehuman2`");
        return None;
    };
    Some(folder.join("makehuman2"))
}

/// Everything below `folder` but photographs and what belongs to the base `without`.
fn load(folder: &Path, without: &str) -> Files {
    let mut files = Files::new();
    let foreign = format!("/{without}/");
    for entry in walkdir::WalkDir::new(folder) {
        let entry = entry.unwrap();
        let path = entry.path().strip_prefix(folder).unwrap().to_str().unwrap().replace('\\', "/");
        let wanted = !path.contains(&foreign) && Path::new(&path).extension().is_none_or(|ext| ext != "jpg");
        if entry.file_type().is_file() && wanted {
            files.insert(path, std::fs::read(entry.path()).unwrap().into());
        }
    }
    files
}

/// Does the damage, or says why it cannot be done.
fn apply(files: &mut Files, edit: &Edit) -> Result<(), String> {
    let path = |file: &str| format!("data/{file}");
    let known = |file: &str| files.get(&path(file)).map(Arc::clone).ok_or(format!("there is no `{file}`"));
    match *edit {
        Edit::Replace(file, find, replace) => {
            let bytes = known(file)?;
            let text = std::str::from_utf8(&bytes).unwrap();
            if !text.contains(find) {
                return Err(format!("`{file}` does not hold `{find}`"));
            }
            files.insert(path(file), text.replacen(find, replace, 1).into_bytes().into());
        }
        Edit::Insert(file, at, bytes) => {
            let mut all = known(file)?.to_vec();
            all.splice(at..at, bytes.iter().copied());
            files.insert(path(file), all.into());
        }
        Edit::Cut(file, length) => {
            let cut = known(file)?[..length].into();
            files.insert(path(file), cut);
        }
        Edit::Write(file, bytes) => {
            files.insert(path(file), bytes.into());
        }
        Edit::Remove(file) => {
            known(file)?;
            files.remove(&path(file));
        }
        Edit::Copy(from, to) => {
            let bytes = known(from)?;
            files.insert(path(to), bytes);
        }
        Edit::Zero(file, vertices) => {
            let zeroed = zeroed(std::str::from_utf8(&known(file)?).unwrap(), vertices);
            files.insert(path(file), zeroed.into_bytes().into());
        }
        Edit::Move(file, moves) => {
            let displaced = displaced(std::str::from_utf8(&known(file)?).unwrap(), moves)?;
            files.insert(path(file), displaced.into_bytes().into());
        }
        Edit::Rename(from, to) => {
            let bytes = known(from)?;
            files.remove(&path(from));
            files.insert(path(to), bytes);
        }
    }
    Ok(())
}

/// A target whose displacements of some vertices are larger by so much.
fn displaced(text: &str, moves: &[(u32, [f64; 3])]) -> Result<String, String> {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for (vertex, by) in moves {
        let start = format!("{vertex} ");
        let line = lines.iter_mut().find(|line| line.starts_with(&start)).ok_or(format!("no row for {vertex}"))?;
        let delta: Vec<f64> = line.split(' ').skip(1).map(|word| word.parse().unwrap()).collect();
        *line = format!("{vertex} {:.5} {:.5} {:.5}", delta[0] + by[0], delta[1] + by[1], delta[2] + by[2]);
    }
    Ok(lines.join("\n") + "\n")
}

/// A target that no longer moves some vertices.
fn zeroed(text: &str, vertices: &[u32]) -> String {
    let is_one = |line: &str| {
        let vertex = line.split(' ').next().and_then(|word| word.parse::<u32>().ok());
        vertex.filter(|vertex| vertices.contains(vertex))
    };
    let lines = text.lines().map(|line| is_one(line).map_or(line.to_owned(), |vertex| format!("{vertex} 0 0 0")));
    lines.map(|line| line + "\n").collect()
}

fn run(files: &Files, no_eval: bool) -> Outcome {
    let tree = Tree::in_memory("", files.iter().map(|(path, bytes)| (path.clone(), Arc::clone(bytes))));
    lint_trees(vec![tree], None, &Config { no_eval, ..Config::default() }).unwrap()
}

/// `rule path` of the findings of `one` that `other` does not have, or has for fewer things.
fn beyond(one: &Outcome, other: &Outcome) -> Vec<String> {
    let known = |finding: &Finding| {
        let same = other.findings.iter().find(|known| known.fingerprint == finding.fingerprint);
        same.is_some_and(|known| known.parts.is_empty() || finding.parts.iter().all(|part| known.parts.contains(part)))
    };
    let fresh = one.findings.iter().filter(|finding| !known(finding));
    let mut lines: Vec<String> = fresh
        .map(|finding| format!("{} {}", finding.rule, finding.path.strip_prefix("data/").unwrap_or(&finding.path)))
        .collect();
    lines.sort();
    lines
}

/// What is wrong with a case; empty when it is as expected.
fn verdict(case: &Case, files: &Files, healthy: &Outcome, no_eval: bool) -> String {
    let mut damaged = files.clone();
    if let Err(reason) = case.damage.iter().try_for_each(|edit| apply(&mut damaged, edit)) {
        return format!("{}: {reason}\n", case.name);
    }
    let outcome = run(&damaged, no_eval);
    let (fresh, gone) = (beyond(&outcome, healthy), beyond(healthy, &outcome));
    // A fault may silence what can no longer be judged, and the case says what: nothing else may go.
    let is_new = |finding: &&Finding| healthy.findings.iter().all(|known| known.fingerprint != finding.fingerprint);
    let new: Vec<&Finding> = outcome.findings.iter().filter(is_new).collect();
    let says = new.is_empty() || new.iter().any(|finding| finding.message.contains(case.says));
    if fresh == case.fresh && gone == case.gone && says && outcome.failed_rules.is_empty() {
        return String::new();
    }
    let messages: Vec<_> =
        new.iter().map(|finding| format!("    {}: {} [{}]", finding.path, finding.message, finding.key)).collect();
    format!(
        "{}:\n  says {:?}: {says}\n  new  {fresh:?}\n  not  {:?}\n  gone {gone:?}\n  not  {:?}\n  failed rules {:?}\n{}\n",
        case.name,
        case.says,
        case.fresh,
        case.gone,
        outcome.failed_rules,
        messages.join("\n")
    )
}

fn every_case_of(cases: &[&Case], base: &str, without: &str, no_eval: bool) {
    let Some(corpus) = corpus() else { return };
    let files = load(&corpus, without);
    let healthy = run(&files, no_eval);
    let only = std::env::var("CASE").unwrap_or_default();
    let wanted = cases.iter().filter(|case| case.base == base && case.name.contains(&only));
    let wrong: Vec<String> =
        wanted.map(|case| verdict(case, &files, &healthy, no_eval)).filter(|text| !text.is_empty()).collect();
    assert!(wrong.is_empty(), "{} cases:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn damage_to_hm08_is_named_once() {
    every_case_of(&CASES.iter().collect::<Vec<_>>(), "hm08", "mh2bot", true);
}

#[test]
fn damage_to_mh2bot_is_named_once() {
    every_case_of(&CASES.iter().collect::<Vec<_>>(), "mh2bot", "hm08", true);
}

/// Whether the rules of this build include `rule`; an unknown selector is refused.
fn knows(rule: &str) -> bool {
    let options = Config { only: vec![rule.to_owned()], ..Config::default() };
    lint_trees(Vec::new(), None, &options).is_ok()
}

#[test]
fn damage_that_evaluation_sees_is_named_once() {
    let rule = |finding: &&str| finding.split(' ').next().is_some_and(knows);
    let known: Vec<&Case> = NUMERIC.iter().filter(|case| case.fresh.iter().all(&rule)).collect();
    let names: Vec<&str> = NUMERIC.iter().map(|case| case.name).collect();
    eprintln!("{} of {} cases have their rules: {names:?}", known.len(), names.len());
    assert!(known.len() >= 3);
    every_case_of(&known, "hm08", "mh2bot", false);
}

#[test]
fn there_are_enough_cases_and_their_names_differ() {
    let names: std::collections::BTreeSet<_> = CASES.iter().map(|case| case.name).collect();
    assert_eq!(names.len(), CASES.len());
    assert!(names.len() >= 60, "{}", names.len());
}
