//! What becomes of a value that does not fit its schema, where it is not the usual exception: a
//! table by schema place (`docs/loaders/makehuman2/macros.md#structure`,
//! `docs/loaders/makehuman2/sliders.md#keys-of-a-slider`,
//! `docs/loaders/makehuman2/sliders.md#categories`, `docs/loaders/makehuman2/base.md#keys`,
//! `docs/loaders/makehuman2/base.md#geometryjson`,
//! `docs/loaders/makehuman2/skeletons.md#keys-of-a-skeleton`,
//! `docs/loaders/makehuman2/weights.md#faults-of-weights`,
//! `docs/loaders/makehuman2/libraries.md#scan`).

use super::makehuman2::{
    NEVER_OPENED, NO_WEIGHTS_LOADED, NOT_READ, REFUSED_ASSET, is_opened_by_scripts,
};
use super::values::{ANY, NULL, Row, TEXT, Test, row};
use super::{Consequence, values};
use mhlint_diag::{Application::Makehuman2, Level};
use mhlint_discover::Kind;
use mhlint_formats::Content;
use mhlint_json::{Found, SchemaFault};
use mhlint_repo::makehuman2::View;
use mhlint_repo::{FileFacts, ReferenceKind};

const LIST: Test = |found| matches!(found, Some(Found::List { .. }));
const TEXT_OR_LIST: Test = |found| TEXT(found) || LIST(found);
const NUMBER: Test = |found| matches!(found, Some(Found::Number(_)));
const OBJECT: Test = |found| found == Some(&Found::Object);
const TRUTH: Test = |found| matches!(found, Some(Found::Bool(_)));
/// What Python takes for false, and the loader for no file.
const EMPTY: Test = |found| match found {
    Some(Found::Null | Found::Bool(false) | Found::List { is_empty: true }) => true,
    Some(Found::Text(text)) => text.as_ref().is_some_and(String::is_empty),
    Some(Found::Number(number)) => number == "0",
    _ => false,
};

const SKIPPED: &str = "silently skips the combination";
const SCAN_TYPE: &str = "crashes at start with `TypeError` while scanning the assets";
const IGNORED_BONE: &str = "ignores the entry: no bone has this name";
const OF_DEFAULT: Consequence = Consequence::new(
    Level::Info,
    "never reads the references of the default skeleton",
);

use Kind::{
    BaseJson, Geometry, MacroJson, ModellingJson, Pose, PoseUnits, SelectionFilter, Shaders,
    Skeleton, TargetCategories, Version, Weights,
};
use Level::{Error, Warning};

