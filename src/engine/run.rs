//! A run: inputs to data roots, roots to repositories, repositories through the rules to an outcome.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use super::data::Data;
use super::input::{Input, open};
use super::load::Place;
use super::locate::locate;
use super::measure::measure_bases;
use super::outcome::{Error, Outcome, RootSummary, Timing};
use super::select::Selection;
use super::stack::Role;
use crate::diag::{Application, Finding, Level, fingerprint};
use crate::discover::{DataRoot, find_roots};
use crate::eval::measures::Measures;
use crate::repo::{Layer, Repository};
use crate::rules::{Check, RULES, Rule, RuleCx};
use crate::source::{EntryKind, Limits, Tree};

/// What a run is asked to do.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// System data that is read and not reported.
    pub system: Option<PathBuf>,
    /// Judge these applications only; empty for all.
    pub applications: Vec<Application>,
    /// Report these base meshes only; empty for all.
    pub bases: Vec<String>,
    /// Globs of rule ids to run; empty for all.
    pub only: Vec<String>,
    /// Globs of rule ids not to run.
    pub skip: Vec<String>,
    /// Levels by rule id or glob, `None` for off; the last one that fits counts.
    pub levels: Vec<(String, Option<Level>)>,
    /// Options of rules, by rule and name.
    pub rule_options: BTreeMap<(String, String), f64>,
    /// Leave out everything that needs evaluation.
    pub no_eval: bool,
    /// Random settings of the sliders to look at besides the deliberate ones; `None` for the default.
    pub samples: Option<usize>,
    /// Visit every corner of the slider space.
    pub exhaustive: bool,
    /// Bounds on what is read.
    pub limits: Limits,
}

/// Judges data roots found at `paths`.
///
/// # Errors
/// When a path cannot be read, or an option names nothing that exists.
pub fn lint(paths: &[PathBuf], options: &Options) -> Result<Outcome, Error> {
    let inputs = open(paths)?;
    let system = options.system.as_deref().map(super::input::open_system).transpose()?;
    lint_inputs(&inputs, system.as_ref(), options)
}

/// Judges data roots in trees, from disk or memory; `system` is read and not reported.
///
/// # Errors
/// As [`lint`].
pub fn lint_trees(trees: Vec<Tree>, system: Option<Tree>, options: &Options) -> Result<Outcome, Error> {
    let inputs: Vec<Input> = trees.into_iter().map(Input::whole).collect();
    lint_inputs(&inputs, system.as_ref(), options)
}

/// A data root with its facts.
pub(super) struct Loaded<'t> {
    pub(super) place: Place<'t>,
    pub(super) layer: Layer,
    pub(super) role: Role,
    narrow: Vec<String>,
}

pub(super) fn lint_inputs(inputs: &[Input], system: Option<&Tree>, options: &Options) -> Result<Outcome, Error> {
    let selection = Selection::new(options)?;
    let mut outcome = Outcome::default();
    let started = Instant::now();
    let system_roots = system.map(roots_of).unwrap_or_default();
    let system_place = system.map(|tree| system_place(tree, &system_roots)).transpose()?;
    let roots: Vec<Vec<DataRoot>> = inputs.iter().map(|input| roots_of(&input.tree)).collect();
    let places = places(inputs, &roots, system_place, options, &mut outcome);
    let mut data = Data::load(places, system_place, &options.limits);
    outcome.timings.push(timing("read", started));
    let started = Instant::now();
    let measures = measure_bases(&mut data, options);
    outcome.timings.push(timing("targets and evaluation", started));
    let started = Instant::now();
    for (number, (system, user, judged)) in data.stacks().into_iter().enumerate() {
        outcome.summary.files += judged.layer.files.len();
        outcome.summary.bytes += judged.layer.files.values().map(|file| file.size).sum::<u64>();
        let repository = Repository::connect(Application::Makehuman2, system, user, &judged.layer);
        summarise(&repository, &mut outcome);
        let findings = judge(&repository, measures.get(number), &selection, options, &mut outcome);
        outcome.findings.extend(report(&repository, findings, judged, &selection, options));
    }
    check_bases(options, &outcome)?;
    outcome.timings.push(timing("rules", started));
    let trees: Vec<&Tree> = inputs.iter().map(|input| &input.tree).chain(system).collect();
    let started = Instant::now();
    finish(&mut outcome, &trees, &options.limits);
    outcome.timings.push(timing("places", started));
    Ok(outcome)
}

