//! Saved characters: what they name, and whether the program reads them at all
//! (`docs/loaders/makehuman1/models.md#version-of-a-model`).

use super::Asset;
use super::search::Search;
use super::view::OWN;
use crate::{FileFacts, Layer, Layers, Reference, ReferenceKind, Worn};
use mhlint_diag::Place;
use mhlint_discover::{Kind, library_of};
use mhlint_formats::mhm::Word;
use mhlint_formats::mhm::lines::{Line, Lines};
use mhlint_source::parent;

/// The folder of characters, beside the user's data.
const LIBRARY: &str = "models";

/// A character that can be loaded.
#[derive(Debug, Clone, Copy)]
pub struct SavedModel<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// Its lines.
    pub lines: &'a Lines,
    /// What its version comes to.
    pub version: Version<'a>,
}

/// What the program makes of a version.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version<'a> {
    /// There is none.
    Missing,
    /// It is not written as one, or is one that the program does not know.
    Refused(&'a Word),
    /// 1.0: names of modifiers are older ones.
    First(&'a Word),
    /// 1.1: the tags are the name.
    Second(&'a Word),
    /// One whose lines are those of today.
    Current,
}

impl<'a> Version<'a> {
    fn of(lines: &'a Lines) -> Self {
        let Some(word) = lines.last("version") else {
            return Self::Missing;
        };
        match numbers(&word.text) {
            Some(("1", "0")) => Self::First(word),
            Some(("1", "1")) => Self::Second(word),
            Some(("1", "2" | "3")) => Self::Current,
            _ => Self::Refused(word),
        }
    }

    /// Whether the rest of the file is read.
    pub const fn is_read(self) -> bool {
        !matches!(self, Self::Missing | Self::Refused(_))
    }
}

/// The first two numbers of `v1.3.0`.
fn numbers(text: &str) -> Option<(&str, &str)> {
    let (major, rest) = text.strip_prefix('v')?.split_once('.')?;
    let end = rest
        .find(|one: char| !one.is_ascii_digit())
        .unwrap_or(rest.len());
    let minor = rest.get(..end)?;
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    (is_number(major) && is_number(minor)).then_some((major, minor))
}

/// The characters of all layers that are listed.
pub(super) fn models(layers: Layers<'_>) -> Vec<SavedModel<'_>> {
    let files = layers
        .strongest_first()
        .flat_map(|layer| layer.below(LIBRARY));
    // Beside the data folder, not in it.
    let beside = files.filter(|file| file.is_loose);
    let listed =
        beside.filter(|file| file.kind_in(OWN) == Kind::Model && library_of(&file.rel).is_some());
    // Of what is not UTF-8 nothing is read.
    let read = listed.filter(|file| file.encoding.invalid_utf8_at.is_none());
    let model = |file| {
        let lines = &FileFacts::model(file)?.lines;
        Some(SavedModel {
            file,
            lines,
            version: Version::of(lines),
        })
    };
    read.filter_map(model).collect()
}

/// The files that characters name.
pub(super) fn references<'a>(
    layers: Layers<'a>,
    models: &[SavedModel<'a>],
    worn: &[Worn<'a>],
) -> Vec<Reference<'a>> {
    let named: [(&str, ReferenceKind, &str); 4] = [
        ("skinMaterial", ReferenceKind::Skin, ""),
        ("skeleton", ReferenceKind::ModelSkeleton, "rigs"),
        ("pose", ReferenceKind::ModelPose, "poses"),
        ("expression", ReferenceKind::ModelExpression, "expressions"),
    ];
    let mut all = Vec::new();
    for model in models.iter().filter(|model| model.version.is_read()) {
        let Some(asking) = Asking::of(layers, model.file) else {
            continue;
        };
        for (keyword, kind, folder) in named {
            let first: Vec<_> = layers
                .strongest_first()
                .map(|layer| (layer, folder))
                .collect();
            let first = if folder.is_empty() { &[][..] } else { &first };
            all.extend(
                model
                    .lines
                    .last(keyword)
                    .map(|word| asking.reference(kind, first, word, "")),
            );
        }
        for (line, uuid, path) in model.lines.of("material").filter_map(material) {
            let Some(asset) = worn.iter().find(|asset| uuid_of(asset) == Some(uuid)) else {
                continue;
            };
            let first = layer_of(layers, asset.file).map(|layer| (layer, parent(&asset.file.rel)));
            let first: Vec<_> = first.into_iter().collect();
            all.push(asking.reference(ReferenceKind::ModelMaterial, &first, path, line.value(0)));
        }
    }
    all
}

/// A line `material` with the uuid of its asset and the path.
pub fn material(line: &Line) -> Option<(&Line, &str, &Word)> {
    // Name, uuid and path, or the last two alone.
    let at = usize::from(line.values.len() > 2);
    Some((line, line.value(at), line.values.get(at + 1)?))
}

/// The uuid that models know an asset by.
pub fn uuid_of<'a>(asset: &Worn<'a>) -> Option<&'a str> {
    Some(Asset::of(asset)?.uuid?.text)
}

fn layer_of<'a>(layers: Layers<'a>, file: &FileFacts) -> Option<&'a Layer> {
    layers.strongest_first().find(|layer| {
        layer
            .file(&file.rel)
            .is_some_and(|own| std::ptr::eq(own, file))
    })
}

/// A model that names files.
struct Asking<'a> {
    search: Search<'a>,
    base: &'a str,
}

impl<'a> Asking<'a> {
    fn of(layers: Layers<'a>, file: &'a FileFacts) -> Option<Self> {
        let search = Search {
            layers,
            layer: layer_of(layers, file)?,
            file,
        };
        Some(Self {
            search,
            base: file.base_in(OWN)?,
        })
    }

    fn reference(
        &self,
        kind: ReferenceKind,
        first: &[(&'a Layer, &str)],
        word: &'a Word,
        owner: &'a str,
    ) -> Reference<'a> {
        let (rel, resolution) = self.search.find_from(first, &word.text);
        let (base, from, place, text) = (
            self.base,
            self.search.file,
            Place::Span(word.span.clone()),
            &*word.text,
        );
        Reference {
            kind,
            base,
            from,
            place,
            text,
            owner,
            folder_at_fault: None,
            rel,
            resolution,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_formats::mhm::lines::read;

    #[test]
    fn a_version_has_two_numbers() {
        for (text, is_read) in [
            ("version v1.3.0", true),
            ("version v1.2", true),
            ("version v1.0.2", true),
            ("version 1.3.0", false),
            ("version v1.4", false),
            ("version v0.8.0", false),
            ("version", false),
            ("Version v1.3.0", false),
            ("version v1.0\nversion v2.0", false),
        ] {
            let lines = read(text.as_bytes());
            assert_eq!(Version::of(&lines).is_read(), is_read, "{text}");
        }
        let lines = read(b"version v1.0.2");
        assert!(matches!(Version::of(&lines), Version::First(_)));
    }

    #[test]
    fn a_material_has_a_name_in_front_or_none() {
        let lines = read(b"material 12 a.mhmat\nmaterial cap 12 a.mhmat more\nmaterial 12\n");
        let told: Vec<_> = lines
            .all
            .iter()
            .filter_map(material)
            .map(|(_, uuid, path)| (uuid, &*path.text))
            .collect();
        assert_eq!(told, [("12", "a.mhmat"), ("12", "a.mhmat")]);
    }
}
