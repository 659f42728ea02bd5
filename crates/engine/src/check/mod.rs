//! The rules over the views of the same data, and at the end over the ignores and the baseline.

mod merge;
mod pair;

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use self::merge::merged;
pub(super) use self::merge::merged_as_printed;
use super::caught::caught;

use super::settle::{Ignores, Selection, Verdict};
use mhlint_config::Config;
use mhlint_diag::{Finding, Outcome, Timed, Timing, Upkeep, fingerprint};
use mhlint_eval::measures::Measures;
use mhlint_repo::{Body, Doubt, FileFacts, Layers, View};
use mhlint_rules::{
    Check, RULES, Rule, RuleCx, SideBySide, drop_outdated, drop_unmerged, lower_archived,
    lower_aside, name_wearers, word_for_version,
};

/// A view with what is computed once for all rules.
struct Checked<'v> {
    view: &'v View<'v>,
    files: Vec<&'v FileFacts>,
    bodies: Vec<Body<'v>>,
    /// By name of the body.
    measures: Option<&'v ByBase>,
    /// The assets of packs that are checked side by side.
    beside: &'v SideBySide,
}

/// What a rule did, or a part of it.
#[derive(Default)]
struct Done {
    time: Duration,
    findings: Vec<Finding>,
    failed: bool,
}

/// Measures by name of the base.
type ByBase = BTreeMap<String, Arc<Measures>>;

/// Files that all rules on files look at before they go on: so many are still near when the next
/// rule comes.
const AT_ONCE: usize = 128;

