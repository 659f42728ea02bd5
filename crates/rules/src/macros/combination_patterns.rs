//! Absent combinations of a cross product: which of them are a system and which a hole, and how to
//! say it shortly.
//!
//! Pure functions over a grid of cells (mixed radix, the last component runs fastest). An absent
//! cell is part of a *system* if
//! * one of its values is absent everywhere, and leaves out more than one combination (or is
//!   neutral): the macro is not meant for it;
//! * or it has neutral values, and no listed cell with the same neutral values moves anything (none
//!   listed, or two and more, all null, and something listed around the neutral state).
//!
//! Neither holds where a cell of the slice in question is *wanted*: files wait for it.
//!
//! Every other absent cell is a *hole*.

/// Largest grid that is walked, wildcard cells included.
pub(super) const LIMIT: usize = 1 << 20;

/// Patterns are joined into value sets only below this number; the work grows with its square.
const JOINED: usize = 256;

/// What the table has for a combination.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cell {
    Target,
    Null,
    Absent,
}

/// For each component the values meant; empty for all of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Pattern {
    pub(crate) values: Vec<Vec<usize>>,
}

impl Pattern {
    /// How many combinations it stands for.
    pub(super) fn count(&self, sizes: &[usize]) -> usize {
        let widths = self.values.iter().zip(sizes);
        widths
            .map(|(values, size)| {
                if values.is_empty() {
                    *size
                } else {
                    values.len()
                }
            })
            .product()
    }
}

/// Whether a grid is small enough to be walked.
pub(crate) fn is_walkable(sizes: &[usize]) -> bool {
    sizes
        .iter()
        .try_fold(1_usize, |cells, size| cells.checked_mul(size + 1))
        .is_some_and(|cells| cells <= LIMIT)
}

/// Place of a combination in the grid.
pub(crate) fn index(sizes: &[usize], combination: &[usize]) -> usize {
    sizes
        .iter()
        .zip(combination)
        .fold(0, |index, (size, value)| index * size + value)
}

/// The combination at a place of the grid.
pub(super) fn digits(sizes: &[usize], mut index: usize) -> Vec<usize> {
    let mut digits = vec![0; sizes.len()];
    for (digit, size) in digits.iter_mut().zip(sizes).rev() {
        *digit = index % size;
        index /= size;
    }
    digits
}

/// For each cell whether it belongs to a system of absent ones. `neutral` tells the neutral values
/// of each component, `wanted` the cells that a file waits for.
pub(super) fn systematic(
    sizes: &[usize],
    cells: &[Cell],
    neutral: &[Vec<bool>],
    wanted: &[bool],
) -> Vec<bool> {
    let cube = Cube::new(sizes);
    let listed = cube.counts(|cell| cells.get(cell) != Some(&Cell::Absent));
    let moving = cube.counts(|cell| cells.get(cell) == Some(&Cell::Target));
    let waiting = cube.counts(|cell| wanted.get(cell) == Some(&true));
    let is_neutral = |axis: usize, value: usize| {
        neutral.get(axis).and_then(|values| values.get(value)) == Some(&true)
    };
    let slice = |counts: &[u32], place: usize| counts.get(place).copied().unwrap_or(0);
    let whole = cube.len - 1;
    let width = |axis: usize| cells.len() / sizes.get(axis).copied().unwrap_or(1).max(1);
    // Of each component the values that nothing is listed for.
    let absent_values: Vec<Vec<bool>> = (0..sizes.len())
        .map(|axis| {
            let is_absent = |value: usize| {
                let place = cube.narrowed(whole, axis, value);
                let is_meant = slice(&listed, place) > 0 || slice(&waiting, place) > 0;
                !is_meant && (width(axis) > 1 || is_neutral(axis, value))
            };
            (0..sizes.get(axis).copied().unwrap_or(0))
                .map(is_absent)
                .collect()
        })
        .collect();
    let mut result = vec![false; cells.len()];
    let mut digits = vec![0; sizes.len()];
    for (cell, result) in cells.iter().zip(&mut result) {
        if *cell == Cell::Absent {
            let mut own = absent_values.iter().zip(&digits);
            let value_absent = own.any(|(absent, value)| absent.get(*value) == Some(&true));
            // The neutral values fixed and the others free, and the other way round.
            let (mut state, mut around) = (whole, whole);
            for (axis, value) in digits.iter().enumerate() {
                let part = if is_neutral(axis, *value) {
                    &mut state
                } else {
                    &mut around
                };
                *part = cube.narrowed(*part, axis, *value);
            }
            let nulls = slice(&listed, state);
            let neutral_state = state != whole
                && slice(&moving, state) == 0
                && slice(&waiting, state) == 0
                && (nulls == 0 || nulls > 1 && slice(&listed, around) > 0);
            *result = value_absent || neutral_state;
        }
        advance(sizes, &mut digits);
    }
    result
}

