//! What becomes of a value that does not fit its schema in MakeHuman 1.
//!
//! From `docs/loaders/makehuman1/modifiers.md#faults-of-sliders`,
//! `docs/loaders/makehuman1/skeletons.md#faults-of-skeletons`,
//! `docs/loaders/makehuman1/weights.md#faults-of-weights`,
//! `docs/loaders/makehuman1/expressions.md#faults-of-expressions`,
//! `docs/loaders/makehuman1/program.md#languages`.

use super::makehuman1::{NO_EXPRESSIONS, NO_PROGRAM, STOPS_AT_START};
use super::values::{ANY, NULL, Row, TEXT, row};
use super::{Consequence, values};
use mhlint_diag::Level::{Error, Info, Warning};
use mhlint_discover::{Kind, Single};
use mhlint_formats::python_float;
use mhlint_json::{Found, SchemaFault};
use mhlint_repo::FileFacts;

const NO_SET: &str =
    "fails at start: no further modifiers of the file are loaded, and none of its tabs is shown";
const NO_TABS: &str = "shows neither the rest of the tab nor the tabs behind it in the file";
const NO_RIG: &str = "fails with an exception when the skeleton is chosen";
const NO_RIGS: &str = "lists no skeleton at all: one file that cannot be read empties the list";

#[rustfmt::skip]
pub(super) static ROWS: [Row; 29] = [
    row(Kind::ModifierFile, "/items/properties/modifiers/items/properties/defaultValue", ANY, Error, "fails \
        with `TypeError` at each reset"),
    row(Kind::ModifierFile, "/", ANY, Error, NO_SET),
    row(Kind::ModifierTexts, "/", ANY, Error, "fails at start: none of the tabs of this set is \
        shown"),
    row(Kind::ModifierSliders, "/additionalProperties/properties/sortOrder", ANY, Error,
        "fails with `TypeError`: the tabs of all plugins of Modelling from there on stay empty"),
    row(Kind::ModifierSliders, "/additionalProperties/properties/modifiers/additionalProperties/items/properties/label", ANY, Error, STOPS_AT_START),
    row(Kind::ModifierSliders, "/type", ANY, Error, "fails at start: none of its tabs is shown"),
    row(Kind::ModifierSliders, "/", ANY, Error, NO_TABS),
    row(Kind::Language, "/properties/__options__", ANY, Error, "fails when the language is chosen"),
    row(Kind::Language, "/", ANY, Error, "fails where it shows this text"),
    row(Kind::FaceUnits, "/", ANY, Error, "lists the expressions and shows none of them"),
    row(Kind::Pose, "/properties/tags/type", TEXT, Warning, "makes a tag of every letter"),
    row(Kind::Pose, "/properties/tags", ANY, Error, NO_EXPRESSIONS),
    row(Kind::Pose, "/required", ANY, Error, NO_EXPRESSIONS),
    row(Kind::Pose, "/type", ANY, Error, NO_EXPRESSIONS),
    row(Kind::Pose, "/properties/name", ANY, Warning, "shows the expression without a name"),
    row(Kind::Pose, "/properties/author", ANY, Info, "does not show the author"),
    row(Kind::Pose, "/properties/unit_poses/type", ANY, Error, "fails with `AttributeError` when \
        the expression is chosen"),
    row(Kind::Pose, "/properties/unit_poses/", ANY, Error, "fails with an exception when the \
        expression is chosen"),
    row(Kind::Skeleton, "/properties/tags/type", TEXT, Warning, "makes a tag of every letter"),
    row(Kind::Skeleton, "/properties/tags", ANY, Error, NO_RIGS),
    row(Kind::Skeleton, "/type", ANY, Error, NO_RIGS),
    row(Kind::Skeleton, "/properties/name", ANY, Warning, "shows the skeleton without a name"),
    row(Kind::Skeleton, "/properties/author", ANY, Info, "does not show the author"),
    row(Kind::Skeleton, "/properties/weights_file", NULL, Info, "takes the weights through \
        references"),
    row(Kind::Skeleton, "/$defs/bone/properties/parent", ANY, Warning,
        "drops the bone and all below it with a line in the log; other bones get their weights"),
    row(Kind::Skeleton, "/", ANY, Error, NO_RIG),
    row(Kind::Weights, "/", ANY, Error, "fails when the skeleton with these weights is chosen"),
    row(Kind::AssetWeights, "/", ANY, Error, "does not put on the asset that uses these weights"),
    row(Kind::ProgramSettings, "/type", ANY, Error, NO_PROGRAM),
];

/// Planes may be lists, null or numbers (`docs/loaders/makehuman1/skeletons.md#bones`), and values
/// of units texts and truths (`docs/loaders/makehuman1/expressions.md#faults-of-expressions`).
pub(super) fn is_accepted(file: &FileFacts, fault: &SchemaFault) -> bool {
    match file.kind {
        Kind::Skeleton => fault
            .keyword
            .starts_with("/$defs/bone/properties/rotation_plane"),
        Kind::Pose => {
            fault
                .keyword
                .starts_with("/properties/unit_poses/additionalProperties")
                && is_number(fault)
        }
        _ => false,
    }
}

/// Whether Python makes a number of what was found.
fn is_number(fault: &SchemaFault) -> bool {
    match fault.found() {
        Some(Found::Bool(_)) => true,
        Some(Found::Text(Some(text))) => python_float(text.as_bytes()).is_some(),
        _ => false,
    }
}

/// What a fault comes to.
pub(super) fn of_value(
    layout: &mhlint_discover::Layout,
    file: &FileFacts,
    fault: &SchemaFault,
) -> Option<Consequence> {
    if (layout.single)(&file.rel) == Some(Single::FirstRig) && file.kind == Kind::Weights {
        return Some(Consequence::new(Error, STOPS_AT_START));
    }
    values::first_fit(&ROWS, file.kind, fault)
}
