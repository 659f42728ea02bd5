//! The shape of an asset where its rows put it, against the shape that was drawn.

use super::affine::{Affine, median, square};
use super::{Garment, Triples, Wearer};
use crate::fit::{Reference, fit};
use crate::lists::Lists;
use crate::vector::{Point, Vec3, add, distance, scale, sub, widen};

/// A vertex has left its neighbours when it is away from where their shape puts it by this part of
/// the wearer's height (3.4 cm on hm08): single vertices of MakeHuman's own clothes come to 2.6 cm.
const AWAY: f64 = 0.02;
/// And by this many times what three quarters of all vertices are away at most: rough shapes are
/// rough everywhere.
const ROUGHNESS: f64 = 5.0;
/// And by this part of the length of its edges.
const OF_EDGES: f64 = 0.5;
/// Edges that are longer than drawn by this factor, in proportion to the whole, join points that do
/// not belong together. Those of MakeHuman's assets come to 1.03.
const LONGER: f64 = 1.25;
/// Where they do, no affine map brings the shapes together: the rest is this part of the size of
/// the asset (at most 0.07 for MakeHuman's assets).
const MISFIT: f64 = 0.08;
/// Shapes as far apart as this have nothing in common, whatever the lengths of edges.
const STRANGE: f64 = 0.35;
/// Where edges are shorter than this part of those that were drawn, the drawing is at fault, which
/// does not matter.
const SHORTER: f64 = 0.9;
/// Fewer vertices are no shape.
const FEWEST: usize = 8;
/// Another numbering of rows is meant if with it the shapes are apart by this part of what they are
/// now.
const BETTER: f64 = 0.3;

/// An asset against its drawing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ShapeMeasure {
    /// Single vertices away from their neighbours, the farthest first.
    pub drifts: Vec<Drift>,
    /// Whether its faces join vertices that do not belong together.
    pub disorder: Option<Disorder>,
    /// How the rows would have to be numbered for the shapes to agree.
    pub numbering: Option<Numbering>,
    /// Edges that more than two faces have, whatever the shape.
    pub crowded_edges: Vec<[u32; 2]>,
}

/// A vertex that leaves its neighbours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drift {
    /// Its number.
    pub vertex: usize,
    /// How far it is from where the shape of its neighbours puts it, mesh units.
    pub away: f64,
}

/// Faces that join vertices which do not belong together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disorder {
    /// How many times as long as drawn edges are, in proportion to the size of the asset.
    pub longer: f64,
    /// Whether it is the mirror image of the drawing, and therefore inside out.
    pub is_mirrored: bool,
}

/// Another numbering of rows, or of the vertices in them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbering {
    /// Rows from the last to the first.
    Reversed,
    /// Each row belongs to the vertex before.
    RowBefore,
    /// Each row belongs to the vertex behind.
    RowBehind,
    /// All vertices in the rows are one too high: counted from 1.
    OneLess,
    /// All vertices in the rows are one too low.
    OneMore,
}

const NUMBERINGS: [Numbering; 5] = [
    Numbering::Reversed,
    Numbering::RowBefore,
    Numbering::RowBehind,
    Numbering::OneLess,
    Numbering::OneMore,
];

/// Compares the fitted shape with the drawn one, which has as many vertices.
pub(super) fn measure(
    wearer: &Wearer<'_>,
    garment: &Garment<'_>,
    fitted: &[Point],
    triples: &Triples,
    is_inside_out: bool,
) -> ShapeMeasure {
    let count = fitted.len();
    if count != garment.drawn.len() || count < FEWEST {
        return ShapeMeasure::default();
    }
    let (edges, crowded_edges) = garment.faces.edges(count);
    let mut measure = ShapeMeasure {
        crowded_edges,
        ..ShapeMeasure::default()
    };
    let Some(shapes) = Shapes::of(garment.drawn, fitted, &edges) else {
        return measure;
    };
    measure.disorder = shapes.disorder(&edges, is_inside_out);
    if measure.disorder.is_none() {
        let is_told = |vertex: usize| {
            let in_triples = triples
                .faults
                .binary_search_by_key(&vertex, |(row, _)| *row)
                .is_ok();
            in_triples
                || garment
                    .references
                    .get(vertex)
                    .is_some_and(is_told_by_its_weights)
        };
        measure.drifts = shapes.drifts(&edges, wearer.height, is_told);
    }
    // On a symmetric asset rows in reverse order look like a mirrored mesh: nobody can tell.
    let is_mixed = measure
        .disorder
        .is_some_and(|disorder| !disorder.is_mirrored);
    if is_mixed || !measure.drifts.is_empty() {
        measure.numbering = numbering(wearer, garment, &edges, shapes.misfit);
    }
    measure
}