fn timing(what: &str, started: Instant) -> Timing {
    Timing { what: what.to_owned(), time: started.elapsed() }
}

fn system_place<'t>(tree: &'t Tree, roots: &'t [DataRoot]) -> Result<Place<'t>, Error> {
    let root = roots.iter().find(|root| root.application == Application::Makehuman2);
    let root = root.ok_or_else(|| Error::Path {
        path: tree.label().to_owned(),
        reason: "holds no MakeHuman 2 data (a folder with base/<name>/base.json in it is wanted)".to_owned(),
    })?;
    Ok(Place { tree, root: &root.path })
}

pub(super) fn roots_of(tree: &Tree) -> Vec<DataRoot> {
    let files = tree.entries().iter().filter(|entry| entry.kind == EntryKind::File);
    find_roots(files.map(|entry| entry.path.as_str()))
}

/// The data roots to judge, with what to report of each.
fn places<'t>(
    inputs: &'t [Input],
    roots: &'t [Vec<DataRoot>],
    system: Option<Place<'_>>,
    options: &Options,
    outcome: &mut Outcome,
) -> Vec<(Place<'t>, Vec<String>)> {
    let system = system.map(Place::path);
    let mut wanted = Vec::new();
    for (input, roots) in inputs.iter().zip(roots) {
        for root in roots {
            let place = Place { tree: &input.tree, root: &root.path };
            if system == Some(place.path()) || !is_asked_for(root.application, options) {
                continue;
            }
            if root.application == Application::Makehuman2 {
                want(&mut wanted, place, &input.narrow);
            } else {
                note_unjudged(&place.path(), root.application, outcome);
            }
        }
    }
    wanted
}

/// A root that two PATHs lead to is judged once, for everything that either asks for.
fn want<'t>(wanted: &mut Vec<(Place<'t>, Vec<String>)>, place: Place<'t>, narrow: &[String]) {
    match wanted.iter_mut().find(|(known, _)| known.path() == place.path()) {
        Some((_, known)) if known.is_empty() || narrow.is_empty() => known.clear(),
        Some((_, known)) => known.extend_from_slice(narrow),
        None => wanted.push((place, narrow.to_vec())),
    }
}

fn is_asked_for(application: Application, options: &Options) -> bool {
    options.applications.is_empty() || options.applications.contains(&application)
}

fn note_unjudged(path: &str, application: Application, outcome: &mut Outcome) {
    let shown = if path.is_empty() { "." } else { path };
    outcome.notes.push(format!("{shown}: {application} data, which this version does not judge yet"));
    outcome.roots.push(RootSummary { path: shown.to_owned(), application, bases: Vec::new(), judged: false });
}

fn summarise(repository: &Repository<'_>, outcome: &mut Outcome) {
    let judged = repository.judged;
    let own = |name: &str| judged.files.values().any(|file| file.base.as_deref() == Some(name));
    let bases = repository.bases.iter().map(|base| base.name).filter(|name| own(name));
    let shown = if judged.path.is_empty() { "." } else { judged.path.as_str() };
    outcome.roots.push(RootSummary {
        path: shown.to_owned(),
        application: repository.application,
        bases: bases.map(str::to_owned).collect(),
        judged: true,
    });
}

