//! A run: inputs to data roots, roots to repositories, repositories through the rules to an
//! outcome.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use super::check::{check, check_upkeep, merged_as_printed};
use super::coverage::Coverage;
use super::error::Error;
use super::load::{Data, Loaded, Roots, Side, Stack, sides};
use super::measure::{Measured, measure_bases};
use super::settle::{
    Ignores, Keeper, Known, Placed, Root, Scope, Selection, gone_and_smaller, idle, new_or_worse,
    place_and_sort,
};
use super::summary::{check_bases, summarise};
use super::verdict::conclude;
use mhlint_config::{Before, Compare, Config, Selector};
use mhlint_diag::{
    self as diag, Application, BaselineUse, Compared, Finding, IdleGlob, Level, NotChecked, Note,
    Outcome, Phase, Timed, Timing, Unchecked, Upkeep,
};
use mhlint_repo::{Layer, View};
use mhlint_rules::{RULES, SideBySide, add_pack};
use mhlint_source::{Tree, is_below, resolved};

/// Checks data roots found at `paths`.
///
/// # Errors
/// When a path cannot be read, or an option names nothing that exists.
pub fn lint(paths: &[PathBuf], options: &Config) -> Result<Outcome, Error> {
    let (now, before) = sides(paths, options)?;
    lint_sides(&now, before.as_ref(), options)
}

/// Checks data roots in trees, from disk or memory; `systems` are read and not reported.
///
/// # Errors
/// As [`lint`].
pub fn lint_trees(
    trees: Vec<Tree>,
    systems: impl IntoIterator<Item = Tree>,
    options: &Config,
) -> Result<Outcome, Error> {
    lint_sides(&Side::of(trees, systems), None, options)
}

/// Checks data roots in trees as they are now, and reports what is new or worse than in the trees
/// before; each with its system data.
///
/// # Errors
/// As [`lint`].
pub fn lint_trees_beside(
    [now, before]: [Vec<Tree>; 2],
    [system, system_before]: [Option<Tree>; 2],
    options: &Config,
) -> Result<Outcome, Error> {
    let compare = Compare {
        with: "before".to_owned(),
        before: Before::Contents(BTreeMap::new()),
        now: BTreeMap::new(),
        missing: Vec::new(),
    };
    let options = Config {
        compare: Some(compare),
        ..options.clone()
    };
    let [now, before] = [Side::of(now, system), Side::of(before, system_before)];
    lint_sides(&now, Some(&before), &options)
}

/// What is asked for, made ready.
struct Asked<'c> {
    options: &'c Config,
    selection: Selection<'c>,
    scope: Scope<'c>,
    known: Option<Known>,
}

/// The findings on one side: those to report, and those that were there before settings on known
/// ones.
struct Found {
    shown: Vec<Finding>,
    all: Vec<Finding>,
}

/// Checks what one side holds; beside another one only what is new or worse is reported.
pub(super) fn lint_sides(
    now: &Side,
    before: Option<&Side>,
    options: &Config,
) -> Result<Outcome, Error> {
    let scope = Scope::new(named(now).collect(), options);
    let (selection, known) = (Selection::new(options)?, Known::open(options)?);
    let asked = Asked {
        options,
        selection,
        scope,
        known,
    };
    let looked_for = Application::ALL
        .into_iter()
        .filter(|application| asked.options.asks_for(*application))
        .collect();
    let mut outcome = Outcome {
        looked_for,
        ..Outcome::default()
    };
    // What is told of the data as they were but for findings.
    let mut told = Outcome::default();
    let started = Instant::now();
    let mut data = asked.load(now, None, &mut outcome)?;
    let mut data_before = before
        .map(|side| asked.load(side, Some(&data), &mut told))
        .transpose()?;
    outcome.scope = asked_for(&data, options);
    outcome.timings.push(timing(Phase::Read, started));
    let started = Instant::now();
    let [measures, measures_before] = measure_bases(
        &mut data,
        data_before.as_mut(),
        options,
        &mut outcome.failed_steps,
    );
    outcome.timings.push(timing(Phase::Evaluation, started));
    let started = Instant::now();
    let found_before = match (before, &data_before) {
        (Some(side), Some(data)) => Some(asked.check(side, data, &measures_before, &mut told)?),
        _ => None,
    };
    let found = asked.check(now, &data, &measures, &mut outcome)?;
    check_bases(options, &data, &outcome)?;
    match found_before.zip(options.compare.as_ref()) {
        Some((before, compare)) => {
            settle_comparison(before, found, compare, now, &mut outcome);
            outcome.notes.extend(settings_changed(options, compare));
        }
        None => outcome.findings = found.shown,
    }
    outcome.take_failures(told);
    outcome.timings.push(timing(Phase::Rules, started));
    let started = Instant::now();
    let settings = options
        .file
        .as_ref()
        .map(|file| (file.path.clone(), file.text.clone().into_bytes()));
    let settings = Tree::in_memory("", settings);
    let trees: Vec<&Tree> = now.trees().chain([&settings]).collect();
    outcome
        .roots
        .sort_by(|a, b| (&a.path, a.application).cmp(&(&b.path, b.application)));
    place_and_sort(
        &mut outcome.findings,
        &trees,
        &options.limits,
        &mut outcome.failed_steps,
    );
    // System data are read and never written.
    outcome.journals = now
        .inputs
        .iter()
        .flat_map(|input| input.tree.journals())
        .collect();
    conclude(&mut outcome, options);
    outcome.notes.extend(nothing_for(&outcome, options));
    outcome.timings.push(timing(Phase::Places, started));
    Ok(outcome)
}

