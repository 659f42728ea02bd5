//! From setting to setting with few additions: settings are ordered by what they add to the mesh,
//! and of two neighbours only the difference is taken back and added.
//!
//! Macros come before detail sliders here, the other way round than in the application, because
//! most settings share their macros. Of the sum that changes only the last bit.

use std::borrow::Cow;

use super::macros::MacroWork;
use super::morph::moved;
use super::scene::{Scene, Setting};
use super::vector::{Point, round_to_f32};

/// Vertex and displacement.
type Row = (u32, Point);

/// The targets of a scene, made ready to be added: one row a vertex, in ascending order, inside the
/// mesh.
#[derive(Debug)]
pub(super) struct Addable<'s> {
    scene: &'s Scene,
    /// `None` where the application stops.
    rows: Vec<Option<Cow<'s, [Row]>>>,
}

/// A setting by what it adds to the mesh.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Stop {
    addends: Vec<Addend>,
    /// Number of the setting; of settings that add the same the first.
    pub(super) setting: usize,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Addend {
    target: usize,
    /// The factor as the application stores it.
    factor: u32,
}

/// Brings settings into the order in which a walk costs least; those that add the same become one.
pub fn in_order(mut stops: Vec<Stop>) -> Vec<Stop> {
    stops.sort_unstable();
    stops.dedup_by(|later, first| later.addends == first.addends);
    stops
}

impl Stop {
    /// How many targets it adds.
    pub fn target_count(&self) -> usize {
        self.addends.len()
    }

    /// Targets that it adds, but for those that it begins with like another stop: they stay when
    /// the walk goes on.
    pub(super) fn targets_unlike(&self, other: &Self) -> impl Iterator<Item = usize> {
        let common = self
            .addends
            .iter()
            .zip(&other.addends)
            .take_while(|(own, others)| own == others)
            .count();
        self.addends.iter().skip(common).map(|addend| addend.target)
    }
}

impl<'s> Addable<'s> {
    pub(super) fn new(scene: &'s Scene) -> Self {
        let rows = scene
            .targets
            .iter()
            .map(|target| one_a_vertex(target.rows.as_deref()?, scene.positions.len()));
        Self {
            scene,
            rows: rows.collect(),
        }
    }

    /// What a setting adds. `None` where the application stops.
    pub(super) fn stop(
        &self,
        number: usize,
        setting: &Setting,
        work: &mut MacroWork,
    ) -> Option<Stop> {
        let mut factors = self.scene.macro_factors(setting, work).ok()?;
        factors.extend(self.scene.detail_factors(setting));
        factors.retain(|(target, _)| {
            !self
                .scene
                .targets
                .get(*target)
                .is_some_and(|target| target.suspect)
        });
        let addend = |(target, factor): (usize, f64)| {
            self.rows.get(target)?.as_ref()?;
            Some(Addend {
                target,
                factor: round_to_f32(factor).to_bits(),
            })
        };
        Some(Stop {
            addends: factors.into_iter().map(addend).collect::<Option<_>>()?,
            setting: number,
        })
    }

    pub(super) fn rows(&self, target: usize) -> &[Row] {
        self.rows
            .get(target)
            .and_then(Option::as_deref)
            .unwrap_or_default()
    }
}

/// Of several rows for a vertex the last counts. `None` with a vertex outside the mesh.
fn one_a_vertex(rows: &[Row], vertices: usize) -> Option<Cow<'_, [Row]>> {
    if rows.iter().any(|(vertex, _)| *vertex as usize >= vertices) {
        return None;
    }
    if rows.is_sorted_by(|a, b| a.0 < b.0) {
        return Some(Cow::Borrowed(rows));
    }
    // The sort is stable: from the back, the last row of a vertex comes first.
    let mut sorted: Vec<Row> = rows.iter().rev().copied().collect();
    sorted.sort_by_key(|(vertex, _)| *vertex);
    sorted.dedup_by_key(|(vertex, _)| *vertex);
    Some(Cow::Owned(sorted))
}