/// Runs those of the rules that are on over each view; what several views show is one finding.
pub(super) fn check(
    rules: &[&Rule],
    views: &[(&View<'_>, Option<&ByBase>)],
    beside: &SideBySide,
    selection: &Selection<'_>,
    options: &Config,
    outcome: &mut Outcome,
) -> Vec<Finding> {
    let mut found = Vec::new();
    for (view, measures) in views {
        let checked = Checked {
            view,
            files: view.files().collect(),
            bodies: view.bodies(),
            measures: *measures,
            beside,
        };
        found.push(check_view(rules, &checked, selection, options, outcome));
    }
    merged(found)
}

/// Runs the rules that concern the application: those on files over some files in a thread, each
/// other one in its own.
fn check_view(
    rules: &[&Rule],
    checked: &Checked<'_>,
    selection: &Selection<'_>,
    options: &Config,
    outcome: &mut Outcome,
) -> Vec<Finding> {
    let view = checked.view;
    let application = view.application();
    let is_loose = view.layers().checked.is_loose;
    let in_pieces = view.is_in_pieces();
    let is_asked =
        |rule: &Rule| !(is_loose && rule.info.of_library || in_pieces && asks_for_whole(rule));
    let is_on =
        |rule: &Rule| selection.runs(rule.info.id) && rule.concerns(application) && is_asked(rule);
    let rules: Vec<&Rule> = rules.iter().copied().filter(|rule| is_on(rule)).collect();
    let mut done = over_files(checked, &rules, options);
    let others = rules
        .par_iter()
        .map(|rule| run_caught(|out| run_rule(rule, checked, options, out)));
    done.iter_mut()
        .zip(others.collect::<Vec<_>>())
        .for_each(|(done, other)| done.join(other));
    let mut findings = Vec::new();
    for (rule, done) in rules.iter().zip(done) {
        outcome.timings.push(Timing {
            what: Timed::Rule(rule.info.id),
            time: done.time,
        });
        if done.failed {
            outcome.failed_rules.push(rule.info.id.to_owned());
        } else {
            findings.extend(done.findings);
        }
    }
    drop_outdated(view, &mut findings);
    drop_unmerged(&mut findings);
    name_wearers(view, &mut findings);
    lower_archived(view, &mut findings);
    lower_aside(view, &mut findings);
    word_for_version(view, &mut findings);
    let of_system = |names: &BTreeSet<&'static str>| alone(view, &rules, names, options);
    let findings = pair::at_checked(findings, view.layers(), of_system);
    findings
        .into_iter()
        .map(|finding| finding.only_in(&[application]))
        .collect()
}

/// Whether a rule takes the data of a program for a whole: what its indexes name has to be there,
/// and what is there has to be named.
fn asks_for_whole(rule: &Rule) -> bool {
    const FAMILIES: [&str; 12] = [
        "base",
        "catalog",
        "filter",
        "library",
        "macro",
        "metadata",
        "modelling",
        "modifiers",
        "numeric",
        "overlay",
        "parts",
        "program",
    ];
    let info = &rule.info;
    !info.of_pieces && (info.of_library || info.of_whole || FAMILIES.contains(&info.family()))
}

/// What these rules find in the system data alone.
fn alone(
    view: &View<'_>,
    rules: &[&Rule],
    names: &BTreeSet<&'static str>,
    options: &Config,
) -> Vec<Finding> {
    let Some(system) = view.layers().system else {
        return Vec::new();
    };
    let view = View::connect(
        view.application(),
        Layers {
            system: Some(system),
            user: None,
            beside: None,
            checked: system,
        },
    );
    let beside = SideBySide::default();
    let checked = Checked {
        view: &view,
        files: Vec::new(),
        bodies: view.bodies(),
        measures: None,
        beside: &beside,
    };
    let asked = rules.iter().filter(|rule| names.contains(rule.info.id));
    asked
        .flat_map(|rule| run_caught(|out| run_rule(rule, &checked, options, out)).findings)
        .collect()
}

impl Done {
    fn join(&mut self, other: Self) {
        self.time += other.time;
        self.findings.extend(other.findings);
        self.failed |= other.failed;
    }
}

fn run_caught(run: impl FnOnce(&mut Vec<Finding>)) -> Done {
    let started = Instant::now();
    let mut findings = Vec::new();
    let failed = catch_unwind(AssertUnwindSafe(|| run(&mut findings))).is_err();
    Done {
        time: started.elapsed(),
        findings,
        failed,
    }
}

/// What the rules on files did, in the order of `rules`; nothing for the others.
fn over_files(checked: &Checked<'_>, rules: &[&Rule], options: &Config) -> Vec<Done> {
    let run_all = |files: &[&FileFacts]| -> Vec<Done> {
        let run = |rule: &&Rule| match rule.check {
            Check::File(run) => run_caught(|out| {
                let cx = RuleCx::new(&options.rule_options, checked.beside);
                files
                    .iter()
                    .for_each(|file| run(checked.view, file, &cx, out));
            }),
            _ => Done::default(),
        };
        rules.iter().map(run).collect()
    };
    let parts: Vec<Vec<Done>> = checked.files.par_chunks(AT_ONCE).map(run_all).collect();
    let mut all: Vec<Done> = rules.iter().map(|_| Done::default()).collect();
    for part in parts {
        all.iter_mut()
            .zip(part)
            .for_each(|(all, part)| all.join(part));
    }
    all
}

/// The family of the rules that compare macros with one another.
const MACROS: &str = "macro";

/// Runs a rule on more than files.
fn run_rule(rule: &Rule, checked: &Checked<'_>, options: &Config, out: &mut Vec<Finding>) {
    let cx = &RuleCx::new(&options.rule_options, checked.beside);
    // What belongs to no mesh is asked for with every one.
    let asked = |name: &str| name.is_empty() || options.asks_for_base(name);
    let bodies = || checked.bodies.iter().filter(|body| asked(body.name));
    match (&rule.check, checked.view) {
        (Check::Body(run), _) => bodies().for_each(|body| run(body, cx, out)),
        (Check::Makehuman2(run) | Check::EachBase(run, ..), View::Makehuman2(view)) => {
            let compares_macros = rule.info.family() == MACROS;
            let bases = view.bases.iter().filter(|base| asked(base.name));
            let bases = bases.filter(|base| !(compares_macros && base.has_too_many_macros()));
            bases.for_each(|base| run(view, base, cx, out));
        }
        (Check::Makehuman2Library(run), View::Makehuman2(view)) => run(view, cx, out),
        (Check::Libraries(run, _) | Check::LibrariesOfAll(run, ..), View::Makehuman2(view)) => {
            run(view, cx, out);
        }
        (
            Check::Libraries(_, run)
            | Check::LibrariesOfAll(_, run, _)
            | Check::EachBase(_, run, _)
            | Check::Makehuman1(run),
            View::Makehuman1(view),
        ) => run(view, cx, out),
        (
            Check::Mpfb(run) | Check::EachBase(.., run) | Check::LibrariesOfAll(.., run),
            View::Mpfb(view),
        ) => {
            run(view, cx, out);
        }
        (Check::Numeric(run), _) => {
            // What is measured on a mesh in another unit follows from that.
            for body in bodies().filter(|body| body.doubt != Some(Doubt::Misplaced)) {
                if let Some(measures) = checked.measures.and_then(|all| all.get(body.name)) {
                    run(body, measures, cx, out);
                }
            }
        }
        (Check::Repository(run), view) => run(view, cx, out),
        (
            Check::File(_)
            | Check::Makehuman2(_)
            | Check::Makehuman2Library(_)
            | Check::Libraries(..)
            | Check::Makehuman1(_)
            | Check::Mpfb(_)
            | Check::Upkeep(_),
            _,
        ) => {}
    }
}

/// Findings on the ignores themselves. Rules that panicked are noted in `failed`.
pub(super) fn check_upkeep(
    upkeep: &Upkeep,
    selection: &Selection<'_>,
    ignores: &Ignores<'_>,
    options: &Config,
    failed: &mut Vec<String>,
) -> Vec<Finding> {
    let beside = SideBySide::default();
    let cx = RuleCx::new(&options.rule_options, &beside);
    let mut findings = Vec::new();
    for rule in RULES.iter().filter(|rule| selection.runs(rule.info.id)) {
        if let Check::Upkeep(run) = rule.check {
            caught(rule.info.id, failed, || run(upkeep, &cx, &mut findings));
        }
    }
    findings.retain_mut(|finding| {
        let Verdict::At(level) = selection.verdict(finding.rule, finding.level, None) else {
            return false;
        };
        finding.regrade(level);
        finding.fingerprint = fingerprint(
            finding.rule,
            &ignores.asset(&finding.path),
            &finding.subject.key,
            0,
        );
        true
    });
    findings
}

#[cfg(test)]
mod tests {
    use super::super::load::{Data, Input, Roots};
    use super::super::settle::Scope;
    use super::*;
    use mhlint_diag::Application::{Makehuman2, Mpfb};
    use mhlint_diag::{Application, Case, Level, Place, RuleInfo};
    use mhlint_source::Tree;

    static RULE: Rule = Rule {
        info: RuleInfo {
            breaks: &[(Makehuman2, "stops"), (Mpfb, "ignores it")],
            levels: &[(Mpfb, Level::Info)],
            ..RuleInfo::new("made-up", Level::Error, "")
        },
        check: Check::File(|_, file, _, out| {
            let finding = RULE.at(file, Place::File, "");
            out.push(match file.stem() {
                "loaded" => finding.case(LOADED),
                "worse" => finding.case(LOADED).case(WORSE),
                "harmless" => finding.at_most(Level::Info),
                _ => finding,
            });
        }),
    };

    const LOADED: Case = &[(Makehuman2, Level::Warning, "loads it")];
    const WORSE: Case = &[(Mpfb, Level::Error, "cannot be enabled")];

    #[test]
    fn each_application_has_its_own_level_and_words_and_the_finding_the_worst() {
        let certain = [
            "base/cube/base.json",
            "target/cube/a/b.target",
            "targets/target.json",
            "mesh_metadata/hm08_config.json",
            "node_trees/a.json",
        ];
        let files = certain.into_iter();
        let clothes = ["usual", "loaded", "worse", "harmless"]
            .map(|name| format!("clothes/hm08/a/{name}.mhclo"));
        let files = files
            .map(str::to_owned)
            .chain(clothes)
            .map(|path| (path, b"#".to_vec()));
        let config = Config {
            applications: vec![Makehuman2, Mpfb],
            ..Config::default()
        };
        let mut outcome = Outcome::default();
        let inputs = [Input::whole(Tree::in_memory("", files))];
        let scope = Scope::new(vec![String::new()], &config);
        let roots = Roots::of(&inputs, &[], &scope, &config, &mut outcome).unwrap();
        let data = Data::load(roots, &config.limits, None);
        let seen = data.stacks().into_iter().flat_map(|stack| stack.seen);
        let views: Vec<View<'_>> = seen
            .map(|(application, layers)| View::connect(application, layers))
            .collect();
        let views: Vec<_> = views.iter().map(|view| (view, None)).collect();
        let selection = Selection::new(&config).unwrap();
        let mut found = check(
            &[&RULE],
            &views,
            &SideBySide::default(),
            &selection,
            &config,
            &mut outcome,
        );
        found.retain(|finding| finding.path.starts_with("clothes/"));
        let row = |finding: &Finding, of: Application| {
            let own = finding
                .breaks
                .iter()
                .find(|own| own.application == of)
                .unwrap();
            (own.level, own.effect.clone())
        };
        let told =
            |finding: &Finding| (finding.level, row(finding, Makehuman2), row(finding, Mpfb));
        let usual = (Level::Info, "ignores it".to_owned());
        let expected = [
            (
                Level::Info,
                (Level::Info, "stops".to_owned()),
                usual.clone(),
            ),
            (
                Level::Warning,
                (Level::Warning, "loads it".to_owned()),
                usual.clone(),
            ),
            (Level::Error, (Level::Error, "stops".to_owned()), usual),
            (
                Level::Error,
                (Level::Warning, "loads it".to_owned()),
                (Level::Error, "cannot be enabled".to_owned()),
            ),
        ];
        assert_eq!(found.iter().map(told).collect::<Vec<_>>(), expected);
    }
}
