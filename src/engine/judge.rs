//! The rules on one repository, and at the end on the ignores and the baseline.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use rayon::prelude::*;

use super::caught::caught;
use super::settle::{Ignores, Selection, Verdict};
use crate::config::Config;
use crate::diag::{Finding, Outcome, Timing, Upkeep, fingerprint};
use crate::eval::measures::Measures;
use crate::repo::Repository;
use crate::rules::{Check, RULES, Rule, RuleCx};

/// Runs all rules that are on, each in its own thread.
pub(super) fn judge(
    repository: &Repository<'_>,
    measures: Option<&BTreeMap<String, Measures>>,
    selection: &Selection,
    options: &Config,
    outcome: &mut Outcome,
) -> Vec<Finding> {
    let cx = RuleCx { options: &options.rule_options };
    let results: Vec<(&str, Duration, Option<Vec<Finding>>)> = RULES
        .par_iter()
        .filter(|rule| selection.runs(rule.info.id))
        .map(|rule| {
            let started = Instant::now();
            let found = catch_unwind(AssertUnwindSafe(|| run_rule(rule, repository, measures, &cx, options))).ok();
            (rule.info.id, started.elapsed(), found)
        })
        .collect();
    let mut findings = Vec::new();
    for (rule, time, found) in results {
        outcome.timings.push(Timing { what: rule.to_owned(), time });
        match found {
            Some(found) => findings.extend(found),
            None => outcome.failed_rules.push(rule.to_owned()),
        }
    }
    findings
}

fn run_rule(
    rule: &Rule,
    repository: &Repository<'_>,
    measures: Option<&BTreeMap<String, Measures>>,
    cx: &RuleCx<'_>,
    options: &Config,
) -> Vec<Finding> {
    let mut findings = Vec::new();
    let bases = || repository.bases.iter().filter(|base| options.asks_for_base(base.name));
    match rule.check {
        Check::Layer(run) => run(repository.judged, cx, &mut findings),
        Check::Repository(run) => run(repository, cx, &mut findings),
        Check::Upkeep(_) => {}
        Check::Base(run) => bases().for_each(|base| run(repository, base, cx, &mut findings)),
        Check::Numeric(run) => {
            for base in bases() {
                if let Some(measures) = measures.and_then(|all| all.get(base.name)) {
                    run(repository, base, measures, cx, &mut findings);
                }
            }
        }
    }
    findings
}

/// Findings on the ignores themselves. Rules that panicked are noted in `failed`.
pub(super) fn look_after(
    upkeep: &Upkeep,
    selection: &Selection<'_>,
    ignores: &Ignores<'_>,
    options: &Config,
    failed: &mut Vec<String>,
) -> Vec<Finding> {
    let cx = RuleCx { options: &options.rule_options };
    let mut findings = Vec::new();
    for rule in RULES.iter().filter(|rule| selection.runs(rule.info.id)) {
        if let Check::Upkeep(run) = rule.check {
            caught(rule.info.id, failed, || run(upkeep, &cx, &mut findings));
        }
    }
    findings.retain_mut(|finding| {
        let Verdict::At(level) = selection.verdict(finding.rule, finding.level, None) else { return false };
        finding.regrade(level);
        finding.fingerprint = fingerprint(finding.rule, &ignores.asset(&finding.path), &finding.subject.key, 0);
        true
    });
    findings
}
