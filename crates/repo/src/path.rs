//! Names followed to files: links to other folders, capitals, backslashes, and ways out of the data
//! root.

use super::{Layer, Resolution};
use mhlint_source::normalized;

/// Bytes that a path has at most, on any system that the applications run on.
const LONGEST: usize = 4096;

/// As much of a name as a path may have.
pub fn shortened(text: &str) -> &str {
    text.get(..text.floor_char_boundary(LONGEST))
        .unwrap_or(text)
}

/// Whether a name begins at a root or a drive instead of the folder it is looked for in.
pub(super) fn is_absolute(text: &str) -> bool {
    text.starts_with(['/', '\\']) || text.get(1..2) == Some(":")
}

/// What `rel` leads to in the layers, strongest first; `text` is the name in it as written.
pub(super) fn resolve<'a>(layers: &[&'a Layer], text: &str, rel: &str) -> Resolution<'a> {
    if is_absolute(text) {
        return Resolution::Absolute;
    }
    if rel.len() > LONGEST {
        return Resolution::Missing;
    }
    let Some(normal) = normalized(rel) else {
        return Resolution::Escapes;
    };
    if rel.ends_with('/') || !layers.iter().any(|layer| has_way(layer, rel)) {
        return Resolution::Missing;
    }
    if let Some(file) = layers.iter().find_map(|layer| layer.file(&normal)) {
        return Resolution::Found(file);
    }
    if layers.iter().any(|layer| layer.has_unusable(&normal)) {
        return Resolution::Unusable;
    }
    if text.contains('\\') {
        let Some(slashed) = normalized(&rel.replace('\\', "/")) else {
            return Resolution::Escapes;
        };
        let exact = layers.iter().find_map(|layer| layer.file(&slashed));
        // Where `\` separates folders, capitals make no difference either.
        let found = exact.or_else(|| {
            layers
                .iter()
                .find_map(|layer| layer.file_ignoring_case(&slashed))
        });
        return Resolution::Backslash(found);
    }
    match layers
        .iter()
        .find_map(|layer| layer.file_ignoring_case(&normal))
    {
        Some(file) => Resolution::CaseOnly(file),
        None => Resolution::Missing,
    }
}

/// Whether the folders are there that `..` leaves again. Only Windows does without.
fn has_way(layer: &Layer, rel: &str) -> bool {
    let exists = |folder: &String| {
        layer.folders.binary_search(folder).is_ok() || layer.below(folder).next().is_some()
    };
    let mut at: Vec<&str> = Vec::new();
    for part in rel.split('/') {
        match part {
            "" | "." => {}
            ".." if !at.is_empty() && !exists(&at.join("/")) => return false,
            ".." => drop(at.pop()),
            other => at.push(other),
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, shortened};

    #[test]
    fn names_are_cut_to_what_a_path_may_have() {
        assert_eq!(shortened("a/b"), "a/b");
        assert_eq!(shortened(&"é".repeat(4096)).len(), LONGEST);
    }
}
