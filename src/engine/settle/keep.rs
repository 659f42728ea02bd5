//! Which findings on some layers are reported, at which level, and which files of their fixes stay as they are.

use std::collections::BTreeSet;

use super::heard::{Filter, Heard};
use super::identify::{Placed, Root, identify};
use super::ignore::Ignores;
use super::scope::Scope;
use super::select::Selection;
use crate::config::Config;
use crate::diag::Finding;

/// All that decides what is reported of some layers.
pub(in crate::engine) struct Keeper<'r> {
    pub(in crate::engine) root: Root<'r>,
    /// Whether a path is one that the PATHs ask for.
    pub(in crate::engine) is_asked_for: &'r dyn Fn(&str) -> bool,
    pub(in crate::engine) selection: &'r Selection<'r>,
    pub(in crate::engine) scope: &'r Scope<'r>,
    pub(in crate::engine) options: &'r Config,
}

impl Keeper<'_> {
    /// Keeps what is to be reported for the judged layer and gives it level and fingerprint; counts what is ignored.
    pub(in crate::engine) fn keep(&self, findings: Vec<Finding>, ignores: &mut Ignores<'_>) -> (Vec<Placed>, usize) {
        let files = self.root.layer.files.values();
        let commented = files.filter(|file| !file.ignores.is_empty() && self.is_reported(&file.path));
        commented.for_each(|file| ignores.note(file, self.selection, self.scope));
        let filter = self.filter();
        let (mut kept, mut hidden) = (Vec::new(), 0);
        for mut finding in findings.into_iter().filter(|finding| self.is_wanted(finding)) {
            let consequence = finding.level;
            match filter.of(&mut finding, ignores) {
                Heard::At(level) => {
                    let spared = self.spared(&filter.spared(&finding, ignores), &finding);
                    finding.fix.iter_mut().for_each(|fix| fix.spared.clone_from(&spared));
                    finding.regrade(level);
                    kept.push((finding, consequence));
                }
                Heard::Hidden => hidden += 1,
                Heard::Off | Heard::Excluded => {}
            }
        }
        (identify(self.root, kept), hidden)
    }

    fn filter(&self) -> Filter<'_> {
        let Self { selection, scope, options, .. } = self;
        Filter { layer: self.root.layer, selection, scope, options }
    }

    /// Files of a fix that are not to be written: those for which the rule is ignored, and those beside the PATHs.
    fn spared(&self, ignored: &[String], finding: &Finding) -> Vec<String> {
        let steps = finding.fix.iter().flat_map(|fix| fix.steps.iter().map(|step| &step.path));
        let files: BTreeSet<&String> = ignored.iter().chain(steps.filter(|path| !(self.is_asked_for)(path))).collect();
        files.into_iter().cloned().collect()
    }

    fn is_wanted(&self, finding: &Finding) -> bool {
        let Some(rel) = self.root.own_path(&finding.path) else { return false };
        let bases = self.root.layer.bases_at(rel);
        let is_of_asked = bases.is_empty() || bases.iter().any(|base| self.options.asks_for_base(base));
        // One finding may speak for several files; who names one of them is told.
        let mut files = std::iter::once(&finding.path).chain(finding.files());
        files.any(|file| (self.is_asked_for)(file)) && is_of_asked
    }

    fn is_reported(&self, path: &str) -> bool {
        (self.is_asked_for)(path) && !self.scope.excludes(path)
    }
}
