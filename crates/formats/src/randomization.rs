//! Presets of the randomizer of MPFB, `randomization.<name>.json`
//! (`docs/loaders/mpfb/models.md#presets-of-the-randomizer`).
//!
//! The loader takes every key with `[]` and sets a property of Blender to its value, one after the
//! other: at the first key that is missing, or value that the property does not take, it stops.

use std::collections::BTreeSet;

use super::unfit::{Unfits, Why, below, is_number};
use mhlint_json::{Document, Member, Node, Value};

/// A preset.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Randomization {
    /// What stops the loader, whatever sections the catalogue has.
    stops: Unfits,
    /// The sections of the catalogue that it has settings for, each with what stops the loader
    /// there; nothing where it has no such object.
    sections: Option<Vec<(String, Unfits)>>,
}

impl Randomization {
    /// What stops the loader. Settings for a section that the catalogue does not have are passed
    /// over, whatever they are; `None` if the catalogue is not at hand.
    pub fn stops(&self, catalog: Option<&[&str]>) -> Unfits {
        let mut stops = self.stops.clone();
        let catalog = catalog.map(|names| names.iter().copied().collect::<BTreeSet<&str>>());
        let is_read = |name: &str| {
            catalog
                .as_ref()
                .is_none_or(|catalog| catalog.contains(name))
        };
        let sections = self
            .sections
            .iter()
            .flatten()
            .filter(|(name, _)| is_read(name));
        sections.for_each(|(_, faults)| stops.extend(faults.clone()));
        stops
    }

    /// The sections of a catalogue that it has no settings for.
    pub fn lacks<'c>(&self, catalog: &[&'c str]) -> Vec<&'c str> {
        let Some(sections) = &self.sections else {
            return Vec::new();
        };
        let known: BTreeSet<&str> = sections.iter().map(|(name, _)| name.as_str()).collect();
        catalog
            .iter()
            .copied()
            .filter(|wanted| !known.contains(wanted))
            .collect()
    }
}

/// A key that the loader takes.
struct Key {
    name: &'static str,
    wants: Wants,
    /// Older presets lack it, and the loader knows.
    is_optional: bool,
}

/// What a value has to be.
enum Wants {
    Flag,
    Number,
    Whole,
    Text,
    /// One of a few words.
    Word(&'static [&'static str]),
    /// Something in which names are looked for: a list, or a text.
    Names,
    /// Whatever is there.
    Anything,
    Keys(&'static [Key]),
    /// An object with settings for each section of the catalogue, whose names nobody knows here.
    Sections,
}
use Wants::{Anything, Flag, Keys, Names, Number, Sections, Text, Whole, Word};

const fn key(name: &'static str, wants: Wants) -> Key {
    Key {
        name,
        wants,
        is_optional: false,
    }
}

const fn later(name: &'static str, wants: Wants) -> Key {
    Key {
        name,
        wants,
        is_optional: true,
    }
}

const PRESET: &[Key] = &[
    key("phenotype", Keys(PHENOTYPE)),
    key("creation", Keys(CREATION)),
    key("assets", Keys(ASSETS)),
    key("details", Keys(DETAILS)),
    key("batch", Keys(BATCH)),
];

const PHENOTYPE: &[Key] = &[
    key("distribution", Word(&["flat", "bell", "pyramid", "peak"])),
    key("discrete_race", Flag),
    key("discrete_gender", Flag),
    key("discrete_age", Flag),
    key("breast_gender_cutoff", Number),
    key("breast_age_cutoff", Number),
    key("attributes", Keys(ATTRIBUTES)),
];
const ATTRIBUTES: &[Key] = &[
    key("gender", Keys(CHOSEN)),
    key("age", Keys(CHOSEN)),
    key("muscle", Keys(DRAWN)),
    key("weight", Keys(DRAWN)),
    key("height", Keys(DRAWN)),
    key("proportions", Keys(DRAWN)),
    key("cupsize", Keys(DRAWN)),
    key("firmness", Keys(DRAWN)),
    key("race", Keys(&[key("include", Flag), key("allowed", Names)])),
];
/// What is drawn at random around a value.
const DRAWN: &[Key] = &[
    key("include", Flag),
    key("neutral", Number),
    key("deviation", Number),
];
/// The same where a few values may be all there are.
const CHOSEN: &[Key] = &[
    key("include", Flag),
    key("neutral", Number),
    key("deviation", Number),
    key("allowed", Names),
];