/// The next combination of the grid.
fn advance(sizes: &[usize], digits: &mut [usize]) {
    for (digit, size) in digits.iter_mut().zip(sizes).rev() {
        *digit += 1;
        if *digit < *size {
            return;
        }
        *digit = 0;
    }
}

/// Few patterns that together stand for exactly the member cells: largest first, those that others
/// make superfluous left out.
pub(crate) fn cover(sizes: &[usize], member: &[bool]) -> Vec<Pattern> {
    let cube = Cube::new(sizes);
    let counts = cube.counts(|cell| member.get(cell) == Some(&true));
    let mut maximal = cube.maximal(&counts);
    maximal.sort_by_key(|fixed| std::cmp::Reverse(cube.size(fixed)));
    let mut times = vec![0_u32; member.len()];
    let mut chosen = Vec::new();
    for fixed in maximal {
        let cells = cube.cells(&fixed);
        if cells.iter().any(|cell| times.get(*cell) == Some(&0)) {
            add(&mut times, &cells, 1);
            chosen.push(fixed);
        }
    }
    for at in (0..chosen.len()).rev() {
        let cells = chosen
            .get(at)
            .map(|fixed| cube.cells(fixed))
            .unwrap_or_default();
        if cells
            .iter()
            .all(|cell| times.get(*cell).is_some_and(|times| *times > 1))
        {
            add(&mut times, &cells, -1);
            chosen.remove(at);
        }
    }
    let single = |fixed: Vec<Option<usize>>| Pattern {
        values: fixed.into_iter().map(|v| v.into_iter().collect()).collect(),
    };
    join(chosen.into_iter().map(single).collect(), sizes)
}

fn add(times: &mut [u32], cells: &[usize], change: i32) {
    for cell in cells {
        if let Some(times) = times.get_mut(*cell) {
            *times = times.saturating_add_signed(change);
        }
    }
}

/// Joins patterns that differ in the values of one component only.
fn join(mut patterns: Vec<Pattern>, sizes: &[usize]) -> Vec<Pattern> {
    if patterns.len() > JOINED {
        return patterns;
    }
    let mut at = 0;
    while at < patterns.len() {
        let joined = (at + 1..patterns.len()).find_map(|other| {
            let (a, b) = (patterns.get(at)?, patterns.get(other)?);
            Some((other, joined(a, b, sizes)?))
        });
        if let Some((other, pattern)) = joined {
            patterns.remove(other);
            if let Some(place) = patterns.get_mut(at) {
                *place = pattern;
            }
            at = 0;
        } else {
            at += 1;
        }
    }
    patterns
}

fn joined(a: &Pattern, b: &Pattern, sizes: &[usize]) -> Option<Pattern> {
    let mut differing = (0..sizes.len()).filter(|axis| a.values.get(*axis) != b.values.get(*axis));
    let axis = differing.next()?;
    if differing.next().is_some() {
        return None;
    }
    let (first, second) = (a.values.get(axis)?, b.values.get(axis)?);
    if first.is_empty() || second.is_empty() {
        return None;
    }
    let mut values: Vec<usize> = first.iter().chain(second).copied().collect();
    values.sort_unstable();
    values.dedup();
    if values.len() == *sizes.get(axis)? {
        values.clear();
    }
    let mut pattern = a.clone();
    *pattern.values.get_mut(axis)? = values;
    Some(pattern)
}

/// The grid with one more place per component that stands for all its values.
struct Cube<'a> {
    sizes: &'a [usize],
    strides: Vec<usize>,
    len: usize,
}

