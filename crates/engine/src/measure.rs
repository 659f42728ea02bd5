//! Targets and evaluation, one base at a time: rows are read, measured and dropped before the next
//! base.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::caught::caught;
use super::load::{Data, Loaded};
use mhlint_config::Config;
use mhlint_diag::{Application, FailedStep, grouped};
use mhlint_eval::measures::Measures;
use mhlint_evaluate::{self as evaluate, Rows, is_measured, needs_rows};
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
    let mut all = names(data);
    all.extend(before.iter().flat_map(|before| names(before)));
    let owned = bases(data);
    let owned_before = before
        .as_ref()
        .map(|before| bases(before))
        .unwrap_or_default();
    let has_rows = |data: &Data<'_>| {
        data.stacks()
            .iter()
            .flat_map(|stack| &stack.seen)
            .any(|(of, _)| needs_rows(*of))
    };
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
        let mut rows = load_targets(
            data,
            name.as_deref(),
            options,
            None,
            evaluated.filter(|_| keeps_rows).map(|_| &nothing),
        );
        let Some(before) = &mut before else {
            if let Some(name) = evaluated {
                measure_base(
                    data,
                    name,
                    &owned,
                    &mut rows,
                    options,
                    &mut measures,
                    failed,
                );
            }
            continue;
        };
        let mut rows_before = {
            let kept = evaluated.filter(|_| keeps_rows).map(|_| &rows);
            load_targets(before, name.as_deref(), options, Some(data), kept)
        };
        let Some(name) = evaluated else { continue };
        let is_same = !differing.contains(&None)
            && !differing.contains(&Some(name.to_owned()))
            && are_same(&targets(data, name), &targets(before, name));
        if is_same {
            rows_before = Rows::new();
        }
        measure_base(
            data,
            name,
            &owned,
            &mut rows,
            options,
            &mut measures,
            failed,
        );
        if is_same {
            take_over([data, before], &measures, &mut measures_before, name);
        } else {
            measure_base(
                before,
                name,
                &owned_before,
                &mut rows_before,
                options,
                &mut measures_before,
                failed,
            );
        }
    }
    [measures, measures_before]
}

fn load_targets(
    data: &mut Data<'_>,
    base: Option<&str>,
    options: &Config,
    other: Option<&Data<'_>>,
    keep_rows: Option<&Rows>,
) -> Rows {
    let mut rows = Rows::new();
    for root in data.all_mut() {
        rows.append(&mut root.load_targets(base, &options.limits, other, keep_rows));
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
fn targets<'d>(data: &'d Data<'_>, base: &str) -> Vec<&'d Arc<Content>> {
    let files = data.all().flat_map(|root| {
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

/// Gives the data as they were the measures of now.
fn take_over(data: [&Data<'_>; 2], now: &[Measured], before: &mut [Measured], base: &str) {
    let [data, data_before] = data;
    for (root, before) in data_before.roots.iter().zip(before) {
        let same = data
            .roots
            .iter()
            .zip(now)
            .filter(|(other, _)| other.place.is_counterpart(&root.place));
        for (application, measures) in same.flat_map(|(_, now)| now) {
            let own = measures
                .get(base)
                .map(|measures| (base.to_owned(), Arc::clone(measures)));
            before.entry(*application).or_default().extend(own);
        }
    }
}

/// Names of the bases with targets or a mesh, in order; `None` for targets that belong to no base.
fn names(data: &Data<'_>) -> BTreeSet<Option<String>> {
    let mut names = BTreeSet::new();
    for root in data.all() {
        names.extend(
            root.place
                .target_bases()
                .into_iter()
                .map(|base| base.map(str::to_owned)),
        );
        let with_mesh = root
            .layer
            .files
            .values()
            .filter(|file| file.mesh().is_some());
        names.extend(with_mesh.map(|file| file.base().map(str::to_owned)));
    }
    names
}

/// Names of the bases that files of each repository belong to, targets included.
fn bases(data: &Data<'_>) -> Vec<BTreeSet<String>> {
    let of = |root: &Loaded<'_>| {
        let files = root.layer.files.values().filter_map(|file| file.base());
        files
            .chain(root.place.target_bases().into_iter().flatten())
            .map(str::to_owned)
            .collect()
    };
    data.roots.iter().map(of).collect()
}

fn measure_base(
    data: &Data<'_>,
    name: &str,
    owned: &[BTreeSet<String>],
    rows: &mut Rows,
    options: &Config,
    measures: &mut [Measured],
    failed: &mut Vec<FailedStep>,
) {
    let has_base = |number: usize| owned.get(number).is_some_and(|bases| bases.contains(name));
    let stacks = data.stacks_of(has_base).into_iter();
    let seen = stacks.flat_map(|(number, stack)| {
        stack
            .seen
            .into_iter()
            .map(move |(of, layers)| (number, of, layers))
    });
    let mut seen = seen
        .filter(|(_, application, _)| is_measured(*application))
        .peekable();
    while let Some((number, application, layers)) = seen.next() {
        // Repositories over the same system data share its rows; the last one takes them.
        let own = if seen.peek().is_none() {
            &mut *rows
        } else {
            &mut rows.clone()
        };
        let evaluate = || evaluate::measure(application, layers, name, own, options);
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