const CREATION: &[Key] = &[
    key("scale_factor", Word(&["METER", "DECIMETER", "CENTIMETER"])),
    key("detailed_helpers", Flag),
    key("extra_vertex_groups", Flag),
    key("mask_helpers", Flag),
    // A rig that there is not is taken for none.
    key("rig", Anything),
    key("auto_generate_rigify", Flag),
    key("meta_rig_action", Text),
    later("add_subdiv_modifier", Flag),
    later("subdiv_render_levels", Whole),
];

const ASSETS: &[Key] = &[
    key("skin", Keys(SKIN)),
    key("asset_material_type", Word(&["GAMEENGINE", "MAKESKIN"])),
    key("eyes", Keys(EYES)),
    key("hair", Keys(HAIR)),
    key("eyebrows", Keys(PART)),
    key("eyelashes", Keys(PART)),
    key("teeth", Keys(PART)),
    key("tongue", Keys(PART)),
    key("clothes", Keys(CLOTHES)),
];
const SKIN: &[Key] = &[
    key("enabled", Flag),
    key("match_gender", Flag),
    key("match_age", Flag),
    key("match_race", Flag),
    key("fallback", Flag),
    key("pack", Text),
    key("include", Text),
    key("exclude", Text),
    key("skin_type", Text),
    key("material_instances", Anything),
];
const EYES: &[Key] = &[
    key("mode", Word(&["DONOTADD", "HIGHPOLY", "LOWPOLY"])),
    key(
        "material_type",
        Word(&["GAMEENGINE", "MAKESKIN", "PROCEDURAL_EYES"]),
    ),
    key("randomize_alt_materials", Flag),
];
const HAIR: &[Key] = &[
    key("enabled", Flag),
    key("match_gender", Flag),
    key("fallback", Flag),
    key("pack", Text),
    key("include", Text),
    key("exclude", Text),
    key("randomize_alt_materials", Flag),
];
const PART: &[Key] = &[
    key("enabled", Flag),
    key("pack", Text),
    key("include", Text),
    key("exclude", Text),
];
const CLOTHES: &[Key] = &[
    key("head", Keys(GARMENT)),
    key("full_body", Keys(GARMENT)),
    key("upper_body", Keys(GARMENT)),
    key("lower_body", Keys(GARMENT)),
    key("hands", Keys(GARMENT)),
    key("feet", Keys(GARMENT)),
    key("underwear", Keys(GARMENT)),
    key("accessories", Keys(GARMENT)),
];
const GARMENT: &[Key] = &[
    key("enabled", Flag),
    key("chance", Whole),
    key("pack", Text),
    key("include_any", Text),
    key("include_female", Text),
    key("include_male", Text),
    key("exclude", Text),
];

const DETAILS: &[Key] = &[
    key("enabled", Flag),
    key("symmetry", Flag),
    key("sections", Sections),
];
const SECTION: &[Key] = &[
    key("min", Whole),
    key("max", Whole),
    key("include", Text),
    key("exclude", Text),
    key("deviation", Number),
];

const BATCH: &[Key] = &[
    key("count", Whole),
    key("strategy", Word(&["GRID", "RANDOM"])),
    later("origin_x", Number),
    later("origin_y", Number),
    key("spacing_x", Number),
    key("row_length", Whole),
    key("row_shift_y", Number),
    key("x_min", Number),
    key("x_max", Number),
    key("y_min", Number),
    key("y_max", Number),
    key("min_distance", Number),
    key("random_rotation", Flag),
];

/// Takes what the loader would take.
pub fn read(document: &Document) -> Randomization {
    let root = &document.root;
    let mut preset = Randomization::default();
    check_keys(&mut preset.stops, "", root, PRESET);
    let sections = root
        .get("details")
        .and_then(|details| details.get("sections"))
        .filter(|node| node.is_object());
    preset.sections = sections.map(|sections| {
        sections
            .effective_members()
            .into_iter()
            .map(section)
            .collect()
    });
    preset
}

fn section(member: &Member) -> (String, Unfits) {
    let mut stops = Unfits::default();
    check_keys(
        &mut stops,
        &below("/details/sections", &member.key),
        &member.node,
        SECTION,
    );
    (member.key.clone(), stops)
}

