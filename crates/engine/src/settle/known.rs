//! The baseline in a run: which findings it hides, which of its entries are stale, and what a new
//! baseline contains.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::baseline::{self, Found, placed};
use super::compare::{Claim, Comparison, Standing, compare};
use super::identify::Placed;
use super::scope::Scope;
use super::select::{Selection, cannot_be_ignored};
use crate::catalogue::named;
use crate::error::{BaselineFault, Error};
use mhlint_config::Config;
use mhlint_diag::{Baseline, BaselineUse, Entry, Finding, Level, TakenOver};
use mhlint_source::{Folder, canonical, holds, slashed};

/// The baseline of a run. It is read before the run begins.
pub(crate) struct Known {
    path: PathBuf,
    folder: Folder,
    old: Baseline,
    write: bool,
    is_first: bool,
}

/// The result of comparing the findings with the baseline.
pub(crate) struct Compared {
    pub(crate) kept: Vec<Finding>,
    pub(crate) hidden: usize,
    pub(crate) used: BaselineUse,
    /// How many findings have a better amount than in the baseline.
    pub(crate) smaller: usize,
    /// The baseline to write.
    pub(crate) new: Option<Baseline>,
    /// How the baseline to write differs from the old one.
    pub(crate) taken_over: Option<TakenOver>,
}

impl Known {
    /// Reads the baseline, if the run has one. The file need not exist if the run is to write it.
    pub(crate) fn open(config: &Config) -> Result<Option<Self>, Error> {
        let Some(path) = config.baseline.clone() else {
            return Ok(None);
        };
        let inside = path.parent().unwrap_or(Path::new("")).to_owned();
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let is_first = config.write_baseline && !holds(&inside, &name);
        let old = if is_first {
            Baseline::default()
        } else {
            baseline::read(&path)?
        };
        Ok(Some(Self {
            folder: Folder::of(&inside),
            path,
            old,
            write: config.write_baseline,
            is_first,
        }))
    }

