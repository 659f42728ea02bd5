//! What happens to a base mesh over its slider space: one look at a setting measures everything that can go wrong
//! with the shape, and a survey keeps the worst of each.
//!
//! Looks are independent of each other; surveys are merged in the order of the settings, so that the outcome does
//! not depend on threads.

use super::joints::joint_positions;
use super::macro_eval::MacroResult;
use super::scene::{Scene, Setting};
use super::skeleton::{PARALLEL_SINE, plane_sine};
use super::surface::bounding_box;
use super::vector::{Point, distance};

/// A face whose area falls to this part of what it is on the default character, or below, has collapsed. The faces of
/// hm08 keep more than that at every setting; two of its smallest babies' faces come below a thousandth.
pub const COLLAPSE_RATIO: f32 = 1e-4;
/// Faces that look the other way count only together: lips, eyelids and sagging breasts of hm08 flip at extremes, up
/// to 64 faces, and 2.6 % of the area. A part of the visible area of the default character.
pub const FLIPPED_SHARE: f64 = 0.05;
/// A vertex farther outside the box of the default character than this many of its diagonals has exploded: the tallest
/// character of hm08 stays within 0.41.
pub const EXPLOSION_DIAGONALS: f32 = 0.6;
/// A bone shorter than this has collapsed, in mesh units (a hundredth of a millimetre).
pub const SHORTEST_BONE: f64 = 1e-4;
/// A joint has left its limb when it moved away from the skin around it by more than this many times its stand on the
/// default character: distance from the mean of that skin, plus the radius of that skin. The joints of hm08 come to 2.2
/// (toes and spine at the corners of age and weight).
pub const DRIFT_STANDS: f64 = 3.0;
/// Skin vertices around a joint that it is compared with.
const SKIN_AROUND_JOINT: usize = 16;

/// The worst that was seen of one thing, and at which setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Worst {
    /// How bad; larger is worse.
    pub value: f64,
    /// Vertex, face, joint or bone, by number.
    pub element: usize,
    /// How many elements are concerned at this setting.
    pub count: usize,
    /// Number of the setting.
    pub setting: usize,
}

/// What a survey found.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Survey {
    /// Settings looked at.
    pub settings: usize,
    /// Settings at which the application stops, the first of them.
    pub stopped: Option<usize>,
    /// Vertices that are not finite though no row is; the value is their number.
    pub non_finite: Option<Worst>,
    /// Visible faces without area; the value is their number.
    pub collapsed: Option<Worst>,
    /// Visible faces that look the other way; the value is their part of the visible area.
    pub flipped: Option<Worst>,
    /// Vertex farthest outside the box, in diagonals.
    pub exploded: Option<Worst>,
    /// Joint farthest from its place in the skin, in stands.
    pub drifted: Option<Worst>,
    /// Shortest bone; the value is 1 / length.
    pub short_bone: Option<Worst>,
    /// Plane whose three joints are in line; the value is 1 / sine.
    pub flat_plane: Option<Worst>,
}

/// A scene made ready to be looked at.
#[derive(Debug)]
pub struct Surveyor<'s> {
    scene: &'s Scene,
    /// Visible faces with area.
    faces: Vec<FaceAtRest>,
    /// Twice their area.
    area: f64,
    visible: Vec<u32>,
    low: Point,
    high: Point,
    diagonal: f32,
    anchors: Vec<Anchor>,
    /// Bones and planes that are at fault already on the default character.
    short_at_rest: Vec<bool>,
    flat_at_rest: Vec<bool>,
}

#[derive(Debug, Clone, Copy)]
struct FaceAtRest {
    face: u32,
    vector: Point,
    square: f32,
}

/// A joint and the skin around it.
#[derive(Debug, Clone)]
struct Anchor {
    joint: usize,
    skin: Vec<u32>,
    distance: f64,
    stand: f64,
}

/// Buffers of a look, reused.
#[derive(Debug, Default)]
pub struct Scratch {
    positions: Vec<Point>,
    macros: MacroResult,
}

