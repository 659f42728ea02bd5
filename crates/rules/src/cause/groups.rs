//! Weights of rigs that lead to bones by more than their names.

use mhlint_eval::mpfb::groups::{MASK, Taker, Takers};
use mhlint_formats::rig::Rig;
use mhlint_repo::FileFacts;

/// The groups that a rig takes.
pub(crate) struct Groups<'a> {
    rig: &'a Rig,
    takers: Takers<'a>,
}

/// Those of a rig of MPFB that has bones.
pub(crate) fn of(file: &FileFacts) -> Option<Groups<'_>> {
    let rig = file.rig().filter(|rig| !rig.bones.is_empty())?;
    let bones = rig.bones.iter().map(|bone| Taker {
        name: &bone.name,
        parent: bone.parent.as_deref(),
        deforms: true,
    });
    Some(Groups {
        rig,
        takers: Takers::new(bones, rig.extra_bones.iter().map(String::as_str)),
    })
}

/// Whether weights of this group are used.
pub(crate) fn take(takers: &Takers<'_>, group: &str) -> bool {
    group.starts_with(MASK) || takers.taker(group).is_some()
}

impl<'a> Groups<'a> {
    /// Names of the bones.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        self.rig.bones.iter().map(|bone| bone.name.as_str())
    }

    /// What the groups of weights lead to.
    pub(crate) const fn takers(&self) -> &Takers<'a> {
        &self.takers
    }

    /// Whether weights of this group are used.
    pub(crate) fn take(&self, group: &str) -> bool {
        take(&self.takers, group)
    }
}