    /// Removes the findings that the baseline has. `roots` are the printed paths of the checked
    /// data roots.
    pub(crate) fn compare<'r>(
        &self,
        found: Vec<Placed>,
        roots: impl Iterator<Item = &'r str>,
        selection: &Selection<'_>,
        scope: &Scope<'_>,
    ) -> Result<Compared, Error> {
        let roots: BTreeSet<String> = roots.map(|root| placed(&self.folder, root)).collect();
        let (safe, rest): (Vec<Placed>, Vec<Placed>) = found
            .into_iter()
            .partition(|placed| cannot_be_ignored(placed.finding.rule));
        let entries: Vec<Found> = rest.iter().map(|placed| self.found(placed)).collect();
        let homes = baseline::homes(&self.old.entries, &entries, &roots, |entry| {
            self.is_there(&entry.path)
        });
        let before: Vec<Claim<'_>> = self
            .old
            .entries
            .iter()
            .zip(homes)
            .map(|(entry, path)| baseline::claim(entry, path))
            .collect();
        let claims = entries
            .iter()
            .map(|found| baseline::claim(&found.entry, &found.entry.path))
            .zip(&rest);
        let now: Vec<Claim<'_>> = claims
            .map(|(claim, placed)| Claim {
                grows: placed.finding.measure().map(|one| one.grows),
                ..claim
            })
            .collect();
        let Comparison { now, gone } = compare(&before, &now);
        let known: Vec<bool> = now
            .iter()
            .map(|one| matches!(one, Standing::Same | Standing::Smaller))
            .collect();
        let smaller = now
            .iter()
            .filter(|standing| **standing == Standing::Smaller)
            .count();
        let lost: Vec<&Entry> = gone
            .iter()
            .filter_map(|number| self.old.entries.get(*number))
            .collect();
        // Data in memory have no paths on disk at which entries could be looked for.
        let on_disk = roots.iter().any(|root| self.is_there(root));
        if on_disk && lost.len() == self.old.entries.len() && scope.is_whole() {
            self.refuse_foreign(selection)?;
        }
        let checked = |entry: &&Entry| self.is_checked(entry, selection, scope);
        let stale: Vec<&Entry> = lost.into_iter().filter(checked).collect();
        let mut used = BaselineUse {
            path: slashed(&self.path),
            checked: self.old.entries.iter().filter(checked).count(),
            stale: stale.iter().map(|entry| describe(entry)).collect(),
        };
        let (mut new, mut taken_over) = (None, None);
        if self.write {
            let added = || {
                rest.iter()
                    .zip(&known)
                    .filter(|(_, known)| !**known)
                    .map(|(placed, _)| placed)
            };
            let errors = added()
                .filter(|placed| placed.finding.level == Level::Error)
                .count();
            taken_over = (!self.is_first).then(|| TakenOver {
                new: added().count(),
                errors,
                gone: used.stale.len(),
            });
            // Keeps entries that this run could not check: otherwise a run on a part of the data
            // would remove them.
            let others = self
                .old
                .entries
                .iter()
                .filter(|entry| !checked(entry) && !is_found(entry, &entries));
            let mut all: Vec<Entry> = others.cloned().collect();
            all.extend(entries.into_iter().map(|found| found.entry));
            new = Some(Baseline { entries: all });
            used.stale.clear();
        }
        let all = rest.len();
        let told = rest.into_iter().zip(now).filter(|_| !self.write);
        let told: Vec<Finding> = told
            .filter_map(|(placed, standing)| standing.of(placed.finding))
            .collect();
        let hidden = all - told.len();
        let kept = safe
            .into_iter()
            .map(|placed| placed.finding)
            .chain(told)
            .collect();
        Ok(Compared {
            kept,
            hidden,
            used,
            smaller,
            new,
            taken_over,
        })
    }

    /// Whether something exists at the path of an entry, relative to the baseline or to the working
    /// directory.
    fn is_there(&self, path: &str) -> bool {
        let folder = self.path.parent().unwrap_or(Path::new(""));
        [folder.join(path).as_path(), Path::new(path)]
            .into_iter()
            .any(|path| canonical(path).is_some())
    }

    /// Refuses a baseline that was made for other data: neither its findings nor its assets nor the
    /// folders of these exist. If the folder exists the asset may have been removed to fix the
    /// finding.
    fn refuse_foreign(&self, selection: &Selection<'_>) -> Result<(), Error> {
        let entries = &self.old.entries;
        let folder = |entry: &Entry| {
            entry
                .path
                .rsplit_once('/')
                .map_or(".", |(folder, _)| folder)
                .to_owned()
        };
        let is_gone = |entry: &Entry| !self.is_there(&entry.path) && !self.is_there(&folder(entry));
        let Some(first) = entries.first() else {
            return Ok(());
        };
        if !entries
            .iter()
            .all(|entry| !selection.is_silenced(&entry.rule) && is_gone(entry))
        {
            return Ok(());
        }
        let fault = BaselineFault::Foreign {
            first: first.path.clone(),
        };
        Err(Error::Baseline {
            path: self.path.display().to_string(),
            fault,
        })
    }

    fn found(&self, placed_at: &Placed) -> Found {
        let finding = &placed_at.finding;
        let entry = Entry {
            path: placed(&self.folder, finding.asset_path()),
            rule: finding.rule.to_owned(),
            key: finding.subject.key.clone(),
            fingerprint: placed_at.known_as.clone(),
            level: placed_at.consequence,
            parts: finding.subject.parts.clone(),
            measure: finding.measure().map(|measure| measure.value),
        };
        Found {
            entry,
            rel: placed_at.rel.clone(),
        }
    }

    /// Whether this run would have found the finding of an entry if it were still there.
    fn is_checked(&self, entry: &Entry, selection: &Selection<'_>, scope: &Scope<'_>) -> bool {
        named(&entry.rule).is_none()
            || !selection.is_silenced(&entry.rule) && scope.covers(&self.folder, &entry.path)
    }
}

fn is_found(entry: &Entry, found: &[Found]) -> bool {
    found
        .iter()
        .any(|found| found.entry.fingerprint == entry.fingerprint && found.entry.path == entry.path)
}

fn describe(entry: &Entry) -> String {
    let key = if entry.key.is_empty() {
        String::new()
    } else {
        format!(" ({})", entry.key)
    };
    format!("{}: {}{key}", entry.path, entry.rule)
}
