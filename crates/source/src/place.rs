//! Places on disk: paths with their links resolved.

use std::fs;
use std::path::{Component, Path, PathBuf};

/// The path, or `.` for an empty one, which names the working directory as well.
pub(super) fn named(path: &Path) -> &Path {
    if path.as_os_str().is_empty() {
        Path::new(".")
    } else {
        path
    }
}

/// The folder that a file is in.
pub fn folder_of(file: &Path) -> &Path {
    named(file.parent().unwrap_or(Path::new("")))
}

/// The path with forward slashes. A backslash separates on Windows and is part of a name elsewhere.
pub fn slashed(path: &Path) -> String {
    let text = path.to_string_lossy();
    if cfg!(windows) {
        text.replace('\\', "/")
    } else {
        text.into_owned()
    }
}

/// The absolute path without links, if there is something.
pub fn canonical(path: &Path) -> Option<PathBuf> {
    fs::canonicalize(named(path)).ok()
}

/// The name of a folder as it is written, else as it is.
pub fn folder_name(folder: &Path) -> String {
    let written = folder.file_name().map(ToOwned::to_owned);
    let name = written.or_else(|| Some(resolved(folder).file_name()?.to_owned()));
    slashed(Path::new(&name.unwrap_or_default()))
}

/// The absolute path without `..`, and without links in as much of it as exists: a deleted file
/// still has its folder.
pub fn resolved(path: &Path) -> PathBuf {
    let whole = std::path::absolute(named(path)).unwrap_or_else(|_| path.to_owned());
    let existing = whole
        .ancestors()
        .find_map(|above| Some((fs::canonicalize(above).ok()?, above)));
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

/// The same for a file that may be a link itself: it keeps its own name.
pub fn own_place(file: &Path) -> PathBuf {
    file.file_name().map_or_else(
        || resolved(file),
        |name| resolved(folder_of(file)).join(name),
    )
}

/// Links that are followed one after the other before they count as a loop, as Linux does it.
pub(super) const LONGEST_CHAIN: usize = 40;

/// What a link leads to, link by link, whether it is there or not; nothing for what is no link.
pub fn link_targets(path: &Path) -> Vec<PathBuf> {
    let mut targets: Vec<PathBuf> = Vec::new();
    let mut at = path.to_owned();
    while let Ok(target) = fs::read_link(&at) {
        at = folder_of(&at).join(target);
        if targets.len() == LONGEST_CHAIN || targets.contains(&at) {
            break;
        }
        targets.push(at.clone());
    }
    targets
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
            assert_eq!(
                resolved(&folder.path().join(path)),
                root.join(place),
                "{path}"
            );
        }
        assert_eq!(resolved(Path::new("")), std::env::current_dir().unwrap());
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_one_by_one_and_never_in_a_circle() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        for (path, target) in [("one", "two"), ("two", "gone"), ("a", "b"), ("b", "a")] {
            symlink(target, at(path)).unwrap();
        }
        assert_eq!(link_targets(&at("one")), [at("two"), at("gone")]);
        assert_eq!(link_targets(&at("a")), [at("b"), at("a")]);
        assert_eq!(link_targets(&at("gone")), Vec::<PathBuf>::new());
    }

    #[test]
    fn every_file_has_a_folder() {
        assert_eq!(folder_of(Path::new("a")), Path::new("."));
        assert_eq!(folder_of(Path::new("a/b")), Path::new("a"));
    }
}
