//! What an application makes of a material: who has it, and which of its pictures are there.

use super::FileFacts;
use crate::diag::{Application, Place};
use crate::formats::mhmat::{Line, Material};

/// A material that an application opens.
#[derive(Debug)]
pub(crate) struct Surface<'a> {
    /// Who opens it.
    pub application: Application,
    /// Its file.
    pub file: &'a FileFacts,
    /// What is in it.
    pub material: &'a Material,
    /// Who has it.
    pub wearer: Wearer,
    /// Its pictures by keyword, those in use.
    pub pictures: Vec<(&'static str, Picture<'a>)>,
    /// The picture of its litsphere, if it names one.
    pub litsphere: Option<Picture<'a>>,
    /// A file of the shader that it asks for, where shaders are files.
    pub shader: Option<Picture<'a>>,
}

/// Who has a material.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wearer {
    /// The body.
    Skin,
    /// An asset that names it.
    Asset,
    /// Nobody before it is chosen.
    Choice,
}

/// A picture that a material names.
#[derive(Debug, Clone)]
pub(crate) struct Picture<'a> {
    /// The name, as it is written.
    pub text: &'a str,
    /// Where the name stands.
    pub place: Place,
    /// The file; `None` where there is none, or nobody can tell.
    pub file: Option<&'a FileFacts>,
    /// Whether nobody can tell.
    pub is_open: bool,
}

impl<'a> Surface<'a> {
    /// The picture of a keyword.
    pub(crate) fn picture(&self, keyword: &str) -> Option<&Picture<'a>> {
        self.pictures.iter().find(|(own, _)| *own == keyword).map(|(_, picture)| picture)
    }

    /// Whether the picture of a keyword is there; `None` where nobody can tell.
    pub(crate) fn has(&self, keyword: &str) -> Option<bool> {
        self.picture(keyword).map_or(Some(false), |picture| (!picture.is_open).then_some(picture.file.is_some()))
    }

    /// All pictures that are there, with what they are for.
    pub(crate) fn found(&self) -> impl Iterator<Item = (&'static str, &Picture<'a>, &'a FileFacts)> {
        let litsphere = self.litsphere.iter().map(|picture| ("litsphereTexture", picture));
        let all = self.pictures.iter().map(|(keyword, picture)| (*keyword, picture)).chain(litsphere);
        all.filter_map(|(keyword, picture)| Some((keyword, picture, picture.file?)))
    }

    /// The place of a line: its words, or all of it where it has none.
    pub(crate) fn place(line: &Line) -> Place {
        match (line.words.first(), line.words.last()) {
            (Some(first), Some(last)) => Place::Span(first.span.start..last.span.end),
            _ => Place::Line(line.number),
        }
    }
}
