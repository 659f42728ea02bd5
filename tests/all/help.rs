//! Help is never worse than none: what a finding advises is done, then it is gone and nothing new
//! is found.
//!
//! `fixtures/help/<family>.toml` has a row for each help that the cases of `fixtures/rules` show:
//! edits that do what it says, or one sentence why none can. A help that differs from another one
//! only in names and numbers needs no row of its own, and what a fix does needs none at all: it is
//! applied. `CASE=<rule>` tries the rows of some rules alone.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::{LazyLock, Mutex};

use crate::fixes::HIDDEN;
use crate::scratch::advice::Row;
use crate::scratch::memory::{Asked, Memory};
use crate::scratch::{Case, copy_folder, example_of, folders, mhlint, project};
use serde_json::Value;

/// A finding as far as it matters here.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Told {
    rule: String,
    path: String,
    message: String,
    help: Option<String>,
    is_fixable: bool,
    fingerprint: String,
}

/// Everything that the cases of all rules find of their own rule and of others, by rule and case.
static FOUND: LazyLock<BTreeMap<[String; 2], Vec<Told>>> = LazyLock::new(|| {
    let mut cases = Vec::new();
    for rule in folders(&project("fixtures/rules")) {
        cases.extend(
            folders(&rule)
                .into_iter()
                .map(|folder| [name(&rule), name(&folder)]),
        );
    }
    let only = std::env::var("CASE").unwrap_or_default();
    cases.retain(|[rule, _]| rule.contains(&only));
    on_all(cases, |case| (case.clone(), Damaged::of(&case).found()))
        .into_iter()
        .collect()
});

/// Does something with all of them on a few threads. Not those on which rules run: one that waits
/// for a check would start the next one meanwhile, and so on.
fn on_all<T: Send, R: Send>(all: Vec<T>, work: impl Fn(T) -> R + Sync) -> Vec<R> {
    let (waiting, done) = (Mutex::new(all.into_iter()), Mutex::new(Vec::new()));
    let turn = || {
        while let Some(next) = { waiting.lock().unwrap().next() } {
            let result = work(next);
            done.lock().unwrap().push(result);
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        let all: Vec<_> = (0..threads).map(|_| scope.spawn(turn)).collect();
        all.into_iter().for_each(|one| one.join().unwrap());
    });
    done.into_inner().unwrap()
}

fn name(path: &std::path::Path) -> String {
    path.file_name().unwrap().to_str().unwrap().to_owned()
}

/// An example repository with the edits of a case, and more edits where a help is followed.
struct Damaged {
    case: Case,
    then: Option<Case>,
    restore: Vec<String>,
}

impl Damaged {
    fn of([rule, case]: &[String; 2]) -> Self {
        let folder: PathBuf = project("fixtures/rules").join(rule).join(case);
        Self {
            case: Case::read(&folder),
            then: None,
            restore: Vec::new(),
        }
    }

    fn followed(row: Row) -> Self {
        let mut damaged = Self::of(&[row.rule.clone(), row.case.clone()]);
        damaged.case.args = row.args.clone().unwrap_or(damaged.case.args);
        damaged.restore.clone_from(&row.restore);
        damaged.then = Some(row.into_edits());
        damaged
    }

    /// What is found, in memory if it can be.
    fn found(&self) -> Vec<Told> {
        let Some(asked) = self.in_memory() else {
            return self.on_disk(&[]);
        };
        let mut repository = Memory::example(&self.case);
        let whole = repository.clone();
        repository.apply(&self.case);
        self.restore
            .iter()
            .for_each(|path| repository.restore(path, &whole));
        self.then.iter().for_each(|then| repository.apply(then));
        let outcome = asked.lint(&repository);
        assert!(
            outcome.is_whole(),
            "failed {:?} {:?}",
            outcome.failed_rules,
            outcome.failed_files
        );
        let told = |finding: mhlint::Finding| Told {
            rule: finding.rule.to_owned(),
            path: finding.path,
            message: finding.message,
            help: finding.help,
            is_fixable: finding.fix.is_some(),
            fingerprint: finding.fingerprint,
        };
        outcome.findings.into_iter().map(told).collect()
    }

    /// What is asked for, if neither the case nor what follows needs a disk.
    fn in_memory(&self) -> Option<Asked> {
        if let Some(then) = &self.then {
            let names_settings = |file: &str| file.ends_with("mhlint.toml");
            let files = then
                .write
                .iter()
                .map(|write| &write.file)
                .chain(then.edit.iter().map(|edit| &edit.file));
            if files.chain(&then.remove).any(|file| names_settings(file)) {
                return None;
            }
            Asked::of(then)?;
        }
        Asked::of(&self.case)
    }

