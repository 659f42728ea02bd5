//! What was not checked, in words.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use super::count;
use mhlint_diag::{NotChecked, Outcome, Unchecked};

/// Extensions that are named.
const NAMED: usize = 5;

/// What people call the files of an extension: one, and several.
const KINDS: [(&str, &str, &str); 5] = [
    ("bvh", "pose", "poses"),
    ("mhclo", "clothes file", "clothes"),
    ("mhm", "model", "models"),
    ("proxy", "proxy", "proxies"),
    ("thumb", "thumbnail", "thumbnails"),
];

/// A clause for each reason, not made harmless yet.
pub(super) fn unchecked(outcome: &Outcome) -> impl Iterator<Item = String> {
    let mut all: Vec<NotChecked> = Vec::new();
    for entry in &outcome.not_checked {
        // A clause does not name the application.
        match all.iter_mut().find(|other| other.what == entry.what) {
            Some(other) => {
                let paths = other.paths.union(&entry.paths).cloned().collect();
                *other = NotChecked::of(other.application, other.what, paths);
            }
            None => all.push(entry.clone()),
        }
    }
    all.into_iter().map(|entry| clause(&entry))
}

/// `Not checked: 12 .bvh poses, 3 .blend (no rules yet); …`, not made harmless yet.
pub fn unchecked_line(outcome: &Outcome) -> Option<String> {
    let clauses: Vec<String> = unchecked(outcome).collect();
    (!clauses.is_empty()).then(|| format!("Not checked: {}.", clauses.join("; ")))
}

fn clause(entry: &NotChecked) -> String {
    let files = count(entry.count, "file");
    match entry.what {
        Unchecked::Kind => of_kinds(entry),
        Unchecked::Unused => format!("{} (part of nothing that was checked)", by_extension(entry)),
        Unchecked::Outside => format!("{} (not in a data folder)", by_extension(entry)),
        Unchecked::NoBaseMesh => format!(
            "{} in {} (no base mesh; use `--system`, and `--base` for files outside data folders)",
            of_base_mesh(entry),
            by_extension(entry)
        ),
        Unchecked::BaseNotInSystem => {
            let of_it = if entry.count == 1 {
                "its base mesh is"
            } else {
                "their base meshes are"
            };
            format!(
                "{} in {} ({of_it} not in the system data)",
                of_base_mesh(entry),
                by_extension(entry)
            )
        }
        Unchecked::BaseNotKnown => {
            format!(
                "{} in {} (base mesh not known; use `--base`)",
                of_base_mesh(entry),
                by_extension(entry)
            )
        }
        Unchecked::NoSystem => format!(
            "{} (expected in the system data; use `--system`)",
            names(entry)
        ),
        Unchecked::Closed => format!("the contents of {} (cannot be listed)", names(entry)),
        Unchecked::Part => format!("parts of {} (too large)", names(entry)),
        Unchecked::Packed => format!(
            "the contents of {} (its compression is not supported)",
            names(entry)
        ),
        Unchecked::TooManyMacros => {
            format!(
                "all effects of the macros of {} (too many to compare or try)",
                names(entry)
            )
        }
        Unchecked::Evaluation => {
            format!(
                "some effects of sliders on {} (over the limit for one base mesh)",
                names(entry)
            )
        }
        Unchecked::Helpers => {
            format!(
                "{files} of an add-on that makes assets (no assets; name their folder to check \
                    them)"
            )
        }
        Unchecked::Tests => format!("{files} of test data (name their folder to check them)"),
        Unchecked::NotCompared => {
            format!("whether findings in {files} are new (previous contents are not available)")
        }
    }
}

/// Those of other kinds, and those that would be of one of ours if their suffix were in small
/// letters.
fn of_kinds(entry: &NotChecked) -> String {
    let is_in_capitals = |path: &String| {
        let suffix = path
            .rsplit('/')
            .next()
            .and_then(|name| name.rsplit_once('.'))
            .map_or("", |(_, suffix)| suffix);
        let is_packed = path.to_lowercase().ends_with(".target.gz");
        suffix != suffix.to_lowercase() && (is_packed || OURS.contains(&&*suffix.to_lowercase()))
    };
    let (misspelt, other): (BTreeSet<String>, BTreeSet<String>) =
        entry.paths.iter().cloned().partition(is_in_capitals);
    let clauses = [
        (other, "no rules yet"),
        (misspelt, "not read with a suffix in capitals"),
    ];
    let clauses = clauses
        .into_iter()
        .filter(|(paths, _)| !paths.is_empty())
        .map(|(paths, why)| {
            format!(
                "{} ({why})",
                by_extension(&NotChecked::of(entry.application, entry.what, paths))
            )
        });
    clauses.collect::<Vec<_>>().join("; ")
}