impl<'s> Surveyor<'s> {
    /// Makes a scene ready. The default character is what everything is compared with; `None` if it cannot be made
    /// or is not finite, which is reported by other means.
    pub fn new(scene: &'s Scene) -> Option<Self> {
        let mut surveyor = Self {
            scene,
            faces: Vec::new(),
            area: 0.0,
            visible: Vec::new(),
            low: [0.0; 3],
            high: [0.0; 3],
            diagonal: 0.0,
            anchors: Vec::new(),
            short_at_rest: Vec::new(),
            flat_at_rest: Vec::new(),
        };
        let mut scratch = Scratch::default();
        surveyor.morph(&scene.defaults(), &mut scratch)?;
        let rest = scratch.positions;
        surveyor.measure_rest(&rest)?;
        Some(surveyor)
    }

    fn measure_rest(&mut self, rest: &[Point]) -> Option<()> {
        if rest.iter().flatten().any(|part| !part.is_finite()) {
            return None;
        }
        let shown = |face: usize| {
            let group = self.scene.face_groups.get(face).map(|group| *group as usize);
            group.and_then(|group| self.scene.visible.get(group)).is_some_and(|visible| *visible)
        };
        let mut used = vec![false; rest.len()];
        for face in (0..self.scene.face_count()).filter(|face| shown(*face)) {
            let vector = doubled_area(rest, self.scene.face(face));
            let square = dot(vector, vector);
            for vertex in self.scene.face(face) {
                if let Some(used) = used.get_mut(*vertex as usize) {
                    *used = true;
                }
            }
            if square > 0.0 {
                self.area += f64::from(square.sqrt());
                self.faces.push(FaceAtRest { face: u32::try_from(face).ok()?, vector, square });
            }
        }
        self.visible = (0..).zip(&used).filter(|(_, used)| **used).map(|(vertex, _)| vertex).collect();
        let skin: Vec<Point> = self.visible.iter().filter_map(|vertex| rest.get(*vertex as usize)).copied().collect();
        (self.low, self.high) = bounding_box(&skin).or_else(|| bounding_box(rest))?;
        self.diagonal = dot(sub(self.high, self.low), sub(self.high, self.low)).sqrt();
        self.anchor_joints(rest);
        Some(())
    }

