//! A run: inputs to data roots, roots to repositories, repositories through the rules to an outcome.

use std::path::PathBuf;
use std::time::Instant;

use super::catalogue::CHECKED;
use super::changed::{Change, explain, narrow};
use super::check::{check, check_upkeep};
use super::error::Error;
use super::load::{Data, Input, Loaded, Roots, Stack, open};
use super::measure::{Measured, measure_bases};
use super::settle::{Ignores, Keeper, Known, Placed, Root, Scope, Selection, idle, place_and_sort};
use super::summary::{check_bases, summarise};
use super::verdict::conclude;
use crate::config::{Config, Selector};
use crate::diag::{self, Application, IdleGlob, Level, Outcome, Phase, Timed, Timing, Upkeep};
use crate::repo::{Layer, View};
use crate::rules::RULES;
use crate::source::Tree;

/// Checks data roots found at `paths`.
///
/// # Errors
/// When a path cannot be read, or an option names nothing that exists.
pub fn lint(paths: &[PathBuf], options: &Config) -> Result<Outcome, Error> {
    let inputs = open(paths, &CHECKED)?;
    let system = options.system.as_deref().map(super::load::open_system).transpose()?;
    lint_inputs(&inputs, system.as_ref(), options, &CHECKED)
}

/// Checks data roots in trees, from disk or memory; `system` is read and not reported.
///
/// # Errors
/// As [`lint`].
pub fn lint_trees(trees: Vec<Tree>, system: Option<Tree>, options: &Config) -> Result<Outcome, Error> {
    let inputs: Vec<Input> = trees.into_iter().map(Input::whole).collect();
    lint_inputs(&inputs, system.as_ref(), options, &CHECKED)
}

/// What is asked for, made ready.
struct Asked<'c> {
    options: &'c Config,
    selection: Selection<'c>,
    scope: Scope<'c>,
    change: Option<Change>,
    idle: Vec<IdleGlob>,
}

/// Checks what the inputs hold for these applications.
pub(super) fn lint_inputs(
    inputs: &[Input],
    system: Option<&Tree>,
    options: &Config,
    applications: &[Application],
) -> Result<Outcome, Error> {
    let scope = Scope::new(inputs.iter().flat_map(Input::paths).collect(), options);
    let asked = Asked {
        options,
        selection: Selection::new(options)?,
        idle: idle(options, inputs.iter().map(|input| &input.tree).chain(system), &scope),
        scope,
        change: options.changed.as_deref().map(Change::new),
    };
    let known = Known::open(options)?;
    let mut ignores = Ignores::new(options);
    let mut outcome = Outcome { looked_for: applications.to_vec(), ..Outcome::default() };
    let started = Instant::now();
    let roots = Roots::of(inputs, system, &asked.scope, options, applications, &mut outcome)?;
    let mut data = Data::load(roots, &options.limits);
    outcome.scope = asked_for(&data, options);
    outcome.timings.push(timing(Phase::Read, started));
    let started = Instant::now();
    let measures = measure_bases(&mut data, options, &mut outcome.failed_steps);
    outcome.failed_files = data.failed_files();
    outcome.timings.push(timing(Phase::Evaluation, started));
    let started = Instant::now();
    let found = check_all(&data, &measures, &asked, &mut ignores, &mut outcome);
    check_bases(options, &outcome)?;
    settle(found, known, &data, &asked, &ignores, &mut outcome)?;
    outcome.timings.push(timing(Phase::Rules, started));
    let started = Instant::now();
    let settings = options.file.as_ref().map(|file| (file.path.clone(), file.text.clone().into_bytes()));
    let settings = Tree::in_memory("", settings);
    let trees: Vec<&Tree> = inputs.iter().map(|input| &input.tree).chain(system).chain([&settings]).collect();
    outcome.roots.sort_by(|a, b| (&a.path, a.application).cmp(&(&b.path, b.application)));
    place_and_sort(&mut outcome.findings, &trees, &options.limits, &mut outcome.failed_steps);
    conclude(&mut outcome, options);
    outcome.timings.push(timing(Phase::Places, started));
    Ok(outcome)
}

