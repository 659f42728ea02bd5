//! What a skeleton and its weights come to on a mesh: lengths, planes, rolls, influences, losses,
//! rest pose.

use std::collections::{BTreeMap, BTreeSet};

use super::influences::Influences;
use super::side::{self, Side};
use super::skeleton::{SceneSkeleton, plane_sine, roll_sine};
use super::skin::{pose_bones, skin};
use super::steps::step;
use super::symmetry::MirrorMap;
use super::vector::{Point, distance};
use super::weights::{BoneWeights, Entry, LoadedWeights, merge_duplicates};

/// Influences that real-time engines take.
pub const ENGINE_INFLUENCES: usize = 4;

/// A bone on a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct BoneMeasure {
    /// Its name.
    pub name: String,
    /// Number of its parent.
    pub parent: Option<usize>,
    /// Where it begins.
    pub head: Point,
    /// Where it ends.
    pub tail: Point,
    /// Distance of head and tail, mesh units.
    pub length: f64,
    /// Sine of the angle in its plane, NaN if joints coincide; `None` without a plane.
    pub plane_sine: Option<f64>,
    /// Sine of the angle between bone and plane normal; near 0 the roll is noise.
    pub roll_sine: f64,
}

/// Weights on a mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WeightMeasure {
    /// Most bones on one vertex.
    pub most: usize,
    /// Vertices with more than [`ENGINE_INFLUENCES`], and the share of its weight that each loses
    /// when reduced to them.
    pub over: Vec<(u32, f32)>,
    /// Pairs of bones (left, right by number) whose weights are not mirrored: vertices and largest
    /// difference.
    pub asymmetric: Vec<AsymmetricPair>,
    /// Bones whose weights are on the other half of the mesh than their name says, and their joints
    /// lie.
    pub wrong_side: Vec<usize>,
    /// Vertex farthest from its place after skinning with all bones at rest, and how far, mesh
    /// units.
    pub rest_distance: Option<(u32, f64)>,
}

/// Bones weighted unlike their mirror.
#[derive(Debug, Clone, PartialEq)]
pub struct AsymmetricPair {
    /// Left bone.
    pub left: usize,
    /// Right bone.
    pub right: usize,
    /// Vertices whose weights differ.
    pub vertices: usize,
    /// Largest difference and its vertex on the left bone.
    pub worst: (u32, f32),
}

/// Every bone of a skeleton on a mesh, in its order. `None` if a joint has no vertices in the mesh.
pub fn bones(skeleton: &SceneSkeleton, positions: &[Point]) -> Option<Vec<BoneMeasure>> {
    let joints = skeleton.joint_positions(positions).ok()?;
    let at = |joint: usize| joints.get(joint).copied();
    let mut measures = Vec::with_capacity(skeleton.bones.len());
    for (name, bone) in skeleton.names.iter().zip(&skeleton.bones) {
        let (head, tail) = (at(bone.head)?, at(bone.tail)?);
        let plane = match bone.plane {
            Some([a, b, c]) => Some((at(a)?, at(b)?, at(c)?)),
            None => None,
        };
        let normal = skeleton.normal(&joints, bone).ok()?;
        measures.push(BoneMeasure {
            name: name.clone(),
            parent: bone.parent,
            head,
            tail,
            length: distance(head, tail),
            plane_sine: plane.map(|(a, b, c)| plane_sine(a, b, c)),
            roll_sine: roll_sine(head, tail, normal),
        });
    }
    Some(measures)
}

/// Weights of a skeleton on a mesh. `pairs` are the numbers of left and right bones; `tolerance` is
/// the difference of two mirrored weights that counts.
pub fn weights(
    loaded: &LoadedWeights,
    skeleton: &SceneSkeleton,
    positions: &[Point],
    mirror: &MirrorMap,
    pairs: &[(usize, usize)],
    tolerance: f32,
) -> Option<WeightMeasure> {
    let reduction = Influences::new(&loaded.bones, positions.len())
        .ok()?
        .reduce(ENGINE_INFLUENCES);
    // Of several lists for a bone the first.
    let lists: BTreeMap<usize, &[Entry]> = loaded
        .bones
        .iter()
        .rev()
        .map(|list| (list.bone, list.entries.as_slice()))
        .collect();
    let asymmetry = |pair: &(usize, usize)| {
        asymmetry(
            [lists.get(&pair.0)?, lists.get(&pair.1)?],
            &loaded.raw_sums,
            *pair,
            mirror,
            tolerance,
        )
    };
    Some(WeightMeasure {
        most: reduction.most,
        over: reduction.reduced,
        asymmetric: pairs.iter().filter_map(asymmetry).collect(),
        wrong_side: wrong_side(&loaded.bones, skeleton, positions, positions),
        rest_distance: rest_distance(loaded, skeleton, positions),
    })
}

