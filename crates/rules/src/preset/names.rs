//! Names in a saved character that lead to nothing.

use std::collections::BTreeMap;

use super::super::{RuleCx, did_you_mean, such};
use mhlint_diag::{Cases, Evidence, Level, steps};
use mhlint_formats::human_preset::HumanPreset;
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::mpfb::{NamedTarget, View};
use mhlint_source::file_name;

/// What a finding on names says.
pub(super) struct Named {
    pub(super) at: String,
    pub(super) message: String,
    pub(super) key: &'static str,
    pub(super) help: String,
    pub(super) level: Level,
    pub(super) effect: &'static str,
    pub(super) cases: Cases,
}

/// What becomes of a rig that MPFB cannot add.
pub(super) const NO_RIG: &str =
    "fails with an exception when it adds the rig: only the body is made";

/// What is named: key of the finding, word for it, and what becomes of a name that leads to
/// nothing.
const SORTS: [(&str, &str, Level, &str); 4] = [
    (
        "worn",
        "asset",
        Level::Warning,
        "leaves it out, with a message in the log",
    ),
    (
        "skin",
        "skin",
        Level::Warning,
        "shows the body without a material, with a message in the log",
    ),
    (
        "expressions",
        "expression",
        Level::Warning,
        "drops the expression",
    ),
    (
        "makeup",
        "ink layer",
        Level::Error,
        "fails with `TypeError` at the makeup; the character has everything that comes before it",
    ),
];

/// What saved characters are looked up in, made once for all of them.
pub(super) struct Known {
    /// Whether saved characters are alone, without the user's data.
    has_no_data: bool,
    /// The names of the rigs of MPFB.
    rigs: Vec<String>,
    /// The same by their small letters.
    by_small_letters: BTreeMap<String, String>,
}

impl Known {
    pub(super) fn of(view: &View<'_>) -> Self {
        let files = view
            .layers
            .system
            .into_iter()
            .flat_map(|layer| layer.below("rigs/standard"));
        let stem = |file: &str| Some(file.strip_prefix("rig.")?.strip_suffix(".json")?.to_owned());
        let rigs: Vec<String> = files.filter_map(|file| stem(file.file_name())).collect();
        let mut by_small_letters = BTreeMap::new();
        for rig in &rigs {
            let small = rig.to_ascii_lowercase();
            by_small_letters.entry(small).or_insert_with(|| rig.clone());
        }
        Self {
            has_no_data: view.layers.checked.files.values().all(|file| file.is_loose),
            rigs,
            by_small_letters,
        }
    }
}

/// All names that lead to nothing: one finding for those of one sort.
pub(super) fn named(
    view: &View<'_>,
    known: &Known,
    preset: &HumanPreset,
    cx: &RuleCx<'_>,
) -> Vec<Named> {
    let mut all = Vec::new();
    all.extend(targets(view, preset, cx));
    all.extend(ambiguous(view, preset));
    let rig = preset
        .rig
        .as_ref()
        .and_then(|rig| Some((rig, unknown_rig(view, known, rig, cx)?)));
    let is_own_rig = |rig: &NamedAt| rig.name.starts_with(OWN_RIG);
    let (own, others) = rig
        .into_iter()
        .partition::<Vec<_>, _>(|(rig, _)| is_own_rig(rig));
    all.extend(own.into_iter().map(|(_, named)| named));
    let of_sort = [
        preset.worn.as_slice(),
        preset.skin.as_slice(),
        preset.expressions.as_slice(),
        preset.makeup.as_slice(),
    ];
    for (names, (key, what, level, effect)) in of_sort.into_iter().zip(SORTS) {
        all.extend(files(view, names, cx).map(|(first, near, count, cases)| {
            Named {
                at: first.pointer.clone(),
                message: format!(
                    "{what} `{}` does not exist{}",
                    first.name,
                    such(count, "names")
                ),
                key,
                help: elsewhere(view, first)
                    .unwrap_or_else(|| did_you_mean(near, "correct the name, or add the file")),
                level,
                effect,
                cases,
            }
        }));
    }
    if known.has_no_data {
        all.iter_mut()
            .for_each(|one| (one.level, one.effect) = (Level::Info, UNLESS_USERS));
    }
    // A rig of MPFB itself is there or not, whatever the user has.
    all.extend(others.into_iter().map(|(_, named)| named));
    all
}

/// What the names of a user's own rigs begin with.
const OWN_RIG: &str = "custom.";

/// What names lead to that may be in data of the user that are not at hand.
const UNLESS_USERS: &str =
    "leaves it out, unless it is in the data of the user, which are not checked here";