    fn anchor_joints(&mut self, rest: &[Point]) {
        let Some(joints) = self.joints(rest) else { return };
        for (joint, place) in joints.iter().enumerate() {
            let mut near: Vec<(f64, u32)> = self
                .visible
                .iter()
                .filter_map(|vertex| Some((distance(*place, *rest.get(*vertex as usize)?), *vertex)))
                .collect();
            let count = SKIN_AROUND_JOINT.min(near.len());
            if count == 0 {
                return;
            }
            near.select_nth_unstable_by(count - 1, |a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
            near.truncate(count);
            let mut skin: Vec<u32> = near.into_iter().map(|(_, vertex)| vertex).collect();
            skin.sort_unstable();
            let distance = stand(*place, &skin, rest);
            let stand = (distance + radius(&skin, rest)).max(f64::MIN_POSITIVE);
            self.anchors.push(Anchor { joint, skin, distance, stand });
        }
        let Some(skeleton) = &self.scene.skeleton else { return };
        for bone in &skeleton.bones {
            let ends = joints.get(bone.head).zip(joints.get(bone.tail));
            self.short_at_rest.push(ends.is_some_and(|(head, tail)| distance(*head, *tail) < SHORTEST_BONE));
            self.flat_at_rest.push(bone.plane.is_some_and(|plane| flatness(&joints, plane) <= PARALLEL_SINE));
        }
    }

    fn joints(&self, positions: &[Point]) -> Option<Vec<Point>> {
        let skeleton = self.scene.skeleton.as_ref()?;
        joint_positions(positions, skeleton.joints.iter().map(Vec::as_slice)).ok()
    }

    /// The mesh at a setting, into the scratch buffers. `None` where the application stops.
    fn morph(&self, setting: &Setting, scratch: &mut Scratch) -> Option<()> {
        let mut factors = self.scene.factors(setting, &mut scratch.macros).ok()?;
        factors.retain(|(target, _)| !self.scene.targets.get(*target).is_some_and(|target| target.suspect));
        scratch.positions.clone_from(&self.scene.positions);
        self.scene.add(&mut scratch.positions, &factors).ok()
    }

    /// Looks at one setting.
    pub fn look(&self, number: usize, setting: &Setting, scratch: &mut Scratch, survey: &mut Survey) {
        survey.settings += 1;
        if self.morph(setting, scratch).is_none() {
            survey.stopped.get_or_insert(number);
            return;
        }
        let positions = &scratch.positions;
        if Self::non_finite(number, positions, survey) {
            return;
        }
        self.faces(number, positions, survey);
        self.explosion(number, positions, survey);
        if let Some(joints) = self.joints(positions) {
            self.drift(number, positions, &joints, survey);
            self.bones(number, &joints, survey);
        }
    }

    fn non_finite(setting: usize, positions: &[Point], survey: &mut Survey) -> bool {
        let bad = |point: &Point| !(point[0] + point[1] + point[2]).is_finite();
        let Some(element) = positions.iter().position(bad) else { return false };
        let count = positions.iter().filter(|point| bad(point)).count();
        keep(&mut survey.non_finite, Worst { value: count as f64, element, count, setting });
        true
    }

    fn faces(&self, setting: usize, positions: &[Point], survey: &mut Survey) {
        let (mut collapsed, mut flipped) = (Faces::default(), Faces::default());
        for rest in &self.faces {
            let now = doubled_area(positions, self.scene.face(rest.face as usize));
            if dot(now, now) <= rest.square * COLLAPSE_RATIO * COLLAPSE_RATIO {
                collapsed.add(rest);
            } else if dot(now, rest.vector) < 0.0 {
                flipped.add(rest);
            }
        }
        if collapsed.count > 0 {
            keep(&mut survey.collapsed, collapsed.worst(f64::from(collapsed.count), setting));
        }
        let share = flipped.area / self.area;
        if share > FLIPPED_SHARE {
            keep(&mut survey.flipped, flipped.worst(share, setting));
        }
    }

    fn explosion(&self, setting: usize, positions: &[Point], survey: &mut Survey) {
        let mut worst = (0.0_f32, 0);
        let mut count = 0;
        for (vertex, point) in positions.iter().enumerate() {
            let mut outside = 0.0_f32;
            for axis in 0..3 {
                outside = outside.max(self.low[axis] - point[axis]).max(point[axis] - self.high[axis]);
            }
            if outside > self.diagonal * EXPLOSION_DIAGONALS {
                count += 1;
                if outside > worst.0 {
                    worst = (outside, vertex);
                }
            }
        }
        if count > 0 {
            let value = f64::from(worst.0 / self.diagonal);
            keep(&mut survey.exploded, Worst { value, element: worst.1, count, setting });
        }
    }

    fn drift(&self, setting: usize, positions: &[Point], joints: &[Point], survey: &mut Survey) {
        for anchor in &self.anchors {
            let Some(joint) = joints.get(anchor.joint) else { continue };
            let value = (stand(*joint, &anchor.skin, positions) - anchor.distance) / anchor.stand;
            if value > DRIFT_STANDS {
                keep(&mut survey.drifted, Worst { value, element: anchor.joint, count: 1, setting });
            }
        }
    }

    fn bones(&self, setting: usize, joints: &[Point], survey: &mut Survey) {
        let Some(skeleton) = &self.scene.skeleton else { return };
        for (element, bone) in skeleton.bones.iter().enumerate() {
            let Some((head, tail)) = joints.get(bone.head).zip(joints.get(bone.tail)) else { continue };
            let length = distance(*head, *tail);
            let known = |list: &[bool]| list.get(element).is_some_and(|known| *known);
            if length < SHORTEST_BONE && !known(&self.short_at_rest) {
                keep(&mut survey.short_bone, Worst { value: 1.0 / length, element, count: 1, setting });
            }
            let sine = bone.plane.map_or(1.0, |plane| flatness(joints, plane));
            // A coincidence of joints is not finite: it counts as in line.
            if !(sine > PARALLEL_SINE || known(&self.flat_at_rest)) {
                keep(&mut survey.flat_plane, Worst { value: 1.0 / sine, element, count: 1, setting });
            }
        }
    }
}

/// Faces of one kind at one setting: how many, their area at rest, and the largest.
#[derive(Debug, Clone, Copy, Default)]
struct Faces {
    count: u32,
    area: f64,
    largest: (f32, u32),
}

impl Faces {
    fn add(&mut self, face: &FaceAtRest) {
        self.count += 1;
        self.area += f64::from(face.square.sqrt());
        if face.square > self.largest.0 {
            self.largest = (face.square, face.face);
        }
    }