/// Weights that do not sum to 1 move a vertex by themselves.
pub(super) fn is_told_by_its_weights(reference: &Reference) -> bool {
    (reference.weights.iter().sum::<f32>() - 1.0).abs() > 0.002
}

/// The drawn and the fitted shape.
struct Shapes<'a> {
    drawn: &'a [Point],
    fitted: &'a [Point],
    map: Affine,
    /// What is left between them, as a part of the size.
    misfit: f64,
}

impl<'a> Shapes<'a> {
    fn of(drawn: &'a [Point], fitted: &'a [Point], edges: &[[u32; 2]]) -> Option<Self> {
        let mut used: Vec<u32> = edges.iter().flatten().copied().collect();
        used.sort_unstable();
        used.dedup();
        let points = |all: &[Point]| {
            used.iter()
                .filter_map(|at| all.get(*at as usize).copied())
                .collect::<Vec<_>>()
        };
        let (before, after) = (points(drawn), points(fitted));
        let map = Affine::between(&before, &after)?;
        let rest = before
            .iter()
            .zip(&after)
            .map(|(a, b)| square(sub(map.of_point(widen(*a)), widen(*b))));
        let rest = mean_of_lowest(rest.collect(), 0.9)?.sqrt();
        let misfit = rest / radius(&after)?;
        misfit.is_finite().then_some(Self {
            drawn,
            fitted,
            map,
            misfit,
        })
    }

    fn disorder(&self, edges: &[[u32; 2]], is_inside_out: bool) -> Option<Disorder> {
        let mean = |all: &[Point]| {
            let length = |[one, other]: &[u32; 2]| {
                Some(distance(
                    *all.get(*one as usize)?,
                    *all.get(*other as usize)?,
                ))
            };
            Some(mean_of_lowest(edges.iter().filter_map(length).collect(), 0.95)? / radius(all)?)
        };
        let longer = mean(self.fitted)? / mean(self.drawn)?;
        let is_mixed = longer >= LONGER && self.misfit >= MISFIT
            || longer >= SHORTER && self.misfit >= STRANGE;
        let is_mirrored = !is_mixed && is_inside_out && self.map.is_mirror();
        (is_mixed || is_mirrored).then_some(Disorder {
            longer,
            is_mirrored,
        })
    }

    fn drifts(
        &self,
        edges: &[[u32; 2]],
        height: f64,
        is_told: impl Fn(usize) -> bool,
    ) -> Vec<Drift> {
        let both = edges
            .iter()
            .flat_map(|[one, other]| [(*one as usize, *other), (*other as usize, *one)]);
        let around = Lists::new(self.fitted.len(), both);
        let mut is_out = vec![false; self.fitted.len()];
        let mut away: Vec<(f64, usize)> = Vec::new();
        for vertex in 0..self.fitted.len() {
            away.extend(
                self.away(vertex, around.of(vertex), &is_out)
                    .map(|(away, _)| (away, vertex)),
            );
        }
        let most = away.len() * 3 / 4;
        if most >= away.len() {
            return Vec::new();
        }
        let (_, rough, _) =
            away.select_nth_unstable_by(most, |one, other| one.0.total_cmp(&other.0));
        let limit = (rough.0 * ROUGHNESS).max(height * AWAY);
        away.retain(|(away, _)| *away >= limit);
        away.sort_by(|one, other| other.0.total_cmp(&one.0).then(one.1.cmp(&other.1)));
        let mut drifts = Vec::new();
        for (_, vertex) in away {
            // Without those that have drifted: their neighbours stay where they are.
            let Some((away, own)) = self.away(vertex, around.of(vertex), &is_out) else {
                continue;
            };
            if away < limit
                || own < away * OF_EDGES
                || away < self.edge(vertex, around.of(vertex)) * OF_EDGES
            {
                continue;
            }
            is_out[vertex] = true;
            drifts.extend((!is_told(vertex)).then_some(Drift { vertex, away }));
        }
        drifts
    }

    /// How far a vertex is from where its neighbours and the drawing put it, and how far from their
    /// middle.
    fn away(&self, vertex: usize, around: &[u32], is_out: &[bool]) -> Option<(f64, f64)> {
        let fitted = off_middle(self.fitted, vertex, around, is_out)?;
        let drawn = off_middle(self.drawn, vertex, around, is_out)?;
        let away = square(sub(fitted, self.map.of_direction(drawn))).sqrt();
        away.is_finite().then_some((away, square(fitted).sqrt()))
    }

    /// The middle one of the edges of a vertex.
    fn edge(&self, vertex: usize, around: &[u32]) -> f64 {
        let at = |vertex: usize| self.fitted.get(vertex).copied().unwrap_or_default();
        let mut lengths: Vec<f64> = around
            .iter()
            .map(|other| distance(at(vertex), at(*other as usize)))
            .collect();
        lengths.sort_by(f64::total_cmp);
        lengths.get(lengths.len() / 2).copied().unwrap_or_default()
    }
}

