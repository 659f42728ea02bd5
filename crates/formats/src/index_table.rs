//! Packed tables of MPFB's base mesh: the vertices of each face, the faces of each vertex
//! (`docs/loaders/mpfb/base-mesh.md#metadata`).

use super::json_file::JsonFault;
use super::packed_json::text_fault;
use mhlint_json::{Reader, SyntaxFault};
use mhlint_source::Encoding;

/// A list of lists of numbers.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct IndexTable {
    /// Why it is no JSON.
    pub fault: Option<JsonFault>,
    /// Whether it is a list.
    pub is_list: bool,
    /// The first row that is no list of whole numbers, and how many there are.
    pub misshapen: Option<(usize, usize)>,
    /// Where each row ends in `numbers`.
    ends: Vec<u32>,
    /// The numbers of all rows. What is no index is [`NO_INDEX`].
    numbers: Vec<u32>,
}

/// Stands for a whole number that cannot be an index.
const NO_INDEX: u32 = u32::MAX;

/// Rows and numbers that are kept. The base mesh has a hundredth of it.
const MOST: usize = 8_000_000;

type Step<T> = Result<T, SyntaxFault>;

/// Reads all rows.
pub fn read(text: &[u8], encoding: &Encoding) -> IndexTable {
    let mut table = IndexTable {
        fault: text_fault(text, encoding),
        ..IndexTable::default()
    };
    if table.fault.is_none() {
        table.fault = table
            .rows_of(&mut Reader::new(text))
            .err()
            .map(JsonFault::Syntax);
    }
    table
}

impl IndexTable {
    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.ends.len()
    }

    /// Whether every row can be read.
    pub fn is_sound(&self) -> bool {
        self.fault.is_none() && self.is_list && self.misshapen.is_none()
    }

    /// The numbers of a row.
    pub fn row(&self, at: usize) -> &[u32] {
        let start = at
            .checked_sub(1)
            .and_then(|before| self.ends.get(before))
            .copied()
            .unwrap_or_default();
        let end = self.ends.get(at).copied().unwrap_or(start);
        self.numbers
            .get(start as usize..end as usize)
            .unwrap_or_default()
    }

    /// The largest number in any row.
    pub fn largest(&self) -> Option<u32> {
        self.numbers.iter().copied().max()
    }

    /// Whether it has the rows of `other` in which each of its own numbers is, and that has no
    /// other numbers.
    pub fn is_inverse_of(&self, other: &Self) -> bool {
        let rows: Vec<Vec<u32>> = (0..other.rows()).map(|at| sorted(other.row(at))).collect();
        let is_inside = other
            .largest()
            .is_none_or(|largest| (largest as usize) < self.rows());
        let found = inverse(&rows, self.rows());
        is_inside
            && found
                .iter()
                .enumerate()
                .all(|(at, own)| sorted(self.row(at)) == *own)
    }

    fn rows_of(&mut self, reader: &mut Reader<'_>) -> Step<()> {
        self.is_list = reader.peek() == Some(b'[');
        if !self.is_list {
            reader.pass()?;
            return reader.finish();
        }
        reader.open()?;
        while reader.more(b']')? {
            let is_row = self.row_of(reader)?;
            if !is_row {
                self.misshapen.get_or_insert((self.ends.len(), 0)).1 += 1;
            }
            if self.ends.len() < MOST {
                self.ends
                    .push(u32::try_from(self.numbers.len()).unwrap_or(u32::MAX));
            }
        }
        reader.finish()
    }

    /// Reads a row; whether it is a list of whole numbers.
    fn row_of(&mut self, reader: &mut Reader<'_>) -> Step<bool> {
        if reader.peek() != Some(b'[') {
            reader.pass()?;
            return Ok(false);
        }
        reader.open()?;
        let mut is_row = true;
        while reader.more(b']')? {
            let index = if matches!(reader.peek(), Some(b'-' | b'0'..=b'9')) {
                reader.number()?
            } else {
                None
            };
            match index {
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "in the range, and whole"
                )]
                Some((number, true)) if self.numbers.len() < MOST => {
                    let is_index = (0.0..f64::from(NO_INDEX)).contains(&number);
                    self.numbers
                        .push(if is_index { number as u32 } else { NO_INDEX });
                }
                Some((_, true)) => {}
                Some((_, false)) => is_row = false,
                None => {
                    reader.pass()?;
                    is_row = false;
                }
            }
        }
        Ok(is_row)
    }
}

/// The numbers of a row in ascending order: how they are ordered does not matter to the loader.
pub fn sorted(row: &[u32]) -> Vec<u32> {
    let mut row = row.to_vec();
    row.sort_unstable();
    row
}

/// For each number below `count`, the rows that it is in.
pub fn inverse(rows: &[Vec<u32>], count: usize) -> Vec<Vec<u32>> {
    let mut found = vec![Vec::new(); count];
    for (at, row) in (0..).zip(rows) {
        for number in row {
            if let Some(own) = found.get_mut(*number as usize) {
                own.push(at);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn of(text: &str) -> IndexTable {
        read(text.as_bytes(), &Encoding::of(text.as_bytes()))
    }

    #[test]
    fn rows_are_lists_of_whole_numbers() {
        let table = of("[[0, 1, 2], [], [-3, 4]]");
        assert!(table.is_sound());
        assert_eq!(
            (table.rows(), table.row(0), table.row(1)),
            (3, [0, 1, 2].as_slice(), [].as_slice())
        );
        assert_eq!(
            (table.row(2), table.row(3)),
            ([NO_INDEX, 4].as_slice(), [].as_slice())
        );
        assert_eq!(
            of("[[0], 5, [0.5], [\"a\"], {\"a\": 1}]").misshapen,
            Some((1, 4))
        );
        assert!(!of("{}").is_list);
        assert!(matches!(of("[[0]").fault, Some(JsonFault::Syntax(_))));
        assert_eq!(of("").fault, Some(JsonFault::Empty));
    }

    #[test]
    fn tables_may_be_inverse() {
        let faces = of("[[0, 1], [2, 1]]");
        assert!(of("[[0], [1, 0], [1]]").is_inverse_of(&faces));
        assert!(!of("[[0], [0], [1]]").is_inverse_of(&faces));
        assert!(!of("[[0], [0, 1]]").is_inverse_of(&faces));
    }

    proptest! {
        #[test]
        fn no_text_stops_the_reader(text in "[\\[\\]{},0-9\" :.-]{0,40}") {
            let table = of(&text);
            prop_assert!(table.row(0).len() <= text.len());
        }
    }
}
