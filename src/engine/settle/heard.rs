//! Which findings get through: levels, exclusions and ignores are for files, a finding may speak for several.

use super::ignore::Ignores;
use super::scope::Scope;
use super::select::{Selection, Verdict, cannot_be_ignored};
use crate::config::Config;
use crate::diag::{Finding, IgnoredFiles, Level};
use crate::repo::Layer;

/// What becomes of a finding, or of its part in one file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::engine) enum Heard {
    /// Reported at this level.
    At(Level),
    /// Hidden by somebody's wish, and counted.
    Hidden,
    /// Excluded: out of sight.
    Excluded,
    /// The rule is off.
    Off,
}

/// All that can keep a finding on the files of a layer from being reported, but for the PATHs.
pub(in crate::engine) struct Filter<'r> {
    pub(in crate::engine) layer: &'r Layer,
    pub(in crate::engine) selection: &'r Selection<'r>,
    pub(in crate::engine) scope: &'r Scope<'r>,
    pub(in crate::engine) options: &'r Config,
}

impl Filter<'_> {
    /// What becomes of a finding. Where it stays although some of its files are ignored, it says so.
    pub(in crate::engine) fn of(&self, finding: &mut Finding, ignores: &mut Ignores<'_>) -> Heard {
        let own = self.at(finding, &finding.path, ignores);
        let files = finding.files();
        if files.is_empty() {
            return own;
        }
        // What is between files is gone when only one is left.
        let fewest = if finding.between.is_empty() { 1 } else { 2 };
        let is_folder = !files.contains(&finding.path);
        if is_folder && matches!(own, Heard::Hidden | Heard::Excluded) {
            return own;
        }
        let all: Vec<Heard> = files.iter().map(|file| self.at(finding, file, ignores)).collect();
        let heard: Vec<Heard> = all.iter().copied().filter(|heard| matches!(heard, Heard::At(_))).collect();
        let silent = all.len() - heard.len();
        match heard.first() {
            Some(first) if heard.len() >= fewest => {
                finding.ignored = (silent > 0).then_some(IgnoredFiles { count: silent, of: all.len() });
                if matches!(own, Heard::At(_)) { own } else { *first }
            }
            _ if all.contains(&Heard::Hidden) => Heard::Hidden,
            _ => all.into_iter().find(|heard| !matches!(heard, Heard::At(_))).unwrap_or(own),
        }
    }

    /// Files of its fix for which the rule of a finding is not heard.
    pub(in crate::engine) fn spared(&self, finding: &Finding, ignores: &mut Ignores<'_>) -> Vec<String> {
        let steps = finding.fix.iter().flat_map(|fix| &fix.steps);
        let mut files: Vec<&String> = steps.map(|step| &step.path).collect();
        files.sort_unstable();
        files.dedup();
        files.retain(|file| !matches!(self.at(finding, file, ignores), Heard::At(_)));
        files.into_iter().cloned().collect()
    }

    fn at(&self, finding: &Finding, path: &str, ignores: &mut Ignores<'_>) -> Heard {
        if cannot_be_ignored(finding.rule) {
            return Heard::At(finding.level);
        }
        // What is excluded is out of sight; but what is dangerous is told wherever the run looks.
        if self.scope.excludes(path) {
            return Heard::Excluded;
        }
        let rel = self.options.file.as_ref().and_then(|file| file.relative(path));
        let level = match self.selection.verdict(finding.rule, finding.level, rel.as_deref()) {
            Verdict::Off => return Heard::Off,
            Verdict::OffHere => return Heard::Hidden,
            Verdict::At(level) => level,
        };
        let file = self.layer.relative(path).and_then(|rel| self.layer.file(rel));
        if ignores.hides(finding.rule, path, file) { Heard::Hidden } else { Heard::At(level) }
    }
}
