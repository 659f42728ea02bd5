//! A look at settings, one after the other: what a step does not touch is as it was before.

use std::collections::{BTreeMap, BTreeSet};

use super::skeleton::PARALLEL_SINE;
use super::survey::{
    DETACHED_DIAGONALS, DETACHED_STANDS, DRIFT_STANDS, EXPLOSION_DIAGONALS, FLIPPED_SHARE, Fault,
    SHORTEST_BONE, Survey, Trouble, Worst, add,
};
use super::surveyor::{Anchor, FaceAtRest, Surveyor, flatness, stand};
use super::vector::{Point, distance, dot, sub};
use super::walk::{Stop, Walk};

/// A step that moves more than this part of the vertices is looked at as a whole.
const LARGE_STEP: usize = 4;

/// More vertices than these are no tail. How they hang together is looked at in every setting.
const MOST_HIDDEN: usize = 1 << 12;

/// Looks at stops, best in the order of [`super::walk::in_order`].
pub fn look<'s>(surveyor: &'s Surveyor<'s>, stops: &[Stop]) -> Survey {
    let mut look = Look::new(surveyor);
    for (number, stop) in stops.iter().enumerate() {
        look.at(stop, stops.get(number + 1));
    }
    look.survey
}

/// What is seen of the mesh as it stands.
struct Look<'s> {
    surveyor: &'s Surveyor<'s>,
    walk: Walk<'s>,
    /// Whether nothing has been looked at yet.
    new: bool,
    /// Number of this step, and the last step in which each face was judged alone.
    step: u32,
    judged: Vec<u32>,
    /// Vertices that may have exploded or are not finite.
    strays: BTreeSet<u32>,
    /// Faces at fault, by their number among the visible ones.
    collapsed: BTreeSet<u32>,
    flipped: BTreeSet<u32>,
    /// Joints and bones at fault, whatever the setting.
    skeleton: Survey,
    /// The same for what is worn.
    worn: Survey,
    survey: Survey,
}

impl<'s> Look<'s> {
    fn new(surveyor: &'s Surveyor<'s>) -> Self {
        Self {
            surveyor,
            walk: Walk::new(&surveyor.targets),
            new: true,
            step: 0,
            judged: vec![0; surveyor.faces.len()],
            strays: BTreeSet::new(),
            collapsed: BTreeSet::new(),
            flipped: BTreeSet::new(),
            skeleton: Survey::new(),
            worn: Survey::new(),
            survey: Survey::new(),
        }
    }

    fn at(&mut self, stop: &Stop, next: Option<&Stop>) {
        self.walk.to(stop, next);
        if self.new || self.walk.moved_count() > self.walk.positions().len() / LARGE_STEP {
            self.all();
        } else {
            self.touched();
        }
        self.new = false;
        self.tell(stop.setting);
    }

    fn all(&mut self) {
        self.strays.clear();
        self.collapsed.clear();
        self.flipped.clear();
        let (surveyor, positions) = (self.surveyor, self.walk.positions());
        for (vertex, point) in (0..).zip(positions) {
            if !surveyor.in_range(*point) {
                self.strays.insert(vertex);
            }
        }
        for (number, face) in (0..).zip(&surveyor.faces) {
            match state(surveyor, positions, face) {
                State::Fine => {}
                State::Collapsed => _ = self.collapsed.insert(number),
                State::Flipped => _ = self.flipped.insert(number),
            }
        }
        self.skeleton();
        self.worn();
    }

    /// The same for what the last step moved.
    fn touched(&mut self) {
        let (surveyor, positions) = (self.surveyor, self.walk.positions());
        let (mut holds_joint, mut holds_probe) = (false, false);
        self.step += 1;
        for vertex in self.walk.moved() {
            let at = vertex as usize;
            mark(
                &mut self.strays,
                vertex,
                !positions
                    .get(at)
                    .is_some_and(|point| surveyor.in_range(*point)),
            );
            holds_joint |= surveyor.holds_joint.get(at).is_some_and(|holds| *holds);
            holds_probe |= surveyor.holds_probe.get(at).is_some_and(|holds| *holds);
            for number in surveyor.faces_of(vertex) {
                let at = *number as usize;
                let Some((face, judged)) = surveyor.faces.get(at).zip(self.judged.get_mut(at))
                else {
                    continue;
                };
                if *judged != self.step {
                    *judged = self.step;
                    let state = state(surveyor, positions, face);
                    mark(&mut self.collapsed, *number, state == State::Collapsed);
                    mark(&mut self.flipped, *number, state == State::Flipped);
                }
            }
        }
        if holds_joint {
            self.skeleton();
        }
        if holds_probe {
            self.worn();
        }
    }

