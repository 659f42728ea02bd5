//! The rules over the views of the same data, and at the end over the ignores and the baseline.

mod merge;

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use rayon::prelude::*;

use self::merge::merged;
use super::caught::caught;

use super::settle::{Ignores, Selection, Verdict};
use crate::config::Config;
use crate::diag::{Finding, Outcome, Timed, Timing, Upkeep, fingerprint};
use crate::eval::measures::Measures;
use crate::repo::{Body, FileFacts, View};
use crate::rules::{Check, RULES, Rule, RuleCx};

/// A view with what is computed once for all rules.
struct Sight<'v> {
    view: &'v View<'v>,
    bodies: Vec<Body<'v>>,
    /// By name of the body.
    measures: Option<&'v BTreeMap<String, Measures>>,
}

/// Runs all rules that are on over each view; what several views show is one finding.
pub(super) fn check(
    views: &[(&View<'_>, Option<&BTreeMap<String, Measures>>)],
    selection: &Selection<'_>,
    options: &Config,
    outcome: &mut Outcome,
) -> Vec<Finding> {
    merged(views.iter().map(|(view, measures)| check_view(view, *measures, selection, options, outcome)).collect())
}

/// Runs the rules that concern the application, each in its own thread.
fn check_view(
    view: &View<'_>,
    measures: Option<&BTreeMap<String, Measures>>,
    selection: &Selection<'_>,
    options: &Config,
    outcome: &mut Outcome,
) -> Vec<Finding> {
    let cx = RuleCx { options: &options.rule_options };
    let sight = Sight { view, bodies: view.bodies(), measures };
    let application = view.application();
    let results: Vec<(&str, Duration, Option<Vec<Finding>>)> = RULES
        .par_iter()
        .filter(|rule| selection.runs(rule.info.id) && rule.concerns(application))
        .map(|rule| {
            let started = Instant::now();
            let found = catch_unwind(AssertUnwindSafe(|| run_rule(rule, &sight, &cx, options))).ok();
            (rule.info.id, started.elapsed(), found)
        })
        .collect();
    let mut findings = Vec::new();
    for (rule, time, found) in results {
        outcome.timings.push(Timing { what: Timed::Rule(rule), time });
        match found {
            Some(found) => findings.extend(found),
            None => outcome.failed_rules.push(rule.to_owned()),
        }
    }
    findings.into_iter().map(|finding| finding.only_in(&[application])).collect()
}

fn run_rule(rule: &Rule, sight: &Sight<'_>, cx: &RuleCx<'_>, options: &Config) -> Vec<Finding> {
    let mut findings = Vec::new();
    let out = &mut findings;
    let view = sight.view;
    // What belongs to no mesh is asked for with every one.
    let asked = |name: &str| name.is_empty() || options.asks_for_base(name);
    let bodies = || sight.bodies.iter().filter(|body| asked(body.name));
    match (&rule.check, view) {
        (Check::File(run), _) => {
            // Not what another application reads it as.
            let own = |file: &&FileFacts| file.kind_in(view.application()) == file.kind;
            view.layers().checked.files.values().filter(own).for_each(|file| run(file, cx, out));
        }
        (Check::Body(run), _) => bodies().for_each(|body| run(body, cx, out)),
        (Check::Makehuman2(run), View::Makehuman2(view)) => {
            view.bases.iter().filter(|base| asked(base.name)).for_each(|base| run(view, base, cx, out));
        }
        (Check::Makehuman1(run), View::Makehuman1(view)) => run(view, cx, out),
        (Check::Mpfb(run), View::Mpfb(view)) => run(view, cx, out),
        (Check::Numeric(run), _) => {
            for body in bodies() {
                if let Some(measures) = sight.measures.and_then(|all| all.get(body.name)) {
                    run(body, measures, cx, out);
                }
            }
        }
        (Check::Repository(run), _) => run(view, cx, out),
        (Check::Makehuman2(_) | Check::Makehuman1(_) | Check::Mpfb(_) | Check::Upkeep(_), _) => {}
    }
    findings
}

/// Findings on the ignores themselves. Rules that panicked are noted in `failed`.
pub(super) fn check_upkeep(
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
