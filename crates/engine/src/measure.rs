//! Targets and evaluation, one base at a time: rows are read, measured and dropped before the next
//! base.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::caught::caught;
use super::load::Data;
use mhlint_config::Config;
use mhlint_diag::{Application, FailedStep, grouped};
use mhlint_eval::measures::Measures;
use mhlint_evaluate::{self as evaluate, Rows};
use mhlint_formats::Content;
use mhlint_formats::Format;

/// Measures by name of the base, as each application shows it.
pub(super) type Measured = BTreeMap<Application, BTreeMap<String, Arc<Measures>>>;

/// Reads the targets of all bases and measures each base of each repository: one entry a
/// repository. The same for the data as they were; a base of which nothing that is evaluated has
/// changed is measured once. What could not be measured for a bug of ours is noted in `failed`.
pub(super) fn measure_bases(
    data: &mut Data<'_>,
    mut before: Option<&mut Data<'_>>,
    options: &Config,
    failed: &mut Vec<FailedStep>,
) -> [Vec<Measured>; 2] {
    let none = |data: &Data<'_>| {
        data.roots
            .iter()
            .map(|_| Measured::new())
            .collect::<Vec<_>>()
    };
    let mut measures = none(data);
    let mut measures_before = before
        .as_ref()
        .map(|before| none(before))
        .unwrap_or_default();
    let owned = roots_of_bases(data);
    let owned_before = before
        .as_ref()
        .map(|before| roots_of_bases(before))
        .unwrap_or_default();
    let looked_at = owned.iter().chain(&owned_before);
    let looked_at = looked_at.filter(|(_, own)| own.is_looked_at);
    let all: BTreeSet<Option<String>> = looked_at.map(|(name, _)| name.clone()).collect();
    let has_rows = |data: &Data<'_>| data.stacks().iter().any(|stack| !stack.seen.is_empty());
    let keeps_rows = has_rows(data) || before.as_ref().is_some_and(|before| has_rows(before));
    let differing = before
        .as_ref()
        .map(|before| differing(data, before))
        .unwrap_or_default();
    for name in all {
        let evaluated = name
            .as_deref()
            .filter(|name| !options.no_eval && options.asks_for_base(name));
        let nothing = Rows::new();
        let rows = load_targets(
            data,
            owned.get(&name),
            name.as_deref(),
            options,
            None,
            evaluated.filter(|_| keeps_rows).map(|_| &nothing),
        );
        let Some(before) = &mut before else {
            if let Some(name) = evaluated {
                measure_base(data, name, &owned, &rows, options, &mut measures, failed);
            }
            continue;
        };
        let mut rows_before = {
            let kept = evaluated.filter(|_| keeps_rows).map(|_| &rows);
            let own = owned_before.get(&name);
            load_targets(before, own, name.as_deref(), options, Some(data), kept)
        };
        let Some(name) = evaluated else { continue };
        let key = Some(name.to_owned());
        let is_same = !differing.contains(&None)
            && !differing.contains(&key)
            && are_same(
                &targets(data, owned.get(&key), name),
                &targets(before, owned_before.get(&key), name),
            );
        if is_same {
            rows_before = Rows::new();
        }
        measure_base(data, name, &owned, &rows, options, &mut measures, failed);
        if is_same {
            let own = owned.get(&key).map(|own| own.roots.as_slice());
            let own = own.unwrap_or_default();
            take_over([data, before], own, &measures, &mut measures_before, name);
        } else {
            measure_base(
                before,
                name,
                &owned_before,
                &rows_before,
                options,
                &mut measures_before,
                failed,
            );
        }
    }
    [measures, measures_before]
}

/// The roots with something of a base: numbers among those to check, and among all those with
/// targets.
#[derive(Default)]
struct OfBase {
    roots: Vec<usize>,
    with_targets: Vec<usize>,
    /// Whether it has targets or a mesh.
    is_looked_at: bool,
}

fn load_targets(
    data: &mut Data<'_>,
    own: Option<&OfBase>,
    base: Option<&str>,
    options: &Config,
    other: Option<&Data<'_>>,
    keep_rows: Option<&Rows>,
) -> Rows {
    let mut rows = Rows::new();
    for number in own.into_iter().flat_map(|own| &own.with_targets) {
        if let Some(root) = data.all_mut().nth(*number) {
            rows.extend(root.load_targets(base, &options.limits, other, keep_rows));
        }
    }
    rows
}

