//! An asset as MakeHuman 2 reads it (`docs/loaders/makehuman2/clothes.md#keywords`): a keyword may
//! have a colon, and every line is read whatever stands above it.

use super::FaultKind;
use super::reading::{Reader, first_stop};

/// How it reads.
pub static READER: Reader = Reader {
    knows: |_| true,
    is_fault: |_, _| true,
    passes_over: &[],
    needs_value: |_| false,
    stop: |clothes| first_stop(clothes, |fault| stop(fault.kind)),
};

/// The keywords that it reads.
pub const KEYWORDS: [&str; 18] = [
    "name",
    "uuid",
    "description",
    "author",
    "license",
    "homepage",
    "tag",
    "obj_file",
    "material",
    "vertexboneweights_file",
    "version",
    "z_depth",
    "x_scale",
    "y_scale",
    "z_scale",
    "verts",
    "delete_verts",
    "weights",
];

/// The exception at such a line, and why; `None` where the loader goes on without it.
pub(super) fn stop(kind: FaultKind) -> Option<(&'static str, String)> {
    let (exception, reason) = match kind {
        FaultKind::FieldCount(count) => {
            return Some((
                "IndexError",
                format!("a vertex line needs 1, 6 or at least 9 words, but has {count}"),
            ));
        }
        FaultKind::ShortScale => ("IndexError", "the values of a keyword are missing"),
        FaultKind::RowWord | FaultKind::ScaleWord | FaultKind::NotWhole => {
            ("ValueError", "a word is not a number")
        }
        FaultKind::DeleteWord => (
            "ValueError",
            "a word in the list of vertices to delete is not a number",
        ),
        FaultKind::OldFormat => (
            "ValueError",
            "`weights` belongs to an old format that is no longer read",
        ),
        FaultKind::OpenRange => ("UnboundLocalError", "a range begins with `-`"),
        FaultKind::MissingValue | FaultKind::DroppedRow | FaultKind::NumbersInHeader => {
            return None;
        }
    };
    Some((exception, reason.to_owned()))
}