/// The applications that were asked for by name, and of which nothing is there while others have
/// something.
fn nothing_for(outcome: &Outcome, options: &Config) -> Option<Note> {
    let is_checked = |own: &&Application| {
        outcome
            .applications
            .iter()
            .any(|one| one.application == **own)
    };
    let missing: Vec<Application> = options
        .applications
        .iter()
        .filter(|own| !is_checked(own))
        .copied()
        .collect();
    let has_others = !outcome.applications.is_empty() && !missing.is_empty();
    has_others.then_some(Note::NothingFor {
        applications: missing,
    })
}

/// What the PATHs, `--base`, `exclude` and the rules that are on leave of the data to report on.
fn asked_for(data: &Data<'_>, options: &Config) -> diag::Scope {
    let file = || options.file.iter();
    let texts = |selectors: &[Selector]| {
        selectors
            .iter()
            .map(|one| one.text.clone())
            .collect::<Vec<_>>()
    };
    let mut rules = options.only.clone();
    let mut without: Vec<String> = options
        .skip
        .iter()
        .chain(off(&options.levels, |name| name))
        .cloned()
        .collect();
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
        paths: parts(data),
        excluded: file()
            .flat_map(|file| file.exclude.iter())
            .map(|glob| glob.text.clone())
            .collect(),
        bases: options.bases.clone(),
        rules,
        without,
    }
}

/// What the PATHs ask for of the data roots, in their order. Many roots of one tree have the same.
fn parts(data: &Data<'_>) -> Vec<String> {
    let (mut seen, mut paths) = (BTreeSet::new(), Vec::new());
    for narrow in data.roots.iter().filter_map(Loaded::parts) {
        if seen.insert(Arc::as_ptr(narrow)) {
            paths.extend_from_slice(narrow.paths());
        }
    }
    let mut seen = BTreeSet::new();
    paths.retain(|path| seen.insert(path.clone()));
    paths
}

/// The rules whose level is `off`, by what they were named with.
fn off<'l, T>(
    levels: &'l [(T, Option<Level>)],
    name: impl Fn(&'l T) -> &'l String,
) -> impl Iterator<Item = &'l String> {
    levels
        .iter()
        .filter(|(_, level)| level.is_none())
        .map(move |(rules, _)| name(rules))
}

/// What lies in users' folders and zips that are each named as PATH: they are to lie in one
/// library.
fn side_by_side(named: &BTreeSet<String>, data: &Data<'_>) -> SideBySide {
    let is_named = |stack: &Stack<'_, '_>| {
        let root = &stack.root;
        let path = if root.layer.pack.is_some() {
            root.place.tree.label()
        } else {
            &root.layer.path
        };
        !root.layer.is_loose && named.contains(path)
    };
    let mut packs: Vec<Stack<'_, '_>> = data.stacks().into_iter().filter(is_named).collect();
    // A zip beside a user's folder is mostly one that is to be put there, or a newer state of what
    // is there.
    if packs.iter().any(|pack| pack.root.layer.pack.is_some()) {
        packs.retain(|pack| pack.root.layer.pack.is_some());
    }
    let mut beside = SideBySide::default();
    for (application, layers) in packs
        .iter()
        .filter(|_| packs.len() > 1)
        .flat_map(|pack| &pack.seen)
    {
        if !layers.checks_system() {
            add_pack(&mut beside, &View::connect(*application, *layers));
        }
    }
    beside
}

