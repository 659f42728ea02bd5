//! Contarget over target: each JSON falls back on its own, target files follow `macro.json` alone
//! (`docs/loaders/makehuman2/folders.md#overlays`).

use crate::{FileFacts, Layer};
use mhlint_formats::Content;

/// One of two places a JSON can come from.
#[derive(Debug)]
pub enum Candidate<'a, T> {
    /// No such file.
    Absent,
    /// Unreadable, no JSON, or empty (`{}`): treated as absent, without a word to the user.
    Refused(&'a FileFacts),
    /// Taken if nothing stronger is.
    Accepted(&'a FileFacts, &'a T),
}

/// A JSON that exists in contarget and in the system's target folder.
#[derive(Debug)]
pub struct Overlaid<'a, T> {
    /// `contarget/<base>/` of the user.
    pub contarget: Candidate<'a, T>,
    /// `target/<base>/` of the system.
    pub system: Candidate<'a, T>,
}

impl<'a, T> Candidate<'a, T> {
    /// Looks at the file `rel` of `layer`; `model` picks the content of the right kind.
    pub(super) fn find(
        layer: Option<&'a Layer>,
        rel: &str,
        model: impl Fn(&'a Content) -> Option<&'a T>,
    ) -> Self {
        let Some(file) = layer.and_then(|layer| layer.file(rel)) else {
            return Self::Absent;
        };
        match model(&file.content) {
            Some(found) if !file.json.falsy => Self::Accepted(file, found),
            _ => Self::Refused(file),
        }
    }

    /// File and model, if accepted.
    pub fn accepted(&self) -> Option<(&'a FileFacts, &'a T)> {
        if let Self::Accepted(file, model) = self {
            Some((file, model))
        } else {
            None
        }
    }

    /// The file, accepted or not.
    pub fn file(&self) -> Option<&'a FileFacts> {
        match self {
            Self::Absent => None,
            Self::Refused(file) | Self::Accepted(file, _) => Some(file),
        }
    }

    /// Whether the file is there and rejected.
    pub fn is_refused(&self) -> bool {
        matches!(self, Self::Refused(_))
    }
}

impl<'a, T> Overlaid<'a, T> {
    /// What the application takes.
    pub fn winner(&self) -> Option<(&'a FileFacts, &'a T)> {
        self.contarget.accepted().or_else(|| self.system.accepted())
    }

    /// Whether the contarget file is in use.
    pub fn is_overridden(&self) -> bool {
        self.contarget.accepted().is_some()
    }

    /// Whether a file that would be in use is rejected; what depends on it cannot be checked.
    pub fn is_broken(&self) -> bool {
        self.winner().is_none() && (self.contarget.is_refused() || self.system.is_refused())
    }
}
