//! Modifiers with their targets, descriptions and sliders
//! (`docs/loaders/makehuman1/modifiers.md#modifier-file`).

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::targets::Targets;
use crate::{FileFacts, Layer, Layers, ReferenceKind};
use mhlint_formats::modifiers::file::{Modifier, ModifierFile, Part};
use mhlint_formats::modifiers::sliders::ModifierSliders;
use mhlint_formats::modifiers::texts::ModifierTexts;
use mhlint_formats::target::name::category_of;

/// The files that the program opens, in its order: each has a list of modifiers, their descriptions
/// and their sliders.
pub const SETS: [&str; 3] = ["modeling", "bodyshapes", "measurement"];

/// The macro variables.
pub const VARIABLES: [&str; 11] = [
    "Gender",
    "Age",
    "Muscle",
    "Weight",
    "Height",
    "BreastSize",
    "BreastFirmness",
    "BodyProportions",
    "African",
    "Asian",
    "Caucasian",
];

/// All modifiers of the system.
#[derive(Debug, Default)]
pub struct Modifiers<'a> {
    /// The sets in the order in which they are loaded.
    pub sets: Vec<ModifierSet<'a>>,
    /// The modifiers of all sets in that order.
    pub all: Vec<KnownModifier<'a>>,
    /// Places of those of each name.
    by_name: BTreeMap<String, Vec<usize>>,
    /// Whether there are any of their files.
    pub is_there: bool,
    /// How targets are used, by their places; of several uses that by a macro.
    pub uses: BTreeMap<usize, ReferenceKind>,
}

/// The files of one set.
#[derive(Debug)]
pub struct ModifierSet<'a> {
    /// What their names begin with.
    pub stem: &'static str,
    /// The modifiers, if they could be read.
    pub file: Option<(&'a FileFacts, &'a ModifierFile)>,
    /// Their descriptions, if they could be read.
    pub texts: Option<(&'a FileFacts, &'a ModifierTexts)>,
    /// Their sliders, if they could be read.
    pub sliders: Option<(&'a FileFacts, &'a ModifierSliders)>,
}

/// A modifier of some set.
#[derive(Debug)]
pub struct KnownModifier<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// Place of its set.
    pub set: usize,
    /// The modifier.
    pub modifier: &'a Modifier,
    /// The name by which it is known.
    pub name: String,
    /// The groups that it asks for, with the places of their targets.
    pub parts: Vec<TargetPart>,
}

/// The targets of one side of a modifier.
#[derive(Debug)]
pub struct TargetPart {
    /// What they are for.
    pub part: Part,
    /// The name of the group.
    pub group: String,
    /// Places of its targets; none where no file has the name.
    pub targets: Arc<[usize]>,
}

impl<'a> Modifiers<'a> {
    pub(super) fn of(layers: Layers<'a>, targets: &Targets<'a>) -> Self {
        let Some(system) = layers.system else {
            return Self::default();
        };
        let sets: Vec<ModifierSet<'a>> = SETS
            .iter()
            .map(|stem| ModifierSet::of(system, stem))
            .collect();
        let mut modifiers = Self {
            is_there: system.below("modifiers").next().is_some(),
            ..Self::default()
        };
        let mut shared = BTreeMap::new();
        for (set, (file, list)) in sets
            .iter()
            .enumerate()
            .filter_map(|(set, own)| Some((set, own.file?)))
        {
            for modifier in &list.modifiers {
                let name = modifier.full_name();
                modifiers
                    .by_name
                    .entry(name.clone())
                    .or_default()
                    .push(modifiers.all.len());
                let parts = parts(modifier, targets, &mut shared);
                modifiers.all.push(KnownModifier {
                    file,
                    set,
                    modifier,
                    name,
                    parts,
                });
            }
        }
        modifiers.sets = sets;
        modifiers.uses = uses(&modifiers.all);
        modifiers
    }

