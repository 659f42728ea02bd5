//! Rigs on a figure: read, put on the mesh, and as JSON.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Map, Value};

use crate::Error;
use crate::files::{read_document, shown};
use crate::outputs::{object, rounded, vector};
use mhlint_diag::Application;
use mhlint_eval::mpfb::groups::{Taker, Takers};
use mhlint_eval::mpfb::identify::identified;
use mhlint_eval::mpfb::joints::{BoneEnd, Joints, Located, Strategy as How};
use mhlint_eval::mpfb::rest::{Defined, NO_LENGTH, RestBone, Roll, rest};
use mhlint_eval::vector::{Vec3, length, sub};
use mhlint_formats::rig::{self, DefaultPosition, End, Rig, RigBone, Strategy};

/// A rig of MPFB with its path.
#[derive(Debug, Clone)]
pub struct RigFile {
    /// Its path.
    pub path: String,
    /// What is in it.
    pub definition: Rig,
}

/// A rig on a mesh.
#[derive(Debug, Clone)]
pub struct StandingRig {
    /// Its bones in the order of the file.
    pub names: Vec<String>,
    /// The bones at rest, in metres or whatever unit the mesh has.
    pub bones: Vec<RestBone>,
    /// What each takes of the scale of its parent.
    inherit_scale: Vec<String>,
    /// The scale of the mesh by that at which the rig was recorded.
    pub relative_scale: f64,
    /// Ends that are at their default positions.
    pub at_default: Vec<String>,
    /// How many ends there are of each strategy.
    strategies: BTreeMap<&'static str, usize>,
}

/// Reads a rig.
///
/// # Errors
/// A file that cannot be read, and one that stops MPFB.
pub fn read_rig(path: &Path) -> Result<RigFile, Error> {
    let definition = rig::read(&read_document(path)?);
    let is_sound = definition.faults.layout.is_empty()
        && definition.faults.keys.all().is_empty()
        && definition.faults.ends.all().is_empty();
    if !is_sound {
        return Err(Error::file(
            shown(path),
            "MPFB does not read it as a rig; `mhlint check` says why",
        ));
    }
    Ok(RigFile {
        path: shown(path),
        definition,
    })
}

impl RigFile {
    /// The rig on a mesh with its joints, at the scale that one unit of the OBJ comes to.
    ///
    /// # Errors
    /// An end that is nowhere, a bone without length.
    pub fn stand(&self, joints: &Joints<'_>, scale_factor: f64) -> Result<StandingRig, Error> {
        let rig = &self.definition;
        let relative_scale = if rig.scale_factor == 0.0 {
            1.0
        } else {
            scale_factor / rig.scale_factor
        };
        let numbers: BTreeMap<&str, usize> = rig
            .bones
            .iter()
            .enumerate()
            .map(|(at, bone)| (bone.name.as_str(), at))
            .collect();
        let mut standing = StandingRig {
            names: Vec::new(),
            bones: Vec::new(),
            inherit_scale: Vec::new(),
            relative_scale,
            at_default: Vec::new(),
            strategies: BTreeMap::new(),
        };
        let mut defined = Vec::with_capacity(rig.bones.len());
        for bone in &rig.bones {
            let head = standing.place(joints, bone, bone.head.as_ref(), "head")?;
            let tail = standing.place(joints, bone, bone.tail.as_ref(), "tail")?;
            let parent = bone
                .parent
                .as_deref()
                .and_then(|parent| numbers.get(parent))
                .copied();
            defined.push(Defined {
                head,
                tail,
                roll: roll(bone),
                parent,
                use_connect: bone.use_connect,
            });
            standing.names.push(bone.name.clone());
            standing.inherit_scale.push(bone.inherit_scale.clone());
        }
        standing.bones = rest(&defined);
        standing.checked()
    }

    /// The bones that take weights.
    pub(super) fn takers(&self) -> Takers<'_> {
        let bones = self.definition.bones.iter();
        let bones = bones.map(|bone| Taker {
            name: &bone.name,
            parent: bone.parent.as_deref(),
            deforms: true,
        });
        Takers::new(
            bones,
            self.definition.extra_bones.iter().map(String::as_str),
        )
    }
}

/// What decides the turn of a bone.
pub(super) fn roll(bone: &RigBone) -> Roll {
    roll_of(
        bone.roll_strategy.as_deref(),
        bone.roll_reference_z,
        bone.roll,
    )
}

/// The same of what a file says: a strategy, a direction, an angle.
pub(super) fn roll_of(strategy: Option<&str>, reference: Option<Vec3>, angle: f64) -> Roll {
    match (strategy, reference) {
        (Some("ALIGN_Z_WORLD_Z"), _) => Roll::ZUp,
        (Some("ALIGN_X_WORLD_X"), _) => Roll::XLeft,
        (Some("ALIGN_Z_REFERENCE_Z"), Some(reference)) if length(reference) > NO_LENGTH => {
            Roll::ZTo(reference)
        }
        _ => Roll::Angle(angle),
    }
}

