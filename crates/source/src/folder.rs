//! Where a folder is, so that paths as reports print them can be told relative to it.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::OnceLock;

use super::path::{is_below_any, without_slashes};
use super::place::{canonical, named, slashed};

/// A folder that globs are relative to.
///
/// Paths are compared as texts: with the links in the name of the folder resolved, and as it was
/// named.
#[derive(Debug, Clone, Default)]
pub struct Folder {
    /// Absolute names of the working directory; none where paths are relative to the folder itself.
    here: Vec<String>,
    /// Absolute names of the folder.
    names: Vec<String>,
}

impl Folder {
    /// The folder at `path`.
    pub fn of(path: &Path) -> Self {
        let here = names_of(Path::new("."));
        Self {
            names: names_of(path),
            here,
        }
    }

    /// The part of a printed path below the folder; empty for the folder itself.
    pub fn relative(&self, path: &str) -> Option<String> {
        if self.here.is_empty() {
            return Some(path.to_owned());
        }
        self.absolute(path).iter().find_map(|path| {
            self.names.iter().find_map(|name| {
                let rest = path.strip_prefix(name.as_str())?;
                if rest.is_empty() || name == "/" {
                    Some(rest)
                } else {
                    rest.strip_prefix('/')
                }
                .map(str::to_owned)
            })
        })
    }

    /// Whether `rel`, a path below this folder, lies at or below one of other places.
    pub fn lies_in(&self, rel: &str, outer: &Outer) -> bool {
        if self.here.is_empty() {
            return is_below_any(rel, &outer.paths);
        }
        let names_of = |path: &String| {
            let own = self.absolute(path).into_iter();
            own.chain(names_of(Path::new(path))).collect::<Vec<_>>()
        };
        let outer = outer
            .names
            .get_or_init(|| without_slashes(outer.paths.iter().flat_map(names_of)));
        self.names
            .iter()
            .any(|name| is_below_any(&plain(&format!("{name}/{rel}")), outer))
    }

    fn absolute(&self, path: &str) -> Vec<String> {
        if is_absolute(path) {
            return vec![plain(path)];
        }
        self.here
            .iter()
            .map(|here| plain(&format!("{here}/{path}")))
            .collect()
    }
}

/// Printed paths that others may lie in. Their absolute names are asked of the file system once.
#[derive(Debug)]
pub struct Outer {
    paths: BTreeSet<String>,
    names: OnceLock<BTreeSet<String>>,
}

impl Outer {
    /// The places of printed paths.
    pub fn of<'p>(paths: impl IntoIterator<Item = &'p str>) -> Self {
        Self {
            paths: without_slashes(paths.into_iter().map(str::to_owned)),
            names: OnceLock::new(),
        }
    }
}

/// Whether a folder holds something of that name.
pub fn holds(folder: &Path, name: &str) -> bool {
    folder.join(name).exists()
}

fn is_absolute(path: &str) -> bool {
    path.starts_with('/') || Path::new(path).is_absolute()
}

fn names_of(path: &Path) -> Vec<String> {
    let both = [canonical(path), std::path::absolute(named(path)).ok()];
    let mut names: Vec<String> = both
        .into_iter()
        .flatten()
        .map(|path| plain(&path.to_string_lossy()))
        .collect();
    names.dedup();
    names
}

/// Forward slashes, no `.`, no `..` but at the front.
fn plain(path: &str) -> String {
    let slashed = slashed(Path::new(path));
    let slashed = slashed.strip_prefix("//?/").unwrap_or(&slashed);
    let mut parts: Vec<&str> = Vec::new();
    for part in slashed
        .split('/')
        .filter(|part| !part.is_empty() && *part != ".")
    {
        if part == ".." && parts.last().is_some_and(|last| *last != "..") {
            parts.pop();
        } else {
            parts.push(part);
        }
    }
    format!(
        "{}{}",
        if slashed.starts_with('/') { "/" } else { "" },
        parts.join("/")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_told_relative_to_the_folder() {
        let folder = Folder {
            here: vec!["/w/repo/data".to_owned()],
            names: vec!["/w/repo".to_owned()],
        };
        assert_eq!(
            folder.relative("target/a.target").as_deref(),
            Some("data/target/a.target")
        );
        assert_eq!(folder.relative("../user/x").as_deref(), Some("user/x"));
        assert_eq!(folder.relative("/w/repo/y").as_deref(), Some("y"));
        assert_eq!(folder.relative("..").as_deref(), Some(""));
        assert_eq!(folder.relative("../../other"), None);
        assert_eq!(folder.relative("../../repository/x"), None);
    }

    #[test]
    fn a_path_lies_in_a_folder_or_beside_it() {
        let folder = Folder {
            here: vec!["/w/repo".to_owned()],
            names: vec!["/w/repo".to_owned()],
        };
        assert!(folder.lies_in("data/target", &Outer::of(["data"])));
        assert!(folder.lies_in("", &Outer::of([".."])));
        let data = Outer::of(["data"]);
        assert!(!folder.lies_in("", &data) && !folder.lies_in("database", &data));
    }

    #[test]
    fn in_memory_paths_are_relative_already() {
        assert_eq!(Folder::default().relative("a/b").as_deref(), Some("a/b"));
        let lies_in = |outer: &str| Folder::default().lies_in("a/b", &Outer::of([outer]));
        assert!(lies_in("") && !lies_in("a/c"));
    }
}