    fn worn(&mut self) {
        self.worn.clear();
        let positions = self.walk.positions();
        for (element, probe) in self.surveyor.probes.iter().enumerate() {
            let value = probe.drift(positions);
            let is_far =
                value * probe.anchor.stand > f64::from(self.surveyor.diagonal * DETACHED_DIAGONALS);
            if value > DETACHED_STANDS && is_far {
                add_one(
                    &mut self.worn,
                    Trouble::Detached(probe.asset),
                    value,
                    element,
                );
            }
        }
    }

    fn skeleton(&mut self) {
        self.skeleton.clear();
        let positions = self.walk.positions();
        let Some((skeleton, joints)) = self
            .surveyor
            .scene
            .skeleton
            .as_ref()
            .zip(self.surveyor.joints(positions))
        else {
            return;
        };
        for (anchor, helper) in self.surveyor.anchors.iter().zip(&self.surveyor.helpers) {
            let Some(joint) = joints.get(anchor.joint) else {
                continue;
            };
            let drift = |anchor: &Anchor| {
                (stand(*joint, &anchor.skin, positions) - anchor.distance) / anchor.stand
            };
            let value = drift(anchor);
            if value > DRIFT_STANDS
                && helper
                    .as_ref()
                    .is_none_or(|helper| drift(helper) > DRIFT_STANDS)
            {
                add_one(&mut self.skeleton, Trouble::Drifted, value, anchor.joint);
            }
        }
        for (element, bone) in skeleton.bones.iter().enumerate() {
            let Some((head, tail)) = joints.get(bone.head).zip(joints.get(bone.tail)) else {
                continue;
            };
            let length = distance(*head, *tail);
            let known = |list: &[bool]| list.get(element).is_some_and(|known| *known);
            if length < SHORTEST_BONE && !known(&self.surveyor.short_at_rest) {
                add_one(
                    &mut self.skeleton,
                    Trouble::ShortBone,
                    1.0 / length,
                    element,
                );
            }
            let sine = bone.plane.map_or(1.0, |plane| flatness(&joints, plane));
            // A coincidence of joints is not finite: it counts as in line.
            if !(sine > PARALLEL_SINE || known(&self.surveyor.flat_at_rest)) {
                add_one(
                    &mut self.skeleton,
                    Trouble::FlatPlane,
                    1.0 / sine.max(0.0),
                    element,
                );
            }
        }
    }

    /// Adds what is seen at a setting to the survey.
    fn tell(&mut self, setting: usize) {
        // Where vertices are not finite, everything else follows from that.
        if self.non_finite(setting) {
            return;
        }
        let collapsed = Faces::of(self.surveyor, &self.collapsed);
        if collapsed.count > 0 {
            let worst = collapsed.worst(f64::from(collapsed.count), setting);
            add(
                &mut self.survey,
                Trouble::Collapsed,
                worst,
                numbers(self.surveyor, &self.collapsed),
            );
        }
        let flipped = Faces::of(self.surveyor, &self.flipped);
        let share = flipped.area / self.surveyor.area;
        if share > FLIPPED_SHARE {
            add(
                &mut self.survey,
                Trouble::Flipped,
                flipped.worst(share, setting),
                numbers(self.surveyor, &self.flipped),
            );
        }
        self.explosion(setting);
        for (trouble, Fault { worst, elements }) in self.skeleton.iter().chain(&self.worn) {
            let worst = worst.iter().map(|worst| Worst {
                setting,
                ..worst.clone()
            });
            worst
                .for_each(|worst| add(&mut self.survey, *trouble, worst, elements.iter().copied()));
        }
    }

    fn strays(&self) -> impl Iterator<Item = (usize, Point)> {
        let positions = self.walk.positions();
        self.strays
            .iter()
            .filter_map(|vertex| Some((*vertex as usize, *positions.get(*vertex as usize)?)))
    }

    fn non_finite(&mut self, setting: usize) -> bool {
        let bad = self
            .strays()
            .filter(|(_, point)| !(point[0] + point[1] + point[2]).is_finite());
        let bad: Vec<usize> = bad.map(|(vertex, _)| vertex).collect();
        let (Some(element), count) = (bad.first().copied(), bad.len()) else {
            return false;
        };
        add(
            &mut self.survey,
            Trouble::NonFinite,
            Worst {
                value: count as f64,
                element,
                count,
                setting,
            },
            bad,
        );
        true
    }

