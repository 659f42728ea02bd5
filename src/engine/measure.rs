//! Targets and evaluation, one base at a time: rows are read, measured and dropped before the next base.

use std::collections::{BTreeMap, BTreeSet};

use super::caught::caught;
use super::load::{Data, Loaded, Stack};
use crate::config::Config;
use crate::diag::{Application, FailedStep};
use crate::eval::measures::Measures;
use crate::evaluate::{self, Rows};
use crate::repo::makehuman2::Base;

/// Reads the targets of all bases and measures each base of each repository: one map a repository. What could not be
/// measured for a bug of ours is noted in `failed`.
pub(super) fn measure_bases(
    data: &mut Data<'_>,
    options: &Config,
    failed: &mut Vec<FailedStep>,
) -> Vec<BTreeMap<String, Measures>> {
    let mut measures: Vec<BTreeMap<String, Measures>> = data.roots.iter().map(|_| BTreeMap::new()).collect();
    let bases: Vec<BTreeSet<String>> = data.roots.iter().map(bases_of).collect();
    for name in names(data) {
        let evaluated = name.as_deref().filter(|name| !options.no_eval && options.asks_for_base(name));
        let mut rows = Rows::new();
        for root in data.all_mut() {
            rows.append(&mut root.load_targets(name.as_deref(), &options.limits, evaluated.is_some()));
        }
        if let Some(name) = evaluated {
            let concerned: Vec<bool> = bases.iter().map(|bases| bases.contains(name)).collect();
            measure_base(data, name, rows, &concerned, options, &mut measures, failed);
        }
    }
    measures
}

/// Names of the bases with targets or a mesh, in order; `None` for targets that belong to no base.
fn names(data: &Data<'_>) -> BTreeSet<Option<String>> {
    let mut names = BTreeSet::new();
    for root in data.all() {
        names.extend(root.place.target_bases().into_iter().map(|base| base.map(str::to_owned)));
        let with_mesh = root.layer.files.values().filter(|file| file.mesh().is_some());
        names.extend(with_mesh.map(|file| file.base().map(str::to_owned)));
    }
    names
}

/// Names of the bases that files of a root of MakeHuman 2 belong to, its targets included.
fn bases_of(root: &Loaded<'_>) -> BTreeSet<String> {
    if !root.layer.layouts.iter().any(|layout| layout.application == Application::Makehuman2) {
        return BTreeSet::new();
    }
    let files = root.layer.files.values().filter_map(|file| file.base());
    files.chain(root.place.target_bases().into_iter().flatten()).map(str::to_owned).collect()
}

fn measure_base(
    data: &Data<'_>,
    name: &str,
    mut rows: Rows,
    concerned: &[bool],
    options: &Config,
    measures: &mut [BTreeMap<String, Measures>],
    failed: &mut Vec<FailedStep>,
) {
    let last = concerned.iter().rposition(|concerned| *concerned);
    for (number, (Stack { seen, .. }, found)) in data.stacks().into_iter().zip(measures).enumerate() {
        let own = seen.iter().find(|(application, _)| *application == Application::Makehuman2);
        let (Some((_, layers)), Some(true)) = (own, concerned.get(number)) else { continue };
        let base = Base::resolve(name, layers.system, layers.user);
        // Repositories over the same system data share its rows; the last one takes them.
        let own = if Some(number) == last { &mut rows } else { &mut rows.clone() };
        let evaluate = || evaluate::measure(&base, own, options);
        if let Some(Some(measured)) = caught(FailedStep::Evaluation { base: name.to_owned() }, failed, evaluate) {
            found.insert(name.to_owned(), measured);
        }
    }
}
