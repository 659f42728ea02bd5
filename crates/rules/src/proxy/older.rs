//! What MakeHuman 1 makes of the lines of an asset where that is not what MakeHuman 2 does
//! (`docs/loaders/makehuman1/clothes.md#keywords`, `docs/loaders/makehuman1/clothes.md#rows`).

use std::cmp::Ordering;

use super::Text;
use super::keywords::known_to_makehuman1;
use mhlint_diag::{Application::Makehuman1, Case, Level};
use mhlint_formats::mhclo::{Fault, FaultKind};
use mhlint_formats::python_int;

/// Of faults of one kind those that are some, and how many there are.
pub(super) fn meant<'v>(
    text: &Text<'_, 'v>,
    faults: &'v [Fault],
    count: u64,
) -> Option<(Vec<&'v Fault>, u64)> {
    let end = end(text);
    let own: Vec<&Fault> = faults
        .iter()
        .filter(|fault| fault.line < end && is_fault(text, fault))
        .collect();
    // Those that were counted and not kept are like these.
    let spared = faults.len().saturating_sub(own.len()) as u64;
    (!own.is_empty()).then(|| (own, count.saturating_sub(spared)))
}

/// The line of an old section of weights: what stands in it is read and not used.
fn end(text: &Text<'_, '_>) -> u32 {
    let old = text.clothes.faults.of(|kind| kind == FaultKind::OldFormat);
    old.and_then(|(faults, _)| faults.first())
        .map_or(u32::MAX, |fault| fault.line)
}

fn is_fault(text: &Text<'_, '_>, fault: &Fault) -> bool {
    // With a colon behind its keyword it is a line of an unknown one.
    let is_of_colon = || {
        text.clothes
            .entries
            .iter()
            .any(|entry| entry.line == fault.line && entry.has_colon)
    };
    match fault.kind {
        FaultKind::OldFormat => false,
        FaultKind::NotWhole
        | FaultKind::ScaleWord
        | FaultKind::ShortScale
        | FaultKind::MissingValue => !is_of_colon(),
        // Keywords may stand below any section.
        FaultKind::DeleteWord => !known_to_makehuman1(&fault.word),
        // `+5` is a number to Python.
        FaultKind::DroppedRow => python_int(fault.word.as_bytes()).is_none_or(|number| number < 0),
        _ => true,
    }
}

/// A fault at which the loader stops, before anything is put on.
pub(super) fn stops(text: &Text<'_, '_>) -> bool {
    use FaultKind::{
        DeleteWord, DroppedRow, FieldCount, MissingValue, NotWhole, OpenRange, RowWord, ScaleWord,
        ShortScale,
    };
    let end = end(text);
    text.clothes
        .faults
        .iter()
        .filter(|fault| fault.line < end && is_fault(text, fault))
        .any(|fault| match fault.kind {
            DeleteWord | DroppedRow | FieldCount(_) | NotWhole | OpenRange | RowWord
            | ScaleWord | ShortScale => true,
            MissingValue => needs_value(&fault.word),
            _ => false,
        })
}

/// Keywords whose line is not read without a value.
pub(super) fn needs_value(keyword: &str) -> bool {
    matches!(
        keyword,
        "obj_file" | "material" | "vertexboneweights_file" | "z_depth"
    ) || keyword.contains("shear_")
        || matches!(
            keyword,
            "x_scale" | "y_scale" | "z_scale" | "basemesh" | "version" | "max_pole"
        )
}

pub(super) const SCALE_ALONE: Case = &[(
    Makehuman1,
    Level::Error,
    "does not put the asset on: `TypeError` when it is fitted",
)];
const NOWHERE: Case = &[(
    Makehuman1,
    Level::Warning,
    "divides by 0: all vertices of the asset have no position (NaN)",
)];
const MIRRORED: Case = &[(
    Makehuman1,
    Level::Warning,
    "mirrors all offsets along the axis",
)];

/// What is wrong with the distance of a scale, by which it divides as it is written.
pub(super) fn distance(text: &Text<'_, '_>, name: &str, distance: f32) -> Option<(String, Case)> {
    match distance
        .partial_cmp(&0.0)
        .filter(|_| text.is_makehuman1())?
    {
        Ordering::Equal => Some((format!("the distance of `{name}` is 0"), NOWHERE)),
        Ordering::Less => Some((
            format!("the distance of `{name}` is {distance}, which is negative"),
            MIRRORED,
        )),
        Ordering::Greater => None,
    }
}
