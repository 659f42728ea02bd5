//! Infos that say the same of many files, or many times of one: a line for all of them.

use std::collections::{BTreeMap, BTreeSet};

use crate::diag::{Finding, Level};
use crate::report::{count, phrase, printable};

/// Infos of one rule in a folder or file from which on they share a line.
const MANY: usize = 3;

/// Names in a line.
const NAMED: usize = 5;

/// Findings that are shown as one.
pub(super) struct Group<'f> {
    /// The first: all of a group have its rule and level.
    pub(super) first: &'f Finding,
    rest: Vec<&'f Finding>,
}

/// Findings in their order; infos of one rule that lie in the files of one folder, or in one file, stand together where
/// the first of them stands, unless all are to be shown in full.
pub(super) fn groups(findings: &[Finding], full: bool) -> Vec<Group<'_>> {
    let shared = if full { BTreeMap::new() } else { shared(findings) };
    let mut numbers: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut groups: Vec<Group<'_>> = Vec::new();
    for finding in findings {
        let place = shared.get(&(finding.path.as_str(), finding.rule)).filter(|_| finding.level == Level::Info);
        let known = place.and_then(|place| numbers.get(&(*place, finding.rule)));
        if let Some(group) = known.and_then(|number| groups.get_mut(*number)) {
            group.rest.push(finding);
            continue;
        }
        if let Some(place) = place {
            numbers.insert((place, finding.rule), groups.len());
        }
        groups.push(Group { first: finding, rest: Vec::new() });
    }
    groups
}

/// The folder or file whose line has the infos, by file and rule.
fn shared(findings: &[Finding]) -> BTreeMap<(&str, &str), &str> {
    let mut folders: BTreeMap<(&str, &str), BTreeMap<&str, usize>> = BTreeMap::new();
    for finding in findings.iter().filter(|finding| finding.level == Level::Info) {
        let files = folders.entry((folder_of(&finding.path), finding.rule)).or_default();
        *files.entry(&finding.path).or_default() += 1;
    }
    let mut shared = BTreeMap::new();
    for ((folder, rule), files) in folders {
        for (path, infos) in &files {
            if files.len() >= MANY {
                shared.insert((*path, rule), folder);
            } else if *infos >= MANY {
                shared.insert((*path, rule), *path);
            }
        }
    }
    shared
}

fn folder_of(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}

impl Group<'_> {
    /// How many findings it has.
    pub(super) fn len(&self) -> usize {
        self.rest.len() + 1
    }

    /// One line: where, which rule, how many, and what the first one says.
    pub(super) fn line(&self) -> String {
        let Self { first, rest } = self;
        if rest.is_empty() {
            return phrase::one_line(first);
        }
        let all = || std::iter::once(first).chain(rest);
        let files: BTreeSet<&str> = all().map(|finding| finding.path.as_str()).collect();
        let (place, number, names) = if files.len() > 1 {
            let names = all().map(|finding| format!("`{}`", name(finding)));
            (folder(first), count(files.len(), "file"), distinct(names))
        } else {
            let lines = all().filter_map(|finding| finding.location.line);
            (phrase::path_of(first), format!("{} times", self.len()), distinct(lines.map(|line| line.to_string())))
        };
        let message = printable(&phrase::message(first));
        let names = match (files.len(), names.len()) {
            (_, 0) => String::new(),
            (1, 1) => format!(": line {}", listed(&names)),
            (1, _) => format!(": lines {}", listed(&names)),
            _ => format!(": {}", listed(&names)),
        };
        format!("{place}: {}[{}] {number}{names}; the first: {message}", first.level, first.rule)
    }
}

/// The folder of a finding as a place.
fn folder(finding: &Finding) -> String {
    let folder = folder_of(&finding.path);
    printable(&format!("{}/", if folder.is_empty() { "." } else { folder }))
}

/// What a finding stands at, without the folder.
fn name(finding: &Finding) -> String {
    let path = phrase::path_of(finding);
    let from = folder_of(path.trim_end_matches('/')).len();
    path.get(from..).unwrap_or_default().trim_start_matches('/').to_owned()
}

fn distinct(names: impl Iterator<Item = String>) -> Vec<String> {
    let mut distinct: Vec<String> = names.collect();
    distinct.dedup();
    distinct
}

/// `a, b, c, d, e and 7 more`.
fn listed(names: &[String]) -> String {
    let shown = names.get(..NAMED).unwrap_or(names).join(", ");
    match names.len().saturating_sub(NAMED) {
        0 => shown,
        left => format!("{shown} and {left} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Place, RuleInfo};

    fn at(path: &str, level: Level) -> Finding {
        Finding::new(&RuleInfo::new("a-rule", level, ""), path, Place::File, format!("{path} is so"))
    }

    fn lines(findings: &[Finding], full: bool) -> Vec<String> {
        groups(findings, full).iter().map(Group::line).collect()
    }

    #[test]
    fn infos_of_a_folder_share_a_line() {
        let findings: Vec<Finding> = (0..7).map(|number| at(&format!("a/{number}.x"), Level::Info)).collect();
        let names = "`0.x`, `1.x`, `2.x`, `3.x`, `4.x` and 2 more";
        assert_eq!(lines(&findings, false), [format!("a/: info[a-rule] 7 files: {names}; the first: a/0.x is so")]);
        assert_eq!(lines(&findings, true).len(), 7);
        assert_eq!(
            lines(&findings[..2], false),
            ["a/0.x: info[a-rule] a/0.x is so", "a/1.x: info[a-rule] a/1.x is so"]
        );
        let top = ["x", "y", "z"].map(|path| at(path, Level::Info));
        assert_eq!(lines(&top, false), ["./: info[a-rule] 3 files: `x`, `y`, `z`; the first: x is so"]);
    }

    #[test]
    fn infos_of_a_file_share_a_line() {
        let mut findings = ["a/x", "a/x", "a/x", "a/y"].map(|path| at(path, Level::Info));
        findings[0].location.line = Some(3);
        findings[2].location.line = Some(7);
        let expected = ["a/x: info[a-rule] 3 times: lines 3, 7; the first: a/x is so", "a/y: info[a-rule] a/y is so"];
        assert_eq!(lines(&findings, false), expected);
    }

    #[test]
    fn warnings_stand_alone() {
        let findings = ["a/1", "a/2", "a/3", "a/4"].map(|path| at(path, Level::Warning));
        assert_eq!(groups(&findings, false).len(), 4);
        assert!(groups(&findings, false).iter().all(|group| group.len() == 1));
    }
}
