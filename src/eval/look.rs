//! A look at settings, one after the other: what a step does not touch is as it was before.

use std::collections::BTreeSet;

use super::skeleton::PARALLEL_SINE;
use super::survey::{DRIFT_STANDS, EXPLOSION_DIAGONALS, FLIPPED_SHARE, SHORTEST_BONE, Survey, Worst, keep};
use super::surveyor::{FaceAtRest, Surveyor, dot, flatness, stand};
use super::vector::{Point, distance};
use super::walk::{Stop, Walk};

/// A step that moves more than this part of the vertices is looked at as a whole.
const LARGE_STEP: usize = 8;

/// Looks at stops, best in the order of [`super::walk::in_order`].
pub fn look<'s>(surveyor: &'s Surveyor<'s>, stops: &[Stop]) -> Survey {
    let mut look = Look::new(surveyor);
    for stop in stops {
        look.at(stop);
    }
    look.survey
}

/// What is seen of the mesh as it stands.
struct Look<'s> {
    surveyor: &'s Surveyor<'s>,
    walk: Walk<'s>,
    /// Whether nothing has been looked at yet.
    new: bool,
    /// Vertices that may have exploded or are not finite.
    strays: BTreeSet<u32>,
    /// Faces at fault, by their number among the visible ones.
    collapsed: BTreeSet<u32>,
    flipped: BTreeSet<u32>,
    /// The worst joint and the worst bones.
    drifted: Option<Worst>,
    short_bone: Option<Worst>,
    flat_plane: Option<Worst>,
    survey: Survey,
}

impl<'s> Look<'s> {
    fn new(surveyor: &'s Surveyor<'s>) -> Self {
        Self {
            surveyor,
            walk: Walk::new(&surveyor.targets),
            new: true,
            strays: BTreeSet::new(),
            collapsed: BTreeSet::new(),
            flipped: BTreeSet::new(),
            drifted: None,
            short_bone: None,
            flat_plane: None,
            survey: Survey::default(),
        }
    }

