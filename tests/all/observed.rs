//! The tables of what running programs did with damaged assets (`fixtures/observed/`): every row is
//! there once, and the fixtures that it names exist.

use std::fs;

use crate::scratch::project;

/// Rows of a table, as section and number, with the last column.
fn rows(name: &str) -> Vec<((usize, usize), String)> {
    let text = fs::read_to_string(project("fixtures/observed").join(name)).unwrap();
    let lines = text.lines().filter_map(|line| {
        let mut cells = line
            .strip_prefix('|')?
            .strip_suffix('|')?
            .split('|')
            .map(str::trim);
        let (section, row) = cells.next()?.split_once('.')?;
        let number = (section.parse().ok()?, row.parse().ok()?);
        Some((number, cells.next_back()?.to_owned()))
    });
    lines.collect()
}

/// What stands in backticks.
fn named(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

#[test]
fn every_row_is_shown_by_fixtures_or_says_why_not() {
    for (name, sections) in [
        ("makehuman2-worn.md", &[11, 18, 18, 12, 4, 10, 14][..]),
        ("makehuman1.md", &[19, 16, 19, 42][..]),
        ("mpfb.md", &[9, 30, 22][..]),
        ("worn-numbers.md", &[26, 12, 5, 6, 6, 17][..]),
    ] {
        let rows = rows(name);
        let numbers: Vec<(usize, usize)> = rows.iter().map(|(number, _)| *number).collect();
        let all = (1..)
            .zip(sections)
            .flat_map(|(section, count)| (1..=*count).map(move |row| (section, row)));
        assert_eq!(numbers, all.collect::<Vec<_>>(), "{name}");
        for ((section, row), cell) in rows {
            let fixtures = named(&cell);
            let is_told = ["no fault of data", "later", "needs numbers"]
                .iter()
                .any(|word| cell.contains(word));
            assert!(
                !fixtures.is_empty() || is_told,
                "{name} {section}.{row} names no fixture and no reason"
            );
            for fixture in fixtures {
                let case = project("fixtures/rules").join(fixture).join("case.toml");
                assert!(
                    case.is_file(),
                    "{name} {section}.{row} names `{fixture}`, which does not exist"
                );
            }
        }
    }
}
