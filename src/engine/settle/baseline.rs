//! `mhlint-baseline/1`: findings that are known, by fingerprint, and what of them is found again.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::parts::{Names, packed};
use crate::diag::{Baseline, Entry};
use crate::engine::error::{BaselineFault, Error};
use crate::source::{Folder, Limits, ReadFault, read_file};

const FORMAT: &str = "mhlint-baseline/1";

/// A finding as the baseline compares it.
pub(super) struct Found {
    /// The entry that it would be.
    pub(super) entry: Entry,
    /// Path of the asset below its data root: the end of the path of the entry.
    pub(super) rel: String,
}

impl Baseline {
    /// Reads a baseline.
    pub(super) fn read(path: &Path) -> Result<Self, Error> {
        let refuse = |fault| Error::Baseline { path: path.display().to_string(), fault };
        let bytes = read_file(path, &Limits::default()).map_err(|fault| match fault {
            ReadFault::Unreadable(reason) => refuse(BaselineFault::Unreadable(reason)),
            ReadFault::TooLarge { .. } => refuse(BaselineFault::TooLarge),
        })?;
        if is_conflict(&bytes) {
            return Err(refuse(BaselineFault::Conflict));
        }
        let damaged = |error: serde_json::Error| refuse(BaselineFault::Damaged(error.to_string()));
        let mut file: serde_json::Value = serde_json::from_slice(&bytes).map_err(damaged)?;
        match file.get("format").and_then(|format| format.as_str()) {
            Some(FORMAT) => {}
            Some(other) if other.starts_with("mhlint-baseline/") => {
                return Err(refuse(BaselineFault::Format { found: other.to_owned(), read: FORMAT }));
            }
            _ => return Err(refuse(BaselineFault::Other)),
        }
        let entries = file.get_mut("entries").map(serde_json::Value::take).unwrap_or_default();
        let entries = serde_json::from_value(entries).map_err(damaged)?;
        Ok(Self { entries })
    }

    /// The file: sorted, one entry a line, so that changes can be read and merged.
    pub fn text(&self) -> String {
        let written = |entry: &Entry| Entry { parts: packed(&entry.parts), ..entry.clone() };
        let mut entries: Vec<Entry> = self.entries.iter().map(written).collect();
        entries.sort();
        entries.dedup();
        let line = |entry: &Entry| serde_json::to_string(entry).unwrap_or_default();
        let lines: Vec<String> = entries.iter().map(line).collect();
        let list = if lines.is_empty() { "[]".to_owned() } else { format!("[\n{}\n]", lines.join(",\n")) };
        format!("{{\"format\": \"{FORMAT}\", \"entries\": {list}}}\n")
    }

    /// For each finding whether it is known, and the entries that were not found again. `roots` are the
    /// judged data roots, relative to the folder of the file; `is_there` tells whether the asset of an entry is
    /// still where it says.
    ///
    /// Fingerprints do not depend on where a data root lies. Where several roots hold an asset of the same
    /// name the path decides; an entry of a root that is judged, or of an asset that is still there, is not for
    /// another one.
    ///
    /// Several entries may have one fingerprint: what a rule tells now of each part, now of all together. Together
    /// they speak for a finding.
    pub(super) fn compare(
        &self,
        found: &[Found],
        roots: &BTreeSet<String>,
        is_there: impl Fn(&Entry) -> bool,
    ) -> (Vec<bool>, Vec<&Entry>) {
        let mut alike: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (number, entry) in self.entries.iter().enumerate() {
            alike.entry(&entry.fingerprint).or_default().push(number);
        }
        let mut met: Vec<Option<&str>> = vec![None; self.entries.len()];
        let mut known = vec![false; found.len()];
        for exact in [true, false] {
            for (found, known) in found.iter().zip(&mut known).filter(|(_, known)| !**known) {
                let (path, rel) = (found.entry.path.as_str(), found.rel.as_str());
                let numbers = alike.get(found.entry.fingerprint.as_str()).into_iter().flatten();
                let fits = |entry: &Entry| {
                    if exact {
                        entry.path == path
                    } else {
                        !roots.contains(root_of(&entry.path, rel)) && !is_there(entry)
                    }
                };
                let entries = numbers.filter_map(|number| Some((*number, self.entries.get(*number)?)));
                let entries: Vec<(usize, &Entry)> = entries.filter(|(_, entry)| fits(entry)).collect();
                *known = speak_for(&entries, &found.entry, &mut met);
            }
        }
        let stale = self.entries.iter().zip(&met).filter(|(_, met)| met.is_none());
        (known, stale.map(|(entry, _)| entry).collect())
    }
}

/// Whether git left the lines of both sides of a merge in a file.
fn is_conflict(bytes: &[u8]) -> bool {
    bytes.split(|byte| *byte == b'\n').any(|line| line.starts_with(b"<<<<<<< "))
}

