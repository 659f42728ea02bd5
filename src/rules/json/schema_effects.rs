//! What becomes of a value that does not fit its schema, where it is not the usual exception: a table by schema
//! place (formats/makehuman2.md §3.1, §4, §5.1, §7, §9, §10, §11, §19).

use crate::diag::Level;
use crate::discover::Kind;

/// A row; the first that fits counts.
struct Row {
    kind: Kind,
    /// Beginning of the place in the schema.
    keyword: &'static str,
    /// What was found, as the message calls it; empty for anything.
    found: &'static [&'static str],
    level: Level,
    effect: &'static str,
}

const TEXT: &[&str] = &["is the text", "is an empty text", "is a long text"];
const TEXT_OR_LIST: &[&str] = &["is the text", "is an empty text", "is a long text", "is a list", "is an empty list"];
const LIST: &[&str] = &["is a list", "is an empty list"];
/// What Python takes for false, and the loader for no file.
const EMPTY: &[&str] = &["is null", "is an empty list", "is an empty text", "is the number 0;", "is `false`"];
const ANY: &[&str] = &[];

const fn row(
    kind: Kind,
    keyword: &'static str,
    found: &'static [&'static str],
    level: Level,
    effect: &'static str,
) -> Row {
    Row { kind, keyword, found, level, effect }
}

use Kind::{BaseJson, Geometry, MacroJson, ModellingJson, Skeleton, TargetCategories, Weights};
use Level::{Error, Warning};

#[rustfmt::skip]
static ROWS: [Row; 33] = [
    row(Geometry, "", ANY, Warning, "never reads this file; the scripts that align joint cubes stop"),
    row(MacroJson, "/type", ANY, Error, "stops at start with a TypeError"),
    row(MacroJson, "/allOf/", ANY, Error, "stops at start with a KeyError"),
    row(MacroJson, "/$defs/component/required", ANY, Error, "stops at start with a KeyError"),
    row(MacroJson, "/$defs/macrodef/required", ANY, Error, "stops at start with a KeyError"),
    row(MacroJson, "/$defs/macrodef/properties/comp/type", TEXT, Warning,
        "takes the text letter by letter: the macro definition does nothing, without a word"),
    row(MacroJson, "/$defs/target/required", ANY, Warning, "skips the combination without a word"),
    row(MacroJson, "/$defs/target/properties/name/type", ANY, Warning, "skips the combination without a word"),
    row(MacroJson, "/$defs/target/properties/t/type", ANY, Error, "stops at start with a TypeError"),
    row(ModellingJson, "/$defs/entry/type", TEXT_OR_LIST, Warning,
        "takes it for an entry without keys: the slider is gone, without a word"),
    row(ModellingJson, "/$defs/entry/type", ANY, Error, "stops at start with a TypeError"),
    row(ModellingJson, "/$defs/entry/properties/macro_influence/items/type", &["is the number"], Level::Info,
        "nothing: it only asks whether the list is empty"),
    row(ModellingJson, "/$defs/entry/properties/macro_influence", ANY, Error, "stops at start with a TypeError"),
    row(ModellingJson, "/$defs/entry/properties/default/type", TEXT, Error,
        "repeats the text 100 times at the next reset, and stops later with a TypeError"),
    row(ModellingJson, "/$defs/display/required", ANY, Error, "stops at start with a KeyError"),
    row(ModellingJson, "/$defs/display/properties/slot/type", ANY, Error, "stops at start with a TypeError"),
    row(TargetCategories, "/type", ANY, Error, "stops at start with a TypeError"),
    row(TargetCategories, "/$defs/category/then/required", ANY, Error,
        "looks for `default` in place of the group; in the first category it stops with a KeyError"),
    row(TargetCategories, "/$defs/item/required", ANY, Error, "stops with a KeyError when the tree is built"),
    row(BaseJson, "/properties/numverts/type", ANY, Warning, "does not read the number; its mesh tools do"),
    row(BaseJson, "/properties/modifier-presets/type", ANY, Error, "stops at start with a TypeError"),
    row(BaseJson, "/$defs/preset/oneOf/1/pattern", ANY, Error, "stops at start with a ValueError"),
    row(BaseJson, "/$defs/measure/properties/", ANY, Warning, "shows nothing for it, without a word"),
    row(BaseJson, "/$defs/random/properties/gender/type", ANY, Warning, "does without the choice, without a word"),
    row(BaseJson, "/$defs/random/properties/ideal/type", ANY, Warning, "does without the choice, without a word"),
    row(BaseJson, "/$defs/random/properties/groups/additionalProperties/type", ANY, Warning,
        "takes anything but 0, empty and null for true"),
    row(Skeleton, "/type", ANY, Error, "stops at start, while it scans the assets"),
    row(Skeleton, "/properties/name/type", ANY, Error, "stops at start, while it scans the assets (TypeError)"),
    row(Skeleton, "/properties/tags/type", TEXT, Warning, "makes a tag of every letter"),
    row(Skeleton, "/properties/tags/type", &["is null"], Error,
        "stops at start, while it scans the assets (TypeError)"),
    row(Weights, "/required", ANY, Error, "loads no weights at all: in pose mode the mesh collapses to the origin"),
    row(Weights, "/type", EMPTY, Error, "loads no weights at all: in pose mode the mesh collapses to the origin"),
    row(Weights, "/properties/weights/type", LIST, Error, "stops with an AttributeError when it loads the weights"),
];

/// Level and effect of a fault, where the table has it.
pub(super) fn effect_of(kind: Kind, keyword: &str, message: &str) -> Option<(Level, &'static str)> {
    let kind = if kind == Kind::AssetWeights { Kind::Weights } else { kind };
    let fits = |row: &&Row| {
        row.kind == kind
            && keyword.starts_with(row.keyword)
            && (row.found.is_empty() || row.found.iter().any(|found| message.contains(found)))
    };
    ROWS.iter().find(fits).map(|row| (row.level, row.effect))
}