    /// The modifiers of a name; of several the program has the first.
    pub fn called(&self, name: &str) -> impl Iterator<Item = &KnownModifier<'a>> {
        self.by_name
            .get(name)
            .into_iter()
            .flatten()
            .filter_map(|place| self.all.get(*place))
    }

    /// All names, in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.by_name.keys().map(String::as_str)
    }

    /// Whether there are macros, and none of them has a target.
    pub(super) fn has_no_macro(&self) -> bool {
        let mut macros = self
            .all
            .iter()
            .filter(|one| one.modifier.variable.is_some())
            .peekable();
        macros.peek().is_some()
            && macros.all(|one| one.parts.iter().all(|part| part.targets.is_empty()))
    }

    /// Whether every file of modifiers could be read with all that is in it.
    pub fn is_whole(&self) -> bool {
        self.is_there
            && self
                .sets
                .iter()
                .all(|set| set.file.is_some_and(|(_, list)| list.is_whole))
    }

    /// The modifiers that some slider sets.
    pub fn with_slider(&self) -> BTreeSet<&'a str> {
        let sliders = self.sets.iter().filter_map(|set| set.sliders);
        sliders
            .flat_map(|(_, sliders)| sliders.modifiers())
            .map(|named| named.name.as_str())
            .collect()
    }
}

impl<'a> ModifierSet<'a> {
    fn of(system: &'a Layer, stem: &'static str) -> Self {
        let file = |ending: &str| system.file(&format!("modifiers/{stem}{ending}"));
        Self {
            stem,
            file: file("_modifiers.json").and_then(|file| Some((file, file.modifier_file()?))),
            texts: file("_modifiers_desc.json")
                .and_then(|file| Some((file, file.modifier_texts()?))),
            sliders: file("_sliders.json").and_then(|file| Some((file, file.modifier_sliders()?))),
        }
    }
}

fn uses(all: &[KnownModifier<'_>]) -> BTreeMap<usize, ReferenceKind> {
    let mut uses = BTreeMap::new();
    let mut seen = BTreeSet::new();
    for part in all.iter().flat_map(|one| &one.parts) {
        // All macros of a group have the same targets.
        if !seen.insert((part.group.as_str(), part.part == Part::Macro)) {
            continue;
        }
        let own = if part.part == Part::Macro {
            ReferenceKind::MacroTarget
        } else {
            ReferenceKind::Incr
        };
        for place in part.targets.iter() {
            let known = uses.entry(*place).or_insert(own);
            *known = own.min(*known);
        }
    }
    uses
}

fn parts(
    modifier: &Modifier,
    targets: &Targets<'_>,
    shared: &mut BTreeMap<String, Arc<[usize]>>,
) -> Vec<TargetPart> {
    let groups = modifier.target_groups().into_iter();
    groups
        .map(|(part, group)| TargetPart {
            part,
            targets: Arc::clone(
                shared
                    .entry(group.clone())
                    .or_insert_with(|| targets.of_group(&group).into()),
            ),
            group,
        })
        .collect()
}

/// The category that a macro variable is, if it is one.
pub fn category(variable: &str) -> Option<&'static str> {
    if !VARIABLES.contains(&variable) {
        return None;
    }
    let small = variable.to_lowercase();
    let own = mhlint_formats::target::name::CATEGORIES
        .iter()
        .find(|(category, _)| *category == small);
    own.map(|(category, _)| *category)
        .or_else(|| category_of(&small))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn races_are_values_of_one_category() {
        for (variable, found) in [
            ("Gender", Some("gender")),
            ("BodyProportions", Some("bodyproportions")),
            ("Asian", Some("race")),
            ("asian", None),
            ("Fat", None),
        ] {
            assert_eq!(category(variable), found, "{variable}");
        }
        assert!(
            VARIABLES
                .iter()
                .all(|variable| category(variable).is_some())
        );
    }
}