    /// The same by the binary, after a run with further arguments, if any.
    fn on_disk(&self, before: &[&str]) -> Vec<Told> {
        let example = self.case.application.as_deref().unwrap_or("makehuman2");
        let repository = example_of(example);
        let root = repository.path();
        self.case.apply(root);
        for path in &self.restore {
            let from = project("fixtures").join(example).join(path);
            let to = root.join(path);
            if from.is_dir() {
                copy_folder(&from, &to);
            } else {
                std::fs::create_dir_all(to.parent().unwrap()).unwrap();
                std::fs::copy(from, to).unwrap();
            }
        }
        self.then.iter().for_each(|then| then.apply(root));
        let mut args: Vec<&str> = self.case.args.iter().map(String::as_str).collect();
        if args.is_empty() {
            args.extend(["check", "."]);
        }
        if !before.is_empty() {
            mhlint(root, &[&args, before].concat());
        }
        let output = mhlint(root, &[&args[..], &["--report", "json"]].concat());
        let report: Value = serde_json::from_slice(&output.stdout)
            .unwrap_or_else(|_| panic!("{args:?}: {}", String::from_utf8_lossy(&output.stderr)));
        let text = |value: &Value| value.as_str().map(str::to_owned);
        let told = |finding: &Value| Told {
            rule: text(&finding["rule"]).unwrap(),
            path: text(&finding["path"]).unwrap(),
            message: text(&finding["message"]).unwrap(),
            help: text(&finding["help"]),
            is_fixable: !finding["fix"].is_null(),
            fingerprint: text(&finding["fingerprint"]).unwrap(),
        };
        report["findings"]
            .as_array()
            .unwrap()
            .iter()
            .map(told)
            .collect()
    }
}

/// What remains of a help without its names and numbers.
fn shape(help: &str) -> String {
    let parts = help.split('`').enumerate();
    let text: String = parts
        .map(|(at, part)| if at % 2 == 1 { "`…`" } else { part })
        .collect();
    let words = text.split(' ').map(|word| {
        if word.starts_with(|c: char| c.is_ascii_digit()) {
            "#"
        } else {
            word
        }
    });
    let mut text = words.collect::<Vec<_>>().join(" ");
    for list in ["`…`, `…`", "`…` and `…`", "`…` or `…`"] {
        while text.contains(list) {
            text = text.replace(list, "`…`");
        }
    }
    text
}

/// The helps of the findings in a case, of its own rule.
fn helps<'a>(rule: &'a str, found: &'a [Told]) -> impl Iterator<Item = (&'a Told, &'a str)> {
    found
        .iter()
        .filter(move |told| told.rule == rule)
        .filter_map(|told| Some((told, told.help.as_deref()?)))
}

#[test]
fn what_a_help_advises_takes_its_finding_away_and_brings_none() {
    let only = std::env::var("CASE").unwrap_or_default();
    let rows: Vec<_> = Row::all()
        .into_iter()
        .filter(|(_, row)| row.rule.contains(&only))
        .collect();
    let rows = rows
        .into_iter()
        .map(|(_, row)| row)
        .filter(|row| row.cannot.is_empty())
        .collect();
    let faults = on_all(rows, |row| {
        let title = format!("{}/{}: {}", row.rule, row.case, row.help);
        Some(format!("{title}\n  {}", follow(row)?))
    });
    let faults: Vec<String> = faults.into_iter().flatten().collect();
    assert!(
        faults.is_empty(),
        "\n{}\n{} rows",
        faults.join("\n"),
        faults.len()
    );
}

/// Follows the help of a row; gives what is wrong with it.
fn follow(row: Row) -> Option<String> {
    let Some(before) = FOUND.get(&[row.rule.clone(), row.case.clone()]) else {
        return Some("no such case".to_owned());
    };
    let [rule, help] = [row.rule.clone(), row.help.clone()];
    let shows = row.shows.clone();
    let has_it = |told: &Told| told.rule == rule && told.help.as_ref() == Some(&help);
    if !before.iter().any(has_it) {
        let own: Vec<&str> = helps(&rule, before).map(|(_, help)| help).collect();
        return Some(format!("no finding has this help, but {own:#?}"));
    }
    let after = std::panic::catch_unwind(|| Damaged::followed(row).found());
    let Ok(after) = after else {
        return Some("the edits cannot be made".to_owned());
    };
    let is_shown = |told: &&Told| shows.contains(&told.rule) && !before.contains(told);
    if let Some(rule) = shows.iter().find(|rule| {
        !after
            .iter()
            .filter(is_shown)
            .any(|told| told.rule == **rule)
    }) {
        return Some(format!("{rule} is not shown"));
    }
    let rest: Vec<Told> = after
        .iter()
        .filter(|told| !is_shown(told))
        .cloned()
        .collect();
    difference(before, &rest, has_it)
}

