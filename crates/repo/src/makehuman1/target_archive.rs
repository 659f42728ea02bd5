//! `targets.npz`: when MakeHuman 1 takes its targets from there, and when from the texts
//! (`docs/loaders/makehuman1/target-archive.md#when-the-texts-are-used`).

use std::collections::BTreeMap;

use super::targets::NamedTarget;
use crate::{FileFacts, Layer};
use mhlint_discover::TARGETS_NPZ;
use mhlint_formats::npz::ArchiveFault;
use mhlint_formats::npz::targets::{PackedTarget, TargetsNpz};
use mhlint_formats::picture_list::PictureList;
use mhlint_formats::target::name::{Clash, TargetName};

/// The archive of the system's targets.
#[derive(Debug)]
pub struct TargetArchive<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// What is in it.
    pub content: &'a TargetsNpz,
    /// The pictures of sliders that go with it.
    pub pictures: Option<(&'a FileFacts, &'a PictureList)>,
    /// Why the program makes its list of targets from the texts all the same.
    pub unused: Option<Unused<'a>>,
}

/// Why an archive is not used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unused<'a> {
    /// It cannot be opened.
    Closed,
    /// There is no list of pictures that can be read.
    NoPictures,
    /// A member with backslashes in its path, which only Windows takes for folders.
    Backslashes(&'a str),
    /// Two values of one category in the path of a member.
    Member(&'a str, Clash),
    /// The same for a picture.
    Picture(&'a str, Clash),
}

/// The list of pictures.
const PICTURES: &str = "images.list";

static NO_ARCHIVE: TargetsNpz = TargetsNpz {
    targets: BTreeMap::new(),
    fault: Some(ArchiveFault::Empty),
    is_bomb: false,
};
static NO_PICTURES: PictureList = PictureList {
    pictures: Vec::new(),
    is_broken: false,
};

impl<'a> TargetArchive<'a> {
    /// That of a system.
    pub(super) fn of(system: &'a Layer) -> Option<Self> {
        let file = system.file(TARGETS_NPZ)?;
        // A pointer is no archive, and a list of no picture.
        let content = file
            .targets_npz()
            .or_else(|| file.encoding.lfs_pointer.then_some(&NO_ARCHIVE))?;
        let list = |file: &'a FileFacts| {
            let list = file
                .picture_list()
                .or_else(|| file.encoding.lfs_pointer.then_some(&NO_PICTURES))?;
            Some((file, list))
        };
        let pictures = system
            .file(PICTURES)
            .and_then(list)
            .filter(|(_, list)| !list.is_broken);
        let unused = unused(content, pictures.map(|(_, list)| list));
        Some(Self {
            file,
            content,
            pictures,
            unused,
        })
    }

    /// Whether it is empty or a pointer of Git LFS.
    pub const fn is_blank(&self) -> bool {
        self.file.size == 0 || self.file.encoding.lfs_pointer
    }

    /// What it has for a target.
    pub(super) fn member_of(&self, target: &NamedTarget<'_>) -> Option<&'a PackedTarget> {
        self.content.targets.get(target.member())
    }

    /// The targets that it lists.
    pub fn names(&self) -> impl Iterator<Item = &'a str> {
        let listed = self
            .content
            .targets
            .iter()
            .filter(|(_, own)| own.index.is_some());
        listed.map(|(name, _)| name.as_str())
    }
}

fn unused<'a>(content: &'a TargetsNpz, pictures: Option<&'a PictureList>) -> Option<Unused<'a>> {
    if content.fault.is_some() || content.is_bomb {
        return Some(Unused::Closed);
    }
    let Some(pictures) = pictures else {
        return Some(Unused::NoPictures);
    };
    let listed = content
        .targets
        .iter()
        .filter(|(_, own)| own.index.is_some())
        .map(|(name, _)| name.as_str());
    if let Some(name) = content.targets.keys().find(|name| name.contains('\\')) {
        return Some(Unused::Backslashes(name));
    }
    let mut members = listed.filter_map(|name| Some((name, TargetName::of(name).err()?)));
    if let Some((name, clash)) = members.next() {
        return Some(Unused::Member(name, clash));
    }
    let of_picture = |path: &'a str| {
        Some((
            path,
            TargetName::of(path.strip_prefix("data/").unwrap_or(path)).err()?,
        ))
    };
    let clash = pictures.pictures.iter().find_map(|path| of_picture(path));
    clash.map(|(path, clash)| Unused::Picture(path, clash))
}
