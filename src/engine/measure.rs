//! Targets and evaluation, one base at a time: rows are read, measured and dropped before the next base.

use std::collections::{BTreeMap, BTreeSet};

use super::caught::caught;
use super::load::{Data, Loaded};
use crate::config::Config;
use crate::diag::{Application, FailedStep};
use crate::discover::Kind;
use crate::eval::measures::Measures;
use crate::evaluate::{self, Rows, is_evaluated};

/// Measures by name of the base, as each application shows it.
pub(super) type Measured = BTreeMap<Application, BTreeMap<String, Measures>>;

/// Reads the targets of all bases and measures each base of each repository: one entry a repository. What could not be
/// measured for a bug of ours is noted in `failed`.
pub(super) fn measure_bases(data: &mut Data<'_>, options: &Config, failed: &mut Vec<FailedStep>) -> Vec<Measured> {
    let mut measures: Vec<Measured> = data.roots.iter().map(|_| Measured::new()).collect();
    let bases: Vec<BTreeSet<String>> = data.roots.iter().map(bases_of).collect();
    for name in names(data) {
        let evaluated = name.as_deref().filter(|name| !options.no_eval && options.asks_for_base(name));
        let mut rows = Rows::new();
        for root in data.all_mut() {
            rows.append(&mut root.load_targets(name.as_deref(), &options.limits, evaluated.is_some()));
        }
        if let Some(name) = evaluated {
            measure_base(data, name, rows, &bases, options, &mut measures, failed);
        }
    }
    measures
}

/// Names of the bases with targets or a mesh, in order; `None` for targets that belong to no base.
fn names(data: &Data<'_>) -> BTreeSet<Option<String>> {
    let mut names = BTreeSet::new();
    for root in data.all() {
        names.extend(root.place.target_bases().into_iter().map(|base| base.map(str::to_owned)));
        let with_mesh = root.layer.files.values().filter(|file| file.kind == Kind::BaseMesh && file.mesh().is_some());
        names.extend(with_mesh.map(|file| file.base().map(str::to_owned)));
    }
    names
}

/// Names of the bases that files of a root belong to, its targets included.
fn bases_of(root: &Loaded<'_>) -> BTreeSet<String> {
    let files = root.layer.files.values().filter_map(|file| file.base());
    files.chain(root.place.target_bases().into_iter().flatten()).map(str::to_owned).collect()
}

fn measure_base(
    data: &Data<'_>,
    name: &str,
    mut rows: Rows,
    bases: &[BTreeSet<String>],
    options: &Config,
    measures: &mut [Measured],
    failed: &mut Vec<FailedStep>,
) {
    let is_concerned = |number: usize| bases.get(number).is_some_and(|bases| bases.contains(name));
    let stacks = data.stacks().into_iter().enumerate().filter(|(number, _)| is_concerned(*number));
    let seen = stacks.flat_map(|(number, stack)| stack.seen.into_iter().map(move |(of, layers)| (number, of, layers)));
    let mut seen = seen.filter(|(_, application, _)| is_evaluated(*application)).peekable();
    while let Some((number, application, layers)) = seen.next() {
        // Repositories over the same system data share its rows; the last one takes them.
        let own = if seen.peek().is_none() { &mut rows } else { &mut rows.clone() };
        let evaluate = || evaluate::measure(application, layers, name, own, options);
        let step = FailedStep::Evaluation { base: name.to_owned() };
        if let (Some(Some(found)), Some(root)) = (caught(step, failed, evaluate), measures.get_mut(number)) {
            root.entry(application).or_default().insert(name.to_owned(), found);
        }
    }
}