fn check_bases(options: &Options, outcome: &Outcome) -> Result<(), Error> {
    let known: std::collections::BTreeSet<&String> = outcome.roots.iter().flat_map(|root| &root.bases).collect();
    let unknown = options.bases.iter().find(|name| !known.contains(name));
    unknown.filter(|_| outcome.judged_anything()).map_or(Ok(()), |name| {
        Err(Error::UnknownBase { name: name.clone(), known: known.into_iter().cloned().collect() })
    })
}

fn judge(
    repository: &Repository<'_>,
    measures: Option<&BTreeMap<String, Measures>>,
    selection: &Selection,
    options: &Options,
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
    options: &Options,
) -> Vec<Finding> {
    let mut findings = Vec::new();
    let asked = |name: &str| options.bases.is_empty() || options.bases.iter().any(|base| base == name);
    let bases = || repository.bases.iter().filter(|base| asked(base.name));
    match rule.check {
        Check::Layer(run) => run(repository.judged, cx, &mut findings),
        Check::Repository(run) => run(repository, cx, &mut findings),
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

/// Keeps what is to be reported for the judged layer and gives it level and fingerprint.
fn report(
    repository: &Repository<'_>,
    findings: Vec<Finding>,
    judged: &Loaded<'_>,
    selection: &Selection,
    options: &Options,
) -> Vec<Finding> {
    let mut ordinals: BTreeMap<(String, String, String), u32> = BTreeMap::new();
    let mut kept = Vec::new();
    for mut finding in findings {
        let Some(rel) = own_path(repository, &finding.path).map(str::to_owned) else { continue };
        let wanted_base = || {
            let base = crate::discover::kind_of(&rel).1;
            options.bases.is_empty() || base.is_none_or(|base| options.bases.iter().any(|name| name == base))
        };
        if !judged.is_asked_for(&finding.path) || !wanted_base() {
            continue;
        }
        let Some(level) = selection.level(finding.rule, finding.level) else { continue };
        finding.level = level;
        let identity = (finding.rule.to_owned(), rel, finding.key.clone());
        let ordinal = ordinals.entry(identity).or_default();
        finding.fingerprint =
            fingerprint(finding.rule, own_path(repository, &finding.path).unwrap_or_default(), &finding.key, *ordinal);
        *ordinal += 1;
        kept.push(finding);
    }
    kept
}

/// Path below the judged root, if the file belongs to it and not to a layer inside or beside it.
fn own_path<'p>(repository: &Repository<'_>, path: &'p str) -> Option<&'p str> {
    let judged = repository.judged;
    let deeper = |layer: &&Layer| layer.path.len() > judged.path.len() && layer.holds(path);
    let foreign = [repository.system, repository.user].into_iter().flatten().any(|layer| deeper(&layer));
    if foreign { None } else { judged.relative(path) }
}

impl<'t> Loaded<'t> {
    pub(super) fn new(place: Place<'t>, layer: Layer, role: Role, narrow: Vec<String>) -> Self {
        Self { place, layer, role, narrow }
    }

    fn is_asked_for(&self, path: &str) -> bool {
        let inside = |narrow: &String| {
            path == narrow || path.strip_prefix(narrow.as_str()).is_some_and(|rest| rest.starts_with('/'))
        };
        self.narrow.is_empty() || self.narrow.iter().any(inside)
    }
}

fn finish(outcome: &mut Outcome, trees: &[&Tree], limits: &Limits) {
    outcome.roots.sort_by(|a, b| (&a.path, a.application).cmp(&(&b.path, b.application)));
    outcome.findings.sort_by(|a, b| (&a.path, a.rule, &a.key).cmp(&(&b.path, b.rule, &b.key)));
    locate(&mut outcome.findings, trees, limits);
    let place = |finding: &Finding| (finding.location.line, finding.location.column);
    outcome.findings.sort_by(|a, b| (&a.path, place(a), a.rule, &a.key).cmp(&(&b.path, place(b), b.rule, &b.key)));
    outcome.count();
}
