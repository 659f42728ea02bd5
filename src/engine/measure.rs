//! Targets and evaluation, one base at a time: rows are read, measured and dropped before the next base.

use std::collections::{BTreeMap, BTreeSet};

use super::compose::{Rows, compose};
use super::data::Data;
use super::load::load_targets;
use super::run::Options;
use crate::eval::measures::Measures;
use crate::repo::Base;

/// Reads the targets of all bases and measures each base of each repository: one map a repository.
pub(super) fn measure_bases(data: &mut Data<'_>, options: &Options) -> Vec<BTreeMap<String, Measures>> {
    let names: BTreeSet<Option<String>> =
        data.all().flat_map(|root| root.place.target_bases()).map(|base| base.map(str::to_owned)).collect();
    let with_mesh: BTreeSet<Option<String>> = data
        .all()
        .flat_map(|root| root.layer.files.values())
        .filter(|file| file.mesh().is_some())
        .map(|file| file.base.clone())
        .collect();
    let mut measures: Vec<BTreeMap<String, Measures>> = data.roots.iter().map(|_| BTreeMap::new()).collect();
    for name in names.union(&with_mesh) {
        let evaluated = !options.no_eval && name.as_ref().is_some_and(|name| is_asked_for(name, options));
        let mut rows = Rows::new();
        for (root, sizes) in data.all_mut() {
            let keep = evaluated;
            rows.append(&mut load_targets(root.place, &mut root.layer, name.as_deref(), sizes, &options.limits, keep));
        }
        let Some(name) = name.as_deref().filter(|_| evaluated) else { continue };
        for ((system, user, judged), found) in data.stacks().into_iter().zip(&mut measures) {
            let concerns = judged.layer.files.values().any(|file| file.base.as_deref() == Some(name));
            if !concerns {
                continue;
            }
            let base = Base::resolve(name, system, user);
            // Several repositories may share the rows of their system data.
            let mut rows = if data.roots.len() == 1 { std::mem::take(&mut rows) } else { rows.clone() };
            if let Some(scene) = compose(&base, &mut rows) {
                drop(rows);
                found.insert(name.to_owned(), Measures::of(&scene));
            }
        }
    }
    measures
}

fn is_asked_for(name: &str, options: &Options) -> bool {
    options.bases.is_empty() || options.bases.iter().any(|base| base == name)
}
