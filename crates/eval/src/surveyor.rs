//! A scene made ready to be looked at in many settings: what the default character is like, and
//! which faces, joints and bones depend on which vertices.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use super::attachment::{Probe, probes};
use super::lists::Lists;
use super::macros::MacroWork;
use super::mesh::bounding_box;
use super::nearest::Nearest;
use super::scene::{Scene, Setting, WornAsset};
use super::skeleton::{PARALLEL_SINE, plane_sine};
use super::survey::{COLLAPSE_RATIO, EXPLOSION_DIAGONALS, SHORTEST_BONE};
use super::tears::Neighbours;
use super::vector::{Point, add, cross, distance, dot, sub};
use super::walk::{Addable, Stop, Walk};

/// What the groups of joint cubes begin with.
const JOINTS: &str = "joint-";
/// Skin vertices around a joint that it is compared with.
const SKIN_AROUND_JOINT: usize = 16;
/// Joints times visible vertices that the skin is searched for in: thirty times those of hm08.
const MOST_PAIRS: usize = 1 << 26;
/// What looking at a vertex with the faces around it costs, compared with adding a row.
const LOOK: u64 = 4;

/// A scene made ready to be looked at.
#[derive(Debug)]
pub struct Surveyor<'s> {
    pub(super) scene: &'s Scene,
    pub(super) targets: Addable<'s>,
    /// The default character.
    defaults: Stop,
    /// Visible faces with area.
    pub(super) faces: Vec<FaceAtRest>,
    /// Twice their area.
    pub(super) area: f64,
    /// Numbers of the faces at each vertex.
    faces_of: Lists<u32>,
    visible: Vec<u32>,
    pub(super) low: Point,
    pub(super) high: Point,
    pub(super) diagonal: f32,
    /// The box widened by nearly what makes an explosion.
    range: (Point, Point),
    pub(super) anchors: Vec<Anchor>,
    /// For each of these the helper that the joint belongs to, if one is nearer than the skin: that
    /// of a tail.
    pub(super) helpers: Vec<Option<Anchor>>,
    /// Which vertices are next to one another, once somebody asks.
    neighbours: OnceLock<Neighbours>,
    /// Whether there are too many joints and vertices to search the skin around each joint.
    pub is_without_anchors: bool,
    /// Bones, vertices of joints, and vertices of the skin around them.
    skeleton_size: usize,
    /// Vertices that joints or the skin around them depend on.
    pub(super) holds_joint: Vec<bool>,
    /// What is worn, by vertices, and which vertices these depend on.
    pub(super) probes: Vec<Probe>,
    pub(super) holds_probe: Vec<bool>,
    /// Bones and planes that are at fault already on the default character.
    pub(super) short_at_rest: Vec<bool>,
    pub(super) flat_at_rest: Vec<bool>,
}

/// A visible face on the default character.
#[derive(Debug, Clone, Copy)]
pub(super) struct FaceAtRest {
    pub(super) face: u32,
    /// From, to, from, to: the lines whose cross product is twice the area vector; none for a face
    /// of many corners.
    lines: Option<[u32; 4]>,
    pub(super) vector: Point,
    pub(super) square: f32,
    /// A square of twice its area at which it has collapsed.
    pub(super) collapse: f32,
}

/// A joint and the skin around it.
#[derive(Debug, Clone)]
pub(super) struct Anchor {
    pub(super) joint: usize,
    pub(super) skin: Vec<u32>,
    pub(super) distance: f64,
    pub(super) stand: f64,
}

