//! Rigs with the weights that MPFB finds for them (`docs/loaders/mpfb/rigs.md#where-rigs-lie`,
//! `docs/loaders/mpfb/custom-rigs.md#listing-custom-rigs`,
//! `docs/loaders/mpfb/custom-rigs.md#what-differs`).

use super::view::OWN;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::{FileFacts, Layer, Layers, StoredBones};
use mhlint_discover::Kind;
use mhlint_formats::rig::{Identifying, Rig as Definition};
use mhlint_source::parent;

/// A rig, readable or not.
#[derive(Debug)]
pub struct RigFile<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The layer that it lies in.
    pub layer: &'a Layer,
    /// What it is added to, and who finds it.
    pub part: RigPart,
    /// What MPFB calls it; of one that is added to an asset the name of its file.
    pub name: &'a str,
    /// The weights that are looked for, paths below the data root: the first that is there counts.
    pub wanted_weights: Vec<String>,
}

/// What a rig is added to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RigPart {
    /// The body: one that MPFB brings.
    Standard,
    /// The body: one that Rigify makes a larger one of.
    Rigify,
    /// The body: one of a user.
    Custom,
    /// An asset: it hangs on the rig of the body.
    Asset,
}

/// Rigs whose weights stand in for those that others lack.
const FALLBACKS: [(&str, &str); 3] = [
    ("default_no_toes", "default"),
    ("human", "human_toes"),
    ("human_toes", "human"),
];

impl<'a> RigFile<'a> {
    /// What is in it, if it could be read.
    pub fn definition(&self) -> Option<&'a Definition> {
        self.file.rig()
    }

    /// The weights that MPFB loads.
    pub fn weights(&self) -> Option<&'a FileFacts> {
        self.wanted_weights
            .iter()
            .find_map(|rel| self.layer.file(rel))
    }
}

/// All rigs that MPFB finds: its own in its data, those of users in theirs, and those of assets
/// anywhere.
pub(super) fn all(layers: Layers<'_>) -> Vec<RigFile<'_>> {
    let users = layers.user.into_iter().chain(layers.beside);
    let both = layers.strongest_first().chain(layers.beside);
    let standard = layers
        .system
        .into_iter()
        .flat_map(|layer| of_kind(layer, Kind::Rig));
    let custom = users
        .flat_map(|layer| of_kind(layer, Kind::CustomRig))
        .filter(|(_, file)| is_listed(file) && says_its_bones(file));
    let of_assets = both.flat_map(|layer| of_kind(layer, Kind::SubRig));
    let rig = |(layer, file)| of_file(layer, file);
    standard.chain(custom).chain(of_assets).map(rig).collect()
}

fn of_kind(layer: &Layer, kind: Kind) -> impl Iterator<Item = (&Layer, &FileFacts)> {
    let files = layer
        .files
        .values()
        .filter(move |file| file.kind_in(OWN) == kind && file.kind == kind);
    files.map(move |file| (layer, file))
}

/// Whether a rig of a user is listed: directly in `rigs/`, with a name of letters, digits and `_`.
pub fn is_listed(file: &FileFacts) -> bool {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    parent(&file.rel) == "rigs" && !file.stem().is_empty() && file.stem().bytes().all(is_plain)
}

/// Whether a file says by which bones it is recognised: others are passed over.
fn says_its_bones(file: &FileFacts) -> bool {
    file.rig()
        .is_some_and(|rig| rig.identifying != Identifying::Absent)
}

fn of_file<'a>(layer: &'a Layer, file: &'a FileFacts) -> RigFile<'a> {
    let part = match file.kind {
        Kind::Rig if parent(&file.rel).ends_with("/rigify") => RigPart::Rigify,
        Kind::Rig => RigPart::Standard,
        Kind::CustomRig => RigPart::Custom,
        _ => RigPart::Asset,
    };
    let name = file.stem().strip_prefix("rig.").unwrap_or(file.stem());
    let fallbacks = FALLBACKS
        .iter()
        .filter(|(own, _)| *own == name && part != RigPart::Custom);
    let names = std::iter::once(name).chain(fallbacks.map(|(_, other)| *other));
    let wanted = names.map(|name| format!("{}/weights.{name}.json", parent(&file.rel)));
    let wanted_weights = if part == RigPart::Asset {
        Vec::new()
    } else {
        wanted.collect()
    };
    RigFile {
        file,
        layer,
        part,
        name,
        wanted_weights,
    }
}

/// Endings of the folders of poses behind the name of their rig
/// (`docs/loaders/mpfb/poses.md#stored-poses`).
pub const POSE_ENDINGS: [&str; 3] = ["_fk", "_ik", "_partial"];

/// The rig of the folder that a pose lies in; `None` where the folder is that of no rig.
pub fn rig_of_pose(rel: &str) -> Option<&str> {
    let (folders, _) = rel.strip_prefix("poses/")?.rsplit_once('/')?;
    // A folder in a folder is copied by its own name alone.
    folders.rsplit('/').find_map(|folder| {
        POSE_ENDINGS
            .iter()
            .find_map(|ending| folder.strip_suffix(ending))
    })
}

/// Rigs with the names of their bones, by what folders of poses call them; nothing of those without
/// bones.
pub(super) type OfPoses<'a> = BTreeMap<String, Option<(&'a FileFacts, Arc<BTreeSet<&'a str>>)>>;

/// The rigs that poses can be for.
pub(super) fn of_poses<'a>(rigs: &[RigFile<'a>]) -> OfPoses<'a> {
    let mut by_name = BTreeMap::new();
    for rig in rigs {
        let name = match rig.part {
            RigPart::Standard => rig.name.to_owned(),
            RigPart::Rigify => format!("rigify.{}", rig.name),
            RigPart::Custom | RigPart::Asset => continue,
        };
        by_name.entry(name).or_insert_with(|| {
            let bones = rig.definition()?.bones.iter();
            let names: BTreeSet<&str> = bones.map(|bone| bone.name.as_str()).collect();
            (!names.is_empty()).then(|| (rig.file, Arc::new(names)))
        });
    }
    by_name
}

/// The bones of a stored pose with those of the rig that its folder names, if it is at hand.
pub(super) fn bones_of_pose<'a>(
    rigs: &OfPoses<'a>,
    file: &'a FileFacts,
) -> Option<StoredBones<'a>> {
    let (rig, known) = rigs.get(rig_of_pose(&file.rel)?)?.as_ref()?;
    Some(StoredBones {
        file,
        named: &file.stored_pose()?.bones,
        rig,
        known: Arc::clone(known),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_folder_names_the_rig() {
        assert_eq!(
            rig_of_pose("poses/game_engine_fk/bow.json"),
            Some("game_engine")
        );
        assert_eq!(
            rig_of_pose("poses/more/default_partial/bow.json"),
            Some("default")
        );
        assert_eq!(
            rig_of_pose("poses/default_fk/more/bow.json"),
            Some("default")
        );
        assert_eq!(
            [
                rig_of_pose("poses/bow.json"),
                rig_of_pose("poses/default_FK/bow.json")
            ],
            [None, None]
        );
    }
}