/// Names of the bases of which a file that is evaluated differs, targets left out; `None` for one
/// that belongs to all.
fn differing(now: &Data<'_>, before: &Data<'_>) -> BTreeSet<Option<String>> {
    let (now, before) = (contents(now), contents(before));
    let nothing = Vec::new();
    let mut bases: BTreeSet<Option<&str>> = now.keys().chain(before.keys()).copied().collect();
    bases.retain(|base| {
        !are_same(
            now.get(base).unwrap_or(&nothing),
            before.get(base).unwrap_or(&nothing),
        )
    });
    bases
        .into_iter()
        .map(|base| base.map(str::to_owned))
        .collect()
}

/// What is evaluated but for targets, which are read in turn, by the base that it belongs to.
fn contents<'d>(data: &'d Data<'_>) -> BTreeMap<Option<&'d str>, Vec<&'d Arc<Content>>> {
    let files = data.all().flat_map(|root| root.layer.files.values());
    let read = files.filter(|file| Format::of(file.kind).is_read());
    grouped(read.map(|file| (file.base(), &file.content)))
        .into_iter()
        .collect()
}

/// The targets of a base.
fn targets<'d>(data: &'d Data<'_>, own: Option<&OfBase>, base: &str) -> Vec<&'d Arc<Content>> {
    let numbers = own.into_iter().flat_map(|own| &own.with_targets);
    let roots = numbers.filter_map(|number| data.all().nth(*number));
    let files = roots.flat_map(|root| {
        root.place
            .bulk_of(Some(base))
            .map(|file| root.layer.file(&file.rel))
    });
    files.flatten().map(|file| &file.content).collect()
}

/// Whether contents were read once for both sides.
fn are_same(now: &[&Arc<Content>], before: &[&Arc<Content>]) -> bool {
    now.len() == before.len()
        && now
            .iter()
            .zip(before)
            .all(|(now, before)| Arc::ptr_eq(now, before))
}

/// Gives the data as they were the measures of now, of the roots with these numbers.
fn take_over(
    data: [&Data<'_>; 2],
    own: &[usize],
    now: &[Measured],
    before: &mut [Measured],
    base: &str,
) {
    let [data, data_before] = data;
    for number in own {
        let Some((root, now)) = data.roots.get(*number).zip(now.get(*number)) else {
            continue;
        };
        for same in data_before.counterparts(&root.place) {
            let Some(before) = before.get_mut(same) else {
                continue;
            };
            for (application, measures) in now {
                let own = measures
                    .get(base)
                    .map(|measures| (base.to_owned(), Arc::clone(measures)));
                before.entry(*application).or_default().extend(own);
            }
        }
    }
}

/// The bases that files belong to, by name; `None` for targets that belong to no base.
fn roots_of_bases(data: &Data<'_>) -> BTreeMap<Option<String>, OfBase> {
    let mut all: BTreeMap<Option<String>, OfBase> = BTreeMap::new();
    let of = |base: Option<&str>| base.map(str::to_owned);
    let first = data.systems.len();
    for (number, root) in data.all().enumerate() {
        let with_targets = root.place.target_bases();
        let files = || root.layer.files.values();
        let with_mesh = files().filter(|file| file.mesh().is_some());
        let looked_at = with_mesh
            .map(|file| file.base())
            .chain(with_targets.clone());
        for base in looked_at.collect::<BTreeSet<_>>() {
            all.entry(of(base)).or_default().is_looked_at = true;
        }
        for base in &with_targets {
            all.entry(of(*base)).or_default().with_targets.push(number);
        }
        let own = files().map(|file| file.base()).chain(with_targets);
        if number >= first {
            for base in own.collect::<BTreeSet<_>>() {
                all.entry(of(base)).or_default().roots.push(number - first);
            }
        }
    }
    all
}

fn measure_base(
    data: &Data<'_>,
    name: &str,
    owned: &BTreeMap<Option<String>, OfBase>,
    rows: &Rows,
    options: &Config,
    measures: &mut [Measured],
    failed: &mut Vec<FailedStep>,
) {
    let own = owned.get(&Some(name.to_owned()));
    let numbers = own.into_iter().flat_map(|own| own.roots.iter().copied());
    let stacks = data.stacks_of(numbers).into_iter();
    let seen = stacks.flat_map(|(number, stack)| {
        stack
            .seen
            .into_iter()
            .map(move |(of, layers)| (number, of, layers))
    });
    for (number, application, layers) in seen {
        let evaluate = || evaluate::measure(application, layers, name, rows, options);
        let step = FailedStep::Evaluation {
            base: name.to_owned(),
        };
        if let (Some(Some(found)), Some(root)) =
            (caught(step, failed, evaluate), measures.get_mut(number))
        {
            root.entry(application)
                .or_default()
                .insert(name.to_owned(), Arc::new(found));
        }
    }
}
