//! What a later run knows the faulty rows of a bulk file by: the element a row is for, or its text. Neither moves
//! when lines are added, as a number of the line would.

use xxhash_rust::xxh3::xxh3_64;

/// Rows that are told apart by name; more of them are one mass.
const NAMED: usize = 65_536;
/// A longer text is cut, and told apart by a hash.
const LONGEST: usize = 48;

/// Names of faulty rows, as long as they are few. Costs nothing where there are none.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FaultyRows(Vec<String>);

impl FaultyRows {
    /// Adds a row.
    pub(super) fn add(&mut self, name: impl FnOnce() -> String) {
        if self.0.len() <= NAMED {
            self.0.push(name());
        }
    }

    /// The names, or none where they are too many.
    pub fn names(&self) -> &[String] {
        if self.0.len() > NAMED { &[] } else { &self.0 }
    }
}

/// A text as a name.
pub(super) fn text_name(text: &[u8]) -> String {
    let head: String = String::from_utf8_lossy(text.get(..4 * LONGEST).unwrap_or(text)).chars().take(LONGEST).collect();
    if head.len() == text.len() { head } else { format!("{head}…{:016x}", xxh3_64(text)) }
}

/// The fields of a row as a name, whatever is between them.
pub(super) fn row_name(fields: &[(usize, &[u8])]) -> String {
    text_name(&fields.iter().map(|(_, field)| *field).collect::<Vec<_>>().join(&b' '))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_rows_are_cut_and_still_told_apart() {
        let (one, other) = ("x".repeat(9000), "x".repeat(9001));
        assert_ne!(text_name(one.as_bytes()), text_name(other.as_bytes()));
        assert!(text_name(one.as_bytes()).len() < 80);
        assert_eq!(row_name(&[(3, b"12"), (9, b"x")]), "12 x");
    }

    #[test]
    fn too_many_rows_have_no_names() {
        let mut rows = FaultyRows::default();
        (0..NAMED).for_each(|row| rows.add(|| row.to_string()));
        assert_eq!(rows.names().len(), NAMED);
        (0..NAMED).for_each(|row| rows.add(|| row.to_string()));
        assert_eq!((rows.names().len(), rows.0.len()), (0, NAMED + 1));
    }
}