/// The PATHs, as printed.
fn named(side: &Side) -> impl Iterator<Item = String> {
    side.inputs
        .iter()
        .flat_map(|input| input.named.iter().cloned())
}

fn timing(phase: Phase, started: Instant) -> Timing {
    Timing {
        what: Timed::Phase(phase),
        time: started.elapsed(),
    }
}

impl Asked<'_> {
    /// Reads the data of one side but for their bulk. What it has in common with another one is
    /// taken from there.
    fn load<'t>(
        &self,
        side: &'t Side,
        other: Option<&Data<'_>>,
        outcome: &mut Outcome,
    ) -> Result<Data<'t>, Error> {
        let Self { options, scope, .. } = self;
        let roots = Roots::of(&side.inputs, &side.systems, scope, options, outcome)?;
        let mut data = Data::load(roots, &options.limits, other);
        data.identify(options);
        let alone = data
            .standing_alone()
            .map(|(layer, application)| Note::StandsAlone {
                path: super::load::shown(&layer.path).to_owned(),
                application,
            });
        outcome.notes.extend(alone);
        Ok(data)
    }

    /// Runs the rules on one side and settles what they find.
    fn check(
        &self,
        side: &Side,
        data: &Data<'_>,
        measures: &[Measured],
        outcome: &mut Outcome,
    ) -> Result<Found, Error> {
        outcome.failed_files = data.failed_files();
        let mut ignores = Ignores::new(self.options);
        let mut coverage = Coverage::new(named(side), &self.scope, self.options);
        let beside = side_by_side(&named(side).collect(), data);
        let placed = self.check_all(
            data,
            (measures, &beside),
            &mut ignores,
            &mut coverage,
            outcome,
        );
        coverage.conclude(outcome);
        let idle = idle(self.options, side.trees(), &self.scope);
        self.settle(placed, side, data, &ignores, idle, outcome)
    }

    /// What is to be reported of every repository: with the measures of each, and what lies in
    /// packs side by side.
    fn check_all(
        &self,
        data: &Data<'_>,
        (measures, beside): (&[Measured], &SideBySide),
        ignores: &mut Ignores<'_>,
        coverage: &mut Coverage<'_>,
        outcome: &mut Outcome,
    ) -> Vec<Placed> {
        let Self {
            options,
            selection,
            scope,
            ..
        } = self;
        let mut found = Vec::new();
        for group in data.groups() {
            let mut sets = Vec::new();
            for (number, stack) in &group {
                sets.push(self.check_stack(
                    stack,
                    (measures.get(*number), beside),
                    coverage,
                    outcome,
                ));
            }
            let mut findings = if sets.len() > 1 {
                merged_as_printed(sets)
            } else {
                sets.pop().unwrap_or_default()
            };
            if group
                .iter()
                .any(|(_, stack)| stack.root.layer.pack.is_some())
            {
                // Nothing writes into a zip.
                findings.iter_mut().for_each(|finding| finding.fix = None);
            }
            let is_asked_for =
                |path: &str| group.iter().any(|(_, stack)| stack.root.is_asked_for(path));
            let seen = group.iter().flat_map(|(_, stack)| &stack.seen);
            let below: Vec<&Layer> = seen.filter_map(|(_, layers)| layers.system).collect();
            let layers: Vec<&Layer> = group.iter().map(|(_, stack)| &stack.root.layer).collect();
            let Some((layer, others)) = layers.split_first() else {
                continue;
            };
            let root = Root {
                layer,
                others,
                below: &below,
            };
            let keeper = Keeper {
                root,
                is_asked_for: &is_asked_for,
                selection,
                scope,
                options,
            };
            let (kept, hidden) = keeper.keep(findings, ignores);
            outcome.summary.suppressed += hidden;
            found.extend(kept);
        }
        found
    }

    /// What the rules find in a repository, with what of it was checked.
    fn check_stack(
        &self,
        Stack {
            root: checked,
            seen,
        }: &Stack<'_, '_>,
        (measures, beside): (Option<&Measured>, &SideBySide),
        coverage: &mut Coverage<'_>,
        outcome: &mut Outcome,
    ) -> Vec<Finding> {
        let views: Vec<View<'_>> = seen
            .iter()
            .map(|(application, layers)| View::connect(*application, *layers))
            .collect();
        views.iter().for_each(|view| summarise(view, outcome));
        coverage.add(checked, &views, outcome);
        let of_view = |view: &View<'_>| measures?.get(&view.application());
        let with_measures: Vec<_> = views.iter().map(|view| (view, of_view(view))).collect();
        for (view, measures) in &with_measures {
            coverage.add_measured(checked, view, *measures);
        }
        check(
            &RULES,
            &with_measures,
            beside,
            &self.selection,
            self.options,
            outcome,
        )
    }

    /// Hides what the baseline knows, and adds what is to be said of ignores and baseline.
    fn settle(
        &self,
        found: Vec<Placed>,
        side: &Side,
        data: &Data<'_>,
        ignores: &Ignores<'_>,
        idle: Vec<IdleGlob>,
        outcome: &mut Outcome,
    ) -> Result<Found, Error> {
        let Self {
            options,
            selection,
            scope,
            ..
        } = self;
        let uses = ignores.uses(selection, scope, side.trees());
        let mut upkeep = Upkeep {
            ignores: uses,
            unknown: ignores.unknown(),
            idle,
            ..Upkeep::default()
        };
        let mut all: Vec<Finding> = Vec::new();
        if options.compare.is_some() {
            all.extend(found.iter().map(|placed| placed.finding.clone()));
        }
        let mut shown = if let Some(known) = &self.known {
            let roots = data.roots.iter().map(|root| root.layer.path.as_str());
            let compared = known.compare(found, roots, selection, scope)?;
            outcome.summary.suppressed += compared.hidden;
            outcome.in_baseline = compared.hidden;
            (outcome.baseline, outcome.taken_over) = (compared.new, compared.taken_over);
            let BaselineUse { path, stale, .. } = &compared.used;
            outcome.compared_with_baseline = Some(Compared {
                with: path.clone(),
                gone: stale.len(),
                smaller: compared.smaller,
            });
            upkeep.baseline = Some(compared.used);
            compared.kept
        } else {
            found.into_iter().map(|placed| placed.finding).collect()
        };
        // Known and ignored errors hid what they hide when the baseline and the ignores were
        // written, too.
        let taken_over = outcome
            .taken_over
            .is_some_and(|taken_over| taken_over.errors > 0);
        upkeep.errors = taken_over || shown.iter().any(|finding| finding.level >= Level::Error);
        let on_settings = check_upkeep(
            &upkeep,
            selection,
            ignores,
            options,
            &mut outcome.failed_rules,
        );
        all.extend(
            on_settings
                .iter()
                .filter(|_| options.compare.is_some())
                .cloned(),
        );
        shown.extend(on_settings);
        Ok(Found { shown, all })
    }
}