impl<'a> Cube<'a> {
    fn new(sizes: &'a [usize]) -> Self {
        let mut strides = vec![0; sizes.len()];
        let mut len = 1;
        for (stride, size) in strides.iter_mut().zip(sizes).rev() {
            *stride = len;
            len *= size + 1;
        }
        Self {
            sizes,
            strides,
            len,
        }
    }

    /// The slice at a place, in which a component is free, with that one fixed.
    fn narrowed(&self, place: usize, axis: usize, value: usize) -> usize {
        let (size, stride) = self.axis(axis);
        place - (size - value) * stride
    }

    fn axis(&self, axis: usize) -> (usize, usize) {
        let size = self.sizes.get(axis).copied().unwrap_or(0);
        (size, self.strides.get(axis).copied().unwrap_or(0))
    }

    fn fixed(&self, index: usize) -> Vec<Option<usize>> {
        let digits = self
            .sizes
            .iter()
            .zip(&self.strides)
            .map(|(size, stride)| (index / stride % (size + 1), *size));
        digits
            .map(|(digit, size)| (digit < size).then_some(digit))
            .collect()
    }

    fn size(&self, fixed: &[Option<usize>]) -> usize {
        fixed
            .iter()
            .zip(self.sizes)
            .map(|(value, size)| if value.is_some() { 1 } else { *size })
            .product()
    }

    /// Cells of a slice.
    fn cells(&self, fixed: &[Option<usize>]) -> Vec<usize> {
        let mut cells = vec![0];
        for (value, size) in fixed.iter().zip(self.sizes) {
            let range = value.map_or(0..*size, |value| value..value + 1);
            cells = cells
                .iter()
                .flat_map(|cell| range.clone().map(move |value| cell * size + value))
                .collect();
        }
        cells
    }

    /// For every slice how many of its cells fulfil a condition.
    fn counts(&self, holds: impl Fn(usize) -> bool) -> Vec<u32> {
        let mut counts = vec![0; self.len];
        let total: usize = self.sizes.iter().product();
        let mut digits = vec![0; self.sizes.len()];
        for cell in 0..total {
            let place: usize = digits
                .iter()
                .zip(&self.strides)
                .map(|(digit, stride)| digit * stride)
                .sum();
            if let Some(count) = counts.get_mut(place).filter(|_| holds(cell)) {
                *count = 1;
            }
            advance(self.sizes, &mut digits);
        }
        for (size, stride) in self.sizes.iter().zip(&self.strides) {
            for all in (0..self.len).filter(|index| index / stride % (size + 1) == *size) {
                let sum = (1..=*size)
                    .filter_map(|back| counts.get(all - back * stride))
                    .sum();
                if let Some(count) = counts.get_mut(all) {
                    *count = sum;
                }
            }
        }
        counts
    }

