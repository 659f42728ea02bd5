//! A name of a file in a file, and what the application finds there.

use super::path::resolve;
use super::{FileFacts, Layer};
use mhlint_diag::Place;

/// A name of a file in a file.
#[derive(Debug, Clone)]
pub struct Reference<'a> {
    /// What names it.
    pub kind: ReferenceKind,
    /// Base mesh it is for.
    pub base: &'a str,
    /// File in which the name stands.
    pub from: &'a FileFacts,
    /// Place of the name.
    pub place: Place,
    /// The name as written.
    pub text: &'a str,
    /// What the name belongs to: a combination, a slider, a skeleton.
    pub owner: &'a str,
    /// Place and text of the folder that is put in front, where that is at fault and not the name.
    pub folder_at_fault: Option<(Place, &'a str)>,
    /// Path relative to the data root that the application would open.
    pub rel: String,
    /// What is there.
    pub resolution: Resolution<'a>,
}

/// What names a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ReferenceKind {
    /// `t` in `macro.json`.
    MacroTarget,
    /// `incr` in `modelling.json`.
    Incr,
    /// `decr` in `modelling.json`.
    Decr,
    /// `icon` in `modelling.json`.
    Icon,
    /// `weights_file` in a skeleton (or its default).
    WeightsFile,
    /// `pose-skeleton` in `base.json`.
    PoseSkeleton,
    /// `mhm` in `base.json`.
    Model,
    /// A picture in a material.
    Texture,
    /// The same in a skin, where that makes a difference.
    SkinTexture,
    /// `obj_file` of an asset.
    AssetMesh,
    /// `material` of an asset.
    AssetMaterial,
    /// `vertexboneweights_file` of an asset, or what stands for it.
    AssetWeights,
    /// `uvMap` of a material.
    UvMap,
    /// `skinMaterial` of a model.
    Skin,
    /// `skeleton` of a model.
    ModelSkeleton,
    /// `material` of a model.
    ModelMaterial,
    /// `pose` of a model.
    ModelPose,
    /// `expression` of a model.
    ModelExpression,
    /// A slot of `opposites` in `target.json`.
    Slot,
    /// `name` in `target.json` of a slider without `opposites`.
    SliderName,
}

/// What a reference leads to.
#[derive(Debug, Clone, Copy)]
pub enum Resolution<'a> {
    /// The file; the archive for a target that only the archive holds.
    Found(&'a FileFacts),
    /// A file whose path differs in case only, or in the form of its accented letters.
    CaseOnly(&'a FileFacts),
    /// A file that only a system which takes `\` for a separator finds.
    Backslash(Option<&'a FileFacts>),
    /// Begins with `/` or a drive letter.
    Absolute,
    /// Leaves the data root.
    Escapes,
    /// Nothing in the folder in use, but the file exists in the layer that lost.
    OtherLayer(&'a FileFacts),
    /// Something that cannot be opened: a folder, a broken link, a link that leaves the root.
    Unusable,
    /// Something in the same pack that is no longer there once that is imported or unpacked: a
    /// fault of the pack.
    Moved,
    /// Nothing.
    Missing,
    /// Only system data that was not given could tell.
    NeedsSystem,
}

/// Where the pictures of a material are looked for, below the data root.
#[derive(Debug, Clone)]
pub struct PictureFolders<'a> {
    /// The folder of the material.
    pub own: &'a str,
    /// The one above, where that is asked as well.
    pub above: Option<&'a str>,
    /// The folder of all assets of this sort. A name that begins with `sort` loses its first part
    /// there.
    pub all: String,
    /// What the assets are called.
    pub sort: &'a str,
}

impl ReferenceKind {
    /// Whether it is a morph target.
    pub const fn is_target(self) -> bool {
        matches!(
            self,
            Self::MacroTarget | Self::Incr | Self::Decr | Self::Slot | Self::SliderName
        )
    }
}

impl<'a> Resolution<'a> {
    /// The file that is meant, also where the name is not quite right: that has a finding of its
    /// own.
    pub fn meant(self) -> Option<&'a FileFacts> {
        match self {
            Self::Found(file) | Self::CaseOnly(file) | Self::Backslash(Some(file)) => Some(file),
            _ => None,
        }
    }

    /// What is missing although a pack has it is a fault of the pack.
    pub(super) fn in_pack(self, layers: &[&Layer], from: &FileFacts, text: &str) -> Self {
        let is_moved = |layer: &&Layer| {
            layer
                .pack
                .as_ref()
                .is_some_and(|pack| pack.explains(&layer.path, from, text))
        };
        if matches!(self, Self::Missing) && layers.iter().any(is_moved) {
            Self::Moved
        } else {
            self
        }
    }

    /// How far from the file a place is: what is there outweighs what only another system finds,
    /// and that outweighs nothing at all.
    pub(super) const fn distance(&self) -> u8 {
        match self {
            Self::Found(_) => 0,
            Self::CaseOnly(_) | Self::Backslash(Some(_)) => 1,
            Self::Unusable => 2,
            Self::Absolute | Self::Escapes | Self::Backslash(None) => 3,
            Self::OtherLayer(_) | Self::Moved | Self::Missing | Self::NeedsSystem => 4,
        }
    }
}

impl<'a> Reference<'a> {
    /// A name that leads to a path below the data root, in these layers, strongest first.
    pub(super) fn to(
        layers: &[&'a Layer],
        kind: ReferenceKind,
        base: &'a str,
        from: &'a FileFacts,
        place: Place,
        text: &'a str,
        rel: String,
    ) -> Self {
        let resolution = resolve(layers, text, &rel).in_pack(layers, from, text);
        Self {
            kind,
            base,
            from,
            place,
            text,
            owner: from.stem(),
            folder_at_fault: None,
            rel,
            resolution,
        }
    }

    /// The file, if the name is right.
    pub fn found(&self) -> Option<&'a FileFacts> {
        if let Resolution::Found(file) = self.resolution {
            Some(file)
        } else {
            None
        }
    }

    /// As [`Resolution::meant`].
    pub fn meant(&self) -> Option<&'a FileFacts> {
        self.resolution.meant()
    }
}
