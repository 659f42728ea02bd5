//! Names of pose units: they tell a pose of the body from one of the face, which are written alike.

use std::collections::BTreeSet;

use super::place::Place;
use mhlint_discover::Single;
use mhlint_formats::{mhpose, pose_units};
use mhlint_json::parse;
use mhlint_source::{Entry, Limits, Tree};

/// The units of the system data.
#[derive(Default)]
pub(super) struct UnitNames {
    body: BTreeSet<String>,
    face: BTreeSet<String>,
}

impl UnitNames {
    /// Those of these data roots.
    pub(super) fn of(systems: &[Place<'_>], limits: &Limits) -> Self {
        let mut names = Self::default();
        for place in systems {
            let single = |rel: &str| place.layouts.iter().find_map(|layout| (layout.single)(rel));
            for file in place.files() {
                let own = match single(&file.rel) {
                    Some(Single::Poses) => &mut names.body,
                    Some(Single::Expressions) => &mut names.face,
                    _ => continue,
                };
                let bytes = place.tree.read(file.entry, limits).unwrap_or_default();
                let units = parse(&bytes)
                    .map(|document| pose_units::read(&document).units)
                    .unwrap_or_default();
                own.extend(units.into_iter().map(|unit| unit.name));
            }
        }
        names
    }

    /// The list that a pose belongs to, if its units are those of the body alone.
    pub(super) fn list_of(
        &self,
        tree: &Tree,
        pose: &Entry,
        limits: &Limits,
    ) -> Option<&'static str> {
        if self.body.is_empty() {
            return None;
        }
        let document = parse(&tree.read(pose, limits).ok()?).ok()?;
        let units: Vec<String> = mhpose::read(&document)
            .values
            .into_iter()
            .map(|value| value.unit)
            .collect();
        let is_of_body = units.iter().any(|unit| self.body.contains(unit));
        (is_of_body && !units.iter().any(|unit| self.face.contains(unit))).then_some("poses")
    }
}