/// Leaves what is new or worse, and counts what is gone.
fn settle_comparison(
    before: Found,
    found: Found,
    compare: &Compare,
    now: &Side,
    outcome: &mut Outcome,
) {
    let missing = now.shown(&compare.missing);
    let is_compared = |path: &String| !missing.iter().any(|missing| is_below(path, missing));
    let is_compared = |finding: &Finding| {
        std::iter::once(&finding.path)
            .chain(finding.files())
            .all(is_compared)
    };
    let before = before.all.into_iter().filter(is_compared);
    let before: Vec<Finding> = before.map(Finding::without_ignored).collect();
    let [gone, smaller] = gone_and_smaller(&before, &found.all);
    outcome.findings = new_or_worse(&before, found.shown, is_compared);
    outcome.notes.push(Note::Compared {
        with: compare.with.clone(),
        gone,
    });
    outcome.compared = Some(Compared {
        with: compare.with.clone(),
        gone,
        smaller,
    });
    if !missing.is_empty() {
        outcome
            .not_checked
            .insert(0, NotChecked::of(None, Unchecked::NotCompared, missing));
    }
}

/// Settings have no sides; that they were others before is said.
fn settings_changed(options: &Config, compare: &Compare) -> Option<Note> {
    let path = &options.file.as_ref()?.path;
    let place = resolved(Path::new(path));
    let Before::Contents(contents) = &compare.before else {
        return None;
    };
    let is_changed = contents.contains_key(&place) || compare.now.contains_key(&place);
    is_changed.then(|| Note::SettingsChanged { path: path.clone() })
}
