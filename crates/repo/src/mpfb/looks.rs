//! Materials as MPFB reads them, with the pictures that they name
//! (`docs/loaders/mpfb/materials.md#textures`).

use std::collections::BTreeSet;

use super::view::OWN;
use crate::path::resolve;
use crate::{FileFacts, Layer, Reference, ReferenceKind, Wearer, Worn};
use mhlint_diag::Place;
use mhlint_discover::Kind;
use mhlint_formats::mhmat::mpfb::{is_file, is_picture, key};
use mhlint_formats::mhmat::{Keyword, Material, Statement};
use mhlint_source::{normalized, parent};

/// A material with what its lines set.
#[derive(Debug)]
pub struct Look<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// What is in it.
    pub material: &'a Material,
    /// Who has it.
    pub wearer: Wearer,
    /// The lines of a keyword, in file order.
    pub lines: Vec<Set<'a>>,
    /// The pictures in use.
    pub pictures: Vec<Reference<'a>>,
}

/// A line that sets something.
#[derive(Debug, Clone)]
pub struct Set<'a> {
    /// What it sets.
    pub key: &'static Keyword,
    /// The line.
    pub statement: &'a Statement,
    /// The value once another spelling of the keyword is corrected in all of the line.
    pub value: String,
}

impl<'a> Look<'a> {
    /// The last line of a keyword that has a value, in whatever capitals.
    pub fn last_of(&self, word: &str) -> Option<&Set<'a>> {
        self.lines
            .iter()
            .rfind(|set| set.key.name.eq_ignore_ascii_case(word) && !set.value.is_empty())
    }

    /// Whether a word is a keyword, also in another spelling.
    pub fn reads(&self, word: &str) -> bool {
        self.lines
            .iter()
            .any(|set| *set.statement.key.text == *word)
    }

    /// The picture of a keyword.
    pub fn picture(&self, name: &str) -> Option<&Reference<'a>> {
        self.pictures.iter().find(|picture| picture.owner == name)
    }
}

/// The materials of a layer.
pub(super) fn looks<'a>(layer: &'a Layer, worn: &[Worn<'a>]) -> Vec<Look<'a>> {
    let named = worn
        .iter()
        .filter_map(|worn| worn.reference(ReferenceKind::AssetMaterial)?.meant());
    let named: BTreeSet<&str> = named.map(|file| file.path.as_str()).collect();
    let files = layer
        .files
        .values()
        .filter(|file| file.kind_in(OWN) == Kind::Material);
    // What is not UTF-8 stops the reader, and has a finding of its own.
    let files = files.filter(|file| file.encoding.invalid_utf8_at.is_none());
    let look = |file: &'a FileFacts| {
        let wearer = match file.rel.split('/').next() {
            Some("skins") => Wearer::Skin,
            _ if named.contains(file.path.as_str()) => Wearer::Asset,
            _ => Wearer::Choice,
        };
        look(layer, file, file.material()?, wearer)
    };
    files.filter_map(look).collect()
}

fn look<'a>(
    layer: &'a Layer,
    file: &'a FileFacts,
    material: &'a Material,
    wearer: Wearer,
) -> Option<Look<'a>> {
    let base = file.base_in(OWN)?;
    let lines: Vec<Set<'a>> = material.statements.iter().filter_map(set).collect();
    let mut look = Look {
        file,
        material,
        wearer,
        lines,
        pictures: Vec::new(),
    };
    let is_last = |(at, set): &(usize, &Set<'a>)| {
        let mut behind = look.lines.iter().skip(at + 1);
        let is_used = is_picture(set.key) && !set.value.is_empty();
        is_used && !behind.any(|other| other.key == set.key && !other.value.is_empty())
    };
    let used: Vec<&Set<'a>> = look
        .lines
        .iter()
        .enumerate()
        .filter(is_last)
        .map(|(_, set)| set)
        .collect();
    look.pictures = used
        .into_iter()
        .map(|set| picture(layer, file, base, wearer, set))
        .collect();
    Some(look)
}

fn set(statement: &Statement) -> Option<Set<'_>> {
    let key = key(&statement.key.text).filter(|_| !statement.is_indented)?;
    let value = if is_file(key) && *key.name != *statement.key.text {
        // The correction replaces the word wherever it stands in the line.
        statement.value.text.replace(&*statement.key.text, key.name)
    } else {
        statement.value.text.to_string()
    };
    Some(Set {
        key,
        statement,
        value,
    })
}

fn picture<'a>(
    layer: &'a Layer,
    file: &'a FileFacts,
    base: &'a str,
    wearer: Wearer,
    set: &Set<'a>,
) -> Reference<'a> {
    let kind = if wearer == Wearer::Skin {
        ReferenceKind::SkinTexture
    } else {
        ReferenceKind::Texture
    };
    let name = set.value.replace('\\', "/");
    let rel = format!("{}/{name}", parent(&file.rel));
    // A drive letter is a folder of that name.
    let text = if name.get(1..2) == Some(":") {
        ""
    } else {
        name.as_str()
    };
    let resolution = resolve(&[layer], text, &rel).in_pack(&[layer], file, &name);
    let rel = normalized(&rel).unwrap_or(rel);
    let place = Place::Span(set.statement.value.span.clone());
    let (text, owner) = (&*set.statement.value.text, set.key.name);
    Reference {
        kind,
        base,
        from: file,
        place,
        text,
        owner,
        folder_at_fault: None,
        rel,
        resolution,
    }
}
