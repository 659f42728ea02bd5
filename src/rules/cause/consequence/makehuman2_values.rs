//! What becomes of a value that does not fit its schema, where it is not the usual exception: a table by schema
//! place (formats/makehuman2.md §3.1, §4, §5.1, §7, §9, §10, §11, §19).

use super::Consequence;
use super::makehuman2::{NEVER_OPENED, NO_WEIGHTS_LOADED, NOT_READ, is_opened_by_scripts};
use crate::diag::Level;
use crate::discover::Kind;
use crate::formats::Content;
use crate::json::{Found, SchemaFault};
use crate::repo::FileFacts;
use crate::repo::makehuman2::View;

/// A row; the first that fits counts.
struct Row {
    kind: Kind,
    /// Beginning of the place in the schema.
    keyword: &'static str,
    /// What was found.
    found: Test,
    consequence: Consequence,
}

type Test = fn(Option<&Found>) -> bool;

const TEXT: Test = |found| matches!(found, Some(Found::Text(_)));
const LIST: Test = |found| matches!(found, Some(Found::List { .. }));
const TEXT_OR_LIST: Test = |found| TEXT(found) || LIST(found);
const NUMBER: Test = |found| matches!(found, Some(Found::Number(_)));
const OBJECT: Test = |found| found == Some(&Found::Object);
const TRUTH: Test = |found| matches!(found, Some(Found::Bool(_)));
const NULL: Test = |found| found == Some(&Found::Null);
/// What Python takes for false, and the loader for no file.
const EMPTY: Test = |found| match found {
    Some(Found::Null | Found::Bool(false) | Found::List { is_empty: true }) => true,
    Some(Found::Text(text)) => text.as_ref().is_some_and(String::is_empty),
    Some(Found::Number(number)) => number == "0",
    _ => false,
};
const ANY: Test = |_| true;

const fn row(kind: Kind, keyword: &'static str, found: Test, level: Level, effect: &'static str) -> Row {
    Row { kind, keyword, found, consequence: Consequence::new(level, effect) }
}

const SKIPPED: &str = "skips the combination without a word";
const IGNORED_BONE: &str = "ignores the entry: no bone has such a name";
const OF_DEFAULT: Consequence =
    Consequence::new(Level::Info, "never reads the references of the skeleton that the others refer to");

use Kind::{BaseJson, Geometry, MacroJson, ModellingJson, Skeleton, TargetCategories, Weights};
use Level::{Error, Warning};

#[rustfmt::skip]
static ROWS: [Row; 45] = [
    row(Geometry, "", ANY, Warning, NOT_READ),
    row(MacroJson, "/type", ANY, Error, "stops at start with a TypeError"),
    row(MacroJson, "/allOf/", ANY, Error, "stops at start with a KeyError"),
    row(MacroJson, "/$defs/component/required", ANY, Error, "stops at start with a KeyError"),
    row(MacroJson, "/$defs/macrodef/required", ANY, Error, "stops at start with a KeyError"),
    row(MacroJson, "/$defs/macrodef/properties/comp/type", TEXT, Warning,
        "takes the text letter by letter: the macro definition does nothing, without a word"),
    row(MacroJson, "/$defs/target/required", ANY, Warning, SKIPPED),
    row(MacroJson, "/$defs/target/properties/name/type", LIST, Error, "stops at start with a TypeError"),
    row(MacroJson, "/$defs/target/properties/name/type", ANY, Warning, "skips the combination without a word"),
    row(MacroJson, "/$defs/target/properties/t/type", ANY, Error, "stops at start with a TypeError"),
    row(ModellingJson, "/$defs/entry/type", TEXT_OR_LIST, Warning,
        "takes it for an entry without keys: the slider is gone, without a word"),
    row(ModellingJson, "/$defs/entry/type", ANY, Error, "stops at start with a TypeError"),
    row(ModellingJson, "/$defs/entry/properties/macro_influence/items/type", NUMBER, Level::Info,
        "nothing: it only asks whether the list is empty"),
    row(ModellingJson, "/$defs/entry/properties/macro_influence", ANY, Error, "stops at start with a TypeError"),
    row(ModellingJson, "/$defs/entry/properties/default/type", TEXT, Error,
        "repeats the text 100 times at the next reset, and stops later with a TypeError"),
    row(ModellingJson, "/$defs/entry/properties/tip/type", NULL, Level::Info, "nothing: it shows the general hint"),
    row(ModellingJson, "/$defs/entry/properties/name/type", NULL, Level::Info, "nothing worse: the slider has no text"),
    row(ModellingJson, "/$defs/display/required", ANY, Error, "stops at start with a KeyError"),
    row(ModellingJson, "/$defs/display/properties/slot/type", ANY, Error, "stops at start with a TypeError"),
    row(TargetCategories, "/type", ANY, Error, "stops at start with a TypeError"),
    row(TargetCategories, "/$defs/category/then/required", ANY, Error,
        "looks for `default` in place of the group; in the first category it stops with a KeyError"),
    row(TargetCategories, "/$defs/item/required", ANY, Error, "stops with a KeyError when the tree is built"),
    row(BaseJson, "/properties/numverts/type", ANY, Warning, "does not read the number; its mesh tools do"),
    row(BaseJson, "/properties/modifier-presets/type", ANY, Error, "stops at start with a TypeError"),
    row(BaseJson, "/$defs/preset/oneOf/1/pattern", ANY, Error, "stops at start with a ValueError"),
    row(BaseJson, "/$defs/measure/properties/", LIST, Error, "stops with a TypeError when it shows the sizes"),
    row(BaseJson, "/$defs/measure/properties/", ANY, Warning, "shows nothing for it, without a word"),
    row(BaseJson, "/$defs/random/properties/gender/type", ANY, Warning, "does without the choice, without a word"),
    row(BaseJson, "/$defs/random/properties/ideal/type", ANY, Warning, "does without the choice, without a word"),
    row(BaseJson, "/$defs/random/properties/groups/additionalProperties/type", ANY, Warning,
        "takes anything but 0, empty and null for true"),
    row(Skeleton, "/type", LIST, Error, "refuses the skeleton with a line in its log"),
    row(Skeleton, "/$defs/bone/type", TEXT, Error, "refuses the skeleton with a line in its log"),
    row(Skeleton, "/properties/planes/type", ANY, Error, "stops with a TypeError at the first bone that names a plane"),
    row(Skeleton, "/type", ANY, Error, "stops at start, while it scans the assets"),
    row(Skeleton, "/properties/joints/additionalProperties/items", TRUTH, Warning,
        "counts `true` as vertex 1 and `false` as vertex 0, without a word"),
    row(Skeleton, "/properties/name/type", ANY, Error, "stops at start, while it scans the assets (TypeError)"),
    row(Skeleton, "/properties/tags/type", TEXT, Warning, "makes a tag of every letter"),
    row(Skeleton, "/properties/tags/type", OBJECT, Level::Info, "takes the keys of the object for tags"),
    row(Skeleton, "/$defs/bone/properties/reference/items", ANY, Warning, IGNORED_BONE),
    row(Skeleton, "/$defs/bone/properties/weights_reference/items", ANY, Warning, IGNORED_BONE),
    row(Skeleton, "/properties/tags/type", NULL, Error,
        "stops at start, while it scans the assets (TypeError)"),
    row(Weights, "/required", ANY, Error, NO_WEIGHTS_LOADED),
    row(Weights, "/type", EMPTY, Error, NO_WEIGHTS_LOADED),
    row(Weights, "/type", LIST, Error, NO_WEIGHTS_LOADED),
    row(Weights, "/properties/weights/type", LIST, Error, "stops with an AttributeError when it loads the weights"),
];