impl<'s> Surveyor<'s> {
    /// Makes a scene ready. The default character is what everything is compared with; `None` if it
    /// cannot be made or is not finite, which is reported by other means.
    pub fn new(scene: &'s Scene) -> Option<Self> {
        let targets = Addable::new(scene);
        let defaults = targets.stop(0, &scene.defaults(), &mut MacroWork::default())?;
        let rest = {
            let mut walk = Walk::new(&targets);
            walk.to(&defaults, None);
            walk.positions().to_vec()
        };
        let mut surveyor = Self {
            scene,
            targets,
            defaults,
            faces: Vec::new(),
            area: 0.0,
            faces_of: Lists::default(),
            visible: Vec::new(),
            low: [0.0; 3],
            high: [0.0; 3],
            diagonal: 0.0,
            range: ([0.0; 3], [0.0; 3]),
            anchors: Vec::new(),
            helpers: Vec::new(),
            neighbours: OnceLock::new(),
            is_without_anchors: false,
            skeleton_size: 0,
            holds_joint: vec![false; rest.len()],
            probes: Vec::new(),
            holds_probe: vec![false; rest.len()],
            short_at_rest: Vec::new(),
            flat_at_rest: Vec::new(),
        };
        surveyor.measure(&rest)?;
        Some(surveyor)
    }

    /// What a setting adds to the mesh. `None` where the application stops.
    pub fn stop(&self, number: usize, setting: &Setting, work: &mut MacroWork) -> Option<Stop> {
        self.targets.stop(number, setting, work)
    }

    /// How much work a stop is at most: rows that are added, vertices and faces, joints and bones
    /// that are looked at.
    pub fn cost(&self, stop: &Stop) -> u64 {
        let rows: usize = stop
            .targets_unlike(&self.defaults)
            .map(|target| self.targets.rows(target).len() + 1)
            .sum();
        let mesh = self.scene.positions.len() + self.faces.len();
        let depending = self.skeleton_size + self.probes.len() * SKIN_AROUND_JOINT;
        1 + rows as u64 + (LOOK * rows as u64).min(mesh as u64) + depending as u64
    }

    fn measure(&mut self, rest: &[Point]) -> Option<()> {
        if rest.iter().flatten().any(|part| !part.is_finite()) {
            return None;
        }
        let mut used = vec![false; rest.len()];
        for face in 0..self.scene.face_count() {
            let group = self
                .scene
                .face_groups
                .get(face)
                .map(|group| *group as usize);
            if !group
                .and_then(|group| self.scene.visible.get(group))
                .is_some_and(|visible| *visible)
            {
                continue;
            }
            for vertex in self.scene.face(face) {
                if let Some(used) = used.get_mut(*vertex as usize) {
                    *used = true;
                }
            }
            self.face(face, rest);
        }
        let corners = (0..).zip(&self.faces).flat_map(|(number, face)| {
            self.scene
                .face(face.face as usize)
                .iter()
                .map(move |vertex| (*vertex as usize, number))
        });
        self.faces_of = Lists::new(rest.len(), corners);
        self.visible = (0..)
            .zip(&used)
            .filter(|(_, used)| **used)
            .map(|(vertex, _)| vertex)
            .collect();
        let skin: Vec<Point> = self
            .visible
            .iter()
            .filter_map(|vertex| rest.get(*vertex as usize))
            .copied()
            .collect();
        (self.low, self.high) = bounding_box(&skin).or_else(|| bounding_box(rest))?;
        self.diagonal = dot(sub(self.high, self.low), sub(self.high, self.low)).sqrt();
        // A little less, so that rounding leaves nothing out; an infinite vertex is out of every
        // range.
        let margin = self.diagonal * EXPLOSION_DIAGONALS * 0.999;
        self.range = (
            self.low.map(|low| (low - margin).max(f32::MIN)),
            self.high.map(|high| (high + margin).min(f32::MAX)),
        );
        self.joints_at_rest(rest);
        self.worn_at_rest(rest);
        Some(())
    }

    fn worn_at_rest(&mut self, rest: &[Point]) {
        let skin = Nearest::of(&self.visible, rest);
        let around = |vertex, place| anchor(&skin, vertex, place, rest);
        let probes = probes(&self.scene.worn, rest, around);
        for vertex in probes.iter().flat_map(Probe::vertices) {
            if let Some(holds) = self.holds_probe.get_mut(vertex as usize) {
                *holds = true;
            }
        }
        self.probes = probes;
    }