/// Bones whose weights are on the other half of a mesh than their name says, and their joints lie
/// on the body.
fn wrong_side(
    lists: &[BoneWeights],
    skeleton: &SceneSkeleton,
    body: &[Point],
    positions: &[Point],
) -> Vec<usize> {
    let sides: Vec<[bool; 2]> = skeleton
        .joints
        .iter()
        .map(|joint| sides_of(joint, body))
        .collect();
    lists
        .iter()
        .filter(|list| is_across(list, skeleton, positions, &sides))
        .map(|list| list.bone)
        .collect()
}

/// Bones that have each other's weights on what is worn. Of a single bone only a few vertices may
/// be on an asset, and these may well hang over the middle.
pub fn exchanged(
    lists: &[BoneWeights],
    skeleton: &SceneSkeleton,
    body: &[Point],
    positions: &[Point],
    pairs: &[(usize, usize)],
) -> Vec<usize> {
    let across: BTreeSet<usize> = wrong_side(lists, skeleton, body, positions)
        .into_iter()
        .collect();
    let both = pairs
        .iter()
        .filter(|(left, right)| across.contains(left) && across.contains(right));
    both.flat_map(|(left, right)| [*left, *right]).collect()
}

/// Whether a joint lies wholly on the left, and on the right.
fn sides_of(joint: &[u32], positions: &[Point]) -> [bool; 2] {
    [Side::Left, Side::Right].map(|side| joint.iter().all(|vertex| is_on(positions, *vertex, side)))
}

fn is_on(positions: &[Point], vertex: u32, side: Side) -> bool {
    step();
    positions
        .get(vertex as usize)
        .and_then(|point| Side::at(point[0]))
        == Some(side)
}

/// Whether the weights of a bone with a side in its name are across the middle from its joints, all
/// but a tenth.
fn is_across(
    list: &BoneWeights,
    skeleton: &SceneSkeleton,
    positions: &[Point],
    sides: &[[bool; 2]],
) -> bool {
    let bone = skeleton
        .names
        .get(list.bone)
        .zip(skeleton.bones.get(list.bone));
    let Some(((side, _), bone)) = bone.and_then(|(name, bone)| Some((side::of_bone(name)?, bone)))
    else {
        return false;
    };
    let mut joints = [bone.head, bone.tail]
        .into_iter()
        .filter_map(|joint| sides.get(joint));
    let sum = |wanted: &dyn Fn(u32) -> bool| -> f32 {
        list.entries
            .iter()
            .filter(|(vertex, _)| wanted(*vertex))
            .map(|(_, weight)| weight)
            .sum()
    };
    let across = sum(&|vertex| is_on(positions, vertex, side.other()));
    across > 0.9 * sum(&|_| true)
        && joints.all(|[left, right]| if side == Side::Left { *left } else { *right })
}

/// Entries of one vertex are added, and all are scaled to a sum of 1, so that mending either
/// changes nothing here. Vertices without weights on one side are left out: that is what is wrong
/// there. Costs what the two lists hold, not the size of the mesh.
fn asymmetry(
    [ours, theirs]: [&[Entry]; 2],
    raw_sums: &[f32],
    (left, right): (usize, usize),
    mirror: &MirrorMap,
    tolerance: f32,
) -> Option<AsymmetricPair> {
    let [ours, theirs] = [ours, theirs].map(|entries| {
        let mut weights: BTreeMap<u32, f32> = BTreeMap::new();
        for (vertex, weight) in entries {
            step();
            *weights.entry(*vertex).or_default() += weight;
        }
        weights
    });
    // Partners are mutual.
    let mirrored = theirs.keys().filter_map(|vertex| mirror.partner(*vertex));
    let vertices: BTreeSet<u32> = ours.keys().copied().chain(mirrored).collect();
    let is_weighted = |vertex: u32| raw_sums.get(vertex as usize).is_some_and(|sum| *sum != 0.0);
    let mut pair = AsymmetricPair {
        left,
        right,
        vertices: 0,
        worst: (0, 0.0),
    };
    for vertex in vertices {
        let Some(partner) = mirror.partner(vertex) else {
            continue;
        };
        let weight = |weights: &BTreeMap<u32, f32>, vertex: u32| {
            weights.get(&vertex).copied().unwrap_or(0.0)
        };
        let difference = (weight(&ours, vertex) - weight(&theirs, partner)).abs();
        if difference > tolerance && is_weighted(vertex) && is_weighted(partner) {
            pair.vertices += 1;
            if difference > pair.worst.1 {
                pair.worst = (vertex, difference);
            }
        }
    }
    (pair.vertices > 0).then_some(pair)
}