/// From the middle of the neighbours to a vertex; `None` where there are not two.
fn off_middle(all: &[Point], vertex: usize, around: &[u32], is_out: &[bool]) -> Option<Vec3> {
    let own = around
        .iter()
        .filter(|other| is_out.get(**other as usize) == Some(&false));
    let near: Vec<Vec3> = own
        .filter_map(|other| all.get(*other as usize))
        .map(|point| widen(*point))
        .collect();
    let middle = scale(
        near.iter().copied().fold([0.0; 3], add),
        1.0 / near.len() as f64,
    );
    (near.len() >= 2).then(|| sub(widen(all[vertex]), middle))
}

/// How the rows would have to be numbered for the shapes to agree.
fn numbering(
    wearer: &Wearer<'_>,
    garment: &Garment<'_>,
    edges: &[[u32; 2]],
    misfit: f64,
) -> Option<Numbering> {
    let misfits = NUMBERINGS.iter().filter_map(|numbering| {
        let rows = renumbered(garment.references, *numbering)?;
        let fitted = fit(wearer.positions, &rows, garment.scales).ok()?;
        Some((
            Shapes::of(garment.drawn, &fitted, edges)?.misfit,
            *numbering,
        ))
    });
    let (best, numbering) = misfits.min_by(|one, other| one.0.total_cmp(&other.0))?;
    (best < MISFIT.min(misfit * BETTER)).then_some(numbering)
}

fn renumbered(rows: &[Reference], numbering: Numbering) -> Option<Vec<Reference>> {
    let moved = |by: fn(u32) -> Option<u32>| {
        let row = |row: &Reference| {
            let [a, b, c] = row.vertices.map(by);
            Some(Reference {
                vertices: [a?, b?, c?],
                ..*row
            })
        };
        rows.iter().map(row).collect::<Option<Vec<_>>>()
    };
    let mut rows = rows.to_vec();
    match numbering {
        Numbering::Reversed => rows.reverse(),
        Numbering::RowBefore => rows.rotate_left(1),
        Numbering::RowBehind => rows.rotate_right(1),
        Numbering::OneLess => return moved(|vertex| vertex.checked_sub(1)),
        Numbering::OneMore => return moved(|vertex| vertex.checked_add(1)),
    }
    Some(rows)
}

/// The root of the mean square distance from the middle, but for the farthest tenth.
fn radius(points: &[Point]) -> Option<f64> {
    let middle = [0, 1, 2].map(|axis| {
        let all = points
            .iter()
            .map(|point| f64::from(point[axis]))
            .filter(|part| part.is_finite());
        median(all.collect())
    });
    let squares = points
        .iter()
        .map(|point| square(sub(widen(*point), middle)));
    mean_of_lowest(squares.collect(), 0.9)
        .map(f64::sqrt)
        .filter(|radius| *radius > 0.0)
}

