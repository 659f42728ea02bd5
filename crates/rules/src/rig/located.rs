//! Where the bones of a rig lie on the base mesh, with no target applied.

use std::collections::BTreeMap;

use mhlint_eval::mpfb::joints::{BoneEnd, Joints, Located, Strategy as How};
use mhlint_eval::mpfb::mix::{USUAL_SCALE, in_blender};
use mhlint_eval::vector::{Point, Vec3, length, sub};
use mhlint_formats::rig::{DefaultPosition, End, Rig, RigBone, Strategy};
use mhlint_repo::mpfb::{RigFile, RigPart, View};

/// The vertices of the base mesh in the axes of Blender, in metres.
pub(super) struct Figure<'v> {
    positions: Vec<Point>,
    view: &'v View<'v>,
}

/// A bone with the places of its ends.
pub(super) struct Placed<'r> {
    pub(super) bone: &'r RigBone,
    pub(super) head: Located,
    pub(super) tail: Located,
}

impl<'v> Figure<'v> {
    /// The base mesh, if all of it and its table of vertex groups can be read.
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

    /// The joints of the base mesh.
    pub(super) fn joints(&self) -> Joints<'_> {
        let groups = self.view.groups.iter().flat_map(|groups| &groups.groups);
        Joints::new(
            &self.positions,
            groups.map(|group| (group.name.as_str(), group.ranges.as_slice())),
        )
    }
}

/// A strategy in the type that `eval` takes.
pub(super) fn how(strategy: &Strategy) -> How<'_> {
    match strategy {
        Strategy::Cube(name) => How::Cube(name),
        Strategy::Vertex(vertex) => How::Vertex(*vertex),
        Strategy::Mean(vertices) => How::Mean(vertices),
        Strategy::Xyz(vertices) => How::Xyz(vertices),
        Strategy::Unknown(_) | Strategy::Unfit => How::None,
    }
}

/// An end in the type that `eval` takes.
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

/// The scale of the usual figure, divided by the scale at which the rig was recorded.
pub(super) fn relative_scale(rig: &Rig) -> f64 {
    if rig.scale_factor == 0.0 {
        1.0
    } else {
        f64::from(USUAL_SCALE) / rig.scale_factor
    }
}

/// The bones of a rig of the body that have two ends which can be read, with the places of the
/// ends.
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

/// The rigs of the body, with the places of their bones on the base mesh. Rigs of assets are left
/// out, since they refer to the meshes of the assets.
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
    /// The places of both ends, if both have one, also a default one, and all numbers are finite.
    pub(super) fn ends(&self) -> Option<(Vec3, Vec3)> {
        let (head, tail) = (self.head.place()?, self.tail.place()?);
        Some((head, tail)).filter(|(head, tail)| head.iter().chain(tail).all(|one| one.is_finite()))
    }

    /// The places of both ends, if the strategies of both found one.
    pub(super) fn found(&self) -> Option<(Vec3, Vec3)> {
        match (self.head, self.tail) {
            (Located::Found(head), Located::Found(tail)) => Some((head, tail)),
            _ => None,
        }
    }
}

/// Bones by their names; of bones with equal names the last.
pub(super) fn by_name<'p, 'r>(bones: &'p [Placed<'r>]) -> BTreeMap<&'r str, &'p Placed<'r>> {
    bones
        .iter()
        .map(|placed| (placed.bone.name.as_str(), placed))
        .collect()
}

/// The distance between two places.
pub(super) fn apart(a: Vec3, b: Vec3) -> f64 {
    length(sub(a, b))
}

/// A place as text, in metres: `(0.12, -0.30, 1.45)`.
pub(super) fn place_in_words(place: Vec3) -> String {
    format!("({:.2}, {:.2}, {:.2})", place[0], place[1], place[2])
}
