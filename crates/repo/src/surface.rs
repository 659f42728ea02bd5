//! What an application makes of a material: who has it, and which of its pictures are there.

use super::FileFacts;
use mhlint_diag::{Application, Place};
use mhlint_formats::mhmat::{Line, Material};
use mhlint_formats::shader_source::{ShaderSource, Uniform};

/// A material that an application opens.
#[derive(Debug)]
pub struct Surface<'a> {
    /// Who opens it.
    pub application: Application,
    /// Its file.
    pub file: &'a FileFacts,
    /// What is in it.
    pub material: &'a Material,
    /// Who has it.
    pub wearer: Wearer,
    /// Whether the program starts with it.
    pub is_first: bool,
    /// Its pictures by keyword, those in use.
    pub pictures: Vec<(&'static str, Picture<'a>)>,
    /// The picture of its litsphere, if it names one.
    pub litsphere: Option<Picture<'a>>,
    /// Those of other parameters of its shader, by name.
    pub parameters: Vec<(&'a str, Picture<'a>)>,
    /// The shader that it asks for, where shaders are files.
    pub shader: Option<Shader<'a>>,
}

/// Who has a material.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wearer {
    /// The body.
    Skin,
    /// An asset that names it.
    Asset,
    /// Nobody before it is chosen.
    Choice,
}

/// A picture that a material names.
#[derive(Debug, Clone)]
pub struct Picture<'a> {
    /// The name, as it is written.
    pub text: &'a str,
    /// Where the name stands.
    pub place: Place,
    /// The file; `None` where there is none, or nobody can tell.
    pub file: Option<&'a FileFacts>,
    /// Whether nobody can tell.
    pub is_open: bool,
}

/// A shader that a material names.
#[derive(Debug, Clone)]
pub struct Shader<'a> {
    /// The name, as it is written.
    pub text: &'a str,
    /// Where the name stands.
    pub place: Place,
    /// Its sources.
    pub files: Vec<&'a FileFacts>,
    /// Whether nobody can tell if there are more.
    pub is_open: bool,
}

impl<'a> Shader<'a> {
    /// Its sources, if all of them could be read.
    pub fn sources(&self) -> Option<Vec<&'a ShaderSource>> {
        let sources: Vec<_> = self
            .files
            .iter()
            .filter_map(|file| file.shader_source())
            .collect();
        (!self.is_open && !sources.is_empty() && sources.len() == self.files.len())
            .then_some(sources)
    }

    /// A parameter that one of its sources declares.
    pub fn uniform(&self, name: &str) -> Option<Uniform> {
        let sources = self.files.iter().filter_map(|file| file.shader_source());
        let mut all = sources
            .filter_map(|source| source.uniforms.get(name))
            .copied();
        let first = all.next()?;
        Some(all.fold(first, |known, other| Uniform {
            is_certain: known.is_certain || other.is_certain,
            ..known
        }))
    }
}

impl<'a> Surface<'a> {
    /// Whether the last line of a keyword says so, as both `MakeHuman`s read it.
    pub fn is_true(&self, keyword: &str) -> bool {
        let said = self
            .material
            .last(keyword)
            .map(|line| line.word(0).to_lowercase());
        said.is_some_and(|word| matches!(word.as_str(), "yes" | "enabled" | "true"))
    }

    /// The picture of a keyword.
    pub fn picture(&self, keyword: &str) -> Option<&Picture<'a>> {
        self.pictures
            .iter()
            .find(|(own, _)| *own == keyword)
            .map(|(_, picture)| picture)
    }

    /// Whether the picture of a keyword is there; `None` where nobody can tell.
    pub fn has(&self, keyword: &str) -> Option<bool> {
        self.picture(keyword).map_or(Some(false), |picture| {
            (!picture.is_open).then_some(picture.file.is_some())
        })
    }

    /// All pictures that are there, with what they are for.
    pub fn found(&self) -> impl Iterator<Item = (&'a str, &Picture<'a>, &'a FileFacts)> {
        let litsphere = self
            .litsphere
            .iter()
            .map(|picture| ("litsphereTexture", picture));
        let parameters = self
            .parameters
            .iter()
            .map(|(name, picture)| (*name, picture));
        let all = self
            .pictures
            .iter()
            .map(|(keyword, picture)| (*keyword, picture))
            .chain(litsphere)
            .chain(parameters);
        all.filter_map(|(keyword, picture)| Some((keyword, picture, picture.file?)))
    }

    /// The place of a line: its words, or all of it where it has none.
    pub fn place(line: &Line) -> Place {
        match (line.words.first(), line.words.last()) {
            (Some(first), Some(last)) => Place::Span(first.span.start..last.span.end),
            _ => Place::Line(line.number),
        }
    }
}
