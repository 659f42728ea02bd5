//! Which findings on some layers are reported, at which level, and which files of their fixes stay
//! as they are.
//!
//! Levels, exclusions and ignores are for files, a finding may be about several.

use std::collections::BTreeSet;

use super::identify::{Placed, Root, identify};
use super::ignore::Ignores;
use super::scope::Scope;
use super::select::{Selection, Verdict, cannot_be_ignored};
use mhlint_config::Config;
use mhlint_diag::{Finding, IgnoredFiles};
use mhlint_repo::is_unfiled;

/// All that decides what is reported of some layers.
pub(crate) struct Keeper<'r> {
    pub(crate) root: Root<'r>,
    /// Whether a path is one that the PATHs ask for.
    pub(crate) is_asked_for: &'r dyn Fn(&str) -> bool,
    pub(crate) selection: &'r Selection<'r>,
    pub(crate) scope: &'r Scope<'r>,
    pub(crate) options: &'r Config,
}

impl Keeper<'_> {
    /// Keeps what is to be reported for the checked layer and gives it level and fingerprint;
    /// counts what is ignored.
    pub(crate) fn keep(
        &self,
        findings: Vec<Finding>,
        ignores: &mut Ignores<'_>,
    ) -> (Vec<Placed>, usize) {
        let files = self.root.layers().flat_map(|layer| layer.files.values());
        let commented =
            files.filter(|file| !file.ignores.is_empty() && self.is_reported(&file.path));
        let mut noted = BTreeSet::new();
        commented
            .filter(|file| noted.insert(&file.path))
            .for_each(|file| ignores.note(file, self.selection, self.scope));
        let (mut kept, mut hidden) = (Vec::new(), 0);
        for mut finding in findings
            .into_iter()
            .filter(|finding| self.is_wanted(finding))
        {
            let consequence = finding.level;
            match self.of(&mut finding, ignores) {
                Verdict::At(level) => {
                    let left_out = self.left_out(&finding, ignores);
                    if let Some(fix) = &mut finding.fix {
                        fix.left_out = left_out;
                    }
                    finding.regrade(level);
                    kept.push((finding, consequence));
                }
                Verdict::Hidden => hidden += 1,
                Verdict::Off | Verdict::Excluded => {}
            }
        }
        let mut placed = identify(self.root, kept);
        placed
            .iter_mut()
            .for_each(|one| one.finding.stand_where(self.is_asked_for));
        (placed, hidden)
    }

    /// What becomes of a finding. Where it stays although some of its files are ignored, it says
    /// so.
    fn of(&self, finding: &mut Finding, ignores: &mut Ignores<'_>) -> Verdict {
        let own = self.at(finding, &finding.path, ignores);
        let files = finding.files();
        if files.is_empty() {
            return own;
        }
        // What is between files is gone when only one is left.
        let fewest = if finding.between.is_empty() { 1 } else { 2 };
        let is_folder = !files.contains(&finding.path);
        if is_folder && matches!(own, Verdict::Hidden | Verdict::Excluded) {
            return own;
        }
        let all: Vec<Verdict> = files
            .iter()
            .map(|file| self.at(finding, file, ignores))
            .collect();
        let reported: Vec<Verdict> = all
            .iter()
            .copied()
            .filter(|verdict| matches!(verdict, Verdict::At(_)))
            .collect();
        let is_silent = |(file, verdict): (&String, &Verdict)| {
            (!matches!(verdict, Verdict::At(_))).then(|| file.clone())
        };
        let silent: Vec<String> = files.iter().zip(&all).filter_map(is_silent).collect();
        match reported.first() {
            Some(first) if reported.len() >= fewest => {
                finding.ignored = (!silent.is_empty()).then_some(IgnoredFiles {
                    files: silent,
                    of: all.len(),
                });
                if matches!(own, Verdict::At(_)) {
                    own
                } else {
                    *first
                }
            }
            _ if all.contains(&Verdict::Hidden) => Verdict::Hidden,
            _ => all
                .into_iter()
                .find(|verdict| !matches!(verdict, Verdict::At(_)))
                .unwrap_or(own),
        }
    }

    /// What becomes of the part of a finding in one file.
    fn at(&self, finding: &Finding, path: &str, ignores: &mut Ignores<'_>) -> Verdict {
        if cannot_be_ignored(finding.rule) {
            return Verdict::At(finding.level);
        }
        // What is excluded is hidden; but what is dangerous is reported wherever the run looks.
        if self.scope.excludes(path) {
            return Verdict::Excluded;
        }
        let rel = self
            .options
            .file
            .as_ref()
            .and_then(|file| file.relative(path));
        let verdict = self
            .selection
            .verdict(finding.rule, finding.level, rel.as_deref());
        let file = || self.root.layers().find_map(|layer| layer.printed(path));
        let is_reported = matches!(verdict, Verdict::At(_));
        if is_reported && ignores.hides(finding.rule, path, file()) {
            Verdict::Hidden
        } else {
            verdict
        }
    }

    /// Files of a fix that are not to be written: those for which the rule is ignored, and those
    /// beside the PATHs.
    fn left_out(&self, finding: &Finding, ignores: &mut Ignores<'_>) -> Vec<String> {
        let steps = finding.fix.iter().flat_map(|fix| &fix.steps);
        let mut files: Vec<String> = steps.map(|step| step.path.clone()).collect();
        files.sort_unstable();
        files.dedup();
        files.retain(|file| {
            !matches!(self.at(finding, file, ignores), Verdict::At(_)) || !(self.is_asked_for)(file)
        });
        files
    }

    fn is_wanted(&self, finding: &Finding) -> bool {
        if self.root.own_path(&finding.path).is_none() {
            return false;
        }
        let bases: Vec<String> = self
            .root
            .layers()
            .flat_map(|layer| layer.bases_at(&finding.path))
            .collect();
        let asks = |base: &str| self.options.asks_for_base(base);
        let is_of_asked = bases.is_empty()
            || bases.iter().any(|base| asks(base))
            || self.is_unfiled(&finding.path);
        // One finding may be about several files; who names one of them gets it.
        let mut files = std::iter::once(&finding.path).chain(finding.files());
        files.any(|file| (self.is_asked_for)(file)) && is_of_asked
    }

    /// Whether the file at a path is for a base mesh that is asked for, though it lies in the
    /// folder of none.
    fn is_unfiled(&self, path: &str) -> bool {
        let file = self.root.layers().find_map(|layer| layer.printed(path));
        let layers = || self.root.layers().chain(self.root.below.iter().copied());
        file.is_some_and(|file| is_unfiled(file, layers(), |base| self.options.asks_for_base(base)))
    }

    fn is_reported(&self, path: &str) -> bool {
        (self.is_asked_for)(path) && !self.scope.excludes(path)
    }
}
