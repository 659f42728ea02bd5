//! What lies in a pack beside the libraries that are read: manuals, examples, what was put by.

use super::makehuman1::CUSTOM;
use super::{FileFacts, Layer};
use mhlint_diag::{Application, PlaceKind, nearest};
use mhlint_discover::{Layout, extension, libraries, library_extension};

/// Folders of MakeHuman 1 that hold assets for the program itself.
pub const OF_MAKEHUMAN1: &str = "3dobjs";
/// Folders of MPFB that nothing of a user is called nearly as.
const OF_MPFB: [&str; 4] = ["3dobjs", "mesh_metadata", "node_trees", "settings"];

impl Layer {
    /// Whether it is a pack.
    pub fn is_pack_of(&self, application: Application) -> bool {
        self.identities
            .get(&application)
            .is_some_and(|identity| identity.kind == Some(PlaceKind::Pack))
    }

    /// Whether a file lies in a folder of a pack that an application does not read, and that is not
    /// called nearly as one that it reads.
    pub fn is_aside(&self, application: Application, file: &FileFacts) -> bool {
        let Some((top, _)) = file.rel.split_once('/') else {
            return false;
        };
        let is_read = || match application {
            Application::Makehuman2 => true,
            Application::Makehuman1 => {
                is_library(top) || is_own_target(top, file) || nearest(top, libraries()).is_some()
            }
            Application::Mpfb => is_of_mpfb(top),
        };
        self.is_pack_of(application) && !file.is_loose && !is_read()
    }
}

fn is_library(top: &str) -> bool {
    library_extension(top).is_some() || matches!(top, OF_MAKEHUMAN1 | "models")
}

/// Whether it is a target where MakeHuman 1 looks for those of users; assets of other kinds it does
/// not read there.
fn is_own_target(top: &str, file: &FileFacts) -> bool {
    top == CUSTOM && extension(&file.rel) == "target"
}

fn is_of_mpfb(top: &str) -> bool {
    let (own, other) = (
        Layout::of(Application::Mpfb),
        Layout::of(Application::Makehuman1),
    );
    own.has_at_top(top) || other.has_at_top(top) || near_of_mpfb(top).is_some()
}

/// The folder of a user of MPFB that a name is nearly that of.
pub fn near_of_mpfb(top: &str) -> Option<&'static str> {
    nearest(
        top,
        Layout::of(Application::Mpfb)
            .at_top()
            .filter(|one| !OF_MPFB.contains(one)),
    )
}
