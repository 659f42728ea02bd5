//! Rows taken out of a `.target`, whole lines with their line ends; every other byte stays as it
//! is.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::fields::fields;
use crate::{python_float, python_int, stored};
use mhlint_diag::Edit;
use mhlint_source::lines;

/// A row that the loader takes for data, and the bytes of its line.
struct Row {
    line: Range<usize>,
    /// Nothing where it is no index that the loader takes: such a row is nobody's repetition.
    index: Option<u32>,
    is_zero: bool,
}

/// Takes out rows that move nothing. Those of a vertex that another row moves stay: the last one
/// counts.
pub fn drop_zero_rows(text: &[u8]) -> Vec<Edit> {
    let rows = rows(text);
    let moved: BTreeSet<u32> = rows
        .iter()
        .filter(|row| !row.is_zero)
        .filter_map(|row| row.index)
        .collect();
    let gone = rows
        .iter()
        .filter(|row| row.is_zero && row.index.is_none_or(|index| !moved.contains(&index)));
    gone.map(|row| Edit::removal(row.line.clone())).collect()
}

/// Takes out all rows of a vertex but the last, which is the one that counts.
pub fn keep_last_rows(text: &[u8]) -> Vec<Edit> {
    let rows = rows(text);
    let numbered = rows.iter().enumerate();
    let last: BTreeMap<u32, usize> = numbered
        .filter_map(|(at, row)| Some((row.index?, at)))
        .collect();
    let is_replaced =
        |at: usize, row: &Row| row.index.is_some_and(|index| last.get(&index) != Some(&at));
    let gone = rows
        .iter()
        .enumerate()
        .filter(|(at, row)| is_replaced(*at, row));
    gone.map(|(_, row)| Edit::removal(row.line.clone()))
        .collect()
}

fn rows(text: &[u8]) -> Vec<Row> {
    let row = |(line, text): (Range<usize>, &[u8])| {
        row(text).map(|(index, is_zero)| Row {
            line,
            index,
            is_zero,
        })
    };
    lines(text).filter_map(row).collect()
}

/// Index of a row, and whether it moves nothing. As float32: what is too small for the application
/// is zero, too.
fn row(line: &[u8]) -> Option<(Option<u32>, bool)> {
    let fields = fields(line);
    let [(_, index), deltas @ ..] = fields.as_slice() else {
        return None;
    };
    if deltas.len() != 3 || index.starts_with(b"#") {
        return None;
    }
    let index = python_int(index)?;
    let mut is_zero = true;
    for (_, delta) in deltas {
        is_zero &= stored(python_float(delta)?) == 0.0;
    }
    Some((u32::try_from(index).ok(), is_zero))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::target;

    fn edited(text: &str, edits: Vec<Edit>) -> String {
        let mut bytes = text.as_bytes().to_vec();
        edits
            .into_iter()
            .rev()
            .for_each(|edit| drop(bytes.splice(edit.range, edit.text)));
        String::from_utf8(bytes).unwrap()
    }

    #[test]
    fn whole_lines_go_and_all_others_stay() {
        let text =
            "# a 0 0\r\n1 0 0 0\r\n  2  0 .1 0\n3 0.0 -0 1e-60\r\r4 0 0 0 x\n5 0 0 nan\n6 0 0 0";
        let expected = "# a 0 0\r\n  2  0 .1 0\n\r4 0 0 0 x\n5 0 0 nan\n";
        assert_eq!(edited(text, drop_zero_rows(text.as_bytes())), expected);
    }

    #[test]
    fn a_zero_that_undoes_an_earlier_row_stays() {
        let text = "1 0 .1 0\n2 0 0 0\n1 0 0 0\n";
        assert_eq!(
            edited(text, drop_zero_rows(text.as_bytes())),
            "1 0 .1 0\n1 0 0 0\n"
        );
    }

    #[test]
    fn repeated_zeros_go() {
        let text = "1 0 0 0\n2 0 .1 0\n-1 0 .1 0\n1 0 0 0\n-1 0 0 0\n";
        assert_eq!(
            edited(text, drop_zero_rows(text.as_bytes())),
            "2 0 .1 0\n-1 0 .1 0\n"
        );
    }

    #[test]
    fn the_last_row_of_a_vertex_stays() {
        let text = "1 0 .1 0\n2 0 .1 0\n+1 0 .2 0\n1 0 .3 0";
        assert_eq!(
            edited(text, keep_last_rows(text.as_bytes())),
            "2 0 .1 0\n1 0 .3 0"
        );
    }

    proptest! {
        #[test]
        fn the_parser_agrees(text in "([0-3] (0|-0|\\.1|x) 0 0(\n|\r|\r\n| 1\n)|# 0 0 0\n| \
            ?\n){0,12}") {
            let parsed = |text: &str| target::parse(text.as_bytes(), None);
            let single = edited(&text, keep_last_rows(text.as_bytes()));
            prop_assert_eq!(parsed(&single).facts.duplicate.count, 0);
            let last = |text: &str| -> BTreeMap<u32, String> {
                parsed(text).rows.iter().map(|(index, delta)| (*index, format!("{delta:?}"))).collect()
            };
            prop_assert_eq!(last(&single), last(&text));
            let still = edited(&text, drop_zero_rows(text.as_bytes()));
            prop_assert_eq!(parsed(&still).facts.zero.count, 0);
            prop_assert_eq!(parsed(&still).facts.duplicate.count, parsed(&text).facts.duplicate.count);
            prop_assert_eq!(parsed(&still).facts.moving, parsed(&text).facts.moving);
            let moving = edited(&single, drop_zero_rows(single.as_bytes()));
            prop_assert_eq!(parsed(&moving).facts.zero.count, 0);
            prop_assert_eq!(parsed(&moving).facts.moving, parsed(&single).facts.moving);
            prop_assert_eq!(parsed(&moving).facts.unreadable_rows, parsed(&text).facts.unreadable_rows);
        }
    }
}
