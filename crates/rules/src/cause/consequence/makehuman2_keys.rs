//! What becomes of what a misspelt key was meant for: a table by format and key
//! (`docs/loaders/makehuman2/macros.md#structure`,
//! `docs/loaders/makehuman2/sliders.md#keys-of-a-slider`,
//! `docs/loaders/makehuman2/sliders.md#categories`, `docs/loaders/makehuman2/base.md#keys`).

use super::{Consequence, NO_POSE_SKELETON};
use mhlint_diag::Level;
use mhlint_discover::Kind;
use mhlint_json::UnknownKey;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

use Kind::{BaseJson, ModellingJson, TargetCategories};
use Level::{Error, Info, Warning};

/// A key that is not read, and what is lost with it.
pub(super) struct Row {
    pub kind: Kind,
    pub meant: &'static str,
    consequence: Consequence,
}

const fn row(kind: Kind, meant: &'static str, level: Level, effect: &'static str) -> Row {
    Row {
        kind,
        meant,
        consequence: Consequence::new(level, effect),
    }
}

const NO_HINT: &str = "ignores the key; nothing else is lost";
const NO_PARTNER: &str =
    "ignores the key: the slider has no left/right counterpart, so symmetry changes one side only";
const ONE_SIDED: &str = "ignores the key: the sliders have only one direction";
const RANDOM_STOPS: &str = "ignores the key and crashes with `KeyError` when it makes a random \
    character; the sliders have only one direction";

#[rustfmt::skip]
pub(super) static ROWS: [Row; 22] = [
    row(ModellingJson, "group", Warning, "ignores the key and never shows the slider"),
    row(ModellingJson, "macro_influence", Warning,
        "ignores the key: hides all macro shapes when the slider is opened, until another macro \
            slider moves"),
    row(ModellingJson, "barycentric_diffuse", Warning, "ignores the key: the skin keeps its colour"),
    row(ModellingJson, "default", Warning, "ignores the key: a reset sets the slider to 0"),
    row(ModellingJson, "measure", Warning, "ignores the key and measures nothing"),
    row(ModellingJson, "display", Warning, "ignores the key and does not show the value as a text"),
    row(ModellingJson, "rsym", Warning, NO_PARTNER),
    row(ModellingJson, "lsym", Warning, NO_PARTNER),
    row(ModellingJson, "lsym` or `rsym", Warning, NO_PARTNER),
    row(ModellingJson, "icon", Warning, "ignores the key: the button has no picture of its own"),
    row(ModellingJson, "name", Warning, "ignores the key: the window shows the key of the slider \
        as its name"),
    row(ModellingJson, "tip", Info, NO_HINT),
    row(TargetCategories, "items", Warning, "ignores the key: the category is empty, and its \
        sliders are never shown"),
    row(TargetCategories, "group", Warning, "ignores the key: the sliders of the category are \
        never shown"),
    row(BaseJson, "equipment", Error, "ignores the key and offers only clothes: no hair, eyes, \
        teeth or topologies"),
    row(BaseJson, "pose-skeleton", Error, NO_POSE_SKELETON),
    row(BaseJson, "mhm", Warning, "ignores the key: it shows the default material and applies no \
        target at start"),
    row(BaseJson, "modifier-presets", Warning, "ignores the key: the sliders start at 0"),
    row(BaseJson, "measure", Warning, "ignores the key and shows no sizes"),
    row(BaseJson, "head-pattern", Warning, "ignores the key: loading a head loads the whole \
        character"),
    row(BaseJson, "random", Warning, "ignores the key: random characters use no groups and no \
        rules"),
    row(BaseJson, "numverts", Info, NO_HINT),
];

pub(super) fn of_misspelt(
    view: &View<'_>,
    file: &FileFacts,
    unknown: &UnknownKey,
) -> Option<Consequence> {
    let meant = unknown.nearest.as_deref()?;
    if file.kind == BaseJson && meant == "target-opposites" {
        return Some(without_opposites(view, file));
    }
    let row = ROWS
        .iter()
        .find(|row| row.kind == file.kind && row.meant == meant);
    let matters = matches!(file.kind, ModellingJson | TargetCategories | BaseJson);
    let usual = matters.then_some(Consequence {
        level: Warning,
        effect: None,
    });
    row.map(|row| row.consequence).or(usual)
}

/// The random character view looks a partner up by the pattern that a pair would have.
fn without_opposites(view: &View<'_>, file: &FileFacts) -> Consequence {
    let is_own = |base: &&Base<'_>| {
        base.own_json
            .is_some_and(|(json, _)| std::ptr::eq(json, file))
    };
    let own = file.base().and_then(|name| view.base(name)).filter(is_own);
    let has_partner = own.is_some_and(|base| {
        let mut pairs = base
            .sliders
            .iter()
            .filter(|bound| bound.is_undeclared_pair());
        pairs.any(|bound| bound.slider.lsym.is_some() || bound.slider.rsym.is_some())
    });
    let (level, effect) = if has_partner {
        (Error, RANDOM_STOPS)
    } else {
        (Warning, ONE_SIDED)
    };
    Consequence::new(level, effect)
}