    fn face(&mut self, face: usize, rest: &[Point]) {
        let lines = match self.scene.face(face) {
            [a, b, c] => Some([*a, *b, *a, *c]),
            // The area vector of any quad is half the cross product of its diagonals.
            [a, b, c, d] => Some([*a, *c, *b, *d]),
            _ => None,
        };
        let number = u32::try_from(face).unwrap_or(u32::MAX);
        let mut at_rest = FaceAtRest {
            face: number,
            lines,
            vector: [0.0; 3],
            square: 0.0,
            collapse: 0.0,
        };
        at_rest.vector = self.doubled_area(rest, &at_rest);
        at_rest.square = dot(at_rest.vector, at_rest.vector);
        at_rest.collapse = at_rest.square * COLLAPSE_RATIO * COLLAPSE_RATIO;
        if at_rest.square > 0.0 {
            self.area += f64::from(at_rest.square.sqrt());
            self.faces.push(at_rest);
        }
    }

    /// Twice the area vector of a face, in float32: this is the innermost loop of a survey.
    #[inline]
    pub(super) fn doubled_area(&self, positions: &[Point], face: &FaceAtRest) -> Point {
        let at = |vertex: u32| positions.get(vertex as usize).copied().unwrap_or_default();
        if let Some([a, b, c, d]) = face.lines {
            return cross(sub(at(b), at(a)), sub(at(d), at(c)));
        }
        let [first, rest @ ..] = self.scene.face(face.face as usize) else {
            return [0.0; 3];
        };
        rest.windows(2).fold([0.0; 3], |sum, pair| {
            add(
                sum,
                cross(sub(at(pair[0]), at(*first)), sub(at(pair[1]), at(*first))),
            )
        })
    }

    /// Which vertices are next to one another.
    pub(super) fn neighbours(&self) -> &Neighbours {
        self.neighbours
            .get_or_init(|| Neighbours::new(self.scene.positions.len(), self.scene.faces()))
    }

    /// Numbers of the visible faces at a vertex.
    pub(super) fn faces_of(&self, vertex: u32) -> &[u32] {
        self.faces_of.of(vertex as usize)
    }

    /// How far outside of the box of the default character that many of its diagonals are, mesh
    /// units.
    pub fn length_outside(&self, diagonals: f64) -> f64 {
        diagonals * f64::from(self.diagonal)
    }

    /// How far away from its skin a joint is that has moved by so many stands, mesh units.
    pub fn length_away(&self, joint: usize, stands: f64) -> Option<f64> {
        let anchor = self.anchors.iter().find(|anchor| anchor.joint == joint)?;
        Some(stands * anchor.stand)
    }

    /// How far away from its skin the vertex with this number among all that are looked at is, mesh
    /// units.
    pub fn length_detached(&self, probe: usize, stands: f64) -> Option<f64> {
        Some(self.probes.get(probe)?.anchor.stand * stands)
    }

    /// The asset that it is of.
    pub fn asset(&self, probe: usize) -> Option<&WornAsset> {
        self.scene.worn.get(self.probes.get(probe)?.asset as usize)
    }

    /// The vertex of the asset, and the vertices of the base mesh that its row names.
    pub fn tied(&self, probe: usize) -> Option<(u32, [u32; 3])> {
        let probe = self.probes.get(probe)?;
        Some((probe.vertex, probe.named()))
    }

    /// Whether a vertex is neither exploded nor infinite; in doubt it is not.
    pub(super) fn in_range(&self, point: Point) -> bool {
        let (low, high) = self.range;
        (0..3).all(|axis| point[axis] >= low[axis] && point[axis] <= high[axis])
    }