fn check_keys(stops: &mut Unfits, pointer: &str, node: &Node, keys: &'static [Key]) {
    if !node.is_object() {
        return stops.add_type(pointer, node, "an object");
    }
    for key in keys {
        match node.get(key.name) {
            Some(value) => check(stops, &below(pointer, key.name), value, &key.wants),
            None if key.is_optional => {}
            None => stops.add(pointer, Why::Lacks(key.name)),
        }
    }
}

fn check(stops: &mut Unfits, pointer: &str, node: &Node, wants: &'static Wants) {
    let wanted = match wants {
        Keys(keys) => return check_keys(stops, pointer, node, keys),
        Word(known) if node.as_str().is_some() => return stops.check_word(pointer, node, known),
        Anything => return,
        Sections if node.is_object() => return,
        Flag if is_number(node) => return,
        Number if is_number(node) => return,
        Whole if matches!(node.value, Value::Bool(_) | Value::Number(_, true)) => return,
        Names if node.is_array() || node.is_object() || node.as_str().is_some() => return,
        Text if node.as_str().is_some() => return,
        Flag => "true or false",
        Number => "a number",
        Whole => "a whole number",
        Names => "a list of names",
        Text | Word(_) => "a string",
        Sections => "an object",
    };
    stops.add_type(pointer, node, wanted);
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::parse;

    fn pointers(text: &str) -> Vec<String> {
        let preset = read(&parse(text.as_bytes()).unwrap());
        preset
            .stops(None)
            .all()
            .iter()
            .map(|one| one.pointer.clone())
            .collect()
    }

    /// A preset with everything in it, in the order of the tables.
    fn whole(keys: &[Key]) -> String {
        let members = keys.iter().map(|key| {
            let value = match key.wants {
                Flag => "true".to_owned(),
                Number => "0.5".to_owned(),
                Whole => "3".to_owned(),
                Text | Anything => "\"x\"".to_owned(),
                Word(known) => format!("{:?}", known[0]),
                Names => "[]".to_owned(),
                Keys(keys) => whole(keys),
                Sections => format!("{{\"nose\": {}}}", whole(SECTION)),
            };
            format!("{:?}: {value}", key.name)
        });
        format!("{{{}}}", members.collect::<Vec<_>>().join(", "))
    }

    #[test]
    fn a_whole_preset_has_all_that_the_loader_takes() {
        let text = whole(PRESET);
        assert_eq!(pointers(&text), [""; 0]);
        let preset = read(&parse(text.as_bytes()).unwrap());
        assert_eq!(
            (preset.lacks(&["nose"]), preset.lacks(&["chin", "nose"])),
            (vec![], vec!["chin"])
        );
    }

    #[test]
    fn what_older_presets_lack_is_not_missed() {
        let text = whole(PRESET)
            .replace("\"origin_x\": 0.5, ", "")
            .replace("\"add_subdiv_modifier\": true, ", "");
        assert_eq!(pointers(&text), [""; 0]);
        assert_eq!(
            pointers(&text.replace("\"spacing_x\": 0.5, ", "")),
            ["/batch"]
        );
    }

    #[test]
    fn values_are_of_the_type_of_their_property() {
        let of = |good: &str, bad: &str| {
            let text = whole(PRESET);
            assert!(text.contains(good), "{good}");
            pointers(&text.replacen(good, bad, 1))
        };
        assert_eq!(of("\"count\": 3", "\"count\": 2.5"), ["/batch/count"]);
        assert_eq!(of("\"count\": 3", "\"count\": true"), [""; 0]);
        assert_eq!(
            of("\"distribution\": \"flat\"", "\"distribution\": \"Flat\""),
            ["/phenotype/distribution"]
        );
        assert_eq!(
            of("\"neutral\": 0.5", "\"neutral\": \"0.5\""),
            ["/phenotype/attributes/gender/neutral"]
        );
        assert_eq!(
            of("\"discrete_race\": true", "\"discrete_race\": null"),
            ["/phenotype/discrete_race"]
        );
        let text = whole(PRESET).replace("\"min\": 3", "\"min\": null");
        let preset = read(&parse(text.as_bytes()).unwrap());
        let count = |catalog| preset.stops(catalog).all().len();
        assert_eq!(
            (
                count(None),
                count(Some(&["nose"][..])),
                count(Some(&["chin"][..]))
            ),
            (1, 1, 0)
        );
        assert_eq!(pointers("[]"), [""]);
        assert_eq!(pointers("{}"), [""; 5]);
    }
}