fn end_of(end: &End) -> (BoneEnd<'_>, &'static str) {
    let (strategy, name) = match &end.strategy {
        Strategy::Cube(name) => (How::Cube(name), "CUBE"),
        Strategy::Vertex(vertex) => (How::Vertex(*vertex), "VERTEX"),
        Strategy::Mean(vertices) => (How::Mean(vertices), "MEAN"),
        Strategy::Xyz(vertices) => (How::Xyz(vertices), "XYZ"),
        Strategy::Unknown(_) | Strategy::Unfit => (How::None, "DEFAULT"),
    };
    let default_position = match end.default_position {
        DefaultPosition::At(place) => Some(place),
        DefaultPosition::Absent | DefaultPosition::Unfit => None,
    };
    (
        BoneEnd {
            strategy,
            offset: end.offset,
            default_position,
        },
        name,
    )
}

impl StandingRig {
    /// A rig of bones that are defined by their places.
    pub(super) fn of_places(names: Vec<String>, defined: &[Defined]) -> Result<Self, Error> {
        let inherit_scale = vec!["FULL".to_owned(); names.len()];
        let bones = rest(defined);
        let (at_default, strategies) = (Vec::new(), BTreeMap::new());
        Self {
            names,
            bones,
            inherit_scale,
            relative_scale: 1.0,
            at_default,
            strategies,
        }
        .checked()
    }

    fn place(
        &mut self,
        joints: &Joints<'_>,
        bone: &RigBone,
        end: Option<&End>,
        which: &'static str,
    ) -> Result<Vec3, Error> {
        let nowhere = || {
            stops(
                "KeyError",
                format!("`{which}` of bone `{}` has no place", bone.name),
            )
        };
        let (end, name) = end_of(end.ok_or_else(nowhere)?);
        *self.strategies.entry(name).or_default() += 1;
        let located = joints.locate(&end, self.relative_scale);
        if let Located::Default(_) = located {
            self.at_default.push(format!("{} {which}", bone.name));
        }
        located.place().ok_or_else(nowhere)
    }

    /// Blender drops bones without length, and MPFB looks for them.
    fn checked(self) -> Result<Self, Error> {
        let short = self
            .bones
            .iter()
            .position(|bone| length(sub(bone.tail, bone.head)) < NO_LENGTH);
        match short.and_then(|at| self.names.get(at)) {
            Some(name) => Err(stops(
                "AttributeError",
                format!("bone `{name}` has no length"),
            )),
            None => Ok(self),
        }
    }

    /// What MPFB takes it for.
    pub(super) fn identified(&self) -> &'static str {
        identified(self.names.iter().map(String::as_str))
    }

    /// Bones with all that Blender knows of them at rest.
    pub fn json(&self) -> Value {
        let name = |parent: Option<usize>| {
            parent
                .and_then(|at| self.names.get(at))
                .cloned()
                .unwrap_or_default()
        };
        let bone = |(at, bone): (usize, &RestBone)| {
            let fields = object([
                ("head", vector(bone.head)),
                ("tail", vector(bone.tail)),
                ("roll", rounded(bone.roll)),
                (
                    "matrix",
                    bone.matrix.iter().map(|row| vector(*row)).collect(),
                ),
                ("parent", Value::from(name(bone.parent))),
                ("use_connect", Value::from(bone.use_connect)),
                (
                    "inherit_scale",
                    Value::from(self.inherit_scale.get(at).cloned().unwrap_or_default()),
                ),
                ("use_deform", Value::from(true)),
            ]);
            (
                self.names.get(at).cloned().unwrap_or_default(),
                Value::Object(fields),
            )
        };
        Value::Object(self.bones.iter().enumerate().map(bone).collect())
    }

    /// Heads and tails alone, as they were placed.
    pub(super) fn ends_json(&self) -> Value {
        let bone = |(name, bone): (&String, &RestBone)| {
            (
                name.clone(),
                Value::from(vec![vector(bone.head), vector(bone.tail)]),
            )
        };
        Value::Object(self.names.iter().zip(&self.bones).map(bone).collect())
    }

    /// How many ends there are of each strategy.
    pub(super) fn strategies_json(&self) -> Value {
        Value::Object(
            self.strategies
                .iter()
                .map(|(name, count)| ((*name).to_owned(), Value::from(*count)))
                .collect(),
        )
    }

    /// As `mhlint eval rig` shows it.
    pub fn outputs(&self) -> Map<String, Value> {
        object([
            ("relative_scale", rounded(self.relative_scale)),
            ("identified", Value::from(self.identified())),
            (
                "default_position_used",
                Value::from(self.at_default.clone()),
            ),
            ("bones", self.json()),
        ])
    }
}

/// What stops MPFB.
pub(super) fn stops(exception: &'static str, reason: String) -> Error {
    Error::Stops {
        application: Application::Mpfb,
        exception,
        reason,
    }
}

/// A matrix of a bone in a pose: four rows.
pub(super) fn rows(matrix_of: &mhlint_eval::vector::Mat4) -> Value {
    matrix_of
        .iter()
        .map(|row| Value::from(row.map(rounded).to_vec()))
        .collect()
}