    fn at(&mut self, stop: &Stop) {
        self.walk.to(stop);
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
            mark(&mut self.strays, vertex, !surveyor.in_range(*point));
        }
        for (number, face) in (0..).zip(&surveyor.faces) {
            let (collapsed, flipped) = state(surveyor, positions, face);
            mark(&mut self.collapsed, number, collapsed);
            mark(&mut self.flipped, number, flipped);
        }
        self.skeleton();
    }

    /// The same for what the last step moved.
    fn touched(&mut self) {
        let (surveyor, positions) = (self.surveyor, self.walk.positions());
        let mut holds_joint = false;
        let mut faces: Vec<u32> = Vec::new();
        for vertex in self.walk.moved() {
            let at = vertex as usize;
            mark(&mut self.strays, vertex, !positions.get(at).is_some_and(|point| surveyor.in_range(*point)));
            holds_joint |= surveyor.holds_joint.get(at).is_some_and(|holds| *holds);
            faces.extend_from_slice(surveyor.faces_of(vertex));
        }
        faces.sort_unstable();
        faces.dedup();
        for number in faces {
            let Some(face) = surveyor.faces.get(number as usize) else { continue };
            let (collapsed, flipped) = state(surveyor, positions, face);
            mark(&mut self.collapsed, number, collapsed);
            mark(&mut self.flipped, number, flipped);
        }
        if holds_joint {
            self.skeleton();
        }
    }

    fn skeleton(&mut self) {
        (self.drifted, self.short_bone, self.flat_plane) = (None, None, None);
        let positions = self.walk.positions();
        let Some((skeleton, joints)) = self.surveyor.scene.skeleton.as_ref().zip(self.surveyor.joints(positions))
        else {
            return;
        };
        for anchor in &self.surveyor.anchors {
            let Some(joint) = joints.get(anchor.joint) else { continue };
            let value = (stand(*joint, &anchor.skin, positions) - anchor.distance) / anchor.stand;
            if value > DRIFT_STANDS {
                keep(&mut self.drifted, one(value, anchor.joint));
            }
        }
        for (element, bone) in skeleton.bones.iter().enumerate() {
            let Some((head, tail)) = joints.get(bone.head).zip(joints.get(bone.tail)) else { continue };
            let length = distance(*head, *tail);
            let known = |list: &[bool]| list.get(element).is_some_and(|known| *known);
            if length < SHORTEST_BONE && !known(&self.surveyor.short_at_rest) {
                keep(&mut self.short_bone, one(1.0 / length, element));
            }
            let sine = bone.plane.map_or(1.0, |plane| flatness(&joints, plane));
            // A coincidence of joints is not finite: it counts as in line.
            if !(sine > PARALLEL_SINE || known(&self.surveyor.flat_at_rest)) {
                keep(&mut self.flat_plane, one(1.0 / sine.max(0.0), element));
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
            keep(&mut self.survey.collapsed, collapsed.worst(f64::from(collapsed.count), setting));
        }
        let flipped = Faces::of(self.surveyor, &self.flipped);
        let share = flipped.area / self.surveyor.area;
        if share > FLIPPED_SHARE {
            keep(&mut self.survey.flipped, flipped.worst(share, setting));
        }
        self.explosion(setting);
        let pairs = [
            (&mut self.survey.drifted, &self.drifted),
            (&mut self.survey.short_bone, &self.short_bone),
            (&mut self.survey.flat_plane, &self.flat_plane),
        ];
        for (slot, found) in pairs {
            found.iter().for_each(|found| keep(slot, Worst { setting, ..found.clone() }));
        }
    }

    fn strays(&self) -> impl Iterator<Item = (usize, Point)> {
        let positions = self.walk.positions();
        self.strays.iter().filter_map(|vertex| Some((*vertex as usize, *positions.get(*vertex as usize)?)))
    }

    fn non_finite(&mut self, setting: usize) -> bool {
        let mut bad = self.strays().filter(|(_, point)| !(point[0] + point[1] + point[2]).is_finite());
        let Some((element, _)) = bad.next() else { return false };
        let count = 1 + bad.count();
        keep(&mut self.survey.non_finite, Worst { value: count as f64, element, count, setting });
        true
    }

    fn explosion(&mut self, setting: usize) {
        let surveyor = self.surveyor;
        let mut worst = (0.0_f32, 0);
        let mut count = 0;
        for (vertex, point) in self.strays() {
            let mut outside = 0.0_f32;
            for axis in 0..3 {
                outside = outside.max(surveyor.low[axis] - point[axis]).max(point[axis] - surveyor.high[axis]);
            }
            if outside > surveyor.diagonal * EXPLOSION_DIAGONALS {
                count += 1;
                if outside > worst.0 {
                    worst = (outside, vertex);
                }
            }
        }
        if count > 0 {
            let value = f64::from(worst.0 / surveyor.diagonal);
            keep(&mut self.survey.exploded, Worst { value, element: worst.1, count, setting });
        }
    }
}

fn one(value: f64, element: usize) -> Worst {
    Worst { value, element, count: 1, setting: 0 }
}

fn mark(set: &mut BTreeSet<u32>, number: u32, is_in: bool) {
    if is_in {
        set.insert(number);
    } else if !set.is_empty() {
        set.remove(&number);
    }
}

/// Whether a face has collapsed, and if not, whether it has flipped.
fn state(surveyor: &Surveyor<'_>, positions: &[Point], face: &FaceAtRest) -> (bool, bool) {
    let now = surveyor.doubled_area(positions, face);
    let collapsed = dot(now, now) <= face.collapse;
    (collapsed, !collapsed && dot(now, face.vector) < 0.0)
}

/// Faces of one kind at one setting: how many, their area at rest, and the largest.
#[derive(Debug, Clone, Copy, Default)]
struct Faces {
    count: u32,
    area: f64,
    largest: (f32, u32),
}

impl Faces {
    fn of(surveyor: &Surveyor<'_>, numbers: &BTreeSet<u32>) -> Self {
        let mut faces = Self::default();
        for face in numbers.iter().filter_map(|number| surveyor.faces.get(*number as usize)) {
            faces.count += 1;
            faces.area += f64::from(face.square.sqrt());
            if face.square > faces.largest.0 {
                faces.largest = (face.square, face.face);
            }
        }
        faces
    }

    fn worst(&self, value: f64, setting: usize) -> Worst {
        Worst { value, element: self.largest.1 as usize, count: self.count as usize, setting }
    }
}
