//! What a later run knows the faulty rows of a bulk file by: the element a row is for, or its text.
//! Neither moves when lines are added, as a number of the line would.

use xxhash_rust::xxh3::xxh3_64;

/// A longer text is cut, and told apart by a hash.
const LONGEST: usize = 48;

/// A text as a name.
pub(super) fn text_name(text: &[u8]) -> String {
    let head: String = String::from_utf8_lossy(text.get(..4 * LONGEST).unwrap_or(text))
        .chars()
        .take(LONGEST)
        .collect();
    if head.len() == text.len() {
        head
    } else {
        format!("{head}…{:016x}", xxh3_64(text))
    }
}

/// The fields of a row as a name, whatever is between them.
pub(super) fn row_name(fields: &[(usize, &[u8])]) -> String {
    text_name(
        &fields
            .iter()
            .map(|(_, field)| *field)
            .collect::<Vec<_>>()
            .join(&b' '),
    )
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
}
