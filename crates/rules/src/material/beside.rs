//! Pictures that a material may mean.

use super::super::pictures::blender_loads;
use mhlint_repo::{FileFacts, View};

/// Pictures of a folder that are looked at for a name: among more of them nobody finds one that was
/// mistyped.
const NEIGHBOURS: usize = 200;

/// The pictures in a folder that nothing names: one that something names is that of another map,
/// however near its name.
pub(super) fn free_pictures<'v>(view: &View<'v>, folder: &str) -> Vec<&'v str> {
    let is_free = |file: &&FileFacts| view.references().to_file(file).next().is_none();
    let pictures = view
        .layers()
        .checked
        .below(folder)
        .filter(|file| blender_loads(file))
        .take(NEIGHBOURS)
        .filter(is_free);
    pictures
        .filter_map(|file| file.rel.strip_prefix(folder)?.strip_prefix('/'))
        .collect()
}
