//! Decides which findings are reported, at which level, and which files of their fixes must not be
//! written.
//!
//! Levels, exclusions and ignores are set for files, but a finding may be about several files.

use std::collections::BTreeSet;

use super::identify::{Placed, Root, identify};
use super::ignore::Ignores;
use super::scope::Scope;
use super::select::{Selection, Verdict, cannot_be_ignored};
use mhlint_config::Config;
use mhlint_diag::{Finding, IgnoredFiles};
use mhlint_repo::is_unfiled;

/// Everything that decides which findings on a data root are reported.
pub(crate) struct Keeper<'r> {
    pub(crate) root: Root<'r>,
    /// Whether the PATHs of the command line include a path.
    pub(crate) is_asked_for: &'r dyn Fn(&str) -> bool,
    pub(crate) selection: &'r Selection<'r>,
    pub(crate) scope: &'r Scope<'r>,
    pub(crate) options: &'r Config,
}

impl Keeper<'_> {
    /// Returns the findings on the checked layer that are reported, with level and fingerprint, and
    /// how many are hidden.
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

    /// Whether a finding is reported, and at which level. If it is reported although some of its
    /// files are ignored, the finding says so.
    fn of(&self, finding: &mut Finding, ignores: &mut Ignores<'_>) -> Verdict {
        let own = self.at(finding, &finding.path, ignores);
        let files = finding.files();
        if files.is_empty() {
            return own;
        }
        // A finding on a relation between files makes no sense if only one of the files is left.
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

    /// Whether a finding is reported as far as it is about one file.
    fn at(&self, finding: &Finding, path: &str, ignores: &mut Ignores<'_>) -> Verdict {
        if cannot_be_ignored(finding.rule) {
            return Verdict::At(finding.level);
        }
        // Findings in excluded files are not reported. Safety rules, which return above, are
        // reported even there.
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

    /// The files of a fix that must not be written: those for which the rule is ignored, and those
    /// outside of the PATHs.
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
        // A finding may be about several files. It is reported if the user asks for any of these.
        let mut files = std::iter::once(&finding.path).chain(finding.files());
        files.any(|file| (self.is_asked_for)(file)) && is_of_asked
    }

    /// Whether the file at a path is for a base mesh that the user asks for, although it does not
    /// lie in the folder of a base mesh.
    fn is_unfiled(&self, path: &str) -> bool {
        let file = self.root.layers().find_map(|layer| layer.printed(path));
        let layers = || self.root.layers().chain(self.root.below.iter().copied());
        file.is_some_and(|file| is_unfiled(file, layers(), |base| self.options.asks_for_base(base)))
    }

    fn is_reported(&self, path: &str) -> bool {
        (self.is_asked_for)(path) && !self.scope.excludes(path)
    }
}
