//! Folders that no loader lists because their names have other capitals than those that are looked
//! for.

use std::collections::BTreeMap;

use super::Layer;
use mhlint_discover::{Kind, Layout};

/// A folder of the checked layer with other capitals.
#[derive(Debug)]
pub struct MisnamedFolder {
    /// Its path below the data root.
    pub rel: String,
    /// The path that is looked for.
    pub right: String,
    /// How many files in it are not found.
    pub files: usize,
}

/// The folders of a layer that `other` gives another name, of which it also says what is below:
/// counted are files with a reader.
pub(super) fn misnamed_folders<'l>(
    layer: &'l Layer,
    layout: &Layout,
    other: impl Fn(&'l str) -> Option<(String, String, &'l str)>,
) -> Vec<MisnamedFolder> {
    let mut found: BTreeMap<(String, String), usize> = BTreeMap::new();
    for (folder, right, rest) in layer.files.keys().filter_map(|rel| other(rel)) {
        if is_read(layout, &format!("{right}/{rest}")) {
            *found.entry((folder, right)).or_default() += 1;
        }
    }
    found
        .into_iter()
        .map(|((rel, right), files)| MisnamedFolder { rel, right, files })
        .collect()
}

/// A folder at the top of a data root that differs from one of the application in its capitals
/// alone.
pub(super) fn top_in_other_case<'l>(
    layout: &Layout,
    rel: &'l str,
) -> Option<(String, String, &'l str)> {
    let (top, rest) = rel.split_once('/')?;
    Some((
        top.to_owned(),
        layout.folder_in_other_case(top)?.to_owned(),
        rest,
    ))
}

/// Whether the file at a path has a reader.
fn is_read(layout: &Layout, rel: &str) -> bool {
    (layout.opens)(rel)
        && !matches!(
            layout.use_of(rel).kind,
            Kind::Other | Kind::Image | Kind::Json
        )
}
