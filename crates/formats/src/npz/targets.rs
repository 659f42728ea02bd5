//! `targets.npz`: the archive that MakeHuman 1 makes of all targets in its data
//! (`docs/loaders/makehuman1/target-archive.md#content`).
//!
//! A zip of `.npy`, two for each target: the vertices, and what moves them in thousandths of a
//! decimetre. Gets bytes and limits, returns what is in it for each target with a hash of its rows;
//! keeps no rows.

use std::collections::BTreeMap;

use crate::npy;
use crate::npy::NpyFault;
use crate::npy::table::{Cell, Table};
use crate::npz::{self, ArchiveFault};
use crate::target::Row;
use crate::target::print::PackedPrint;
use mhlint_source::Limits;

/// A parsed archive.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TargetsNpz {
    /// What is there for each target, by its path below the data without suffix.
    pub targets: BTreeMap<String, PackedTarget>,
    /// Why it cannot be opened.
    pub fault: Option<ArchiveFault>,
    /// Whether it unpacks beyond the limits, and so was not looked into.
    pub is_bomb: bool,
}

/// The members of a target.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PackedTarget {
    /// The vertices: how many, or why they cannot be used.
    pub index: Option<Result<usize, NpyFault>>,
    /// What moves them: how many rows, or why they cannot be used.
    pub vector: Option<Result<usize, NpyFault>>,
    /// A licence beside them, which is an array of objects.
    pub has_license: bool,
    /// Hash over the rows, if both are there and of one length.
    pub content: Option<u64>,
    /// The highest vertex.
    pub max_index: Option<i64>,
}

impl PackedTarget {
    /// Whether the program takes it from the archive and can use it.
    pub fn is_sound(&self) -> bool {
        self.content.is_some() && !self.has_license
    }

    /// How many vertices and how many displacements there are, where both can be used.
    pub fn rows(&self) -> Option<(usize, usize)> {
        let rows = |part: &Option<Result<usize, NpyFault>>| part.as_ref()?.as_ref().ok().copied();
        rows(&self.index).zip(rows(&self.vector))
    }

    /// What is wrong with a member, the first of the two.
    pub fn fault(&self) -> Option<&NpyFault> {
        let fault =
            |part: &'_ Option<Result<usize, NpyFault>>| part.as_ref().is_some_and(Result::is_err);
        let part = if fault(&self.index) {
            &self.index
        } else {
            &self.vector
        };
        part.as_ref().and_then(|part| part.as_ref().err())
    }
}

/// Reads an archive within `limits`, which are those of arrays.
pub fn parse(bytes: &[u8], limits: &Limits) -> TargetsNpz {
    let mut archive = TargetsNpz::default();
    let mut zip = match npz::open(bytes) {
        Ok(zip) => zip,
        Err(fault) => {
            return TargetsNpz {
                fault: Some(fault),
                ..archive
            };
        }
    };
    let mut room = limits.of_arrays().unpacked_limit(bytes.len() as u64);
    let mut pending: BTreeMap<String, Table> = BTreeMap::new();
    for place in 0..zip.len() {
        let name = npz::member_name(&zip, place);
        let Some((target, part)) = name.rsplit_once('.') else {
            continue;
        };
        let cells: &[Cell] = match part {
            "index" => &[Cell::Integer],
            "vector" => &[Cell::Number; 3],
            // That of all targets is in every archive.
            "license" if target != "targets/targets" => {
                archive.target(target).has_license = true;
                continue;
            }
            _ => continue,
        };
        let (table, used) = npz::read_member(&mut zip, place, room, |reader| {
            npy::table::read(reader, cells)
        });
        let Some(left) = room.checked_sub(used) else {
            return TargetsNpz {
                is_bomb: true,
                ..TargetsNpz::default()
            };
        };
        room = left;
        archive.add(target, part == "index", table, &mut pending);
    }
    archive
}

/// The rows of one target, as the program has them: in decimetres, exact to a thousandth.
pub fn rows(bytes: &[u8], limits: &Limits, target: &str) -> Option<Vec<Row>> {
    let mut members = npz::Members::open(bytes, limits).ok()?;
    let mut part = |part: &str, cells: &[Cell]| {
        members
            .read(&format!("{target}.{part}"), |reader| {
                npy::table::read(reader, cells)
            })?
            .ok()
    };
    let (index, vector) = (
        part("index", &[Cell::Integer])?,
        part("vector", &[Cell::Number; 3])?,
    );
    if index.rows != vector.rows {
        return None;
    }
    // As the program has it: a number of 32 bits times a thousandth.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "an `int16` where the program made it"
    )]
    let value = |at: usize, axis: usize| Some(vector.number(at, axis)? as f32 * 1e-3);
    let row = |at: usize| {
        let vertex = u32::try_from(index.integer(at, 0)?).ok()?;
        Some((vertex, [value(at, 0)?, value(at, 1)?, value(at, 2)?]))
    };
    (0..index.rows).map(row).collect()
}

impl TargetsNpz {
    fn target(&mut self, name: &str) -> &mut PackedTarget {
        self.targets.entry(name.to_owned()).or_default()
    }

