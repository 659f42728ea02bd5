//! Rules on packs: zips of assets that an application imports, and lists of what is in them.

mod layout;
mod lost;
mod manifest;
mod metadata;
mod misread;
mod moved;
mod named;
mod refused;
mod unpacked;

use super::Rule;
use mhlint_diag::{Finding, Place};
use mhlint_repo::{FileFacts, Import, Layer, Pack};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&layout::RULE, &manifest::RULE, &metadata::RULE];

/// A pack that is imported.
struct Packed<'v> {
    layer: &'v Layer,
    pack: &'v Pack,
    import: &'v Import,
}

impl<'v> Packed<'v> {
    fn of(layer: &'v Layer) -> Option<Self> {
        let pack = layer.pack.as_ref()?;
        Some(Self {
            layer,
            pack,
            import: pack.import.as_ref()?,
        })
    }

    /// A finding at a path in the pack; at the pack itself for an empty one.
    fn at(&self, rule: &Rule, path: &str, message: String) -> Finding {
        Finding::new(&rule.info, self.printed(path), Place::File, message)
    }

    fn printed(&self, path: &str) -> String {
        if path.is_empty() {
            self.layer.path.clone()
        } else {
            format!("{}/{path}", self.layer.path)
        }
    }

    /// The path in the pack of a file of its.
    fn path<'p>(&self, file: &'p FileFacts) -> &'p str
    where
        'v: 'p,
    {
        self.layer.relative(&file.path).unwrap_or(&file.path)
    }

    /// The files that are put somewhere, with the paths that they get.
    fn imported(&self) -> impl Iterator<Item = (&'v str, &'v str)> {
        self.import
            .places
            .iter()
            .filter_map(|(path, place)| Some((path.as_str(), place.as_deref()?)))
    }
}

/// The first folders of a path.
fn top(path: &str, levels: usize) -> String {
    path.split('/').take(levels).collect::<Vec<_>>().join("/")
}
