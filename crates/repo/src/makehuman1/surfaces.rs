//! Materials with the files that they name, and where `MakeHuman` 1 looks for these
//! (`docs/loaders/makehuman1/folders.md#search-lists`).

use std::collections::BTreeSet;

use super::search::Search;
use super::view::OWN;
use crate::surface::{Picture, Shader};
use crate::{Layers, Reference, ReferenceKind, Resolution, Surface, Wearer, Worn};
use mhlint_diag::Place;
use mhlint_discover::{Kind, SHADER_FILES, library_of};
use mhlint_formats::mhmat::{Line, Material, Value, Word, keywords_of};
use mhlint_formats::shader_source::Shape;

/// The skin that it starts with.
const DEFAULT_SKIN: &str = "skins/default.mhmat";
/// What stands for no map of texture coordinates.
const NO_MAP: &str = "uvs/default.mhuv";

/// The materials of all layers, with what they name.
pub(super) fn read<'a>(
    layers: Layers<'a>,
    worn: &[Worn<'a>],
) -> (Vec<Reference<'a>>, Vec<Surface<'a>>) {
    let named = worn
        .iter()
        .filter_map(|worn| worn.reference(ReferenceKind::AssetMaterial)?.found());
    let named: BTreeSet<&str> = named.map(|file| file.path.as_str()).collect();
    let (mut all, mut surfaces) = (Vec::new(), Vec::new());
    for layer in layers.strongest_first() {
        for file in layer
            .files
            .values()
            .filter(|file| file.kind_in(OWN) == Kind::Material)
        {
            let (Some(material), Some(base)) = (file.material(), file.base_in(OWN)) else {
                continue;
            };
            let wearer = match library_of(&file.rel) {
                Some(_) => Wearer::Skin,
                None if named.contains(file.path.as_str()) => Wearer::Asset,
                None => Wearer::Choice,
            };
            let search = Looked {
                search: Search {
                    layers,
                    layer,
                    file,
                },
                base,
            };
            let shader = material.last("shader").and_then(|line| search.shader(line));
            let references = search.references(material, shader.as_ref());
            surfaces.push(search.surface(material, wearer, &references, shader));
            all.extend(references);
        }
    }
    (all, surfaces)
}

/// A material with all that is asked for the files it names.
struct Looked<'a> {
    search: Search<'a>,
    base: &'a str,
}

impl<'a> Looked<'a> {
    fn references(
        &self,
        material: &'a Material,
        shader: Option<&Shader<'a>>,
    ) -> Vec<Reference<'a>> {
        let picture = |keyword: &'static str| {
            let word = material.last(keyword)?.words.first()?;
            Some(self.reference(ReferenceKind::Texture, word, keyword))
        };
        let mut references: Vec<_> = pictures().filter_map(picture).collect();
        references.extend(
            litsphere(material).map(|word| self.reference(ReferenceKind::Texture, word, LITSPHERE)),
        );
        references.extend(
            parameters(material, shader)
                .map(|(name, word)| self.reference(ReferenceKind::Texture, word, name)),
        );
        let map = material.last("uvMap").and_then(|line| line.words.first());
        let map = map.filter(|word| word.text.trim_start_matches("data/") != NO_MAP);
        references.extend(map.map(|word| self.reference(ReferenceKind::UvMap, word, "uvMap")));
        references
    }

    fn reference(&self, kind: ReferenceKind, word: &'a Word, owner: &'a str) -> Reference<'a> {
        let (rel, resolution) = self.search.find(&word.text);
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

    fn surface(
        &self,
        material: &'a Material,
        wearer: Wearer,
        references: &[Reference<'a>],
        shader: Option<Shader<'a>>,
    ) -> Surface<'a> {
        let of = |owner: &str| {
            references
                .iter()
                .find(|one| one.owner == owner)
                .map(picture)
        };
        let pictures = pictures()
            .filter_map(|keyword| Some((keyword, of(keyword)?)))
            .collect();
        let named =
            parameters(material, shader.as_ref()).filter_map(|(name, _)| Some((name, of(name)?)));
        let parameters = named.collect();
        let of_system = self
            .search
            .layers
            .system
            .is_some_and(|system| std::ptr::eq(system, self.search.layer));
        let is_first = of_system && self.search.file.rel == DEFAULT_SKIN;
        let litsphere = of(LITSPHERE);
        let (application, file) = (OWN, self.search.file);
        Surface {
            application,
            file,
            material,
            wearer,
            is_first,
            pictures,
            litsphere,
            parameters,
            shader,
        }
    }

    fn shader(&self, line: &'a Line) -> Option<Shader<'a>> {
        let word = line.words.first()?;
        let all = SHADER_FILES.map(|ending| self.search.find(&format!("{}{ending}", word.text)).1);
        let found = |one: &Resolution<'a>| {
            if let Resolution::Found(file) = one {
                Some(*file)
            } else {
                None
            }
        };
        let files = all.iter().filter_map(found).collect();
        Some(Shader {
            text: &word.text,
            place: Place::Span(word.span.clone()),
            files,
            // A path from the root of a disk is that of its author.
            is_open: all
                .iter()
                .any(|one| is_open(one) && !matches!(one, Resolution::Absolute)),
        })
    }
}

const LITSPHERE: &str = "litsphereTexture";

/// The name of the picture of a litsphere; numbers are none.
fn litsphere(material: &Material) -> Option<&Word> {
    let line = material
        .parameter(LITSPHERE)
        .filter(|line| line.count == 2)?;
    line.words
        .get(1)
        .filter(|word| line.keyword.value == Value::Parameter && word.number().is_none())
}

/// The pictures of other parameters: what is not a number, where the shader takes a picture or the
/// name says so.
fn parameters<'a>(
    material: &'a Material,
    shader: Option<&Shader<'a>>,
) -> impl Iterator<Item = (&'a str, &'a Word)> {
    let lines = material
        .lines_of("shaderParam")
        .filter(|line| line.count == 2);
    lines.filter_map(move |line| {
        let (name, word) = (line.word(0), line.words.get(1)?);
        let is_known = shader.is_some_and(|shader| shader.sources().is_some());
        let declared = shader.and_then(|shader| shader.uniform(name));
        let is_picture = declared.map_or(!is_known && name.ends_with("Texture"), |own| {
            own.value == Shape::Picture
        });
        let is_last = material
            .parameter(name)
            .is_some_and(|last| std::ptr::eq(last, line));
        let is_other = name != LITSPHERE && !pictures().any(|own| own == name);
        (is_picture && is_last && is_other && word.number().is_none()).then_some((name, word))
    })
}

/// The keywords of pictures that it reads, each of which the last line counts.
fn pictures() -> impl Iterator<Item = &'static str> {
    let own = keywords_of(OWN).filter(|keyword| keyword.value == Value::Picture);
    own.map(|keyword| keyword.name)
}

fn picture<'a>(reference: &Reference<'a>) -> Picture<'a> {
    let is_open = is_open(&reference.resolution);
    Picture {
        text: reference.text,
        place: reference.place.clone(),
        file: reference.found(),
        is_open,
    }
}

const fn is_open(resolution: &Resolution<'_>) -> bool {
    matches!(
        resolution,
        Resolution::NeedsSystem | Resolution::Moved | Resolution::Escapes | Resolution::Absolute
    )
}