/// The mesh on its way from stop to stop.
#[derive(Debug)]
pub(super) struct Walk<'s> {
    targets: &'s Addable<'s>,
    positions: Vec<Point>,
    /// What has been added, and how it is taken back.
    added: Vec<(Addend, Undo)>,
    /// Vertices and where they were before an addition.
    before: Vec<Row>,
    /// The whole mesh before the first addition of [`Undo::Whole`].
    whole: Vec<Point>,
    /// Targets that were added or taken back by the last step.
    changed: Vec<usize>,
}

/// How an addition is taken back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Undo {
    /// From this place in `before` on are the vertices that it moved.
    Rows(usize),
    /// With all that are so, by the copy of the whole mesh.
    Whole,
}

impl<'s> Walk<'s> {
    pub(super) fn new(targets: &'s Addable<'s>) -> Self {
        let positions = targets.scene.positions.clone();
        Self {
            targets,
            positions,
            added: Vec::new(),
            before: Vec::new(),
            whole: Vec::new(),
            changed: Vec::new(),
        }
    }

    /// Goes to a stop. What the `next` stop does not share is added so that it is cheap to take
    /// back.
    pub(super) fn to(&mut self, stop: &Stop, next: Option<&Stop>) {
        self.changed.clear();
        let common = self
            .added
            .iter()
            .zip(&stop.addends)
            .take_while(|((known, _), wanted)| known == *wanted)
            .count();
        self.take_back(common);
        let common = common.min(self.added.len());
        let shared = next.map_or(0, |next| {
            stop.addends
                .iter()
                .zip(&next.addends)
                .take_while(|(ours, theirs)| ours == theirs)
                .count()
        });
        let (stay, pass) = stop
            .addends
            .split_at(shared.clamp(common, stop.addends.len()));
        stay.iter()
            .skip(common)
            .for_each(|addend| self.add(*addend));
        let rows: usize = pass
            .iter()
            .map(|addend| self.targets.rows(addend.target).len())
            .sum();
        if rows > self.positions.len() {
            self.whole.clone_from(&self.positions);
            pass.iter().for_each(|addend| self.pass(*addend));
        } else {
            pass.iter().for_each(|addend| self.add(*addend));
        }
    }

    fn add(&mut self, addend: Addend) {
        let factor = f32::from_bits(addend.factor);
        let rows = self.targets.rows(addend.target);
        self.added.push((addend, Undo::Rows(self.before.len())));
        self.changed.push(addend.target);
        let positions = &mut self.positions;
        self.before.extend(rows.iter().map(|(vertex, delta)| {
            let place = &mut positions[*vertex as usize];
            let before = *place;
            *place = moved(before, factor, *delta);
            (*vertex, before)
        }));
    }

    fn pass(&mut self, addend: Addend) {
        let factor = f32::from_bits(addend.factor);
        self.added.push((addend, Undo::Whole));
        self.changed.push(addend.target);
        for (vertex, delta) in self.targets.rows(addend.target) {
            let place = &mut self.positions[*vertex as usize];
            *place = moved(*place, factor, *delta);
        }
    }

    /// Takes back all but the first `keep` additions. Those by the whole mesh are the last and go
    /// together, whatever of them is to be kept: it is added again.
    fn take_back(&mut self, keep: usize) {
        if self
            .added
            .last()
            .is_some_and(|(_, undo)| *undo == Undo::Whole)
        {
            self.positions.copy_from_slice(&self.whole);
        }
        let is_whole = |added: &(Addend, Undo)| added.1 == Undo::Whole;
        while self.added.len() > keep || self.added.last().is_some_and(is_whole) {
            let Some((addend, undo)) = self.added.pop() else {
                return;
            };
            self.changed.push(addend.target);
            let Undo::Rows(start) = undo else { continue };
            for (vertex, before) in self.before.drain(start..) {
                self.positions[vertex as usize] = before;
            }
        }
    }

    pub(super) fn positions(&self) -> &[Point] {
        &self.positions
    }

    /// Vertices that the last step moved, some of them several times.
    pub(super) fn moved(&self) -> impl Iterator<Item = u32> {
        let rows = self
            .changed
            .iter()
            .flat_map(|target| self.targets.rows(*target));
        rows.map(|(vertex, _)| *vertex)
    }

