//! Which file is read as the base mesh, and which ones are not because of it
//! (`docs/loaders/makehuman2/base-mesh.md#which-file-is-read`): an archive goes before any OBJ,
//! that of the user before that of the system, and nobody compares dates.

use super::OWN;
use crate::{FileFacts, Layers};
use mhlint_discover::Kind;
use mhlint_formats::Format;
use mhlint_formats::obj::Mesh;

/// The files of a base mesh.
#[derive(Debug)]
pub struct MeshFiles<'a> {
    /// What is read, whatever is in it.
    pub read: Option<&'a FileFacts>,
    /// Each OBJ that an archive is read in place of.
    pub unread: Vec<UnreadMesh<'a>>,
}

/// An OBJ that an archive is read in place of.
#[derive(Debug, Clone, Copy)]
pub struct UnreadMesh<'a> {
    pub file: &'a FileFacts,
    pub lies: Lies,
}

/// Where an OBJ lies that an archive is read in place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lies {
    /// In the folder of the archive.
    Beside,
    /// In the user's folder, the archive being the system's.
    Above,
    /// In the system's folder, the archive being the user's.
    Below,
}

impl<'a> MeshFiles<'a> {
    pub(super) fn of(base: &str, layers: Layers<'a>) -> Self {
        let [packed, text] = ["base.mhbin", "base.obj"].map(|name| format!("base/{base}/{name}"));
        let Some(archive) = layers.first_existing(&packed) else {
            return Self {
                read: layers.first_existing(&text),
                unread: Vec::new(),
            };
        };
        let mut unread = Vec::new();
        let mut lies = Lies::Above;
        for layer in layers.strongest_first() {
            let is_own = layer
                .file(&packed)
                .is_some_and(|own| std::ptr::eq(own, archive));
            lies = if is_own { Lies::Beside } else { lies };
            // The system's OBJ says nothing of an archive that was made of the user's.
            if let Some(file) = layer
                .file(&text)
                .filter(|_| lies != Lies::Below || unread.is_empty())
            {
                unread.push(UnreadMesh { file, lies });
            }
            lies = if is_own { Lies::Below } else { lies };
        }
        Self {
            read: Some(archive),
            unread,
        }
    }

    /// The archive that is read.
    pub fn archive(&self) -> Option<&'a FileFacts> {
        self.read
            .filter(|file| file.kind_in(OWN) == Kind::MeshArchive)
    }

    /// The OBJ in the folder of the archive.
    pub(super) fn beside(&self) -> Option<&UnreadMesh<'a>> {
        self.unread.iter().find(|text| text.lies == Lies::Beside)
    }

    /// The mesh that is read, if the application gets through it.
    pub(super) fn sound(&self) -> Option<(&'a FileFacts, &'a Mesh)> {
        self.read.and_then(|file| Some((file, sound_mesh(file)?)))
    }
}

impl<'a> UnreadMesh<'a> {
    /// Its mesh, if the application would get through it.
    pub fn sound(&self) -> Option<&'a Mesh> {
        sound_mesh(self.file)
    }
}

fn sound_mesh(file: &FileFacts) -> Option<&Mesh> {
    let is_text = || Format::of(file.kind_in(OWN)).is_text();
    file.mesh()
        .filter(|mesh| mesh.is_sound() && !(is_text() && file.encoding.invalid_utf8_at.is_some()))
}
