//! A run: inputs to data roots, roots to repositories, repositories through the rules to an outcome.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::time::Instant;

use super::caught::caught;
use super::changed::{Change, explain, narrow};
use super::heard::{Filter, Heard};
use super::idle::idle;
use super::judge::{judge, look_after};
use super::known::{Known, Placed};
use super::load::moved;
use super::load::{Data, Loaded};
use super::load::{Input, open};
use super::load::{Roots, check_bases, summarise};
use super::locate::locate;
use super::measure::measure_bases;
use super::mute::Muting;
use super::outcome::{Error, Outcome, Timing};
use super::scope::Scope;
use super::select::Selection;
use crate::config::Config;
use crate::diag::{Application, Finding, IdleGlob, Level, Over, Upkeep, fingerprint};
use crate::eval::measures::Measures;
use crate::repo::{Layer, Repository};
use crate::source::{Limits, Tree};

/// Judges data roots found at `paths`.
///
/// # Errors
/// When a path cannot be read, or an option names nothing that exists.
pub fn lint(paths: &[PathBuf], options: &Config) -> Result<Outcome, Error> {
    let inputs = open(paths)?;
    let system = options.system.as_deref().map(super::load::open_system).transpose()?;
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

/// What is asked for, made ready.
struct Asked<'c> {
    options: &'c Config,
    selection: Selection<'c>,
    scope: Scope<'c>,
    change: Option<Change>,
    idle: Vec<IdleGlob>,
}

/// Judges what the inputs hold.
pub(super) fn lint_inputs(inputs: &[Input], system: Option<&Tree>, options: &Config) -> Result<Outcome, Error> {
    let scope = Scope::new(inputs, options);
    let asked = Asked {
        options,
        selection: Selection::new(options)?,
        idle: idle(options, inputs, system, &scope),
        scope,
        change: options.changed.as_deref().map(Change::new),
    };
    let known = Known::open(options)?;
    let mut muting = Muting::new(options);
    let mut outcome = Outcome::default();
    let started = Instant::now();
    let roots = Roots::of(inputs, system);
    let system_place = roots.system_place(&mut outcome)?;
    let moved = moved(inputs, &roots.found, system, options, &mut outcome);
    let places = roots.places(&moved, system_place, &asked.scope, options, &mut outcome);
    let mut data = Data::load(places, system_place, &options.limits);
    outcome.only = asked_for(&data, options);
    outcome.timings.push(timing("read", started));
    let started = Instant::now();
    let measures = measure_bases(&mut data, options, &mut outcome.failed_steps);
    outcome.failed_files = data.failed_files();
    outcome.timings.push(timing("targets and evaluation", started));
    let started = Instant::now();
    let found = judge_all(&data, &measures, &asked, &mut muting, &mut outcome);
    check_bases(options, &outcome)?;
    settle(found, known, &data, &asked, &muting, &mut outcome)?;
    outcome.timings.push(timing("rules", started));
    let started = Instant::now();
    let settings = options.file.as_ref().map(|file| (file.path.clone(), file.text.clone().into_bytes()));
    let settings = Tree::in_memory("", settings);
    let trees: Vec<&Tree> = inputs.iter().map(|input| &input.tree).chain(system).chain([&settings]).collect();
    finish(&mut outcome, &trees, &options.limits);
    outcome.timings.push(timing("places", started));
    Ok(outcome)
}

/// What the PATHs, `--base`, `exclude` and the rules that are on leave of the data to report on, in words.
fn asked_for(data: &Data<'_>, options: &Config) -> Vec<String> {
    let names = |before: &str, names: &[&str]| {
        let shown: Vec<String> = names.iter().take(NAMED).map(|name| format!("`{name}`")).collect();
        let more = match names.len().saturating_sub(NAMED) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        (!names.is_empty()).then(|| format!("{before} {}{more}", shown.join(", ")))
    };
    let paths: Vec<&str> = data.roots.iter().flat_map(Loaded::parts).collect();
    let bases: Vec<&str> = options.bases.iter().map(String::as_str).collect();
    let of_file = || options.file.iter().flat_map(|file| &file.select).map(|selector| selector.text.as_str());
    let rules: Vec<&str> =
        if options.only.is_empty() { of_file().collect() } else { options.only.iter().map(String::as_str).collect() };
    let rules = if rules.contains(&"*") { Vec::new() } else { rules };
    let mut without: Vec<&String> = options.skip.iter().chain(off(&options.levels, |name| name)).collect();
    // `--only` takes the place of what the file says of rules.
    for file in options.file.iter().filter(|_| options.only.is_empty()) {
        without.extend(file.skip.iter().map(|selector| &selector.text));
        without.extend(off(&file.levels, |selector| &selector.text));
    }
    let without: Vec<&str> = without.into_iter().map(String::as_str).collect();
    let excluded: Vec<&str> =
        options.file.iter().flat_map(|file| &file.exclude).map(|glob| glob.text.as_str()).collect();
    let parts = [
        names("in", &paths),
        names("outside of", &excluded),
        names("on the base mesh", &bases),
        names("by the rules", &rules),
        names("without the rules", &without),
    ];
    parts.into_iter().flatten().collect()
}

