//! Places on disk: paths with their links resolved.

use std::fs;
use std::path::{Component, Path, PathBuf};

/// The path, or `.` for an empty one, which names the working directory as well.
pub(super) fn named(path: &Path) -> &Path {
    if path.as_os_str().is_empty() { Path::new(".") } else { path }
}

/// The folder that a file is in.
pub fn folder_of(file: &Path) -> &Path {
    named(file.parent().unwrap_or(Path::new("")))
}

/// The absolute path without links, if there is something.
pub fn canonical(path: &Path) -> Option<PathBuf> {
    fs::canonicalize(named(path)).ok()
}

/// The absolute path without `..`, and without links in as much of it as exists: a deleted file still has its folder.
pub fn resolved(path: &Path) -> PathBuf {
    let whole = std::path::absolute(named(path)).unwrap_or_else(|_| path.to_owned());
    let existing = whole.ancestors().find_map(|above| Some((fs::canonicalize(above).ok()?, above)));
    let (mut place, rest) = match existing {
        Some((place, above)) => (place, whole.strip_prefix(above).unwrap_or(Path::new(""))),
        None => (PathBuf::new(), whole.as_path()),
    };
    for part in rest.components() {
        if part == Component::ParentDir {
            place.pop();
        } else {
            place.push(part);
        }
    }
    place
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn links_are_resolved_as_far_as_there_is_something() {
        let folder = tempfile::tempdir().unwrap();
        let root = fs::canonicalize(folder.path()).unwrap();
        fs::create_dir_all(root.join("real/deep")).unwrap();
        std::os::unix::fs::symlink("real/deep", root.join("link")).unwrap();
        for (path, place) in [
            ("link", "real/deep"),
            ("link/gone/x", "real/deep/gone/x"),
            ("link/..", "real"),
            ("real/gone/../x", "real/x"),
            ("./gone", "gone"),
        ] {
            assert_eq!(resolved(&folder.path().join(path)), root.join(place), "{path}");
        }
        assert_eq!(resolved(Path::new("")), std::env::current_dir().unwrap());
    }

    #[test]
    fn every_file_has_a_folder() {
        assert_eq!(folder_of(Path::new("a")), Path::new("."));
        assert_eq!(folder_of(Path::new("a/b")), Path::new("a"));
    }
}