#[rustfmt::skip]
pub(super) static ROWS: [Row; 86] = [
    row(Pose, "/required", ANY, Warning, "lists the pose under its whole path"),
    row(Pose, "/type", TEXT_OR_LIST, Error, "lists it under its whole path, and crashes with \
        `TypeError` when it is shown"),
    row(Pose, "/type", ANY, Error, SCAN_TYPE),
    row(Pose, "/properties/name/type", ANY, Error, SCAN_TYPE),
    row(Pose, "/properties/author/type", NULL, Error, "lists the pose; each click on it crashes \
        with `AttributeError`"),
    row(Pose, "/properties/author/type", ANY, Error, "crashes at start with `AttributeError` when \
        it lists the poses"),
    row(Pose, "/properties/tags/type", TEXT, Warning, "turns every letter into a tag"),
    row(Pose, "/properties/tags/type", OBJECT, Level::Info, "uses the keys of the object as tags"),
    row(Pose, "/properties/tags/", ANY, Error, SCAN_TYPE),
    row(Pose, "/properties/unit_poses/additionalProperties/type", TRUTH, Level::Info, "counts it \
        as 1 or 0"),
    row(Pose, "/properties/unit_poses/type", ANY, Error, "crashes with `AttributeError` when the \
        pose is shown"),
    row(Pose, "/properties/unit_poses/", ANY, Error, "crashes with `TypeError` when the pose is \
        shown"),
    row(PoseUnits, "/$defs/unit/type", TEXT_OR_LIST, Warning, "offers no slider for the unit"),
    row(PoseUnits, "/$defs/unit/type", ANY, Error, "crashes at start with `TypeError`"),
    row(PoseUnits, "/$defs/unit/properties/position/required", ANY, Error,
        "crashes with `KeyError` when the pose editor is opened"),
    row(PoseUnits, "/$defs/unit/properties/position/properties/direction", ANY, Warning, "moves \
        the figure along x"),
    row(PoseUnits, "/$defs/unit/properties/position/", ANY, Error, "crashes when the pose editor \
        is opened"),
    row(PoseUnits, "/$defs/unit/properties/bones", ANY, Error, "crashes at start"),
    row(PoseUnits, "/$defs/unit/properties/reverse", ANY, Error, "crashes at start"),
    row(PoseUnits, "/$defs/unit/properties/", ANY, Warning, "does not find the text"),
    row(PoseUnits, "/type", ANY, Error, "crashes at start"),
    row(SelectionFilter, "/type", ANY, Error, "crashes at start when it builds the lists"),
    row(SelectionFilter, "/properties/Translate", ANY, Error, "crashes at start when it builds \
        the lists"),
    row(SelectionFilter, "/properties/GuessName", ANY, Error, "crashes with `TypeError` when a \
        filter is used"),
    row(SelectionFilter, "/properties/Shortcut/type", OBJECT, Warning, "shows other assets than \
        meant"),
    row(SelectionFilter, "/properties/Shortcut/items/minItems", ANY, Error,
        "crashes with `IndexError` when the list is opened, which stays empty"),
    row(SelectionFilter, "/properties/Shortcut/items/items", ANY, Error,
        "crashes with `AttributeError` when the button is pressed"),
    row(SelectionFilter, "/properties/Shortcut", ANY, Error, "crashes when the list is opened"),
    row(SelectionFilter, "/$defs/branch/type", TEXT, Warning, "silently drops the label: no tag \
        leads to it"),
    row(SelectionFilter, "/$defs/branch/type", NULL, Error, "crashes with `TypeError` every time \
        the list is opened"),
    row(SelectionFilter, "/$defs/branch/type", ANY, Error, "crashes when it builds the lists"),
    row(SelectionFilter, "/$defs/branch/items", ANY, Error, "crashes at start with `TypeError`"),
    row(Version, "/required", ANY, Error, "crashes with `KeyError` where it uses the key"),
    row(Version, "/properties/parallelmacro", ANY, Level::Info, "treats it as false"),
    row(Shaders, "/required", ANY, Error, "crashes at start with `KeyError`"),
    row(Shaders, "/properties/lamps/minItems", ANY, Error, "crashes at start with `IndexError`"),
    row(Shaders, "/properties/lamps/items/required", ANY, Error, "crashes at start with `KeyError`"),
    row(Geometry, "", ANY, Warning, NOT_READ),
    row(MacroJson, "/type", ANY, Error, "crashes at start with `TypeError`"),
    row(MacroJson, "/allOf/", ANY, Error, "crashes at start with `KeyError`"),
    row(MacroJson, "/$defs/component/required", ANY, Error, "crashes at start with `KeyError`"),
    row(MacroJson, "/$defs/macrodef/required", ANY, Error, "crashes at start with `KeyError`"),
    row(MacroJson, "/$defs/macrodef/properties/comp/type", TEXT, Warning,
        "reads the text letter by letter: the macrodef silently does nothing"),
    row(MacroJson, "/$defs/target/required", ANY, Warning, SKIPPED),
    row(MacroJson, "/$defs/target/properties/name/type", LIST, Error, "crashes at start with \
        `TypeError`"),
    row(MacroJson, "/$defs/target/properties/name/type", ANY, Warning, SKIPPED),
    row(MacroJson, "/$defs/target/properties/t/type", ANY, Error, "crashes at start with \
        `TypeError`"),
    row(ModellingJson, "/$defs/entry/type", TEXT_OR_LIST, Warning,
        "silently treats it as an entry without keys: the slider disappears"),
    row(ModellingJson, "/$defs/entry/type", ANY, Error, "crashes at start with `TypeError`"),
    row(ModellingJson, "/$defs/entry/properties/macro_influence/items/type", NUMBER, Level::Info,
        "ignores the value: it only checks whether the list is empty"),
    row(ModellingJson, "/$defs/entry/properties/macro_influence", ANY, Error, "crashes at start \
        with `TypeError`"),
    row(ModellingJson, "/$defs/entry/properties/default/type", TEXT, Error,
        "repeats the text 100 times at the next reset, and later crashes with `TypeError`"),
    row(ModellingJson, "/$defs/entry/properties/tip/type", NULL, Level::Info, "shows the general \
        hint instead"),
    row(ModellingJson, "/$defs/entry/properties/name/type", NULL, Level::Info, "shows the slider \
        without a label"),
    row(ModellingJson, "/$defs/display/required", ANY, Error, "crashes at start with `KeyError`"),
    row(ModellingJson, "/$defs/display/properties/slot/type", ANY, Error, "crashes at start with \
        `TypeError`"),
    row(TargetCategories, "/type", ANY, Error, "crashes at start with `TypeError`"),
    row(TargetCategories, "/$defs/category/then/required", ANY, Error,
        "uses `default` as the group; crashes with `KeyError` if it is the first category"),
    row(TargetCategories, "/$defs/item/required", ANY, Error,
        "crashes with `KeyError` when it builds the tree of categories"),
    row(BaseJson, "/properties/equipment/type", TEXT, Error,
        "offers only the kinds whose names are part of the text: others cannot be chosen"),
    row(BaseJson, "/properties/equipment/type", OBJECT, Warning, "offers the kinds that are keys \
        of the object"),
    row(BaseJson, "/properties/numverts/type", ANY, Warning, "does not read the number, but its \
        mesh tools do"),
    row(BaseJson, "/properties/modifier-presets/type", ANY, Error, "crashes at start with \
        `TypeError`"),
    row(BaseJson, "/$defs/preset/oneOf/1/pattern", ANY, Error, "crashes at start with `ValueError`"),
    row(BaseJson, "/$defs/measure/properties/", LIST, Error, "crashes with `TypeError` when it \
        shows the sizes"),
    row(BaseJson, "/$defs/measure/properties/", ANY, Warning, "silently shows nothing for it"),
    row(BaseJson, "/$defs/random/properties/gender/type", ANY, Warning, "silently drops the choice"),
    row(BaseJson, "/$defs/random/properties/ideal/type", ANY, Warning, "silently drops the choice"),
    row(BaseJson, "/$defs/random/properties/groups/additionalProperties/type", ANY, Warning,
        "treats any value except 0, null and empty ones as true"),
    row(Skeleton, "/type", LIST, Error, "rejects the skeleton and logs a line"),
    row(Skeleton, "/$defs/bone/type", TEXT, Error, "rejects the skeleton and logs a line"),
    row(Skeleton, "/properties/planes/type", ANY, Error,
        "crashes with `TypeError` at the first bone that names a plane"),
    row(Skeleton, "/type", ANY, Error, "crashes at start while scanning the assets"),
    row(Skeleton, "/properties/joints/additionalProperties/items", TRUTH, Warning,
        "silently reads `true` as vertex 1 and `false` as vertex 0"),
    row(Skeleton, "/properties/name/type", ANY, Error, "crashes at start with `TypeError` while \
        scanning the assets"),
    row(Skeleton, "/properties/tags/type", TEXT, Warning, "turns every letter into a tag"),
    row(Skeleton, "/properties/tags/type", OBJECT, Level::Info, "uses the keys of the object as \
        tags"),
    row(Skeleton, "/$defs/bone/properties/reference/items", ANY, Warning, IGNORED_BONE),
    row(Skeleton, "/$defs/bone/properties/weights_reference/items", ANY, Warning, IGNORED_BONE),
    row(Skeleton, "/properties/tags/type", NULL, Error,
        "crashes at start with `TypeError` while scanning the assets"),
    row(Kind::AssetWeights, "/required", ANY, Error, REFUSED_ASSET),
    row(Kind::AssetWeights, "/type", ANY, Error, REFUSED_ASSET),
    row(Weights, "/required", ANY, Error, NO_WEIGHTS_LOADED),
    row(Weights, "/type", EMPTY, Error, NO_WEIGHTS_LOADED),
    row(Weights, "/type", LIST, Error, NO_WEIGHTS_LOADED),
    row(Weights, "/properties/weights/type", LIST, Error, "crashes with `AttributeError` while \
        loading the weights"),
];

