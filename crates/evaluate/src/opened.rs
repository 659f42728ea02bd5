//! A base mesh opened for settings, with the trees that its files are read from.
//!
//! Rows of targets come when a setting needs them (`rows`).

use std::collections::BTreeMap;

use super::data::SkeletonFile;
use super::error::Error;
use super::files::read_cause;
use mhlint_diag::Application;
use mhlint_discover::extension;
use mhlint_eval::scene::Scene;
use mhlint_formats::macro_json::MacroFile;
use mhlint_formats::mhbin;
use mhlint_formats::obj::text::text_of;
use mhlint_formats::target::MeshSize;
use mhlint_source::{Entry, Limits, Tree};

/// What is said of a file without a mesh that can be used.
pub(super) const NO_MESH: &str = "it contains no usable mesh";

/// A base mesh ready for settings.
#[derive(Debug)]
pub struct Evaluation {
    /// Whose data are evaluated.
    pub(super) application: Application,
    pub(super) trees: Vec<Tree>,
    pub(super) limits: Limits,
    pub(super) base: String,
    pub(super) size: MeshSize,
    pub(super) scene: Scene,
    /// Other names of sliders, each with the patterns that it stands for.
    pub(super) keys: Vec<(String, Vec<String>)>,
    pub(super) macros: Result<MacroNames, String>,
    pub(super) mesh_path: String,
    pub(super) skeleton: Result<SkeletonFile, String>,
    /// Why the application stops when it binds the weights.
    pub(super) weights_fault: Option<Error>,
    /// The archive that the application reads in place of target files, and the targets in it with
    /// their members.
    pub(super) archive: Option<(String, BTreeMap<String, String>)>,
    /// Vertex groups that are not those of the mesh file, each with its ranges.
    pub(super) groups: Vec<(String, Vec<(i64, i64)>)>,
}

/// What macros are called in their file.
#[derive(Debug)]
pub(super) enum MacroNames {
    /// Components and definitions.
    Components(MacroFile),
    /// Those of MakeHuman 1, which are always the same.
    Variables,
    /// The names of each setting, numbered as in its parts.
    Parts(Vec<Vec<String>>),
}

impl Evaluation {
    /// The same, with the trees that its files are read from.
    #[must_use]
    pub fn reading(self, trees: Vec<Tree>) -> Self {
        Self { trees, ..self }
    }

    /// Name of the base.
    pub fn base(&self) -> &str {
        &self.base
    }

    /// The arrays that are evaluated.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Path of the mesh: `base.obj`, or the archive that is read in its place.
    pub fn mesh_path(&self) -> &str {
        &self.mesh_path
    }

    /// The pose skeleton of the base.
    ///
    /// # Errors
    /// There is none, or it cannot be used.
    pub fn pose_skeleton(&self) -> Result<&SkeletonFile, Error> {
        let missing = |reason: &String| Error::NoSkeleton {
            base: self.base.clone(),
            reason: reason.clone(),
        };
        self.skeleton.as_ref().map_err(missing)
    }

    /// The mesh as OBJ text: the bytes of `base.obj`, or what an archive comes to.
    ///
    /// # Errors
    /// When it cannot be read any more.
    pub fn mesh_text(&self) -> Result<Vec<u8>, Error> {
        let gone = || Error::file(&self.mesh_path, "it no longer exists");
        let (tree, entry) = self.entry(&self.mesh_path).ok_or_else(gone)?;
        let read = tree.read(entry, &self.limits);
        let bytes = read.map_err(|fault| Error::file(&self.mesh_path, read_cause(&fault)))?;
        if extension(&self.mesh_path) != "mhbin" {
            return Ok(bytes);
        }
        let mesh = mhbin::parse(&bytes, &self.limits);
        Ok(text_of(&mesh.map_err(|_| Error::file(&self.mesh_path, NO_MESH))?).into_bytes())
    }

    /// The listed file at a printed path.
    pub(super) fn entry(&self, path: &str) -> Option<(&Tree, &Entry)> {
        self.trees
            .iter()
            .find_map(|tree| Some((tree, tree.entry(tree.below(path)?)?)))
    }
}
