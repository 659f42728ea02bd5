//! What MPFB does with a file that it cannot read or find (formats/mpfb.md §2.3). So far for `targets/target.json` alone.

use super::table::{Cell, LOST, Table, anywhere, cell};
use super::{Consequence, Damage, Moment};
use crate::diag::Level::Error;
use crate::discover::Kind;
use crate::repo::ReferenceKind::{SliderName, Slot};

pub(super) static TABLE: Table = Table {
    rows: &[anywhere(Kind::TargetCatalog, Moment::Start, REFUSED)],
    at_moment: &[],
    in_general: LOST,
    unfound: &[(
        &[Slot, SliderName],
        Consequence::new(Error, "does not find the target and fails when its slider moves"),
    )],
};

/// Blender imports the add-on, which reads the file at once and catches nothing.
const STOPS: &str = "fails while the add-on is imported: MPFB cannot be enabled";

const REFUSED: &[Cell] = &[
    cell(Damage::Closed, Error, STOPS),
    cell(Damage::Pointer, Error, STOPS),
    cell(Damage::Refused, Error, STOPS),
    cell(Damage::NotUtf8, Error, STOPS),
    cell(Damage::Syntax, Error, STOPS),
];