    /// How many vertices [`Walk::moved`] gives.
    pub(super) fn moved_count(&self) -> usize {
        self.changed
            .iter()
            .map(|target| self.targets.rows(*target).len())
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::scene::{MorphTarget, SceneSlider, SliderKind};
    use super::*;

    fn scene() -> Scene {
        let target = |rows: &[Row]| MorphTarget {
            rows: Some(Arc::new(rows.to_vec())),
            ..MorphTarget::default()
        };
        let slider = |incr| SceneSlider {
            pattern: String::new(),
            kind: SliderKind::Detail {
                incr: Some(incr),
                decr: None,
                two_sided: false,
            },
            default: 0.0,
        };
        Scene {
            positions: vec![[0.1, 0.2, 0.3]; 3],
            targets: vec![
                target(&[(0, [0.7, 0.0, 0.1]), (1, [0.3; 3])]),
                target(&[(1, [5.0; 3]), (0, [1.0; 3]), (1, [0.3, 0.1, 0.0])]),
                target(&[(7, [1.0; 3])]),
                MorphTarget::default(),
            ],
            sliders: (0..4).map(slider).collect(),
            ..Scene::default()
        }
    }

    fn setting(details: [f64; 4]) -> Setting {
        Setting {
            macros: Vec::new().into(),
            details: (0..).zip(details).collect(),
        }
    }

    #[test]
    fn every_stop_has_the_mesh_of_its_setting() {
        let scene = scene();
        let targets = Addable::new(&scene);
        let mut walk = Walk::new(&targets);
        for details in [
            [0.3, 0.7, 0.0, 0.0],
            [0.3, 0.1, 0.0, 0.0],
            [0.0, 0.9, 0.0, 0.0],
            [0.0; 4],
        ] {
            let setting = setting(details);
            walk.to(
                &targets
                    .stop(0, &setting, &mut MacroWork::default())
                    .unwrap(),
                None,
            );
            assert_eq!(walk.positions(), scene.morphed(&setting).unwrap());
        }
    }

    #[test]
    fn only_the_difference_is_moved() {
        let scene = scene();
        let targets = Addable::new(&scene);
        let mut walk = Walk::new(&targets);
        let mut go = |details| {
            let stop = targets
                .stop(0, &setting(details), &mut MacroWork::default())
                .unwrap();
            walk.to(&stop, Some(&stop));
            (walk.moved().collect::<Vec<u32>>(), walk.moved_count())
        };
        assert_eq!(go([1.0, 0.0, 0.0, 0.0]), (vec![0, 1], 2));
        assert_eq!(go([1.0, 1.0, 0.0, 0.0]), (vec![0, 1], 2));
        assert_eq!(go([1.0, 0.5, 0.0, 0.0]), (vec![0, 1, 0, 1], 4));
        assert_eq!(go([1.0, 0.5, 0.0, 0.0]), (vec![], 0));
    }

    #[test]
    fn a_target_that_cannot_be_added_stops_the_settings_that_need_it() {
        let scene = scene();
        let targets = Addable::new(&scene);
        let stop = |details| targets.stop(0, &setting(details), &mut MacroWork::default());
        assert_eq!(stop([1.0, 0.0, 0.5, 0.0]), None);
        assert_eq!(stop([1.0, 0.0, 0.0, 0.5]), None);
        assert!(stop([1.0, 0.0, 0.0, -0.5]).is_some());
    }

    #[test]
    fn settings_that_add_the_same_are_one_stop() {
        let scene = scene();
        let targets = Addable::new(&scene);
        let stop = |number, value| {
            targets.stop(
                number,
                &setting([value, 0.0, 0.0, 0.0]),
                &mut MacroWork::default(),
            )
        };
        let stops = in_order(
            [stop(0, 0.5), stop(1, 0.25), stop(2, 0.5)]
                .map(Option::unwrap)
                .to_vec(),
        );
        assert_eq!(
            stops.iter().map(|stop| stop.setting).collect::<Vec<_>>(),
            [1, 0]
        );
    }
}