fn targets(view: &View<'_>, preset: &HumanPreset, cx: &RuleCx<'_>) -> Option<Named> {
    let is_missing = |one: &&NamedAt| matches!(view.targets.find(&one.name), NamedTarget::Missing);
    let mut missing: Vec<&NamedAt> = preset.targets.iter().filter(is_missing).collect();
    missing.first()?;
    // That the target of a slider is missing is told of the slider.
    let of_sliders = view.slot_targets();
    missing.retain(|one| !of_sliders.contains(&one.name.to_lowercase()));
    let first = missing.first()?;
    let near = cx.suggestions.nearest(&first.name, view.targets.names());
    Some(Named {
        at: first.pointer.clone(),
        message: format!(
            "target `{}` does not exist{}",
            first.name,
            such(missing.len(), "targets")
        ),
        key: "targets",
        help: did_you_mean(near, "correct the name, or add the target"),
        level: Level::Warning,
        effect: "skips the target, with a message in the log",
        cases: Evidence::of_cases(missing.iter().map(|one| one.name.as_str())),
    })
}

fn ambiguous<'p>(view: &View<'p>, preset: &'p HumanPreset) -> Option<Named> {
    let of = |one: &'p NamedAt| match view.targets.find(&one.name) {
        NamedTarget::AnyOf(count, file) => Some((one, count, file.file_name())),
        _ => None,
    };
    let ambiguous: Vec<(&NamedAt, usize, &str)> = preset.targets.iter().filter_map(of).collect();
    let (first, count, example) = ambiguous.first()?;
    let more = such(ambiguous.len(), "names");
    Some(Named {
        at: first.pointer.clone(),
        message: format!(
            "no target is named `{}`, but the names of {count} begin with it{more}",
            first.name
        ),
        key: "ambiguous",
        help: format!(
            "write the whole name, such as `{}`",
            example.split(".target").next().unwrap_or(example)
        ),
        level: Level::Warning,
        effect: "takes the first of these that the disk lists",
        cases: Evidence::of_cases(ambiguous.iter().map(|(one, ..)| one.name.as_str())),
    })
}

/// The folder in which a file is looked for, by the key at the top of the saved character.
fn section(one: &NamedAt) -> String {
    let key = steps(&one.pointer).next().unwrap_or_default();
    match key.as_str() {
        "proxy" => "proxymeshes".to_owned(),
        "skin_mhmat" => "skins".to_owned(),
        "makeup" => "ink_layers".to_owned(),
        _ => key,
    }
}

/// What to do where a file of the name is there: in the folder of another kind, or behind another
/// sign.
fn elsewhere(view: &View<'_>, one: &NamedAt) -> Option<String> {
    let section = section(one);
    if one.name.contains('\\') && view.named.has(&section, &one.name.replace('\\', "/")) {
        return Some("write `/` in place of the backslash".to_owned());
    }
    let other = view
        .named
        .section_of(&one.name)
        .filter(|other| *other != section)?;
    Some(format!(
        "the file is in `{other}`: name it there, or move it to `{section}`"
    ))
}

/// Files that are looked for by their name alone: the first that does not exist, what it could be,
/// and how many.
fn files<'p>(
    view: &View<'p>,
    names: &'p [NamedAt],
    cx: &RuleCx<'_>,
) -> Option<(&'p NamedAt, Option<&'p str>, usize, Cases)> {
    let missing: Vec<&NamedAt> = names
        .iter()
        .filter(|one| !view.named.has(&section(one), &one.name))
        .collect();
    let first = *missing.first()?;
    let file = file_name(&first.name);
    let near = cx
        .suggestions
        .nearest_of_kind(file, view.named.names(&section(first)));
    Some((
        first,
        near,
        missing.len(),
        Evidence::of_cases(missing.iter().map(|one| one.name.as_str())),
    ))
}

/// A rig of MPFB, or one of the user.
fn unknown_rig(view: &View<'_>, known: &Known, rig: &NamedAt, cx: &RuleCx<'_>) -> Option<Named> {
    let name = rig.name.as_str();
    let custom = name.strip_prefix(OWN_RIG);
    let layers = view.layers;
    let is_known = match custom {
        Some(own) => layers
            .user
            .into_iter()
            .chain(layers.beside)
            .any(|layer| layer.is_there(&format!("rigs/{own}.json"))),
        None => match name.strip_prefix("rigify.") {
            Some(own) => {
                let system = layers.system?;
                system
                    .file(&format!("rigs/rigify/rig.{own}.json"))
                    .is_some()
                    || system.below("rigs/rigify").next().is_none()
            }
            None => layers
                .system?
                .file(&format!("rigs/standard/rig.{name}.json"))
                .is_some(),
        },
    };
    // A part of the data without any rig says nothing.
    if is_known || custom.is_none() && known.rigs.is_empty() {
        return None;
    }
    let small = name.replace('-', "_").to_ascii_lowercase();
    let near = known.by_small_letters.get(&small).map(String::as_str);
    let near = near.or_else(|| {
        cx.suggestions
            .nearest(name, known.rigs.iter().map(String::as_str))
    });
    Some(Named {
        at: rig.pointer.clone(),
        message: format!("rig `{name}` does not exist"),
        key: "rig",
        help: did_you_mean(
            near,
            "name a rig of MPFB, or add the rig to `rigs` of the user's data",
        ),
        level: Level::Error,
        effect: NO_RIG,
        cases: Evidence::of_cases([name]),
    })
}