/// Vertices whose weights do not add up (lost at the threshold) are pulled to the origin even at
/// rest; they are measured by their loss, so the sum is made whole here, and entries of one vertex,
/// of which skinning uses one, are added: what is left is the fault of the matrices.
fn rest_distance(
    loaded: &LoadedWeights,
    skeleton: &SceneSkeleton,
    positions: &[Point],
) -> Option<(u32, f64)> {
    let joints = skeleton.joint_positions(positions).ok()?;
    let rest = skeleton.rest_bones(&joints).ok()?;
    let posed = pose_bones(&skeleton.bones, &rest, &vec![None; skeleton.bones.len()]).ok()?;
    let moved: Vec<_> = posed.iter().map(|bone| bone.moved).collect();
    let mut bones = loaded.bones.clone();
    bones
        .iter_mut()
        .for_each(|list| merge_duplicates(&mut list.entries));
    let skinned = skin(positions, &bones, &moved).ok()?;
    let mut sums = vec![0.0_f32; positions.len()];
    for (vertex, weight) in bones.iter().flat_map(|list| &list.entries) {
        if let Some(sum) = sums.get_mut(*vertex as usize) {
            *sum += weight;
        }
    }
    let whole = |(vertex, point): (u32, &Point)| {
        let sum = sums.get(vertex as usize).copied()?;
        let rest = positions.get(vertex as usize)?;
        Some((vertex, distance(*point, rest.map(|part| part * sum))))
    };
    let far = (0..).zip(&skinned).filter_map(whole);
    far.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Numbers of left and right bones whose names differ in their side only (`.L`/`.R`, `_l`/`_r`,
/// `l-`/`r-` …).
pub fn bone_pairs(names: &[String]) -> Vec<(usize, usize)> {
    let right_of = |name: &str| {
        side::of_bone(name)
            .filter(|(own, _)| *own == Side::Left)
            .map(|(_, right)| right)
    };
    // Of several bones of one name the first.
    let numbers: BTreeMap<&String, usize> = names
        .iter()
        .enumerate()
        .rev()
        .map(|(number, name)| (name, number))
        .collect();
    let mut pairs = Vec::new();
    for (left, name) in names.iter().enumerate() {
        let right = right_of(name).and_then(|right| numbers.get(&right).copied());
        pairs.extend(right.map(|right| (left, right)));
    }
    pairs
}

#[cfg(test)]
mod tests {
    use super::super::load::load;
    use super::super::skeleton::Bone;
    use super::super::steps::steps_of;
    use super::*;

    const POSITIONS: [Point; 4] = [
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [1.0, 2.0, 0.0],
        [-1.0, 2.0, 0.0],
    ];

    fn skeleton() -> SceneSkeleton {
        let bone = |parent, head, tail| Bone {
            parent,
            head,
            tail,
            plane: None,
        };
        SceneSkeleton {
            names: ["root", "arm.L", "arm.R"].map(str::to_owned).to_vec(),
            bones: vec![bone(None, 0, 1), bone(Some(0), 0, 2), bone(Some(0), 1, 3)],
            joint_names: ["a", "b", "c", "d"].map(str::to_owned).to_vec(),
            joints: vec![vec![0], vec![1], vec![2], vec![3]],
            ..SceneSkeleton::default()
        }
    }

    fn measure(lists: &[(usize, &[(u32, f32)])]) -> WeightMeasure {
        let mirror = MirrorMap::new(&POSITIONS, std::iter::empty::<&[u32]>(), 0.01);
        let loaded = load(lists, 0, POSITIONS.len()).unwrap();
        weights(&loaded, &skeleton(), &POSITIONS, &mirror, &[(1, 2)], 0.01).unwrap()
    }

    #[test]
    fn weights_across_the_middle_are_told_from_a_few_strays() {
        let exchanged = measure(&[
            (0, &[(0, 1.0), (1, 1.0)]),
            (1, &[(3, 1.0)]),
            (2, &[(2, 1.0)]),
        ]);
        // The first joint of an arm is its shoulder: both joints are on the side of its name.
        assert_eq!(exchanged.wrong_side, [1, 2]);
        let stray = measure(&[(1, &[(0, 0.4), (2, 0.6), (3, 0.5)]), (2, &[(1, 1.0)])]);
        assert!(stray.wrong_side.is_empty());
    }

    #[test]
    fn what_is_worn_is_exchanged_where_both_bones_are_across() {
        let worn = [[0.5, 0.0, 0.0], [-0.5, 0.0, 0.0]];
        let list = |bone, vertex| BoneWeights {
            bone,
            entries: vec![(vertex, 1.0)],
        };
        let found =
            |lists: &[BoneWeights]| exchanged(lists, &skeleton(), &POSITIONS, &worn, &[(1, 2)]);
        assert_eq!(found(&[list(1, 1), list(2, 0)]), [1, 2]);
        assert!(
            found(&[list(1, 0), list(2, 1)]).is_empty()
                && found(&[list(1, 1), list(2, 1)]).is_empty()
        );
    }

    #[test]
    fn rest_pose_gives_the_mesh_back() {
        let found = measure(&[
            (0, &[(0, 1.0), (1, 1.0)]),
            (1, &[(2, 1.0)]),
            (2, &[(3, 1.0)]),
        ]);
        assert!(found.rest_distance.unwrap().1 < 1e-6);
        assert_eq!(
            (found.most, found.over.len(), found.asymmetric.len()),
            (1, 0, 0)
        );
    }

    #[test]
    fn weights_unlike_their_mirror_are_counted() {
        let found = measure(&[
            (0, &[(0, 1.0), (1, 1.0), (3, 0.5)]),
            (1, &[(2, 1.0)]),
            (2, &[(3, 0.5)]),
        ]);
        assert_eq!(
            found.asymmetric,
            [AsymmetricPair {
                left: 1,
                right: 2,
                vertices: 1,
                worst: (2, 0.5)
            }]
        );
    }

    #[test]
    fn pairs_of_bones_cost_their_weights_and_not_the_mesh() {
        let count = 2000_u16;
        let side = |x: f32| (0..count).map(move |y| [x, f32::from(y), 0.0]);
        let positions: Vec<Point> = side(1.0).chain(side(-1.0)).collect();
        let mut rig = skeleton();
        rig.names = (0..count)
            .flat_map(|bone| [format!("{bone}.L"), format!("{bone}.R")])
            .collect();
        // All bones share one joint of half of the vertices.
        rig.bones = vec![
            Bone {
                parent: None,
                head: 0,
                tail: 0,
                plane: None
            };
            rig.names.len()
        ];
        rig.joints = vec![(0..u32::from(count)).collect()];
        let lists: Vec<[Entry; 1]> = (0..u32::from(count))
            .flat_map(|at| [[(at + u32::from(count), 1.0)], [(at, 1.0)]])
            .collect();
        let lists: Vec<(usize, &[Entry])> = lists
            .iter()
            .map(<[Entry; 1]>::as_slice)
            .enumerate()
            .collect();
        let loaded = load(&lists, 0, positions.len()).unwrap();
        let mirror = MirrorMap::new(&positions, std::iter::empty::<&[u32]>(), 0.01);
        let pairs = bone_pairs(&rig.names);
        assert_eq!(pairs.len(), usize::from(count));
        let steps = steps_of(|| _ = weights(&loaded, &rig, &positions, &mirror, &pairs, 0.01));
        assert!(steps < 20 * u64::from(count), "{steps}");
    }

    #[test]
    fn sums_and_repeats_are_looked_through() {
        let scaled = measure(&[
            (0, &[(0, 1.0), (1, 1.0)]),
            (1, &[(2, 1.0)]),
            (2, &[(3, 0.25)]),
        ]);
        assert_eq!(scaled.asymmetric, []);
        let repeated = measure(&[
            (0, &[(0, 1.0), (1, 1.0)]),
            (1, &[(2, 1.0)]),
            (2, &[(3, 0.5), (3, 0.5)]),
        ]);
        assert_eq!(
            (
                repeated.asymmetric,
                repeated.rest_distance.map(|rest| rest.1 < 1e-6)
            ),
            (vec![], Some(true))
        );
        let shared = measure(&[
            (0, &[(0, 1.0), (1, 1.0), (3, 0.5)]),
            (1, &[(2, 1.0)]),
            (2, &[(3, 1.0)]),
        ]);
        assert_eq!(shared.asymmetric.first().map(|pair| pair.vertices), Some(1));
        let unweighted = measure(&[
            (0, &[(0, 1.0), (1, 1.0)]),
            (1, &[(2, 1.0)]),
            (2, &[(1, 0.0)]),
        ]);
        assert_eq!(unweighted.asymmetric, []);
    }

    #[test]
    fn bones_know_length_and_roll() {
        let found = bones(&skeleton(), &POSITIONS).unwrap();
        assert_eq!((found[0].length, found[1].length), (2.0, 2.0));
        assert!(found[1].roll_sine < 1e-9 && found[0].roll_sine > 0.99);
    }

    #[test]
    fn pairs_are_found_by_name() {
        let names = ["root", "arm.L", "arm.R", "calf_l", "calf_r", "x.L"].map(str::to_owned);
        assert_eq!(bone_pairs(&names), [(1, 2), (3, 4)]);
    }
}