/// The mean of the lowest part of finite numbers; `None` without any.
fn mean_of_lowest(mut numbers: Vec<f64>, part: f64) -> Option<f64> {
    numbers.retain(|number| number.is_finite());
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a part of a length"
    )]
    let kept = ((numbers.len() as f64 * part) as usize)
        .max(1)
        .min(numbers.len());
    if kept < numbers.len() {
        numbers.select_nth_unstable_by(kept, f64::total_cmp);
    }
    let lowest = numbers.get(..kept).filter(|lowest| !lowest.is_empty())?;
    Some(lowest.iter().sum::<f64>() / lowest.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faces::Faces;

    /// A sheet of 6 by 6 squares, drawn with bumps.
    struct Sheet {
        drawn: Vec<Point>,
        corners: Vec<u32>,
        starts: Vec<u32>,
    }

    impl Sheet {
        fn new() -> Self {
            let drawn = (0..49_u16).map(|at| {
                [
                    f32::from(at % 7),
                    f32::from(at / 7),
                    f32::from(at * at % 11) * 0.1,
                ]
            });
            let squares = (0..36_u32).map(|at| at / 6 * 7 + at % 6);
            let corners = squares
                .flat_map(|first| [first, first + 1, first + 8, first + 7])
                .collect();
            Self {
                drawn: drawn.collect(),
                corners,
                starts: (0..=36).map(|face| 4 * face).collect(),
            }
        }

        /// Fitted by rows of one vertex each to a base of the same shape, turned and stretched.
        fn measure(&self, rows: &[u32], change: impl Fn(&mut Vec<Reference>)) -> ShapeMeasure {
            let base: Vec<Point> = self
                .drawn
                .iter()
                .map(|p| [-3.0 * p[1], 2.0 * p[0], p[2] + 5.0])
                .collect();
            let mut references: Vec<Reference> = rows
                .iter()
                .map(|vertex| Reference::exact(*vertex))
                .collect();
            change(&mut references);
            let faces = Faces {
                corners: &self.corners,
                starts: &self.starts,
            };
            let garment = Garment {
                references: &references,
                scales: None,
                drawn: &self.drawn,
                faces,
                deleted: &[],
            };
            let wearer = Wearer {
                positions: &base,
                skin: Faces::default(),
                height: 20.0,
            };
            measure(
                &wearer,
                &garment,
                &fit(&base, &references, None).unwrap(),
                &Triples::default(),
                false,
            )
        }
    }

    fn all() -> Vec<u32> {
        (0..49).collect()
    }

    fn drifted(measure: &ShapeMeasure) -> Vec<usize> {
        measure.drifts.iter().map(|drift| drift.vertex).collect()
    }

    #[test]
    fn a_shape_that_is_turned_and_stretched_is_the_same() {
        assert_eq!(
            Sheet::new().measure(&all(), |_| {}),
            ShapeMeasure::default()
        );
    }

    #[test]
    fn a_vertex_that_leaves_its_neighbours_is_found_alone() {
        let sheet = Sheet::new();
        let found = sheet.measure(&all(), |rows| rows[24].offset = [0.0, 0.0, 5.0]);
        assert_eq!(drifted(&found), [24]);
        assert!(
            (found.drifts[0].away - 5.0).abs() < 0.1,
            "{:?}",
            found.drifts
        );
        // By less than half of its edges.
        assert_eq!(
            drifted(&sheet.measure(&all(), |rows| rows[24].offset = [0.0, 0.0, 0.5])),
            [0; 0]
        );
        // Its weights tell it.
        let light = sheet.measure(&all(), |rows| rows[24].weights = [3.0, 0.0, 0.0]);
        assert_eq!(drifted(&light), [0; 0]);
    }

    #[test]
    fn two_exchanged_rows_are_two_vertices() {
        let found = Sheet::new().measure(&all(), |rows| rows.swap(8, 40));
        assert_eq!(
            {
                let mut all = drifted(&found);
                all.sort_unstable();
                all
            },
            [8, 40]
        );
        assert_eq!(found.disorder, None);
    }

    #[test]
    fn a_vertex_that_only_the_drawing_displaces_is_no_finding() {
        let mut sheet = Sheet::new();
        sheet.drawn[24][2] = 0.0;
        let base = sheet.drawn.clone();
        sheet.drawn[24][2] = 50.0;
        let references: Vec<Reference> = all()
            .iter()
            .map(|vertex| Reference::exact(*vertex))
            .collect();
        let faces = Faces {
            corners: &sheet.corners,
            starts: &sheet.starts,
        };
        let garment = Garment {
            references: &references,
            scales: None,
            drawn: &sheet.drawn,
            faces,
            deleted: &[],
        };
        let wearer = Wearer {
            positions: &base,
            skin: Faces::default(),
            height: 20.0,
        };
        assert_eq!(
            measure(&wearer, &garment, &base, &Triples::default(), false),
            ShapeMeasure::default()
        );
    }

    #[test]
    fn other_numberings_are_told() {
        let sheet = Sheet::new();
        let numbering =
            |change: &dyn Fn(&mut Vec<Reference>)| sheet.measure(&all(), change).numbering;
        assert_eq!(
            numbering(&|rows| rows.rotate_left(1)),
            Some(Numbering::RowBehind)
        );
        assert_eq!(
            numbering(&|rows| rows.rotate_right(1)),
            Some(Numbering::RowBefore)
        );
        let scrambled = sheet.measure(&all(), |rows| {
            rows.sort_by_key(|row| row.vertices[0] * 13 % 49);
        });
        assert!(
            scrambled
                .disorder
                .is_some_and(|disorder| disorder.longer > 1.5)
        );
        assert_eq!(scrambled.numbering, None);
    }

    #[test]
    fn what_is_no_shape_is_not_compared() {
        let few = Sheet {
            drawn: vec![[0.0; 3]; 7],
            corners: Vec::new(),
            starts: vec![0],
        };
        assert_eq!(few.measure(&[0; 7], |_| {}), ShapeMeasure::default());
        let flat = Sheet {
            drawn: vec![[1.0; 3]; 49],
            ..Sheet::new()
        };
        assert_eq!(flat.measure(&all(), |_| {}), ShapeMeasure::default());
        let lost = Sheet {
            drawn: vec![[f32::NAN; 3]; 49],
            ..Sheet::new()
        };
        assert_eq!(lost.measure(&all(), |_| {}), ShapeMeasure::default());
    }
}
