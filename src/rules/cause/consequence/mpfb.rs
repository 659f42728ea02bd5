//! What MPFB does with a file that it cannot read or find (formats/mpfb.md §2.3, §3.1). So far for
//! `targets/target.json` and `targets/macrodetails/macro.json` alone.

use super::table::{Cell, LOST, Table, anywhere, cell};
use super::{Consequence, Damage, Moment};
use crate::diag::Level::Error;
use crate::diag::Level::Info;
use crate::discover::Kind;
use crate::json::{Found, SchemaFault};
use crate::repo::FileFacts;
use crate::repo::ReferenceKind::{SliderName, Slot};

pub(super) static TABLE: Table = Table {
    rows: &[anywhere(Kind::TargetCatalog, Moment::Start, REFUSED), anywhere(Kind::MacroParts, Moment::Start, REFUSED)],
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

const NO_CHARACTER: &str = "crashes whenever a character is made: none can be made";
const NO_NAME: &str = "crashes where a setting comes into the part; if that is 0.5, no character can be made";

/// What a value of the macro settings comes to: beginning of its place in the schema; the first that fits counts.
static MACRO_PARTS: [(&str, Consequence); 2] = [
    ("/$defs/part/properties/low/", Consequence::new(Error, NO_NAME)),
    ("/$defs/part/properties/high/", Consequence::new(Error, NO_NAME)),
];

/// What a value comes to that does not fit its schema.
pub(super) fn of_value(file: &FileFacts, fault: &SchemaFault) -> Option<Consequence> {
    if file.kind != Kind::MacroParts {
        return None;
    }
    let row = MACRO_PARTS.iter().find(|(place, _)| fault.keyword.starts_with(place));
    let usual = || match fault.found() {
        Some(Found::Bool(_)) if fault.keyword.starts_with("/$defs/part/properties/") => {
            Consequence::new(Info, "takes `true` for 1 and `false` for 0")
        }
        _ => Consequence::new(Error, NO_CHARACTER),
    };
    Some(row.map_or_else(usual, |(_, consequence)| *consequence))
}
