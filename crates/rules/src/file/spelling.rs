//! Names that differ in capitals from the file they mean: which file, what differs, and how they
//! have to be written.

use mhlint_diag::Place;
use mhlint_formats::macro_json::without_suffix;
use mhlint_repo::{Reference, Resolution, fold};

/// The file that a name leads to where capitals make no difference.
pub(super) fn found<'a>(reference: &Reference<'a>) -> Option<&'a str> {
    match reference.resolution {
        Resolution::CaseOnly(file) => Some(&file.rel),
        // The backslash is a fault of its own.
        Resolution::Backslash(Some(file)) if plain(&reference.rel) != file.rel => Some(&file.rel),
        _ => None,
    }
}

/// Folders and name of a path with the places where they begin, without those that lead nowhere.
fn parts(rel: &str) -> Vec<(usize, &str)> {
    let mut parts = Vec::new();
    let mut at = 0;
    for part in rel.split(['/', '\\']) {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()),
            name => parts.push((at, name)),
        }
        at += part.len() + 1;
    }
    parts
}

/// The path without what leads nowhere, with `/`.
pub(super) fn plain(rel: &str) -> String {
    parts(rel)
        .into_iter()
        .map(|(_, part)| part)
        .collect::<Vec<_>>()
        .join("/")
}

/// The name as it has to be written; nothing where the difference is not in the name itself but
/// around it.
pub(super) fn as_on_disk(reference: &Reference<'_>) -> Option<String> {
    spelled(
        &reference.rel,
        found(reference)?,
        begin(reference)?,
        reference.text,
    )
}

/// Where the name begins in the whole path. Targets are named without their suffix.
fn begin(reference: &Reference<'_>) -> Option<usize> {
    let (rel, text) = (reference.rel.as_str(), reference.text);
    let stem = rel.strip_suffix(".target");
    let of_target = |text: &str| stem.and_then(|stem| stem.strip_suffix(text));
    let above = rel
        .strip_suffix(text)
        .or_else(|| of_target(text))
        .or_else(|| of_target(without_suffix(text)));
    above.map(str::len)
}

/// A name with its last parts as the file has them, as far as they differ in capitals only. It need
/// not be the end of the path: the loader may leave out its first part.
pub(super) fn respelled(text: &str, found: &str) -> String {
    let mut parts: Vec<&str> = text.split(['/', '\\']).collect();
    let same = parts
        .iter_mut()
        .rev()
        .zip(found.rsplit('/'))
        .take_while(|(part, name)| fold(part) == fold(name));
    same.for_each(|(part, name)| *part = name);
    parts.join("/")
}

/// Where a folder that is at fault is written, and as what it has to be.
pub(super) fn folder_on_disk(reference: &Reference<'_>) -> Option<(String, String)> {
    let (Place::Pointer(pointer), folder) = reference.folder_at_fault.as_ref()? else {
        return None;
    };
    let start = begin(reference)?.checked_sub(folder.len() + 1)?;
    Some((
        pointer.clone(),
        spelled(&reference.rel, found(reference)?, start, folder)?,
    ))
}

/// A part of the path `rel`, `text` from `start` on, as `found` has it; nothing where they differ
/// elsewhere, too.
fn spelled(rel: &str, found: &str, start: usize, text: &str) -> Option<String> {
    let parts = parts(rel);
    let names: Vec<&str> = found.split('/').collect();
    if parts.len() != names.len() {
        return None;
    }
    let mut right = text.replace('\\', "/");
    for ((at, part), name) in parts
        .into_iter()
        .zip(names)
        .filter(|((_, part), name)| part != name)
    {
        let at = at.checked_sub(start)?;
        // What the loader adds to the last part has to be the same.
        let length = part.len().min(text.len().checked_sub(at)?);
        let is_written = text.get(at..at + length) == part.get(..length);
        if !is_written || part.get(length..) != name.get(length..) {
            return None;
        }
        right.replace_range(at..at + length, name.get(..length)?);
    }
    Some(right)
}

/// Two paths without the folders in front that they have in common.
pub(super) fn without_common_folders<'p>(
    mut one: &'p str,
    mut other: &'p str,
) -> (&'p str, &'p str) {
    while let (Some((above, rest)), Some((same, other_rest))) =
        (one.split_once('/'), other.split_once('/'))
        && above == same
    {
        (one, other) = (rest, other_rest);
    }
    (one, other)
}

/// Whether the names are the same up to the extension of a target, which is not written in what
/// names it, or of a material, which lists know in small letters alone.
pub(super) fn differs_in_extension(written: &str, real: &str) -> bool {
    let targets = written
        .strip_suffix(".target.gz")
        .or_else(|| written.strip_suffix(".target"));
    let stem = targets.or_else(|| written.strip_suffix(".mhmat"));
    stem.is_some_and(|stem| {
        real.strip_prefix(stem)
            .is_some_and(|rest| rest.starts_with('.'))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_in_common_are_left_out() {
        let common = |one, other| without_common_folders(one, other);
        assert_eq!(common("a/b/C", "a/b/c"), ("C", "c"));
        assert_eq!(common("a/B/c", "a/b/c"), ("B/c", "b/c"));
        assert_eq!(common("a/B", "a/b"), ("B", "b"));
        assert_eq!(common("A", "a"), ("A", "a"));
    }

    #[test]
    fn the_end_of_a_name_is_written_as_the_file_is_called() {
        assert_eq!(
            respelled("skins/Textures\\A.png", "skins/b/textures/a.png"),
            "skins/textures/a.png"
        );
        assert_eq!(respelled("../A.png", "skins/a.png"), "../a.png");
    }

    #[test]
    fn a_name_is_written_as_the_file_is_called() {
        let of = |rel: &str, text: &str| spelled(rel, "t/head/a.target", 2, text);
        assert_eq!(of("t/Head/A.target", "Head/A").as_deref(), Some("head/a"));
        assert_eq!(
            of("t/.\\Head\\A.target", ".\\Head\\A").as_deref(),
            Some("./head/a")
        );
        assert_eq!(
            of("t/x/..//HEAD/a.target", "x/..//HEAD/a").as_deref(),
            Some("x/..//head/a")
        );
        assert_eq!(
            of("t/head/A.target", "head/A.target.gz").as_deref(),
            Some("head/a.target.gz")
        );
        assert_eq!(
            of("T/head/A.target", "head/A"),
            None,
            "the folder above is at fault as well"
        );
        assert_eq!(
            of("t/head/a.TARGET", "head/a"),
            None,
            "what the loader adds is at fault"
        );
    }
}