    fn joints_at_rest(&mut self, rest: &[Point]) {
        let Some((skeleton, joints)) = self.scene.skeleton.as_ref().zip(self.joints(rest)) else {
            return;
        };
        self.skeleton_size =
            skeleton.bones.len() + skeleton.joints.iter().map(Vec::len).sum::<usize>();
        // The skin around a joint is looked at with it.
        self.skeleton_size += SKIN_AROUND_JOINT * skeleton.joints.len();
        let of_helpers = self.of_helpers();
        let around = self.visible.len().saturating_add(of_helpers.len());
        self.is_without_anchors = joints.len().saturating_mul(around) > MOST_PAIRS;
        let (skin, of_helpers) = (
            Nearest::of(&self.visible, rest),
            Nearest::of(&of_helpers, rest),
        );
        for (joint, place) in joints
            .iter()
            .enumerate()
            .filter(|_| !self.is_without_anchors)
        {
            let Some(of_skin) = anchor(&skin, joint, *place, rest) else {
                return;
            };
            let helper = anchor(&of_helpers, joint, *place, rest);
            self.helpers
                .push(helper.filter(|helper| helper.stand < of_skin.stand));
            self.anchors.push(of_skin);
        }
        let anchors = self.anchors.iter().chain(self.helpers.iter().flatten());
        let holding = anchors
            .map(|anchor| &anchor.skin)
            .chain(&skeleton.joints)
            .flatten();
        for vertex in holding {
            if let Some(holds) = self.holds_joint.get_mut(*vertex as usize) {
                *holds = true;
            }
        }
        for bone in &skeleton.bones {
            let ends = joints.get(bone.head).zip(joints.get(bone.tail));
            self.short_at_rest
                .push(ends.is_some_and(|(head, tail)| distance(*head, *tail) < SHORTEST_BONE));
            self.flat_at_rest.push(
                bone.plane
                    .is_some_and(|plane| flatness(&joints, plane) <= PARALLEL_SINE),
            );
        }
    }

    /// The vertices of faces that are not drawn, without the cubes of joints.
    fn of_helpers(&self) -> Vec<u32> {
        let is_helper = |group: &u32| {
            let group = *group as usize;
            let is_hidden = self
                .scene
                .visible
                .get(group)
                .is_some_and(|visible| !visible);
            is_hidden
                && self
                    .scene
                    .groups
                    .get(group)
                    .is_some_and(|name| !name.starts_with(JOINTS))
        };
        let faces = self
            .scene
            .faces()
            .zip(&self.scene.face_groups)
            .filter(|(_, group)| is_helper(group));
        let vertices: BTreeSet<u32> = faces.flat_map(|(face, _)| face).copied().collect();
        vertices.into_iter().collect()
    }

    pub(super) fn joints(&self, positions: &[Point]) -> Option<Vec<Point>> {
        let skeleton = self.scene.skeleton.as_ref()?;
        skeleton.joint_positions(positions).ok()
    }
}

/// Those of `skin` that are nearest to a joint. `None` without any.
fn anchor(skin: &Nearest, joint: usize, place: Point, rest: &[Point]) -> Option<Anchor> {
    let skin = skin.to(place, SKIN_AROUND_JOINT);
    if skin.is_empty() {
        return None;
    }
    let distance = stand(place, &skin, rest);
    let stand = (distance + radius(&skin, rest)).max(f64::MIN_POSITIVE);
    Some(Anchor {
        joint,
        skin,
        distance,
        stand,
    })
}

/// Distance of a joint from the mean of the skin around it.
pub(super) fn stand(joint: Point, skin: &[u32], positions: &[Point]) -> f64 {
    distance(joint, mean(skin, positions))
}

/// Mean distance of vertices from their own mean.
fn radius(skin: &[u32], positions: &[Point]) -> f64 {
    let mean = mean(skin, positions);
    let points = skin
        .iter()
        .filter_map(|vertex| positions.get(*vertex as usize));
    points.map(|point| distance(*point, mean)).sum::<f64>() / skin.len().max(1) as f64
}

fn mean(skin: &[u32], positions: &[Point]) -> Point {
    let count = skin.len().max(1) as f32;
    let mut sum = [0.0_f32; 3];
    for point in skin
        .iter()
        .filter_map(|vertex| positions.get(*vertex as usize))
    {
        for axis in 0..3 {
            sum[axis] += point[axis];
        }
    }
    sum.map(|sum| sum / count)
}

/// Sine of the angle in the plane of three joints; NaN where two of them coincide.
pub(super) fn flatness(joints: &[Point], plane: [usize; 3]) -> f64 {
    let [a, b, c] = plane.map(|joint| joints.get(joint).copied().unwrap_or([f32::NAN; 3]));
    plane_sine(a, b, c)
}
