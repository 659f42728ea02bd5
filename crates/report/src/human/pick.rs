//! Which findings a person gets to see: the gravest first, a bounded number for each rule and file.

use std::collections::BTreeMap;

use super::groups::{Group, groups};
use mhlint_diag::{Finding, Level};

/// Findings of one rule in a report; the eleventh says nothing that ten did not.
const PER_RULE: usize = 10;
/// Findings of one file in a report: about two screens.
const PER_FILE: usize = 20;

/// What is shown and what was left out.
#[derive(Default)]
pub(super) struct Picked<'a> {
    /// The findings to show, in the order of the report.
    pub(super) shown: Vec<Group<'a>>,
    left_of_rule: BTreeMap<&'static str, usize>,
    left_in_file: BTreeMap<&'a str, usize>,
    left_of_level: BTreeMap<Level, usize>,
}

/// Picks from all findings, which come in the order of the report; with `full` all of them. Those
/// that share a line count as one.
pub(super) fn pick(findings: &[Finding], full: bool) -> Picked<'_> {
    let groups = groups(findings, full);
    if full {
        return Picked {
            shown: groups,
            ..Picked::default()
        };
    }
    let mut by_level: Vec<(usize, Group<'_>)> = groups.into_iter().enumerate().collect();
    by_level.sort_by_key(|(_, group)| std::cmp::Reverse(group.first.level));
    let mut of_rule: BTreeMap<&str, usize> = BTreeMap::new();
    let mut in_file: BTreeMap<&str, usize> = BTreeMap::new();
    let mut picked = Picked::default();
    let mut shown = Vec::new();
    for (at, group) in by_level {
        let Finding {
            rule, path, level, ..
        } = group.first;
        let (of_rule, in_file) = (
            of_rule.entry(rule).or_default(),
            in_file.entry(path).or_default(),
        );
        if *of_rule >= PER_RULE || *in_file >= PER_FILE {
            *picked.left_of_level.entry(*level).or_default() += group.len();
        }
        if *of_rule >= PER_RULE {
            *picked.left_of_rule.entry(rule).or_default() += group.len();
        } else if *in_file >= PER_FILE {
            *picked.left_in_file.entry(path).or_default() += group.len();
        } else {
            (*of_rule, *in_file) = (*of_rule + 1, *in_file + 1);
            shown.push((at, group));
        }
    }
    shown.sort_by_key(|(at, _)| *at);
    picked.shown = shown.into_iter().map(|(_, group)| group).collect();
    picked
}

impl Picked<'_> {
    /// How many findings of a level are not shown.
    pub(super) fn left(&self, level: Level) -> usize {
        self.left_of_level.get(&level).copied().unwrap_or_default()
    }

    /// What to say below a finding that is the last shown of its rule while more were left out.
    pub(super) fn more_like(&self, finding: &Finding) -> Option<String> {
        let left = self.left_of_rule.get(finding.rule)?;
        let last = self
            .shown
            .iter()
            .rfind(|other| other.first.rule == finding.rule)?;
        std::ptr::eq(last.first, finding).then(|| {
            format!(
                "and {left} more like it; `--only {} --full` shows all",
                finding.rule
            )
        })
    }

    /// What to say below the last shown finding of a file of which more were left out.
    pub(super) fn more_in(&self, path: &str) -> Option<String> {
        let left = self.left_in_file.get(path)?;
        Some(format!("and {left} more in this file; `--full` shows all"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Place, RuleInfo};

    fn findings(rule: &'static str, level: Level, number: usize) -> Vec<Finding> {
        let info = RuleInfo::new(rule, level, "");
        (0..number)
            .map(|at| Finding::new(&info, format!("{rule}{at}"), Place::File, ""))
            .collect()
    }

    #[test]
    fn the_last_shown_finding_says_how_many_are_left() {
        let all = findings("a", Level::Warning, PER_RULE + 3);
        let picked = pick(&all, false);
        assert_eq!(picked.shown.len(), PER_RULE);
        assert!(
            picked
                .more_like(&all[PER_RULE - 1])
                .unwrap()
                .starts_with("and 3 more like it")
        );
        assert_eq!(picked.more_like(&all[0]), None);
    }

    #[test]
    fn an_error_is_shown_before_the_file_is_full_of_warnings() {
        let mut all = Vec::new();
        for rule in ["a", "b", "c"] {
            all.extend(findings(rule, Level::Warning, PER_RULE));
        }
        all.extend(findings("d", Level::Error, 1));
        for finding in &mut all {
            finding.path = "same".to_owned();
        }
        let picked = pick(&all, false);
        assert_eq!(picked.shown.last().unwrap().first.rule, "d");
        assert!(picked.more_in("same").unwrap().starts_with("and 11 more"));
    }
}
