//! The file that is meant by a name that leads to nothing: it lies there under another name.

use mhlint_repo::Layer;
use mhlint_source::{file_name, parent};

/// Suffixes that come to stand behind the own one of a file, mostly because Windows hides them.
const HIDDEN: [&str; 3] = ["txt", "text", "html"];

/// What to do where the file at `rel` has another suffix behind its own, or a space in its name, at
/// which a name in a text ends: `whole` is all that stands there.
pub(super) fn meant_beside(layer: &Layer, rel: &str, whole: Option<&str>) -> Option<String> {
    let name = |rel: &str| file_name(rel).to_owned();
    let hidden = HIDDEN
        .iter()
        .map(|suffix| format!("{rel}.{suffix}"))
        .find(|other| layer.file(other).is_some());
    if let Some(other) = hidden {
        return Some(format!("rename `{}` to `{}`", name(&other), name(rel)));
    }
    let whole = whole.filter(|whole| whole.contains(' '))?;
    let folder = parent(rel);
    let is_there = layer
        .file(&if folder.is_empty() {
            whole.to_owned()
        } else {
            format!("{folder}/{whole}")
        })
        .is_some();
    is_there.then(|| {
        format!(
            "rename `{whole}` without spaces, and write that name: a name ends at the first space"
        )
    })
}
