//! Where the bones of a rig lie on the base mesh as it stands, without a target.

use std::collections::BTreeMap;

use mhlint_eval::mpfb::joints::{BoneEnd, Joints, Located, Strategy as How};
use mhlint_eval::mpfb::mix::{USUAL_SCALE, in_blender};
use mhlint_eval::vector::{Point, Vec3, length, sub};
use mhlint_formats::rig::{DefaultPosition, End, Rig, RigBone, Strategy};
use mhlint_repo::mpfb::{RigFile, RigPart, View};

/// The base mesh in Blender's axes, metres.
pub(super) struct Figure<'v> {
    positions: Vec<Point>,
    view: &'v View<'v>,
}

/// A bone with its ends.
pub(super) struct Placed<'r> {
    pub(super) bone: &'r RigBone,
    pub(super) head: Located,
    pub(super) tail: Located,
}

impl<'v> Figure<'v> {
    /// The mesh, if it is whole, and the tables of its joints can be read.
    pub(super) fn of(view: &'v View<'v>) -> Option<Self> {
        let (_, mesh) = view
            .mesh
            .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0 && view.misplaced.is_none())?;
        view.groups?;
        let positions = mesh
            .positions
            .iter()
            .map(|point| in_blender(*point, USUAL_SCALE))
            .collect();
        Some(Self { positions, view })
    }

    /// Its joints.
    pub(super) fn joints(&self) -> Joints<'_> {
        let groups = self.view.groups.iter().flat_map(|groups| &groups.groups);
        Joints::new(
            &self.positions,
            groups.map(|group| (group.name.as_str(), group.ranges.as_slice())),
        )
    }
}

/// A strategy as evaluation has it.
pub(super) fn how(strategy: &Strategy) -> How<'_> {
    match strategy {
        Strategy::Cube(name) => How::Cube(name),
        Strategy::Vertex(vertex) => How::Vertex(*vertex),
        Strategy::Mean(vertices) => How::Mean(vertices),
        Strategy::Xyz(vertices) => How::Xyz(vertices),
        Strategy::Unknown(_) | Strategy::Unfit => How::None,
    }
}

/// An end as evaluation has it.
pub(super) fn end(end: &End) -> BoneEnd<'_> {
    let default_position = match end.default_position {
        DefaultPosition::At(place) => Some(place),
        DefaultPosition::Absent | DefaultPosition::Unfit => None,
    };
    BoneEnd {
        strategy: how(&end.strategy),
        offset: end.offset,
        default_position,
    }
}

/// The scale of the usual figure by that at which a rig was recorded.
pub(super) fn relative_scale(rig: &Rig) -> f64 {
    if rig.scale_factor == 0.0 {
        1.0
    } else {
        f64::from(USUAL_SCALE) / rig.scale_factor
    }
}

/// The bones of a rig of the body where both ends could be read.
pub(super) fn placed<'r>(rig: &'r Rig, joints: &Joints<'_>) -> Vec<Placed<'r>> {
    let scale = relative_scale(rig);
    let at = |one: &Option<End>| Some(joints.locate(&end(one.as_ref()?), scale));
    let bones = rig.bones.iter();
    bones
        .filter_map(|bone| {
            Some(Placed {
                bone,
                head: at(&bone.head)?,
                tail: at(&bone.tail)?,
            })
        })
        .collect()
}

/// The rigs of the body with their bones on the mesh. Those of assets refer to meshes of their own.
pub(super) fn of_body<'v>(view: &'v View<'v>) -> Vec<(&'v RigFile<'v>, &'v Rig, Vec<Placed<'v>>)> {
    let Some(figure) = Figure::of(view) else {
        return Vec::new();
    };
    let joints = figure.joints();
    let rigs = view
        .own_rigs()
        .filter(|(file, _)| file.part != RigPart::Asset);
    rigs.map(|(file, rig)| (file, rig, placed(rig, &joints)))
        .collect()
}

impl Placed<'_> {
    /// Both ends, if they are anywhere, finite.
    pub(super) fn ends(&self) -> Option<(Vec3, Vec3)> {
        let (head, tail) = (self.head.place()?, self.tail.place()?);
        Some((head, tail)).filter(|(head, tail)| head.iter().chain(tail).all(|one| one.is_finite()))
    }

    /// Both ends, if both were found by their strategies.
    pub(super) fn found(&self) -> Option<(Vec3, Vec3)> {
        match (self.head, self.tail) {
            (Located::Found(head), Located::Found(tail)) => Some((head, tail)),
            _ => None,
        }
    }
}

/// Bones by their names, of equal ones the last.
pub(super) fn by_name<'p, 'r>(bones: &'p [Placed<'r>]) -> BTreeMap<&'r str, &'p Placed<'r>> {
    bones
        .iter()
        .map(|placed| (placed.bone.name.as_str(), placed))
        .collect()
}

/// How far two places are from each other.
pub(super) fn apart(a: Vec3, b: Vec3) -> f64 {
    length(sub(a, b))
}

/// `(0.12, -0.30, 1.45)`, metres.
pub(super) fn place_in_words(place: Vec3) -> String {
    format!("({:.2}, {:.2}, {:.2})", place[0], place[1], place[2])
}