    /// Slices whose cells are all counted and that cannot be widened.
    fn maximal(&self, counts: &[u32]) -> Vec<Vec<Option<usize>>> {
        let is_full = |place: usize, size: usize| {
            counts
                .get(place)
                .is_some_and(|count| *count as usize == size)
        };
        let is_maximal = |place: usize| {
            if counts.get(place).is_none_or(|count| *count == 0) {
                return false;
            }
            let axes = || self.sizes.iter().zip(&self.strides);
            let digit = |size: &usize, stride: &usize| place / stride % (size + 1);
            let cells: usize = axes()
                .map(|(size, stride)| {
                    if digit(size, stride) < *size {
                        1
                    } else {
                        *size
                    }
                })
                .product();
            let is_wider = |(size, stride): (&usize, &usize)| {
                let digit = digit(size, stride);
                digit < *size && is_full(place + (size - digit) * stride, cells * size)
            };
            is_full(place, cells) && !axes().any(is_wider)
        };
        (0..self.len)
            .filter(|place| is_maximal(*place))
            .map(|place| self.fixed(place))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn texts(patterns: &[Pattern]) -> Vec<String> {
        let axis = |values: &Vec<usize>| match values.as_slice() {
            [] => "*".to_owned(),
            values => values
                .iter()
                .map(ToString::to_string)
                .collect::<Vec<_>>()
                .join("|"),
        };
        patterns
            .iter()
            .map(|pattern| {
                pattern
                    .values
                    .iter()
                    .map(axis)
                    .collect::<Vec<_>>()
                    .join("-")
            })
            .collect()
    }

    fn members(sizes: &[usize], test: impl Fn(&[usize]) -> bool) -> Vec<bool> {
        (0..sizes.iter().product())
            .map(|cell| test(&digits(sizes, cell)))
            .collect()
    }

    #[test]
    fn crossing_slices_are_two_patterns() {
        let sizes = [2, 4, 3, 3, 3];
        let absent = members(&sizes, |at| at[1] == 0 || at[4] == 1);
        let patterns = cover(&sizes, &absent);
        assert_eq!(texts(&patterns), ["*-*-*-*-1", "*-0-*-*-*"]);
        assert_eq!(patterns[0].count(&sizes), 72);
    }

    #[test]
    fn neighbours_become_value_sets() {
        let sizes = [2, 4, 3];
        let absent = members(&sizes, |at| {
            at[0] == 1 && (at[1] == 1 || at[1] == 2) && at[2] == 0
        });
        assert_eq!(texts(&cover(&sizes, &absent)), ["1-1|2-0"]);
        assert_eq!(texts(&cover(&sizes, &members(&sizes, |_| true))), ["*-*-*"]);
    }

    #[test]
    fn single_cells_are_holes_and_neutral_products_are_not() {
        let sizes = [2, 3, 3];
        let neutral = [
            vec![false, false],
            vec![false, true, false],
            vec![false, true, false],
        ];
        let cells: Vec<Cell> = members(&sizes, |at| (at[1], at[2]) == (1, 1) || at == [0, 2, 1])
            .into_iter()
            .map(|absent| if absent { Cell::Absent } else { Cell::Target })
            .collect();
        let found = systematic(&sizes, &cells, &neutral, &[]);
        assert_eq!(found, members(&sizes, |at| (at[1], at[2]) == (1, 1)));
    }

    #[test]
    fn a_value_without_any_entry_is_a_system_unless_it_is_a_single_cell() {
        let absent = |sizes: &[usize]| -> Vec<Cell> {
            let cells = members(sizes, |at| at[0] == 0).into_iter();
            cells
                .map(|absent| if absent { Cell::Absent } else { Cell::Target })
                .collect()
        };
        assert_eq!(
            systematic(&[2], &absent(&[2]), &[vec![false; 2]], &[]),
            [false, false]
        );
        assert_eq!(
            systematic(
                &[2, 2],
                &absent(&[2, 2]),
                &[vec![false; 2], vec![false; 2]],
                &[]
            ),
            [true, true, false, false]
        );
        let waiting = [false, true, false, false];
        let found = systematic(
            &[2, 2],
            &absent(&[2, 2]),
            &[vec![false; 2], vec![false; 2]],
            &waiting,
        );
        assert_eq!(found, [false; 4]);
    }

    #[test]
    fn two_null_siblings_make_it_harmless_and_one_does_not() {
        let neutral = [vec![false; 3], vec![true, false]];
        let cell = |second| {
            [
                Cell::Absent,
                Cell::Target,
                second,
                Cell::Target,
                Cell::Null,
                Cell::Target,
            ]
        };
        assert!(systematic(&[3, 2], &cell(Cell::Null), &neutral, &[])[0]);
        assert!(!systematic(&[3, 2], &cell(Cell::Target), &neutral, &[])[0]);
        assert!(!systematic(&[2, 2], &cell(Cell::Null)[..4], &neutral, &[])[0]);
    }

    #[test]
    fn only_small_grids_are_walked() {
        assert!(is_walkable(&[3; 10]));
        assert!(!is_walkable(&[10; 10]) && !is_walkable(&[usize::MAX - 1; 3]));
    }

    fn grids() -> impl Strategy<Value = (Vec<usize>, Vec<bool>)> {
        let sizes = prop::collection::vec(1_usize..5, 1..5);
        sizes.prop_flat_map(|sizes| {
            let total = sizes.iter().product::<usize>();
            (Just(sizes), prop::collection::vec(any::<bool>(), total))
        })
    }

    proptest! {
        #[test]
        fn patterns_cover_exactly_the_members((sizes, absent) in grids()) {
            let patterns = cover(&sizes, &absent);
            let covered = members(&sizes, |at| {
                patterns.iter().any(|pattern| {
                    pattern.values.iter().zip(at).all(|(values, value)| values.is_empty() || values.contains(value))
                })
            });
            prop_assert_eq!(covered, absent);
        }
    }
}