    fn explosion(&mut self, setting: usize) {
        let surveyor = self.surveyor;
        let mut outside_by = BTreeMap::new();
        for (vertex, point) in self.strays() {
            let mut outside = 0.0_f32;
            for axis in 0..3 {
                outside = outside
                    .max(surveyor.low[axis] - point[axis])
                    .max(point[axis] - surveyor.high[axis]);
            }
            if outside > surveyor.diagonal * EXPLOSION_DIAGONALS {
                outside_by.insert(vertex, outside);
            }
        }
        self.leave_what_grew(&mut outside_by);
        // Of equals the first.
        let worst = outside_by
            .iter()
            .rev()
            .max_by(|one, other| one.1.total_cmp(other.1));
        if let Some((element, outside)) = worst.map(|(vertex, outside)| (*vertex, *outside)) {
            let (value, count) = (f64::from(outside / surveyor.diagonal), outside_by.len());
            let worst = Worst {
                value,
                element,
                count,
                setting,
            };
            add(
                &mut self.survey,
                Trouble::Exploded,
                worst,
                outside_by.into_keys(),
            );
        }
    }

    /// Takes out what is not drawn and moves as what is next to it does: a helper that grows, such
    /// as a tail.
    fn leave_what_grew(&self, outside_by: &mut BTreeMap<usize, f32>) {
        let is_drawn = |vertex: u32| !self.surveyor.faces_of(vertex).is_empty();
        let hidden = outside_by
            .keys()
            .filter_map(|vertex| u32::try_from(*vertex).ok());
        let hidden: BTreeSet<u32> = hidden.filter(|vertex| !is_drawn(*vertex)).collect();
        if hidden.is_empty() || hidden.len() > MOST_HIDDEN {
            return;
        }
        let (rest, now) = (&self.surveyor.scene.positions, self.walk.positions());
        let moved =
            |vertex: u32| Some(sub(*now.get(vertex as usize)?, *rest.get(vertex as usize)?));
        let torn = self.surveyor.neighbours().torn(&hidden, 0.0, moved);
        for vertex in hidden.difference(&torn) {
            outside_by.remove(&(*vertex as usize));
        }
    }
}

fn add_one(survey: &mut Survey, trouble: Trouble, value: f64, element: usize) {
    add(
        survey,
        trouble,
        Worst {
            value,
            element,
            count: 1,
            setting: 0,
        },
        [element],
    );
}

fn mark(set: &mut BTreeSet<u32>, number: u32, is_in: bool) {
    if is_in {
        set.insert(number);
    } else if !set.is_empty() {
        set.remove(&number);
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Fine,
    Collapsed,
    Flipped,
}

#[inline]
fn state(surveyor: &Surveyor<'_>, positions: &[Point], face: &FaceAtRest) -> State {
    let now = surveyor.doubled_area(positions, face);
    if dot(now, now) <= face.collapse {
        State::Collapsed
    } else if dot(now, face.vector) < 0.0 {
        State::Flipped
    } else {
        State::Fine
    }
}

/// Faces of one kind at one setting: how many, their area at rest, and the largest.
#[derive(Default)]
struct Faces {
    count: u32,
    area: f64,
    largest: (f32, u32),
}

impl Faces {
    fn of(surveyor: &Surveyor<'_>, places: &BTreeSet<u32>) -> Self {
        let mut all = Self::default();
        for face in faces(surveyor, places) {
            all.count += 1;
            all.area += f64::from(face.square.sqrt());
            if face.square > all.largest.0 {
                all.largest = (face.square, face.face);
            }
        }
        all
    }

    fn worst(&self, value: f64, setting: usize) -> Worst {
        Worst {
            value,
            element: self.largest.1 as usize,
            count: self.count as usize,
            setting,
        }
    }
}

/// Faces by their places among the visible ones.
fn faces<'a>(
    surveyor: &'a Surveyor<'_>,
    places: &'a BTreeSet<u32>,
) -> impl Iterator<Item = &'a FaceAtRest> {
    places
        .iter()
        .filter_map(|place| surveyor.faces.get(*place as usize))
}