/// Suffixes of files that are checked.
const OURS: [&str; 10] = [
    "mhclo", "proxy", "mhmat", "mhskel", "mhw", "mhpose", "mhm", "bvh", "target", "mhpxy",
];

/// What of the files depends on the base mesh.
fn of_base_mesh(entry: &NotChecked) -> &'static str {
    let is_posed = |path: &&String| {
        path.ends_with(".bvh") || path.ends_with(".mhpose") || path.ends_with(".mhm")
    };
    match entry.paths.iter().filter(is_posed).count() {
        0 => "vertex numbers",
        count if count == entry.paths.len() => "names of bones, units and sliders",
        _ => "vertex numbers and names of bones, units and sliders",
    }
}

/// `12 .bvh poses, 3 .blend and 5 more files`.
fn by_extension(entry: &NotChecked) -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for path in &entry.paths {
        let name = path.rsplit('/').next().unwrap_or(path);
        *counts
            .entry(name.rsplit_once('.').map_or("", |(_, extension)| extension))
            .or_default() += 1;
    }
    let mut counts: Vec<(&str, usize)> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| Reverse(*count));
    let named = counts
        .iter()
        .take(NAMED)
        .map(|(extension, count)| match *extension {
            "" => format!("{count} without extension"),
            extension => format!("{count} .{extension}{}", kind(extension, *count)),
        });
    let mut words = named.collect::<Vec<_>>().join(", ");
    let more: usize = counts.iter().skip(NAMED).map(|(_, count)| count).sum();
    if more > 0 {
        words = format!("{words} and {}", count(more, "more file"));
    }
    words
}

/// The kind of files with an extension, with a space before it; empty where the extension says it
/// best.
fn kind(extension: &str, count: usize) -> String {
    let known = KINDS
        .iter()
        .find(|(known, ..)| known.eq_ignore_ascii_case(extension));
    known.map_or_else(String::new, |(_, one, several)| {
        format!(" {}", if count == 1 { one } else { several })
    })
}

/// How many names there are, and the first.
fn names(entry: &NotChecked) -> String {
    match (entry.count, entry.examples.as_slice()) {
        (1, [only]) => format!("`{only}`"),
        (number, [first, ..]) => format!("{number} names such as `{first}`"),
        (number, []) => count(number, "name"),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    fn line(what: Unchecked, paths: &[&str]) -> String {
        let paths: BTreeSet<String> = paths.iter().map(|path| (*path).to_owned()).collect();
        let outcome = Outcome {
            not_checked: vec![NotChecked::of(None, what, paths)],
            ..Outcome::default()
        };
        unchecked_line(&outcome).unwrap()
    }

    #[test]
    fn files_are_counted_by_extension_the_most_first() {
        let paths = [
            "a.bvh", "x/b.bvh", "c.blend", "README", "a.1", "a.2", "a.3", "a.4",
        ];
        assert_eq!(
            line(Unchecked::Kind, &paths),
            "Not checked: 2 .bvh poses, 1 without extension, 1 .1, 1 .2, 1 .3 and 2 more files \
                (no rules yet)."
        );
        assert_eq!(unchecked_line(&Outcome::default()), None);
    }

    #[test]
    fn files_are_named_as_people_call_them() {
        let paths = ["a.mhclo", "b.mhclo", "c.PROXY", "d.mhm", "e.blend"];
        let words = "2 .mhclo clothes, 1 .blend, 1 .mhm model (no rules yet); \
                     1 .PROXY proxy (not read with a suffix in capitals).";
        assert_eq!(
            line(Unchecked::Kind, &paths),
            format!("Not checked: {words}")
        );
        assert_eq!(
            line(Unchecked::Kind, &paths[..1]),
            "Not checked: 1 .mhclo clothes file (no rules yet)."
        );
    }

    #[test]
    fn one_name_stands_alone() {
        assert_eq!(
            line(Unchecked::Closed, &["a/b"]),
            "Not checked: the contents of `a/b` (cannot be listed)."
        );
        let two = line(Unchecked::NoSystem, &["a/b", "a/c"]);
        assert!(
            two.starts_with("Not checked: 2 names such as `a/b`"),
            "{two}"
        );
    }
}