/// Whether the value is, or is in, a list of bones of the default skeleton.
fn is_reference(fault: &SchemaFault) -> bool {
    let lists = ["/$defs/bone/properties/reference/", "/$defs/bone/properties/weights_reference/"];
    lists.iter().any(|list| fault.keyword.starts_with(list))
}

/// Whether a base is posed with the skeleton.
fn is_for_poses(view: &View<'_>, file: &FileFacts) -> bool {
    let mut rigs = view.bases.iter().flat_map(|base| &base.rigs);
    rigs.any(|rig| rig.is_default && std::ptr::eq(rig.file, file))
}

/// What a value of a file comes to, where it is not what `json-schema` says in general.
pub(super) fn of_value(view: &View<'_>, file: &FileFacts, fault: &SchemaFault) -> Option<Consequence> {
    if is_note(file.kind, fault) {
        return Some(Consequence::new(Level::Info, "nothing: it takes the note for an entry that no window shows"));
    }
    if file.kind == Geometry && !is_opened_by_scripts(&file.rel) {
        return Some(Consequence::new(Level::Info, NEVER_OPENED));
    }
    let kind = if file.kind == Kind::AssetWeights { Weights } else { file.kind };
    if kind == Skeleton && is_reference(fault) && is_for_poses(view, file) {
        return Some(OF_DEFAULT);
    }
    if kind == MacroJson && fault.keyword.starts_with("/$defs/target/required") && is_lost(file, fault) {
        return Some(Consequence::new(Error, "never applies the macrodef: no combination of it has a file"));
    }
    let fits = |row: &&Row| row.kind == kind && fault.keyword.starts_with(row.keyword) && (row.found)(fault.found());
    ROWS.iter().find(fits).map(|row| row.consequence)
}

/// What numbers come to that JSON does not have, where a slider is reset to one.
pub(super) fn of_special(file: &FileFacts) -> Option<Consequence> {
    let Content::Modelling(model) = &*file.content else { return None };
    let is_reset_to_one = model.sliders.iter().any(|slider| slider.default.is_some_and(|default| !default.is_finite()));
    let effect = "resets the slider to no number, and stops with a ValueError at every text on sizes after that";
    is_reset_to_one.then(|| Consequence::new(Error, effect))
}

/// Whether the macro definition of an incomplete combination has no complete one.
fn is_lost(file: &FileFacts, fault: &SchemaFault) -> bool {
    let Content::Macro(macros) = &*file.content else { return false };
    let rest = fault.pointer.strip_prefix("/macrodef/").and_then(|rest| rest.split('/').next());
    let Some(index) = rest.and_then(|index| index.parse::<usize>().ok()) else { return false };
    macros.macrodefs.get(index).is_some_and(|own| !own.has_target)
}

/// Whether it is a text that somebody wrote among the sliders for people, under a key such as `_comment`.
fn is_note(kind: Kind, fault: &SchemaFault) -> bool {
    let is_top = fault.pointer.strip_prefix("/_").is_some_and(|key| !key.contains('/'));
    kind == ModellingJson && fault.keyword.starts_with("/$defs/entry/type") && is_top && TEXT_OR_LIST(fault.found())
}