/// Whether the value is, or is in, a list of bones of the default skeleton.
fn is_reference(fault: &SchemaFault) -> bool {
    let lists = [
        "/$defs/bone/properties/reference/",
        "/$defs/bone/properties/weights_reference/",
    ];
    lists.iter().any(|list| fault.keyword.starts_with(list))
}

/// Whether a base is posed with the skeleton.
fn is_for_poses(view: &View<'_>, file: &FileFacts) -> bool {
    let named = view.references.to_file(file);
    let mut poses = named.filter(|one| one.kind == ReferenceKind::PoseSkeleton);
    let own = file.base_in(Makehuman2);
    poses.any(|one| own == Some(one.base) && one.found().is_some())
}

/// What a value of a file comes to, where it is not what `json-schema` says in general.
pub(super) fn of_value(
    view: &View<'_>,
    file: &FileFacts,
    fault: &SchemaFault,
) -> Option<Consequence> {
    if is_note(file.kind, fault) {
        return Some(Consequence::new(
            Level::Info,
            "treats the note as an entry that no window shows",
        ));
    }
    if file.kind == Geometry && !is_opened_by_scripts(&file.rel) {
        return Some(Consequence::new(Level::Info, NEVER_OPENED));
    }
    let kind = file.kind;
    if kind == Skeleton && is_reference(fault) && is_for_poses(view, file) {
        return Some(OF_DEFAULT);
    }
    if kind == MacroJson
        && fault.keyword.starts_with("/$defs/target/required")
        && is_lost(file, fault)
    {
        return Some(Consequence::new(
            Error,
            "never applies the macrodef: none of its combinations has a file",
        ));
    }
    let of = |kind| values::first_fit(&ROWS, kind, fault);
    let general = || (kind == Kind::AssetWeights).then(|| of(Weights)).flatten();
    of(kind).or_else(general)
}