/// The rules whose level is `off`, by what they were named with.
fn off<'l, T>(
    levels: &'l [(T, Option<Level>)],
    name: impl Fn(&'l T) -> &'l String,
) -> impl Iterator<Item = &'l String> {
    levels.iter().filter(|(_, level)| level.is_none()).map(move |(rules, _)| name(rules))
}

/// Names that a sentence holds.
const NAMED: usize = 3;

fn timing(what: &str, started: Instant) -> Timing {
    Timing { what: what.to_owned(), time: started.elapsed() }
}

/// What is to be reported of every repository. `measures` has those of each.
fn judge_all(
    data: &Data<'_>,
    measures: &[BTreeMap<String, Measures>],
    asked: &Asked<'_>,
    muting: &mut Muting<'_>,
    outcome: &mut Outcome,
) -> Vec<Placed> {
    let Asked { options, selection, scope, change, .. } = asked;
    let mut found = Vec::new();
    for (number, (system, user, judged)) in data.stacks().into_iter().enumerate() {
        outcome.summary.files += judged.layer.files.len();
        outcome.summary.bytes += judged.layer.files.values().map(|file| file.size).sum::<u64>();
        let repository = Repository::connect(Application::Makehuman2, system, user, &judged.layer);
        summarise(&repository, outcome);
        let mut findings = judge(&repository, measures.get(number), selection, options, outcome);
        if let Some(change) = change {
            explain(&repository, &mut findings, change);
        }
        let reporter = Reporter { repository: &repository, judged, selection, scope, options };
        found.extend(reporter.report(findings, muting, outcome));
    }
    found
}