/// Their numbers in the mesh.
fn numbers<'a>(
    surveyor: &'a Surveyor<'_>,
    places: &'a BTreeSet<u32>,
) -> impl Iterator<Item = usize> + 'a {
    faces(surveyor, places).map(|face| face.face as usize)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::macros::MacroWork;
    use super::super::scene::{MorphTarget, Scene, SceneSlider, Setting, SliderKind};
    use super::super::skeleton::{Bone, SceneSkeleton};
    use super::super::survey::merge;
    use super::super::walk::in_order;
    use super::*;

    /// A sheet of 10 x 10 vertices with a bone over one edge, and a slider for each of `targets`.
    fn scene(targets: &[&[(u32, Point)]]) -> Scene {
        let corner = |row: u32, column: u32| 10 * row + column;
        let quads = (0..9).flat_map(|row| (0..9).map(move |column| (row, column)));
        let corners = quads.flat_map(|(row, column)| {
            [
                corner(row, column),
                corner(row, column + 1),
                corner(row + 1, column + 1),
                corner(row + 1, column),
            ]
        });
        let slider = |incr| SceneSlider {
            pattern: String::new(),
            kind: SliderKind::Detail {
                incr: Some(incr),
                decr: None,
                two_sided: false,
            },
            default: 0.0,
        };
        let target = |rows: &&[(u32, Point)]| MorphTarget {
            rows: Some(Arc::new(rows.to_vec())),
            ..MorphTarget::default()
        };
        Scene {
            positions: (0..100_u8)
                .map(|at| [f32::from(at % 10), f32::from(at / 10), 0.0])
                .collect(),
            corners: corners.collect(),
            face_starts: (0..=81).map(|face| 4 * face).collect(),
            face_groups: vec![0; 81],
            visible: vec![true],
            targets: targets.iter().map(target).collect(),
            sliders: (0..targets.len()).map(slider).collect(),
            skeleton: Some(SceneSkeleton {
                bones: vec![Bone {
                    parent: None,
                    head: 0,
                    tail: 1,
                    plane: None,
                }],
                joints: vec![vec![98], vec![99]],
                ..SceneSkeleton::default()
            }),
            ..Scene::default()
        }
    }

    fn stops(surveyor: &Surveyor<'_>, settings: &[&[f64]]) -> Vec<Stop> {
        let setting = |details: &&[f64]| Setting {
            macros: Vec::new().into(),
            details: (0..).zip(details.iter().copied()).collect(),
        };
        let settings = settings.iter().map(setting).enumerate();
        settings
            .map(|(at, setting)| {
                surveyor
                    .stop(at, &setting, &mut MacroWork::default())
                    .unwrap()
            })
            .collect()
    }

    /// Collapses the first face, throws a vertex far away, folds the bone.
    const FAULTS: [&[(u32, Point)]; 3] = [
        &[
            (1, [-1.0, 0.0, 0.0]),
            (10, [0.0, -1.0, 0.0]),
            (11, [-1.0, -1.0, 0.0]),
        ],
        &[(55, [0.0, 0.0, 30.0])],
        &[(99, [-1.0, 0.0, 0.0])],
    ];

    #[test]
    fn each_fault_is_seen_at_its_setting_and_gone_at_the_next() {
        let scene = scene(&FAULTS);
        let surveyor = Surveyor::new(&scene).unwrap();
        let settings: [&[f64]; 4] = [
            &[1.0, 0.0, 0.0],
            &[0.0, 1.0, 0.0],
            &[0.0, 0.0, 1.0],
            &[0.0, 0.0, 0.0],
        ];
        let survey = look(&surveyor, &stops(&surveyor, &settings));
        let seen = |trouble| {
            survey
                .get(&trouble)
                .and_then(|fault: &Fault| fault.worst.as_ref())
                .map(|worst| (worst.setting, worst.element, worst.count))
        };
        assert_eq!(seen(Trouble::Collapsed), Some((0, 0, 1)));
        assert_eq!(seen(Trouble::Exploded), Some((1, 55, 1)));
        assert_eq!(seen(Trouble::ShortBone), Some((2, 0, 1)));
        assert_eq!(seen(Trouble::NonFinite), None);
        let healthy = look(&surveyor, &stops(&surveyor, &settings)[3..]);
        assert_eq!(healthy, Survey::new());
    }

    #[test]
    fn a_walk_sees_what_single_looks_see() {
        let scene = scene(&FAULTS);
        let surveyor = Surveyor::new(&scene).unwrap();
        let values = [0.0, 0.5, 0.9999, 1.0, 2.0];
        let settings: Vec<Vec<f64>> = (0..125)
            .map(|at| vec![values[at % 5], values[at / 5 % 5], values[at / 25]])
            .collect();
        let settings: Vec<&[f64]> = settings.iter().map(Vec::as_slice).collect();
        let mut alone = Survey::new();
        for stop in stops(&surveyor, &settings) {
            merge(&mut alone, look(&surveyor, &[stop]));
        }
        assert!(
            [Trouble::Collapsed, Trouble::Exploded, Trouble::ShortBone]
                .iter()
                .all(|trouble| alone.contains_key(trouble))
        );
        assert_eq!(
            look(&surveyor, &in_order(stops(&surveyor, &settings))),
            alone
        );
    }

    #[test]
    fn what_is_not_finite_is_all_that_is_told() {
        let scene = scene(&[&[(1, [f32::INFINITY, 0.0, 0.0])], FAULTS[0]]);
        let surveyor = Surveyor::new(&scene).unwrap();
        let survey = look(&surveyor, &stops(&surveyor, &[&[1.0, 1.0]]));
        let seen = survey
            .get(&Trouble::NonFinite)
            .and_then(|fault| fault.worst.as_ref());
        assert_eq!(seen.map(|worst| (worst.element, worst.count)), Some((1, 1)));
        assert_eq!(survey.len(), 1);
    }
}
