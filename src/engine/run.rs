//! A run: inputs to data roots, roots to repositories, repositories through the rules to an outcome.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use super::changed::{Change, explain, narrow};
use super::data::Data;
use super::input::{Input, open};
use super::known::{Known, Placed};
use super::load::Place;
use super::locate::locate;
use super::loose::moved;
use super::measure::measure_bases;
use super::mute::Muting;
use super::outcome::{Error, Outcome, RootSummary, Timing};
use super::scope::Scope;
use super::select::{Selection, Verdict, is_unmutable};
use super::stack::Role;
use crate::config::Config;
use crate::diag::{Application, Finding, Upkeep, fingerprint};
use crate::discover::{DataRoot, find_roots};
use crate::eval::measures::Measures;
use crate::repo::{Layer, Repository};
use crate::rules::{Check, RULES, Rule, RuleCx};
use crate::source::{EntryKind, Limits, Tree};

/// Judges data roots found at `paths`.
///
/// # Errors
/// When a path cannot be read, or an option names nothing that exists.
pub fn lint(paths: &[PathBuf], options: &Config) -> Result<Outcome, Error> {
    let inputs = open(paths)?;
    let system = options.system.as_deref().map(super::input::open_system).transpose()?;
    lint_inputs(&inputs, system.as_ref(), options)
}

/// Judges data roots in trees, from disk or memory; `system` is read and not reported.
///
/// # Errors
/// As [`lint`].
pub fn lint_trees(trees: Vec<Tree>, system: Option<Tree>, options: &Config) -> Result<Outcome, Error> {
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

pub(super) fn lint_inputs(inputs: &[Input], system: Option<&Tree>, options: &Config) -> Result<Outcome, Error> {
    let selection = Selection::new(options)?;
    let change = options.changed.as_deref().map(Change::new);
    let scope = Scope::new(inputs, options);
    let known = Known::open(options)?;
    let mut muting = Muting::new(options);
    let mut found = Vec::new();
    let mut outcome = Outcome::default();
    let started = Instant::now();
    let system_roots = system.map(roots_of).unwrap_or_default();
    let roots: Vec<Vec<DataRoot>> = inputs.iter().map(|input| roots_of(&input.tree)).collect();
    let mut system_place = system.map(|tree| system_place(tree, &system_roots)).transpose()?;
    if let Some(place) = system_place.filter(|place| is_all_there_is(*place, inputs, &roots)) {
        outcome.notes.push(format!("`--system` names the data to judge itself; {} is judged", shown(&place.path())));
        system_place = None;
    }
    let moved = moved(inputs, &roots, system, options, &mut outcome);
    let mut places = places(inputs, &roots, system_place, &scope, options, &mut outcome);
    for (input, moved) in inputs.iter().zip(&moved).filter(|(_, moved)| !moved.is_empty()) {
        let place = Place { tree: &input.tree, root: "", moved: Some(moved) };
        if is_asked_for(Application::Makehuman2, options) {
            want(&mut places, place, &input.narrow);
        }
    }
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
        let mut findings = judge(&repository, measures.get(number), &selection, options, &mut outcome);
        if let Some(change) = &change {
            explain(&repository, &mut findings, change);
        }
        let reporter = Reporter { repository: &repository, judged, selection: &selection, scope: &scope, options };
        found.extend(reporter.report(findings, &mut muting, &mut outcome));
    }
    check_bases(options, &outcome)?;
    let mut upkeep = Upkeep { mutes: muting.mutes(&selection, &scope), unknown: muting.unknown(), baseline: None };
    if let Some(known) = known {
        let roots = data.roots.iter().map(|root| root.layer.path.as_str());
        let compared = known.compare(found, roots, &selection, &scope);
        outcome.findings = compared.kept;
        outcome.summary.suppressed += compared.hidden;
        outcome.baseline = compared.new;
        upkeep.baseline = Some(compared.used);
    } else {
        outcome.findings = found.into_iter().map(|placed| placed.finding).collect();
    }
    outcome.findings.extend(look_after(&upkeep, &selection, &muting, options));
    if let Some(change) = &change {
        narrow(&mut outcome, change);
    }
    outcome.timings.push(timing("rules", started));
    let settings = options.file.as_ref().map(|file| (file.path.clone(), file.text.clone().into_bytes()));
    let settings = Tree::in_memory("", settings);
    let trees: Vec<&Tree> = inputs.iter().map(|input| &input.tree).chain(system).chain([&settings]).collect();
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
    Ok(Place { tree, root: &root.path, moved: None })
}

pub(super) fn roots_of(tree: &Tree) -> Vec<DataRoot> {
    let files = tree.entries().iter().filter(|entry| entry.kind == EntryKind::File);
    find_roots(files.map(|entry| entry.path.as_str()))
}

/// Whether the system data are the only data root that was given to be judged.
fn is_all_there_is(system: Place<'_>, inputs: &[Input], roots: &[Vec<DataRoot>]) -> bool {
    let path = system.path();
    let mut paths = inputs.iter().zip(roots).flat_map(|(input, roots)| {
        roots.iter().map(|root| Place { tree: &input.tree, root: &root.path, moved: None }.path())
    });
    let all_same = paths.clone().all(|given| given == path);
    all_same && paths.next().is_some()
}

fn shown(path: &str) -> &str {
    if path.is_empty() { "." } else { path }
}

