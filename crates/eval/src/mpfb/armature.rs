//! The axes of bones at rest as an armature of Blender stores them, rounded to 32 bit wherever it
//! does.
//!
//! Source: Blender 4.5, axes of a bone for its direction and roll
//! (`docs/loaders/mpfb/rigs.md#roll`), and the way they take when an armature leaves edit mode:
//! each bone is turned into the space of its parent, and the axes are those of the parent times its
//! own there. Bones of fingers and those that point to -y show each rounding in their fifth digit.

use super::rest::RestBone;
use crate::vector::{Mat3, Point, cross, dot, narrow, round_to_f32, scale, sub, widen};

/// Rows of a 3x3 matrix as Blender stores them.
type Axes = [Point; 3];

/// Sets the axes of bones that have their ends, rolls and parents.
pub fn set_axes(bones: &mut [RestBone]) {
    let mut axes: Vec<Option<Axes>> = vec![None; bones.len()];
    for at in parents_first(bones) {
        let Some(bone) = bones.get_mut(at) else {
            continue;
        };
        let (head, tail) = (narrow(bone.head), narrow(bone.tail));
        let direction = sub(tail, head);
        let roll = round_to_f32(bone.roll);
        let parent = bone
            .parent
            .and_then(|parent| axes.get(parent).copied().flatten());
        let own = parent.map_or_else(
            || of(direction, roll),
            |parent| below(&parent, direction, roll),
        );
        bone.matrix = own.map(widen);
        if let Some(slot) = axes.get_mut(at) {
            *slot = Some(own);
        }
    }
}

/// Axes of a bone, found in the space of its parent.
fn below(parent: &Axes, direction: Point, roll: f32) -> Axes {
    let there = turned(&inverse(parent), direction);
    let without_roll = product(parent, &of(there, 0.0));
    let apart = product(&inverse(&of(direction, roll)), &without_roll);
    product(parent, &of(there, -(apart[0][2].atan2(apart[2][2]))))
}

/// The bones with each behind its parent. There are no circles among accepted parents; chains have
/// any length.
pub fn parents_first(bones: &[RestBone]) -> Vec<usize> {
    let mut order = Vec::with_capacity(bones.len());
    let mut is_taken = vec![false; bones.len()];
    for start in 0..bones.len() {
        let mut way = Vec::new();
        let mut next = Some(start);
        while let Some(at) = next.filter(|at| is_taken.get(*at) == Some(&false)) {
            is_taken[at] = true;
            way.push(at);
            next = bones.get(at).and_then(|bone| bone.parent);
        }
        order.extend(way.into_iter().rev());
    }
    order
}

/// Axes of a bone of this direction and roll. Those of one that points to -y are noise, in Blender
/// as here.
fn of(direction: Point, roll: f32) -> Axes {
    let length = dot(direction, direction).sqrt();
    let direction = direction.map(|part| part * (1.0 / length));
    product(&about(direction, roll), &without_roll(direction))
}

/// The same for roll 0, of a direction of length 1.
pub(super) fn without_roll([a, b, c]: Point) -> Axes {
    let flat = a * a + c * c;
    let mut t = 1.0 + b;
    if t <= NEAR_POLE {
        if flat <= AT_POLE * AT_POLE {
            return [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]];
        }
        t = flat * 0.5 + flat * flat * 0.125;
    }
    [
        [1.0 - a * a / t, a, -a * c / t],
        [-a, b, -c],
        [-a * c / t, c, 1.0 - c * c / t],
    ]
}

const NEAR_POLE: f32 = 0.0061;
const AT_POLE: f32 = 2.5e-4;

/// The turn about an axis of length 1.
fn about([x, y, z]: Point, angle: f32) -> Axes {
    let (sin, cos) = angle.sin_cos();
    let rest = 1.0 - cos;
    [
        [
            x * x * rest + cos,
            x * y * rest - z * sin,
            x * z * rest + y * sin,
        ],
        [
            x * y * rest + z * sin,
            y * y * rest + cos,
            y * z * rest - x * sin,
        ],
        [
            x * z * rest - y * sin,
            y * z * rest + x * sin,
            z * z * rest + cos,
        ],
    ]
}

fn product(a: &Axes, b: &Axes) -> Axes {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
    })
}

fn turned(axes: &Axes, [x, y, z]: Point) -> Point {
    axes.map(|row| row[0] * x + row[1] * y + row[2] * z)
}

fn inverse(axes: &Axes) -> Axes {
    let [a, b, c]: Mat3 = axes.map(widen);
    let columns = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = dot(a, columns[0]);
    let columns = columns.map(|column| scale(column, 1.0 / determinant));
    std::array::from_fn(|i| narrow(columns.map(|column| column[i])))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bone(parent: Option<usize>, tail: [f64; 3], roll: f64) -> RestBone {
        RestBone {
            head: [0.0; 3],
            tail,
            roll,
            matrix: Mat3::default(),
            parent,
            use_connect: false,
        }
    }

    #[test]
    fn a_parent_does_not_change_the_axes_of_its_child() {
        let alone = bone(None, [0.1, 0.3, -0.2], 0.7);
        // The child stands first.
        let mut bones = [
            RestBone {
                parent: Some(1),
                ..alone
            },
            bone(None, [0.0, -1.0, 0.3], 2.0),
        ];
        let mut single = [alone];
        set_axes(&mut bones);
        set_axes(&mut single);
        assert_eq!(parents_first(&bones), [1, 0]);
        for (own, other) in bones[0]
            .matrix
            .iter()
            .flatten()
            .zip(single[0].matrix.iter().flatten())
        {
            assert!((own - other).abs() < 1e-6, "{bones:?} {single:?}");
        }
        // It points along its own y axis.
        let length = 0.14_f64.sqrt();
        assert!((bones[0].matrix[1][1] - 0.3 / length).abs() < 1e-6);
    }

    #[test]
    fn straight_back_has_axes_of_its_own() {
        let mut bones = [bone(None, [0.0, -1.0, 0.0], 0.0)];
        set_axes(&mut bones);
        assert_eq!(
            bones[0].matrix,
            [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]
        );
    }
}