/// What numbers come to that JSON does not have, where a slider is reset to one.
pub(super) fn of_special(file: &FileFacts) -> Option<Consequence> {
    let Content::Modelling(model) = &*file.content else {
        return None;
    };
    let is_reset_to_one = model
        .sliders
        .iter()
        .any(|slider| slider.default.is_some_and(|default| !default.is_finite()));
    let effect = "resets the slider to a value that is NaN or infinite; then the size information \
        crashes with `ValueError`";
    is_reset_to_one.then(|| Consequence::new(Error, effect))
}

/// Whether the macro definition of an incomplete combination has no complete one.
fn is_lost(file: &FileFacts, fault: &SchemaFault) -> bool {
    let Content::Macro(macros) = &*file.content else {
        return false;
    };
    let rest = fault
        .pointer
        .strip_prefix("/macrodef/")
        .and_then(|rest| rest.split('/').next());
    let Some(index) = rest.and_then(|index| index.parse::<usize>().ok()) else {
        return false;
    };
    macros
        .macrodefs
        .get(index)
        .is_some_and(|own| !own.has_target)
}

/// Whether it is a text that somebody wrote among the sliders for people, under a key such as
/// `_comment`.
fn is_note(kind: Kind, fault: &SchemaFault) -> bool {
    let is_top = fault
        .pointer
        .strip_prefix("/_")
        .is_some_and(|key| !key.contains('/'));
    kind == ModellingJson
        && fault.keyword.starts_with("/$defs/entry/type")
        && is_top
        && TEXT_OR_LIST(fault.found())
}
