//! The layers that an application sees together.

use super::{FileFacts, Layer};
use mhlint_diag::{Application, Version};

/// Data roots that lie over one another; one of them is checked.
#[derive(Debug, Clone, Copy)]
pub struct Layers<'a> {
    /// System data (`data/` beside the program).
    pub system: Option<&'a Layer>,
    /// User data. May be the same root as the system data when one root plays both parts.
    pub user: Option<&'a Layer>,
    /// User data that is checked in the same run: what a system names may lie there where that is
    /// checked, and what a user names where an application knows a second folder of the user.
    pub beside: Option<&'a Layer>,
    /// The layer that findings are reported for: one of the two.
    pub checked: &'a Layer,
}

impl<'a> Layers<'a> {
    /// Whether it is the system that is checked.
    pub fn checks_system(&self) -> bool {
        self.system
            .is_some_and(|system| std::ptr::eq(system, self.checked))
    }

    /// The version of an application that the data are of, if something says so: those of the
    /// program say it for all.
    pub fn version(&self, application: Application) -> Option<Version> {
        let of = |layer: &Layer| layer.identities.get(&application)?.version;
        self.system.and_then(of).or_else(|| of(self.checked))
    }

    /// Whether the data are of a version of an application that is older than the one called so.
    pub fn are_before(&self, application: Application, version: &str) -> bool {
        self.version(application)
            .is_some_and(|own| own.is_before(version))
    }

    /// Whether one root plays both parts.
    pub fn is_one_root(&self) -> bool {
        matches!((self.system, self.user), (Some(system), Some(user)) if std::ptr::eq(system, user))
    }

    /// The layers, strongest first.
    pub fn strongest_first(&self) -> impl Iterator<Item = &'a Layer> + use<'a> {
        let system = if self.is_one_root() {
            None
        } else {
            self.system
        };
        self.user.into_iter().chain(system)
    }

    /// The first existing file, user before system.
    pub fn first_existing(&self, rel: &str) -> Option<&'a FileFacts> {
        self.strongest_first().find_map(|layer| layer.file(rel))
    }

    /// Whether a file belongs to the checked layer.
    pub fn is_checked(&self, file: &FileFacts) -> bool {
        self.checked
            .file(&file.rel)
            .is_some_and(|own| std::ptr::eq(own, file))
    }

    /// A file in words: beside one of the checked layer, of another layer with whose it is.
    pub fn named(&self, file: &FileFacts) -> String {
        let name = file.shown();
        match self.system {
            _ if self.is_checked(file) => format!("`{name}`"),
            Some(_) if self.checks_system() => format!("the user's `{name}`"),
            _ => format!("the system's `{name}`"),
        }
    }
}
