//! Paths as texts: relative to a root, with forward slashes.

use std::collections::BTreeSet;

/// Whether a path is another one or lies below it.
pub fn is_below(path: &str, outer: &str) -> bool {
    let outer = outer.trim_end_matches('/');
    outer.is_empty()
        || path
            .strip_prefix(outer)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

/// Whether a path is one of others, which do not end with `/`, or lies below one of them.
pub fn is_below_any(path: &str, outer: &BTreeSet<String>) -> bool {
    !outer.is_empty() && folders_above(path).any(|above| outer.contains(above))
}

/// The paths as [`is_below_any`] has them.
pub fn without_slashes(paths: impl IntoIterator<Item = String>) -> BTreeSet<String> {
    let paths = paths.into_iter();
    paths
        .map(|path| path.trim_end_matches('/').to_owned())
        .collect()
}

/// The folder of a path, empty at the top, and the name in it.
pub fn folder_and_name(path: &str) -> (&str, &str) {
    path.rsplit_once('/').unwrap_or(("", path))
}

/// The folder of a path, empty at the top.
pub fn parent(path: &str) -> &str {
    folder_and_name(path).0
}

/// The last name of a path.
pub fn file_name(path: &str) -> &str {
    folder_and_name(path).1
}

/// The first name of a path.
pub fn first_name(path: &str) -> &str {
    path.split_once('/').map_or(path, |(top, _)| top)
}

/// How many names a path has.
pub fn depth(path: &str) -> usize {
    path.split('/').count()
}

/// What stands behind the last point of a path's last name, as written; empty without a point.
pub fn extension(path: &str) -> &str {
    file_name(path)
        .rsplit_once('.')
        .map_or("", |(_, extension)| extension)
}

/// All before the last point; all where there is none.
pub fn without_extension(path: &str) -> &str {
    path.rsplit_once('.').map_or(path, |(stem, _)| stem)
}

/// A folder and those above it, up to the top.
pub fn folders_above(folder: &str) -> impl Iterator<Item = &str> {
    std::iter::successors(Some(folder), |folder| {
        (!folder.is_empty()).then(|| parent(folder))
    })
}

/// Whether a name in a path begins with a point.
pub fn has_hidden_part(path: &str) -> bool {
    path.split('/').any(|part| part.starts_with('.'))
}

/// The part of a path below a folder; all of it below no folder.
pub fn inside<'p>(path: &'p str, folder: &str) -> Option<&'p str> {
    if folder.is_empty() {
        Some(path)
    } else {
        path.strip_prefix(folder)?.strip_prefix('/')
    }
}

/// The path without `.` and `..`, or nothing if it leaves the root.
pub fn normalized(rel: &str) -> Option<String> {
    let mut parts: Vec<&str> = Vec::new();
    for part in rel.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop()?;
            }
            other => parts.push(other),
        }
    }
    Some(parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_normalized_inside_the_root_only() {
        assert_eq!(
            normalized("target/b/a/../c.target").as_deref(),
            Some("target/b/c.target")
        );
        assert_eq!(normalized("target/../../x"), None);
    }

    #[test]
    fn a_path_has_a_folder_a_name_and_an_extension() {
        assert_eq!(folder_and_name("a/b/c.d.obj"), ("a/b", "c.d.obj"));
        assert_eq!((parent("c.obj"), file_name("c.obj")), ("", "c.obj"));
        assert_eq!((first_name("a/b/c"), first_name("c")), ("a", "c"));
        assert_eq!((depth("a/b/c"), depth("c")), (3, 1));
        assert_eq!((extension("a.b/c.d.obj"), extension("a.b/c")), ("obj", ""));
        assert_eq!(without_extension("a/c.d.obj"), "a/c.d");
        assert_eq!(without_extension("c"), "c");
    }
}
