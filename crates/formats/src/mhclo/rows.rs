//! Facts on the vertex lines and on the vertices to hide, against the mesh that they are for.

use xxhash_rust::xxh3::xxh3_64;

use super::Reference;
use crate::target::MeshSize;
use mhlint_diag::Tally;

/// Weights whose sum is nearer to 1 than this are rounded.
const SUM_TOLERANCE: f64 = 2e-5;
/// Nearer than this they are written with few decimals.
const COARSE_SUM: f64 = 0.0005;
/// From this distance on it can be seen: some millimetres at the head.
pub const VISIBLE_SUM: f64 = 0.002;

/// Facts on the vertex lines.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RowFacts {
    /// How many there are that give a vertex.
    pub count: usize,
    /// The mesh that they are for, if it is known.
    pub mesh: Option<MeshSize>,
    /// Base vertices that do not exist (line, number as written).
    pub out_of_range: Tally,
    /// Base vertices that are UV-seam duplicates (line, number).
    pub in_seams: Tally,
    /// Numbers of base vertices below 0 or beyond 32 bits (line, number).
    pub unstorable: Tally,
    /// Lines with NaN or infinity (line, vertex of the asset).
    pub non_finite: Tally,
    /// Weights whose sum is not 1 (line, vertex of the asset).
    pub off_sums: Tally,
    /// Those that no rounding explains (line, vertex of the asset).
    pub coarse_sums: Tally,
    /// The sum that is farthest from 1, and the vertex of the asset.
    pub worst_sum: Option<(u64, f64)>,
    /// What the rows are compared by: all of each, and the first vertex with its weight.
    pub prints: [u64; 2],
    /// Whether any row has an offset.
    pub has_offsets: bool,
    /// Whether any row takes part of a second or third vertex.
    pub has_shares: bool,
    /// How many sums are farther from 1 than [`VISIBLE_SUM`].
    pub visible_sums: u64,
}

/// Facts on the vertices to hide.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DeleteFacts {
    /// Numbers that the mesh does not have (line, number).
    pub out_of_range: Tally,
    /// Negative numbers, which count from the end (line, number).
    pub negative: Tally,
    /// Ranges whose second number is lower than the first (line, first number).
    pub reversed: Tally,
    /// Lines that end with a dash: the range is forgotten (line, number before it).
    pub cut_ranges: Tally,
}

impl RowFacts {
    /// Counts a row.
    pub(crate) fn count(&mut self, row: &Reference, is_triple: bool) {
        let own = i64::try_from(self.count).unwrap_or(i64::MAX);
        self.print(row);
        self.has_offsets |= row.offset.iter().any(|part| *part != 0.0);
        self.has_shares |= row.has_shares();
        self.count += 1;
        let numbers = row.weights.iter().chain(&row.offset);
        if numbers.clone().any(|number| !number.is_finite()) {
            self.non_finite.add(row.line, own);
        } else if is_triple {
            self.count_sum(row, own);
        }
        let vertices = if is_triple {
            row.vertices.as_slice()
        } else {
            row.vertices.get(..1).unwrap_or_default()
        };
        for vertex in vertices {
            self.count_vertex(row.line, *vertex);
        }
    }

    /// Beside a vertex that alone has a weight others say nothing, and each writer has its own
    /// there: `v 0 1` in the archives of `MakeHuman` 1, three times the vertex in a text as it is
    /// kept here.
    fn print(&mut self, row: &Reference) {
        let [all, first] = &mut self.prints;
        let ([vertex, second, third], [weight, ..]) = (row.vertices, row.weights);
        let others = if row.has_shares() {
            [second, third]
        } else {
            [0; 2]
        };
        let numbers = row
            .weights
            .iter()
            .chain(&row.offset)
            .flat_map(|number| number.to_le_bytes());
        let mut bytes: Vec<u8> = all.to_le_bytes().into_iter().chain(numbers).collect();
        bytes.extend(
            [vertex]
                .iter()
                .chain(&others)
                .flat_map(|vertex| vertex.to_le_bytes()),
        );
        *all = xxh3_64(&bytes);
        *first = xxh3_64(
            &[
                &first.to_le_bytes()[..],
                &vertex.to_le_bytes(),
                &weight.to_le_bytes(),
            ]
            .concat(),
        );
    }

    fn count_vertex(&mut self, line: u32, vertex: i64) {
        let Ok(number) = u32::try_from(vertex) else {
            return self.unstorable.add(line, vertex);
        };
        let Some(MeshSize {
            vertices,
            with_seams,
        }) = self.mesh
        else {
            return;
        };
        match number as usize {
            number if number >= with_seams => self.out_of_range.add(line, vertex),
            number if number >= vertices => self.in_seams.add(line, vertex),
            _ => {}
        }
    }

    fn count_sum(&mut self, row: &Reference, own: i64) {
        let sum: f64 = row.weights.iter().map(|weight| f64::from(*weight)).sum();
        let off = (sum - 1.0).abs();
        if off < SUM_TOLERANCE {
            return;
        }
        self.off_sums.add(row.line, own);
        if off >= COARSE_SUM {
            self.coarse_sums.add(row.line, own);
        }
        self.visible_sums += u64::from(off > VISIBLE_SUM);
        if self
            .worst_sum
            .is_none_or(|(_, worst)| off > (worst - 1.0).abs())
        {
            self.worst_sum = Some((own.unsigned_abs(), sum));
        }
    }
}

impl DeleteFacts {
    /// Counts a run of vertices, or a single one.
    pub(super) fn count(&mut self, line: u32, run: (i64, i64), mesh: Option<MeshSize>) {
        let (first, last) = run;
        if last < first {
            return self.reversed.add(line, first);
        }
        let Some(size) = mesh.and_then(|mesh| i64::try_from(mesh.vertices).ok()) else {
            return;
        };
        if last >= size || first < -size {
            self.out_of_range
                .add(line, if last >= size { last } else { first });
        } else if first < 0 {
            self.negative.add(line, first);
        }
    }
}