    /// Takes a member; with the second of a target its rows are known.
    fn add(
        &mut self,
        name: &str,
        is_index: bool,
        table: Result<Table, NpyFault>,
        pending: &mut BTreeMap<String, Table>,
    ) {
        let own = self.target(name);
        let rows = table.as_ref().map(|table| table.rows).map_err(Clone::clone);
        *(if is_index {
            &mut own.index
        } else {
            &mut own.vector
        }) = Some(rows);
        let Ok(table) = table else { return };
        let Some(other) = pending.remove(name) else {
            pending.insert(name.to_owned(), table);
            return;
        };
        let (index, vector) = if is_index {
            (&table, &other)
        } else {
            (&other, &table)
        };
        own.take(index, vector);
    }
}

impl PackedTarget {
    fn take(&mut self, index: &Table, vector: &Table) {
        if index.rows != vector.rows {
            return;
        }
        let mut print = PackedPrint::default();
        for row in 0..index.rows {
            let vertex = index.integer(row, 0).unwrap_or_default();
            self.max_index = self.max_index.max(Some(vertex));
            let parts = [0, 1, 2].map(|axis| vector.number(row, axis).unwrap_or_default());
            print.add(u32::try_from(vertex).unwrap_or(u32::MAX), parts);
        }
        self.content = Some(print.finish());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::npz::samples::{npy, npy_in_order, zip_of};
    use crate::target;

    fn pair() -> Vec<(&'static str, Vec<u8>)> {
        let index: Vec<u8> = [3_u16, 7]
            .iter()
            .flat_map(|own| own.to_le_bytes())
            .collect();
        let vector: Vec<u8> = [119_i16, -10205, 0, 1, 2, 3]
            .iter()
            .flat_map(|own| own.to_le_bytes())
            .collect();
        vec![
            ("targets/head/oval.index.npy", npy("'<u2'", "(2,)", &index)),
            (
                "targets/head/oval.vector.npy",
                npy("'<i2'", "(2, 3)", &vector),
            ),
        ]
    }

    fn only(members: &[(&str, Vec<u8>)]) -> PackedTarget {
        parse(&zip_of(members), &Limits::default()).targets["targets/head/oval"].clone()
    }

    #[test]
    fn rows_are_those_of_the_text_in_thousandths() {
        let text = |text: &[u8]| target::parse(text, None).facts.thousandths;
        let own = only(&pair());
        assert!(own.is_sound());
        assert_eq!(
            own.content,
            Some(text(b"3 .119 -10.205 0\n7 .001 .002 .003\n"))
        );
        assert_eq!(
            own.content,
            Some(text(b"3 .11904 -10.2053 -0\n7 .001 .002 .003\n"))
        );
        // What does not fit goes around.
        assert_eq!(
            own.content,
            Some(text(b"65539 65.655 -10.205 0\n7 .001 .002 .003\n"))
        );
        assert_ne!(
            own.content,
            Some(text(b"3 .12 -10.205 0\n7 .001 .002 .003\n"))
        );
    }

    #[test]
    fn what_the_program_cannot_use_is_named() {
        let with = |at: usize, name: &'static str, bytes: Vec<u8>| {
            let mut members = pair();
            members[at] = (name, bytes);
            only(&members)
        };
        let vector = "targets/head/oval.vector.npy";
        assert_eq!(
            with(1, vector, b"text".to_vec()).fault(),
            Some(&NpyFault::NotNpy)
        );
        assert_eq!(
            with(1, vector, npy("'|O'", "(2,)", b"")).fault(),
            Some(&NpyFault::Object)
        );
        assert_eq!(
            with(1, vector, npy("'<i2'", "(2, 3)", &[0; 5])).fault(),
            Some(&NpyFault::Truncated)
        );
        assert_eq!(
            with(1, vector, npy("'<i2'", "(1, 3)", &[0; 6])).content,
            None
        );
        assert_eq!(with(1, "other.npy", Vec::new()).vector, None);
        let by_column: Vec<u8> = [119_i16, 1, -10205, 2, 0, 3]
            .iter()
            .flat_map(|own| own.to_be_bytes())
            .collect();
        let fortran = npy_in_order("'>i2'", "True", "(2, 3)", &by_column);
        assert_eq!(with(1, vector, fortran), only(&pair()));
        let mut licensed = pair();
        licensed.push(("targets/head/oval.license.npy", npy("'|O'", "(2,)", b"")));
        assert!(!only(&licensed).is_sound());
    }

    #[test]
    fn a_bomb_is_given_up() {
        let dense = zip_of(&[(
            "a.vector.npy",
            npy("'|i1'", "(1000000, 3)", &vec![0; 3_000_000]),
        )]);
        let limits = Limits {
            ratio_free_bytes: 1000,
            unpacked_ratio: 2,
            ..Limits::default()
        };
        assert!(parse(&dense, &limits).is_bomb);
        // A header can promise what it wants.
        let promised = npy("'<i2'", "(1000000000000, 3)", &[0; 60]);
        assert_eq!(
            only(&[("targets/head/oval.vector.npy", promised)]).fault(),
            Some(&NpyFault::Truncated)
        );
    }

    #[test]
    fn every_truncation_and_every_changed_byte_is_survived() {
        let bytes = zip_of(&pair());
        for at in 0..bytes.len() {
            assert!(parse(&bytes[..at], &Limits::default()).fault.is_some());
            for value in [0, 0x7f, 0xff] {
                let mut changed = bytes.clone();
                changed[at] = value;
                parse(&changed, &Limits::default());
            }
        }
    }
}
