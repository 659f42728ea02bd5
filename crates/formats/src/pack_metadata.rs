//! `packs/*.json` of MPFB: the assets of a pack, as keys
//! (`docs/loaders/mpfb/libraries.md#the-list-of-a-pack`).

use super::unfit::{NamedAt, Unfits, below, keep};
use mhlint_json::Document;

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PackMetadata {
    /// What stops the loader.
    pub stops: Unfits,
    /// Names of assets, which are those of their files without the suffix.
    pub assets: Vec<NamedAt>,
}

/// Takes what the loader would take: values are never read.
pub fn read(document: &Document) -> PackMetadata {
    let root = &document.root;
    let mut pack = PackMetadata::default();
    if !root.is_object() {
        pack.stops.add_type("", root, "an object");
    }
    for member in root.effective_members() {
        keep(&mut pack.assets, &below("", &member.key), &member.key);
    }
    pack
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::parse;

    #[test]
    fn the_keys_are_assets() {
        let of = |text: &str| read(&parse(text.as_bytes()).unwrap());
        let pack = of(r#"{"shirt": {"a": 1}, "hat": null}"#);
        assert_eq!(
            pack.assets.iter().map(|one| &*one.name).collect::<Vec<_>>(),
            ["shirt", "hat"]
        );
        assert_eq!(
            (
                of("[]").stops.all().len(),
                of("null").stops.all().len(),
                of("{}").stops.all().len()
            ),
            (1, 1, 0)
        );
    }
}
