//! A base mesh of MPFB whose vertices lie elsewhere than its tables say: nothing that is measured
//! on it means anything (`docs/loaders/mpfb/base-mesh.md#the-mesh`).

use crate::cubes::{Strays, strays};
use mhlint_formats::mesh_metadata::{MirrorRow, MirrorTable, VertexGroup, VertexGroups};
use mhlint_formats::obj::Mesh;

/// Where the vertices lie instead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Misplaced {
    /// The mesh is largest along this axis.
    Lying(&'static str),
    /// It has another unit; its height in units of the file.
    OtherSize(f32),
    /// Left and right are exchanged: vertices that are on the other side than the mirror table
    /// says, of so many.
    Mirrored(usize, usize),
    /// Vertices have other numbers: those that are not where the mirror table has them, of so many.
    Order(usize, usize),
    /// The same shown by the cubes of joints, which have other vertices than in the table of
    /// groups.
    Cubes(Strays),
}

/// Vertices of the one base mesh that there is. Of any other mesh nobody knows how large it should
/// be.
const VERTICES: usize = 19_158;
/// Its height along y, in units of the file (dm).
pub const HEIGHT: f32 = 16.9;
/// A mesh this many times higher or lower has another unit. No edit of a figure comes near.
const OTHER_UNIT: f32 = 3.0;
/// Nearer to the middle than this a vertex has no side, mesh units.
pub const MIDDLE: f32 = 1e-3;
/// Counterparts are farther from where they mirror each other only where numbers are wrong, mesh
/// units.
const APART: f32 = 0.5;
/// More vertices no cube of a joint has.
const LARGEST_CUBE: i64 = 64;
/// Where one vertex of so many is not where it should be, all numbers are in doubt; fewer are
/// faults of the table.
const MANY: usize = 4;

impl Misplaced {
    /// Whether it is the numbers of the vertices that are others.
    pub const fn is_of_numbers(self) -> bool {
        matches!(self, Self::Order(..) | Self::Cubes(_))
    }

    /// What is wrong with a mesh of which every line was read.
    pub(super) fn of(
        mesh: &Mesh,
        mirror: Option<&MirrorTable>,
        groups: Option<&VertexGroups>,
    ) -> Option<Self> {
        if mesh.facts.unreadable_lines > 0 {
            return None;
        }
        let by_size = (mesh.facts.vertices == VERTICES)
            .then(|| by_size(mesh))
            .flatten();
        let mirror = mirror.filter(|table| table.unreadable.is_none());
        let by_mirror = || mirror.and_then(|table| by_mirror(mesh, table, groups));
        by_size
            .or_else(by_mirror)
            .or_else(|| by_cubes(mesh, groups?))
    }
}

/// Whether most cubes of joints have other vertices than the table of groups says.
fn by_cubes(mesh: &Mesh, groups: &VertexGroups) -> Option<Misplaced> {
    let of_joint = |group: &'_ VertexGroup| match group.ranges.as_slice() {
        [(first, last)]
            if last
                .checked_sub(*first)
                .is_some_and(|more| more < LARGEST_CUBE) =>
        {
            Some((*first..=*last).collect())
        }
        _ => None,
    };
    let joints = groups
        .groups
        .iter()
        .filter_map(|group| Some((group.name.strip_prefix("joint-")?, of_joint(group)?)));
    strays(mesh, joints).map(Misplaced::Cubes)
}

fn by_size(mesh: &Mesh) -> Option<Misplaced> {
    let [wide, high, deep] = extent(mesh)?;
    let tallest = wide.max(high).max(deep);
    if high < tallest {
        return Some(Misplaced::Lying(if wide < tallest { "z" } else { "x" }));
    }
    let is_far = high > HEIGHT * OTHER_UNIT || high * OTHER_UNIT < HEIGHT;
    is_far.then_some(Misplaced::OtherSize(high))
}

/// How far the mesh reaches along each axis.
fn extent(mesh: &Mesh) -> Option<[f32; 3]> {
    let mut ends = [(f32::INFINITY, f32::NEG_INFINITY); 3];
    for position in &mesh.positions {
        for ((low, high), value) in ends.iter_mut().zip(position) {
            // NaN has a finding of its own, and is passed over here.
            *low = low.min(*value);
            *high = high.max(*value);
        }
    }
    let sizes = ends.map(|(low, high)| high - low);
    sizes.iter().all(|size| size.is_finite()).then_some(sizes)
}

fn by_mirror(mesh: &Mesh, table: &MirrorTable, groups: Option<&VertexGroups>) -> Option<Misplaced> {
    let place = |vertex: u32| mesh.positions.get(vertex as usize).copied();
    let count = |is: &dyn Fn(&MirrorRow) -> bool| table.rows.iter().filter(|row| is(row)).count();
    let is_sided = |row: &MirrorRow| {
        row.side != b'm' && place(row.from).is_some_and(|[x, ..]| x.abs() > MIDDLE)
    };
    let (sided, across) = (
        count(&is_sided),
        count(&|row| is_sided(row) && is_across(row, place(row.from))),
    );
    let strays = |row: &MirrorRow| {
        let ([x, y, z], other) = (place(row.from)?, place(row.to)?);
        let apart = [other[0] + x, other[1] - y, other[2] - z];
        Some(apart.iter().any(|part| part.abs() > APART))
    };
    let strayed = count(&|row| strays(row) == Some(true));
    if strayed > table.rows.len() / MANY {
        return Some(Misplaced::Order(strayed, table.rows.len()));
    }
    // Where joints are on their sides the table is at fault.
    let is_mirrored =
        across > sided / 2 && groups.is_some_and(|groups| are_joints_across(mesh, groups));
    is_mirrored.then_some(Misplaced::Mirrored(across, sided))
}

/// Whether most joints of a side, such as `joint-l-hand`, lie on the other one.
fn are_joints_across(mesh: &Mesh, groups: &VertexGroups) -> bool {
    let side = |name: &str| match name.strip_prefix("joint-")?.get(..2)? {
        "l-" => Some(1.0),
        "r-" => Some(-1.0),
        _ => None,
    };
    let own_side = |group: &VertexGroup| {
        let (first, _) = group.ranges.first()?;
        let [x, ..] = mesh.positions.get(usize::try_from(*first).ok()?)?;
        Some(side(&group.name)? * x)
    };
    let sided: Vec<f32> = groups
        .groups
        .iter()
        .filter_map(own_side)
        .filter(|x| x.abs() > MIDDLE)
        .collect();
    sided.iter().filter(|x| **x < 0.0).count() > sided.len() / 2
}

/// Whether a vertex is on the other side than its row says.
pub fn is_across(row: &MirrorRow, place: Option<[f32; 3]>) -> bool {
    let x = place.map_or(0.0, |[x, ..]| x);
    x.abs() > MIDDLE && (row.side == b'l' && x < 0.0 || row.side == b'r' && x > 0.0)
}