    fn worst(&self, value: f64, setting: usize) -> Worst {
        Worst { value, element: self.largest.1 as usize, count: self.count as usize, setting }
    }
}

impl Survey {
    /// Adds what was found at later settings.
    pub fn merge(&mut self, later: Self) {
        self.settings += later.settings;
        self.stopped = self.stopped.or(later.stopped);
        let pairs = [
            (&mut self.non_finite, later.non_finite),
            (&mut self.collapsed, later.collapsed),
            (&mut self.flipped, later.flipped),
            (&mut self.exploded, later.exploded),
            (&mut self.drifted, later.drifted),
            (&mut self.short_bone, later.short_bone),
            (&mut self.flat_plane, later.flat_plane),
        ];
        for (slot, found) in pairs {
            found.into_iter().for_each(|found| keep(slot, found));
        }
    }
}

/// Keeps the worse; of equals the one seen first.
fn keep(slot: &mut Option<Worst>, found: Worst) {
    if slot.as_ref().is_none_or(|known| found.value > known.value) {
        *slot = Some(found);
    }
}

/// Distance of a joint from the mean of the skin around it.
fn stand(joint: Point, skin: &[u32], positions: &[Point]) -> f64 {
    distance(joint, mean(skin, positions))
}

/// Mean distance of vertices from their own mean.
fn radius(skin: &[u32], positions: &[Point]) -> f64 {
    let mean = mean(skin, positions);
    let points = skin.iter().filter_map(|vertex| positions.get(*vertex as usize));
    points.map(|point| distance(*point, mean)).sum::<f64>() / skin.len().max(1) as f64
}

fn mean(skin: &[u32], positions: &[Point]) -> Point {
    let count = skin.len().max(1) as f32;
    let mut mean = [0.0_f32; 3];
    for point in skin.iter().filter_map(|vertex| positions.get(*vertex as usize)) {
        for axis in 0..3 {
            mean[axis] += point[axis] / count;
        }
    }
    mean
}

fn flatness(joints: &[Point], plane: [usize; 3]) -> f64 {
    let [a, b, c] = plane.map(|joint| joints.get(joint).copied().unwrap_or([f32::NAN; 3]));
    plane_sine(a, b, c)
}

/// Twice the area vector of a face, in float32: this is the innermost loop of a survey.
fn doubled_area(positions: &[Point], face: &[u32]) -> Point {
    let at = |vertex: u32| positions.get(vertex as usize).copied().unwrap_or_default();
    match face {
        [a, b, c] => cross(sub(at(*b), at(*a)), sub(at(*c), at(*a))),
        // The area vector of any quad is half the cross product of its diagonals.
        [a, b, c, d] => cross(sub(at(*c), at(*a)), sub(at(*d), at(*b))),
        [first, rest @ ..] => rest.windows(2).fold([0.0; 3], |sum, pair| {
            let part = cross(sub(at(pair[0]), at(*first)), sub(at(pair[1]), at(*first)));
            [sum[0] + part[0], sum[1] + part[1], sum[2] + part[2]]
        }),
        [] => [0.0; 3],
    }
}

fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: Point, b: Point) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