/// The data roots to judge, with what to report of each.
fn places<'t>(
    inputs: &'t [Input],
    roots: &'t [Vec<DataRoot>],
    system: Option<Place<'_>>,
    scope: &Scope<'_>,
    options: &Config,
    outcome: &mut Outcome,
) -> Vec<(Place<'t>, Vec<String>)> {
    let system = system.map(Place::path);
    let mut wanted = Vec::new();
    for (input, roots) in inputs.iter().zip(roots) {
        for root in roots {
            let place = Place { tree: &input.tree, root: &root.path, moved: None };
            let is_excluded = scope.excludes(&place.path());
            if is_excluded || system == Some(place.path()) || !is_asked_for(root.application, options) {
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

fn is_asked_for(application: Application, options: &Config) -> bool {
    options.applications.is_empty() || options.applications.contains(&application)
}

fn note_unjudged(path: &str, application: Application, outcome: &mut Outcome) {
    let path = shown(path);
    outcome.notes.push(format!("{path}: {application} data, which this version does not judge yet"));
    outcome.roots.push(RootSummary { path: path.to_owned(), application, bases: Vec::new(), judged: false });
}

fn summarise(repository: &Repository<'_>, outcome: &mut Outcome) {
    let judged = repository.judged;
    let own = |name: &str| judged.files.values().any(|file| file.base.as_deref() == Some(name));
    let bases = repository.bases.iter().map(|base| base.name).filter(|name| own(name));
    outcome.roots.push(RootSummary {
        path: shown(&judged.path).to_owned(),
        application: repository.application,
        bases: bases.map(str::to_owned).collect(),
        judged: true,
    });
}

fn check_bases(options: &Config, outcome: &Outcome) -> Result<(), Error> {
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
    let asked = |name: &str| options.bases.is_empty() || options.bases.iter().any(|base| base == name);
    let bases = || repository.bases.iter().filter(|base| asked(base.name));
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

/// What is reported of one repository.
struct Reporter<'r, 't> {
    repository: &'r Repository<'r>,
    judged: &'r Loaded<'t>,
    selection: &'r Selection<'r>,
    scope: &'r Scope<'r>,
    options: &'r Config,
}

impl Reporter<'_, '_> {
    /// Keeps what is to be reported for the judged layer and gives it level and fingerprint.
    fn report(&self, findings: Vec<Finding>, muting: &mut Muting<'_>, outcome: &mut Outcome) -> Vec<Placed> {
        let files = self.repository.judged.files.values();
        let commented = files.filter(|file| !file.ignores.is_empty() && self.is_reported(&file.path));
        commented.for_each(|file| muting.note(file, self.selection, self.scope));
        let mut kept = Vec::new();
        for mut finding in findings.into_iter().filter(|finding| self.is_wanted(finding)) {
            let rel = self.options.file.as_ref().and_then(|file| file.relative(&finding.path));
            match self.selection.verdict(finding.rule, finding.level, rel.as_deref()) {
                Verdict::Off => {}
                Verdict::OffHere => outcome.summary.suppressed += 1,
                Verdict::At(level) => {
                    finding.level = level;
                    kept.push(finding);
                }
            }
        }
        let file = |path: &str| self.repository.judged.file(self.repository.judged.relative(path)?);
        let (kept, muted) = muting.apply(kept, file);
        outcome.summary.suppressed += muted;
        self.identify(kept)
    }

    fn is_wanted(&self, finding: &Finding) -> bool {
        let Some(rel) = own_path(self.repository, &finding.path) else { return false };
        let asked = |base: &str| self.options.bases.is_empty() || self.options.bases.iter().any(|name| name == base);
        // What is excluded is out of sight; but what is dangerous is told wherever the run looks.
        let in_sight = !self.scope.excludes(&finding.path) || is_unmutable(finding.rule);
        in_sight && self.judged.is_asked_for(&finding.path) && crate::discover::kind_of(rel).1.is_none_or(asked)
    }

    fn is_reported(&self, path: &str) -> bool {
        self.judged.is_asked_for(path) && !self.scope.excludes(path)
    }

    /// Fingerprints. Keys tell findings of one rule on one asset apart; the ordinal is for those that do not.
    fn identify(&self, findings: Vec<Finding>) -> Vec<Placed> {
        let mut ordinals: BTreeMap<(&str, String, String), u32> = BTreeMap::new();
        // What names the fault may be part of the system data, such as the mesh.
        let below = |asset: &str| {
            let system = || self.repository.system?.relative(asset);
            own_path(self.repository, asset).or_else(system).unwrap_or_default().to_owned()
        };
        let identified = findings.into_iter().map(|mut finding| {
            let asset = finding.asset.clone().unwrap_or_else(|| finding.path.clone());
            let rel = below(&asset);
            let ordinal = ordinals.entry((finding.rule, rel.clone(), finding.key.clone())).or_default();
            finding.fingerprint = fingerprint(finding.rule, &rel, &finding.key, *ordinal);
            *ordinal += 1;
            let Some(whole) = finding.whole.clone() else {
                return Placed { known_as: finding.fingerprint.clone(), finding, asset, rel };
            };
            let rel = below(&whole);
            Placed { known_as: fingerprint(finding.rule, &rel, "", 0), finding, asset: whole, rel }
        });
        identified.collect()
    }
}

/// Findings on the mutes themselves.
fn look_after(upkeep: &Upkeep, selection: &Selection<'_>, muting: &Muting<'_>, options: &Config) -> Vec<Finding> {
    let cx = RuleCx { options: &options.rule_options };
    let mut findings = Vec::new();
    for rule in RULES.iter().filter(|rule| selection.runs(rule.info.id)) {
        if let Check::Upkeep(run) = rule.check {
            run(upkeep, &cx, &mut findings);
        }
    }
    findings.retain_mut(|finding| {
        let Verdict::At(level) = selection.verdict(finding.rule, finding.level, None) else { return false };
        finding.level = level;
        finding.fingerprint = fingerprint(finding.rule, &muting.asset(&finding.path), &finding.key, 0);
        true
    });
    findings
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