/// What is still there of what should be gone, and what is new.
fn difference(
    before: &[Told],
    after: &[Told],
    should_go: impl Fn(&Told) -> bool,
) -> Option<String> {
    let said = |told: &Told| [&told.rule, &told.path, &told.message].map(Clone::clone);
    let is =
        |one: &Told, other: &Told| one.fingerprint == other.fingerprint || said(one) == said(other);
    let stays =
        |told: &Told| should_go(told) || before.iter().any(|old| should_go(old) && is(old, told));
    let wrong = after
        .iter()
        .filter(|told| stays(told) || !before.iter().any(|old| is(old, told)));
    let wrong: Vec<String> = wrong
        .map(|told| format!("{}: [{}] {}", told.path, told.rule, told.message))
        .collect();
    (!wrong.is_empty()).then(|| wrong.join("\n  "))
}

#[test]
fn what_a_fix_does_takes_its_finding_away_and_brings_none() {
    let mut chosen: BTreeMap<[String; 2], &[String; 2]> = BTreeMap::new();
    for (case, found) in &*FOUND {
        for (_, help) in helps(&case[0], found).filter(|(told, _)| told.is_fixable) {
            chosen.entry([case[0].clone(), shape(help)]).or_insert(case);
        }
    }
    let faults = on_all(chosen.into_iter().collect(), |([rule, _], case)| {
        let after = Damaged::of(case).on_disk(&["--fix", "--unsafe-fixes"]);
        let has_it = |told: &Told| told.rule == *rule && told.is_fixable;
        let is_hidden = |told: &Told| HIDDEN.contains(&(rule.as_str(), told.rule.as_str()));
        let after: Vec<Told> = after.into_iter().filter(|told| !is_hidden(told)).collect();
        Some(format!(
            "{case:?}\n  {}",
            difference(&FOUND[case], &after, has_it)?
        ))
    });
    let faults: Vec<String> = faults.into_iter().flatten().collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn every_help_has_a_row() {
    let mut missing: BTreeMap<[String; 2], String> = BTreeMap::new();
    let mut fixed = BTreeSet::new();
    for ([rule, case], found) in &*FOUND {
        for (told, help) in helps(rule, found) {
            let key = [rule.clone(), shape(help)];
            missing
                .entry(key.clone())
                .or_insert_with(|| format!("{rule}/{case}: {help}"));
            fixed.extend(told.is_fixable.then_some(key));
        }
    }
    let mut faults = Vec::new();
    let mut known = fixed;
    for (family, row) in Row::all() {
        let key = [row.rule.clone(), shape(&row.help)];
        if !row.rule.starts_with(&format!("{family}-"))
            || row.cannot.is_empty() == row.case.is_empty()
        {
            faults.push(format!(
                "{}: a row is in the file of its family, and has a case or a reason",
                row.rule
            ));
        }
        if std::env::var_os("CASE").is_none() && !missing.contains_key(&key) {
            faults.push(format!("{}: no case shows: {}", row.rule, row.help));
        }
        known.insert(key);
    }
    let open = missing
        .into_iter()
        .filter(|([rule, shape], _)| !known.contains(&[rule.clone(), shape.clone()]));
    faults.extend(open.map(|(_, title)| {
        let family = title.split('-').next().unwrap_or_default().to_owned();
        format!("no row in fixtures/help/{family}.toml (fixtures/README.md): {title}")
    }));
    assert!(
        faults.is_empty(),
        "\n{}\n{} faults",
        faults.join("\n"),
        faults.len()
    );
}

#[test]
fn names_and_numbers_do_not_make_another_help() {
    assert_eq!(shape("rename `a` or `b`"), shape("rename `c`, `d` or `e`"));
    assert_eq!(shape("use 3 of them"), shape("use 14 of them"));
    assert_ne!(shape("add `a`"), shape("remove `a`"));
}

/// Rows are followed as they are read: that they are of rules which exist.
#[test]
fn rows_name_rules() {
    let ids: BTreeSet<&str> = mhlint::rule_infos()
        .into_iter()
        .map(|rule| rule.id)
        .collect();
    let unknown: Vec<String> = Row::all()
        .into_iter()
        .map(|(_, row)| row.rule)
        .filter(|rule| !ids.contains(rule.as_str()))
        .collect();
    assert_eq!(unknown, Vec::<String>::new());
}
