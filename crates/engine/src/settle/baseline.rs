//! The baseline file, `mhlint-baseline/1`: a list of known findings by fingerprint; and which of
//! them occur again.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::compare::Claim;
use crate::error::{BaselineFault, Error};
use mhlint_diag::{Baseline, Entry, grouped};
use mhlint_source::{Folder, Limits, ReadFault, read_file};

/// A finding in the form in which it is compared with the baseline.
pub(super) struct Found {
    /// The entry that the baseline would have for it.
    pub(super) entry: Entry,
    /// Path of the asset below its data root. The path of `entry` ends with it.
    pub(super) rel: String,
}

/// Reads a baseline.
pub(super) fn read(path: &Path) -> Result<Baseline, Error> {
    let refuse = |fault| Error::Baseline {
        path: path.display().to_string(),
        fault,
    };
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
        Some(Baseline::FORMAT) => {}
        Some(other) if other.starts_with("mhlint-baseline/") => {
            return Err(refuse(BaselineFault::Format {
                found: other.to_owned(),
                read: Baseline::FORMAT,
            }));
        }
        _ => return Err(refuse(BaselineFault::Other)),
    }
    let entries = file
        .get_mut("entries")
        .map(serde_json::Value::take)
        .unwrap_or_default();
    let entries = serde_json::from_value(entries).map_err(damaged)?;
    Ok(Baseline { entries })
}

/// For each entry the path at which its finding is looked for. It is the path in the entry, or that
/// of a finding with the same fingerprint if the data root was moved. `roots` are the checked data
/// roots, relative to the folder of the baseline; `is_there` tells whether the asset of an entry
/// still exists at the path in the entry.
///
/// Fingerprints do not depend on the place of a data root. If several data roots have an asset of
/// the same name the path decides between them. An entry is not taken for moved if its data root is
/// checked in this run, or if its asset still exists.
pub(super) fn homes<'e>(
    entries: &'e [Entry],
    found: &'e [Found],
    roots: &BTreeSet<String>,
    is_there: impl Fn(&Entry) -> bool,
) -> Vec<&'e str> {
    let alike = grouped(
        found
            .iter()
            .map(|found| (found.entry.fingerprint.as_str(), found)),
    );
    let now: BTreeSet<_> = found.iter().map(|found| found.entry.subject()).collect();
    // Findings that are taken: they have an entry at their path, or an entry was moved to them.
    let own = entries
        .iter()
        .filter(|entry| now.contains(&entry.subject()));
    let mut taken: BTreeMap<_, &str> = own
        .map(|entry| (entry.subject(), entry.path.as_str()))
        .collect();
    let home = |entry: &'e Entry| {
        let is_free = |found: &&&Found| {
            taken
                .get(&found.entry.subject())
                .is_none_or(|path| *path == entry.path)
        };
        let is_gone =
            |found: &&&Found| !roots.contains(root_of(&entry.path, &found.rel)) && !is_there(entry);
        let mut alike = alike.get(entry.fingerprint.as_str()).into_iter().flatten();
        let Some(found) = alike
            .find(|found| is_free(found) && (found.entry.path == entry.path || is_gone(found)))
        else {
            return entry.path.as_str();
        };
        taken.insert(found.entry.subject(), &entry.path);
        found.entry.path.as_str()
    };
    entries.iter().map(home).collect()
}
/// An entry in the form in which it is compared, with `path` for the path of its asset.
pub(super) fn claim<'e>(entry: &'e Entry, path: &'e str) -> Claim<'e> {
    let (rule, key, parts, level) = (&entry.rule, &entry.key, &entry.parts, entry.level);
    Claim {
        rule,
        asset: path,
        key,
        parts,
        level,
        breaks: &[],
        value: entry.measure,
        grows: None,
    }
}

/// Whether a file contains the marks of a git merge with conflicts.
fn is_conflict(bytes: &[u8]) -> bool {
    bytes
        .split(|byte| *byte == b'\n')
        .any(|line| line.starts_with(b"<<<<<<< "))
}

/// The path of the data root of an asset: `path` without `rel` at its end.
fn root_of<'p>(path: &'p str, rel: &str) -> &'p str {
    path.strip_suffix(rel).unwrap_or(path).trim_end_matches('/')
}

/// A printed path, relative to the folder of the baseline; unchanged if it lies outside of that
/// folder.
pub(super) fn placed(folder: &Folder, path: &str) -> String {
    folder.relative(path).unwrap_or_else(|| path.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Level, Parts};

    fn entry(path: &str, parts: &[&str]) -> Entry {
        let [rule, key, fingerprint] = ["r", "", "f"].map(str::to_owned);
        Entry {
            path: path.to_owned(),
            rule,
            key,
            fingerprint,
            level: Level::Warning,
            parts: parts.iter().collect(),
            measure: None,
        }
    }

    fn homes(before: &[&str], now: &[&str], roots: &[&str]) -> Vec<String> {
        let all =
            |paths: &[&str]| -> Vec<Entry> { paths.iter().map(|path| entry(path, &[])).collect() };
        let baseline = Baseline {
            entries: all(before),
        };
        let found: Vec<Found> = all(now)
            .into_iter()
            .map(|entry| Found {
                entry,
                rel: "a.target".to_owned(),
            })
            .collect();
        let roots = roots.iter().map(|root| (*root).to_owned()).collect();
        let homes = super::homes(&baseline.entries, &found, &roots, |entry| {
            entry.path.starts_with("there/")
        });
        homes.into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn a_moved_root_is_recognised_and_another_root_is_not() {
        let (old, new) = (["data/a.target"], ["user/a.target"]);
        assert_eq!(homes(&old, &new, &["user"]), new);
        assert_eq!(homes(&old, &new, &["data", "user"]), old);
        assert_eq!(
            homes(&["there/a.target"], &new, &["user"]),
            ["there/a.target"]
        );
        let both = ["x/a.target", "y/a.target"];
        assert_eq!(
            homes(&["data/a.target", "user/a.target"], &both, &["x", "y"]),
            both
        );
        assert_eq!(
            homes(&["data/a.target", "x/a.target"], &both, &["x", "y"]),
            ["y/a.target", "x/a.target"]
        );
    }

    #[test]
    fn a_mass_is_written_in_rows_and_known_by_its_numbers() {
        let all: Parts = (100..5000_u32).collect();
        let text = Baseline {
            entries: vec![Entry {
                parts: all,
                ..entry("a", &[])
            }],
        }
        .text();
        assert!(text.contains("\"parts\":[\"100-4999\"]"), "{text}");
        let file: serde_json::Value = serde_json::from_str(&text).unwrap_or_default();
        let read: Vec<Entry> = serde_json::from_value(file["entries"].clone()).unwrap_or_default();
        let left = |number: u32| {
            [2000, number]
                .into_iter()
                .collect::<Parts>()
                .without(read.iter().map(|one| &one.parts))
        };
        assert_eq!([left(100).count(), left(99).count()], [0, 1]);
    }
}