/// Hides what the baseline knows, adds what is to be said of mutes and baseline, and narrows all to the change.
fn settle(
    found: Vec<Placed>,
    known: Option<Known>,
    data: &Data<'_>,
    asked: &Asked<'_>,
    muting: &Muting<'_>,
    outcome: &mut Outcome,
) -> Result<(), Error> {
    let Asked { options, selection, scope, change, idle } = asked;
    let mutes = muting.mutes(selection, scope);
    let mut upkeep = Upkeep { mutes, unknown: muting.unknown(), idle: idle.clone(), ..Upkeep::default() };
    if let Some(known) = known {
        let roots = data.roots.iter().map(|root| root.layer.path.as_str());
        let compared = known.compare(found, roots, selection, scope)?;
        outcome.findings = compared.kept;
        outcome.summary.suppressed += compared.hidden;
        outcome.in_baseline = compared.hidden;
        (outcome.baseline, outcome.taken_over) = (compared.new, compared.taken_over);
        upkeep.baseline = Some(compared.used);
    } else {
        outcome.findings = found.into_iter().map(|placed| placed.finding).collect();
    }
    // Known and muted errors hid what they hide when the baseline and the mutes were written, too.
    let taken_over = outcome.taken_over.is_some_and(|taken_over| taken_over.errors > 0);
    upkeep.errors = taken_over || outcome.has_at_least(Level::Error);
    outcome.findings.extend(look_after(&upkeep, selection, muting, options, &mut outcome.failed_rules));
    if let Some(change) = change {
        narrow(outcome, change);
    }
    Ok(())
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
        let filter = self.filter();
        let mut kept = Vec::new();
        for mut finding in findings.into_iter().filter(|finding| self.is_wanted(finding)) {
            let consequence = finding.level;
            match filter.of(&mut finding, muting) {
                Heard::At(level) => {
                    let spared = self.spared(&filter.spared(&finding, muting), &finding);
                    finding.fix.iter_mut().for_each(|fix| fix.spared.clone_from(&spared));
                    finding.level = level;
                    kept.push((finding, consequence));
                }
                Heard::Hidden => outcome.summary.suppressed += 1,
                Heard::Off | Heard::Excluded => {}
            }
        }
        self.identify(kept)
    }

    fn filter(&self) -> Filter<'_> {
        let Self { repository, selection, scope, options, .. } = self;
        Filter { layer: repository.judged, selection, scope, options }
    }

    /// Files of a fix that are not to be written: those for which the rule is muted, and those beside the PATHs.
    fn spared(&self, muted: &[String], finding: &Finding) -> Vec<String> {
        let steps = finding.fix.iter().flat_map(|fix| fix.steps.iter().map(|step| &step.path));
        let files: BTreeSet<&String> =
            muted.iter().chain(steps.filter(|path| !self.judged.is_asked_for(path))).collect();
        files.into_iter().cloned().collect()
    }

    fn is_wanted(&self, finding: &Finding) -> bool {
        let Some(rel) = own_path(self.repository, &finding.path) else { return false };
        let asked = |base: &str| self.options.asks_for_base(base);
        // One finding may speak for several files; who names one of them is told.
        let others = match &finding.over {
            Over::Own => [].as_slice(),
            Over::Each(files) | Over::Between(files) => files.as_slice(),
        };
        let mut files = std::iter::once(&finding.path).chain(others);
        files.any(|file| self.judged.is_asked_for(file)) && crate::discover::kind_of(rel).1.is_none_or(asked)
    }

    fn is_reported(&self, path: &str) -> bool {
        self.judged.is_asked_for(path) && !self.scope.excludes(path)
    }

    /// Fingerprints. Keys tell findings of one rule on one asset apart; the ordinal is for those that do not.
    fn identify(&self, findings: Vec<(Finding, Level)>) -> Vec<Placed> {
        let mut ordinals: BTreeMap<(&str, String, String), u32> = BTreeMap::new();
        // What names the fault may be part of the system data, such as the mesh.
        let below = |asset: &str| {
            let system = || self.repository.system?.relative(asset);
            own_path(self.repository, asset).or_else(system).unwrap_or_default().to_owned()
        };
        let identified = findings.into_iter().map(|(mut finding, consequence)| {
            let asset = finding.asset.clone().unwrap_or_else(|| finding.path.clone());
            let rel = below(&asset);
            let ordinal = ordinals.entry((finding.rule, rel.clone(), finding.key.clone())).or_default();
            finding.fingerprint = fingerprint(finding.rule, &rel, &finding.key, *ordinal);
            *ordinal += 1;
            let Some(whole) = finding.whole.clone() else {
                return Placed { known_as: finding.fingerprint.clone(), finding, asset, rel, consequence };
            };
            let rel = below(&whole);
            Placed { known_as: fingerprint(finding.rule, &rel, "", 0), finding, asset: whole, rel, consequence }
        });
        identified.collect()
    }
}

/// Path below the judged root, if the file belongs to it and not to a layer inside or beside it.
fn own_path<'p>(repository: &Repository<'_>, path: &'p str) -> Option<&'p str> {
    let judged = repository.judged;
    let deeper = |layer: &&Layer| layer.path.len() > judged.path.len() && layer.holds(path);
    let foreign = [repository.system, repository.user].into_iter().flatten().any(|layer| deeper(&layer));
    if foreign { None } else { judged.relative(path) }
}

/// Brings everything into its order, with the places of findings.
fn finish(outcome: &mut Outcome, trees: &[&Tree], limits: &Limits) {
    outcome.roots.sort_by(|a, b| (&a.path, a.application).cmp(&(&b.path, b.application)));
    outcome.findings.sort_by(|a, b| (&a.path, a.rule, &a.key).cmp(&(&b.path, b.rule, &b.key)));
    caught("places of findings", &mut outcome.failed_steps, || locate(&mut outcome.findings, trees, limits));
    let place = |finding: &Finding| (finding.location.line, finding.location.column);
    outcome.findings.sort_by(|a, b| (&a.path, place(a), a.rule, &a.key).cmp(&(&b.path, place(b), b.rule, &b.key)));
    outcome.count();
}