/// What the PATHs, `--base`, `exclude` and the rules that are on leave of the data to report on.
fn asked_for(data: &Data<'_>, options: &Config) -> diag::Scope {
    let file = || options.file.iter();
    let texts = |selectors: &[Selector]| selectors.iter().map(|one| one.text.clone()).collect::<Vec<_>>();
    let mut rules = options.only.clone();
    let mut without: Vec<String> = options.skip.iter().chain(off(&options.levels, |name| name)).cloned().collect();
    // `--only` takes the place of what the file says of rules.
    for file in file().filter(|_| options.only.is_empty()) {
        rules = texts(&file.select);
        without.extend(texts(&file.skip));
        without.extend(off(&file.levels, |selector| &selector.text).cloned());
    }
    if rules.iter().any(|rule| rule == "*") {
        rules.clear();
    }
    diag::Scope {
        paths: data.roots.iter().flat_map(Loaded::parts).map(str::to_owned).collect(),
        excluded: file().flat_map(|file| &file.exclude).map(|glob| glob.text.clone()).collect(),
        bases: options.bases.clone(),
        rules,
        without,
    }
}

/// The rules whose level is `off`, by what they were named with.
fn off<'l, T>(
    levels: &'l [(T, Option<Level>)],
    name: impl Fn(&'l T) -> &'l String,
) -> impl Iterator<Item = &'l String> {
    levels.iter().filter(|(_, level)| level.is_none()).map(move |(rules, _)| name(rules))
}

fn timing(phase: Phase, started: Instant) -> Timing {
    Timing { what: Timed::Phase(phase), time: started.elapsed() }
}

/// What is to be reported of every repository. `measures` has those of each.
fn check_all(
    data: &Data<'_>,
    measures: &[Measured],
    asked: &Asked<'_>,
    ignores: &mut Ignores<'_>,
    outcome: &mut Outcome,
) -> Vec<Placed> {
    let Asked { options, selection, scope, change, .. } = asked;
    let mut found = Vec::new();
    for (number, Stack { root: checked, seen }) in data.stacks().into_iter().enumerate() {
        outcome.summary.files += checked.layer.files.len();
        outcome.summary.bytes += checked.layer.files.values().map(|file| file.size).sum::<u64>();
        let views: Vec<View<'_>> =
            seen.iter().map(|(application, layers)| View::connect(*application, *layers)).collect();
        views.iter().for_each(|view| summarise(view, outcome));
        let of_view = |view: &View<'_>| measures.get(number)?.get(&view.application());
        let with_measures: Vec<_> = views.iter().map(|view| (view, of_view(view))).collect();
        let mut findings = check(RULES, &with_measures, selection, options, outcome);
        if let Some(change) = change {
            views.iter().for_each(|view| explain(view, &mut findings, change));
        }
        let is_asked_for = |path: &str| checked.is_asked_for(path);
        let below: Vec<&Layer> = seen.iter().filter_map(|(_, layers)| layers.system).collect();
        let root = Root { layer: &checked.layer, below: &below };
        let keeper = Keeper { root, is_asked_for: &is_asked_for, selection, scope, options };
        let (kept, hidden) = keeper.keep(findings, ignores);
        outcome.summary.suppressed += hidden;
        found.extend(kept);
    }
    found
}

/// Hides what the baseline knows, adds what is to be said of ignores and baseline, and narrows all to the change.
fn settle(
    found: Vec<Placed>,
    known: Option<Known>,
    data: &Data<'_>,
    asked: &Asked<'_>,
    ignores: &Ignores<'_>,
    outcome: &mut Outcome,
) -> Result<(), Error> {
    let Asked { options, selection, scope, change, idle } = asked;
    let uses = ignores.uses(selection, scope);
    let mut upkeep = Upkeep { ignores: uses, unknown: ignores.unknown(), idle: idle.clone(), ..Upkeep::default() };
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
    // Known and ignored errors hid what they hide when the baseline and the ignores were written, too.
    let taken_over = outcome.taken_over.is_some_and(|taken_over| taken_over.errors > 0);
    upkeep.errors = taken_over || outcome.has_at_least(Level::Error);
    outcome.findings.extend(check_upkeep(&upkeep, selection, ignores, options, &mut outcome.failed_rules));
    if let Some(change) = change {
        narrow(outcome, change);
    }
    Ok(())
}