/// Whether everything that a finding speaks for was there before, and as bad. `met` are the entries that were found again, and at
/// which path: an entry without parts hides one finding, one with parts those of one asset.
fn speak_for<'f>(entries: &[(usize, &Entry)], found: &'f Entry, met: &mut [Option<&'f str>]) -> bool {
    let is_as_bad = |entry: &Entry| entry.level >= found.level;
    let unmet = || entries.iter().filter(|(number, entry)| entry.parts.is_empty() && met[*number].is_none());
    if let Some((number, entry)) = unmet().find(|(_, entry)| is_as_bad(entry)).or_else(|| unmet().next()) {
        met[*number] = Some(&found.path);
        return is_as_bad(entry);
    }
    let mut told: Vec<&Entry> = Vec::new();
    for (number, entry) in entries.iter().filter(|(_, entry)| !entry.parts.is_empty()) {
        let names = Names::of(entry.parts.iter());
        let is_here = met[*number].is_none_or(|path| path == found.path);
        if is_here && (entries.len() == 1 || found.parts.iter().any(|part| names.hold(part))) {
            met[*number] = Some(&found.path);
            told.extend(is_as_bad(entry).then_some(entry));
        }
    }
    let names = Names::of(told.iter().flat_map(|entry| &entry.parts));
    !found.parts.is_empty() && found.parts.iter().all(|part| names.hold(part))
}

/// The data root of an asset: its path without what lies below the root.
fn root_of<'p>(path: &'p str, rel: &str) -> &'p str {
    path.strip_suffix(rel).unwrap_or(path).trim_end_matches('/')
}

/// A printed path relative to the folder of the baseline, or as it is where it lies elsewhere.
pub(super) fn placed(folder: &Folder, path: &str) -> String {
    folder.relative(path).unwrap_or_else(|| path.to_owned())
}

#[cfg(test)]
mod tests {
    use std::slice::from_ref;

    use super::*;
    use crate::diag::Level;

    fn entry(path: &str, parts: &[&str]) -> Entry {
        let parts = parts.iter().map(|part| (*part).to_owned()).collect();
        let [rule, key, fingerprint] = ["r", "", "f"].map(str::to_owned);
        Entry { path: path.to_owned(), rule, key, fingerprint, level: Level::Warning, parts }
    }

    fn known(baseline: &[Entry], found: &[Entry], roots: &[&str]) -> (Vec<bool>, usize) {
        let baseline = Baseline { entries: baseline.to_vec() };
        let found: Vec<Found> =
            found.iter().map(|entry| Found { entry: entry.clone(), rel: "a.target".to_owned() }).collect();
        let roots = roots.iter().map(|root| (*root).to_owned()).collect();
        let (known, stale) = baseline.compare(&found, &roots, |entry| entry.path.starts_with("there/"));
        (known, stale.len())
    }

    #[test]
    fn a_moved_root_is_recognised_and_another_root_is_not() {
        let (old, new) = (entry("data/a.target", &[]), entry("user/a.target", &[]));
        assert_eq!(known(from_ref(&old), from_ref(&new), &["user"]), (vec![true], 0));
        assert_eq!(known(from_ref(&old), from_ref(&new), &["data", "user"]), (vec![false], 1));
        let beside = entry("there/a.target", &[]);
        assert_eq!(known(from_ref(&beside), from_ref(&new), &["user"]), (vec![false], 1));
    }

    #[test]
    fn a_part_that_was_not_there_is_not_hidden() {
        let old = entry("a.target", &["x", "y"]);
        let seen = |parts: &[&str]| known(from_ref(&old), &[entry("a.target", parts)], &[""]).0;
        assert_eq!(
            [seen(&["x"]), seen(&["x", "y"]), seen(&["x", "z"]), seen(&[])].concat(),
            [true, true, false, false]
        );
    }

    #[test]
    fn entries_of_one_fingerprint_speak_together_and_apart() {
        let (x, y, both) = (entry("a", &["x"]), entry("a", &["y"]), entry("a", &["x", "y"]));
        let apart = [x.clone(), y.clone()];
        assert_eq!(known(&apart, from_ref(&both), &[""]), (vec![true], 0));
        assert_eq!(known(from_ref(&both), &apart, &[""]), (vec![true, true], 0));
        assert_eq!(known(&apart, from_ref(&y), &[""]), (vec![true], 1));
        assert_eq!(known(&apart, &[x, entry("a", &["z"])], &[""]), (vec![true, false], 1));
        let roots = [entry("a.target", &["x"]), entry("user/a.target", &["y"])];
        assert_eq!(known(&roots, &[entry("a.target", &["x", "y"])], &["", "user"]), (vec![false], 1));
    }

    #[test]
    fn a_mass_is_written_in_rows_and_known_by_its_numbers() {
        let numbers: Vec<String> = (100..5000).map(|number: u32| number.to_string()).collect();
        let all: Vec<&str> = numbers.iter().map(String::as_str).collect();
        let text = Baseline { entries: vec![entry("a", &all)] }.text();
        assert!(text.contains("\"parts\":[\"100-4999\"]"), "{text}");
        let file: serde_json::Value = serde_json::from_str(&text).unwrap_or_default();
        let read: Vec<Entry> = serde_json::from_value(file["entries"].clone()).unwrap_or_default();
        assert_eq!(known(&read, &[entry("a", &["2000", "100"])], &[""]), (vec![true], 0));
        assert_eq!(known(&read, &[entry("a", &["2000", "99"])], &[""]).0, [false]);
    }

    #[test]
    fn what_has_become_worse_is_not_hidden() {
        let old = entry("a.target", &[]);
        let as_bad_as = |level| known(from_ref(&old), &[Entry { level, ..old.clone() }], &[""]);
        assert_eq!([Level::Info, Level::Warning].map(as_bad_as), [(vec![true], 0), (vec![true], 0)]);
        assert_eq!(as_bad_as(Level::Error), (vec![false], 0), "and the entry is not stale");
    }

    #[test]
    fn each_entry_hides_one_finding() {
        let one = entry("a.target", &[]);
        assert_eq!(known(from_ref(&one), &[one.clone(), one.clone()], &[""]), (vec![true, false], 0));
    }
}
