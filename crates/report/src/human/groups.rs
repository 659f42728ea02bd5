//! Infos that say the same of many files, or many times of one: a line for all of them.

use std::collections::BTreeMap;

use crate::{phrase, printable};
use mhlint_diag::{Finding, Level};

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

/// Findings in their order; infos of one rule that lie in the files of one folder, or in one file,
/// stand together where the first of them stands, unless all are to be shown in full.
pub(super) fn groups(findings: &[Finding], full: bool) -> Vec<Group<'_>> {
    let shared = if full {
        BTreeMap::new()
    } else {
        shared(findings)
    };
    let mut numbers: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut groups: Vec<Group<'_>> = Vec::new();
    for finding in findings {
        let place = shared
            .get(&(finding.path.as_str(), finding.rule))
            .filter(|_| finding.level == Level::Info);
        let known = place.and_then(|place| numbers.get(&(*place, finding.rule)));
        if let Some(group) = known.and_then(|number| groups.get_mut(*number)) {
            group.rest.push(finding);
            continue;
        }
        if let Some(place) = place {
            numbers.insert((place, finding.rule), groups.len());
        }
        groups.push(Group {
            first: finding,
            rest: Vec::new(),
        });
    }
    groups
}

/// The folder or file whose line has the infos, by file and rule.
fn shared(findings: &[Finding]) -> BTreeMap<(&str, &str), &str> {
    let mut folders: BTreeMap<(&str, &str), BTreeMap<&str, usize>> = BTreeMap::new();
    for finding in findings
        .iter()
        .filter(|finding| finding.level == Level::Info)
    {
        let files = folders
            .entry((folder_of(&finding.path), finding.rule))
            .or_default();
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

    /// One line: the first finding, how many are like it, and where those are.
    pub(super) fn line(&self) -> String {
        let Self { first, rest } = self;
        let line = phrase::one_line(first);
        if rest.is_empty() {
            return line;
        }
        let places = if rest.iter().any(|finding| finding.path != first.path) {
            format!(
                ": {}",
                listed(&distinct(
                    rest.iter()
                        .map(|finding| format!("`{}`", printable(&name(finding))))
                ))
            )
        } else {
            let lines = distinct(
                rest.iter()
                    .filter_map(|finding| finding.location.line)
                    .map(|line| line.to_string()),
            );
            match lines.as_slice() {
                [] => String::new(),
                [only] => format!(": line {only}"),
                _ => format!(": lines {}", listed(&lines)),
            }
        };
        format!("{line}; {} more like it{places}", rest.len())
    }
}

/// What a finding stands at, without the folder.
fn name(finding: &Finding) -> String {
    let path = phrase::path_of(finding);
    let from = folder_of(path.trim_end_matches('/')).len();
    path.get(from..)
        .unwrap_or_default()
        .trim_start_matches('/')
        .to_owned()
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
    use mhlint_diag::{Place, RuleInfo};

    fn at(path: &str, level: Level) -> Finding {
        Finding::new(
            &RuleInfo::new("a-rule", level, ""),
            path,
            Place::File,
            format!("{path} is so"),
        )
    }

    fn lines(findings: &[Finding], full: bool) -> Vec<String> {
        groups(findings, full).iter().map(Group::line).collect()
    }

    #[test]
    fn infos_of_a_folder_share_a_line() {
        let findings: Vec<Finding> = (0..7)
            .map(|number| at(&format!("a/{number}.x"), Level::Info))
            .collect();
        let names = "`1.x`, `2.x`, `3.x`, `4.x`, `5.x` and 1 more";
        assert_eq!(
            lines(&findings, false),
            [format!(
                "a/0.x: info[a-rule] a/0.x is so; 6 more like it: {names}"
            )]
        );
        assert_eq!(lines(&findings, true).len(), 7);
        assert_eq!(
            lines(&findings[..2], false),
            [
                "a/0.x: info[a-rule] a/0.x is so",
                "a/1.x: info[a-rule] a/1.x is so"
            ]
        );
        let top = ["x", "y", "z"].map(|path| at(path, Level::Info));
        assert_eq!(
            lines(&top, false),
            ["x: info[a-rule] x is so; 2 more like it: `y`, `z`"]
        );
    }

    #[test]
    fn infos_of_a_file_share_a_line() {
        let mut findings = ["a/x", "a/x", "a/x", "a/y"].map(|path| at(path, Level::Info));
        findings[0].location.line = Some(3);
        findings[2].location.line = Some(7);
        let expected = [
            "a/x:3: info[a-rule] a/x is so; 2 more like it: line 7",
            "a/y: info[a-rule] a/y is so",
        ];
        assert_eq!(lines(&findings, false), expected);
    }

    #[test]
    fn warnings_stand_alone() {
        let findings = ["a/1", "a/2", "a/3", "a/4"].map(|path| at(path, Level::Warning));
        assert_eq!(groups(&findings, false).len(), 4);
        assert!(
            groups(&findings, false)
                .iter()
                .all(|group| group.len() == 1)
        );
    }
}
