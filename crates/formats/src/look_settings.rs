//! Settings of MPFB for the materials of eyes and skin: `eye_settings.<name>.json`,
//! `enhanced_settings.<name>.json` (`docs/loaders/mpfb/materials.md#settings-of-skins`,
//! `docs/loaders/mpfb/materials.md#settings-of-eyes`).

use super::unfit::{LoaderFaults, Why, below, is_number};
use mhlint_json::{Document, Node};

/// Keys of eyes with a colour. All others have a number.
const EYE_COLOURS: [&str; 6] = [
    "EyeWhiteColor",
    "IrisMajorColor",
    "IrisMinorColor",
    "IrisSection4Color",
    "OuterLayerColor",
    "PupilColor",
];
const EYE_KEYS: &[&str] = &[
    "Clearcoat",
    "Clearcoat Roughness",
    "InnerLayerRoughness",
    "IrisBumpStrength",
    "IrisClockwiseMult",
    "IrisFeatureScale",
    "IrisRadialMult",
    "IrisSection1End",
    "IrisSection2End",
    "IrisSection3End",
    "IrisToEyeWhiteRelation",
    "OuterLayerAlpha",
    "OuterLayerIOR",
    "OuterLayerRoughness",
    "OuterLayerTransmission",
    "PupilSize",
    "EyeWhiteColor",
    "IrisMajorColor",
    "IrisMinorColor",
    "IrisSection4Color",
    "OuterLayerColor",
    "PupilColor",
];
/// The parts of the skin that have settings of their own.
const ZONES: &[&str] = &[
    "body",
    "ears",
    "fingernails",
    "genitals",
    "lips",
    "nipple",
    "toenails",
];
const SKIN_COLOUR: &str = "colorMixIn";
const SKIN_KEYS: &[&str] = &[
    "Brightness",
    "Clearcoat",
    "Clearcoat Roughness",
    "Contrast",
    "Pore detail",
    "Pore distortion",
    "Pore scale",
    "Pore strength",
    "Roughness",
    "colorMixIn",
    "colorMixInStrength",
];

/// Takes what the loader would take of settings of eyes.
pub fn eyes(document: &Document) -> LoaderFaults {
    let root = &document.root;
    let mut faults = LoaderFaults::default();
    if !root.is_object() {
        faults.stops.add_type("", root, "an object");
    }
    for member in root.effective_members() {
        let key = &*member.key;
        let is_colour = EYE_COLOURS.contains(&key);
        let is_known = EYE_KEYS.contains(&key);
        faults.take(
            &below("", key),
            &member.node,
            is_known.then_some(is_colour),
            EYE_KEYS,
        );
    }
    faults
}

/// Takes what the loader would take of settings of the skin.
pub fn skin(document: &Document) -> LoaderFaults {
    let root = &document.root;
    let mut faults = LoaderFaults::default();
    if !root.is_object() {
        faults.stops.add_type("", root, "an object");
    }
    let zones = root.effective_members();
    if root.is_object() && zones.iter().all(|zone| ZONES.contains(&&*zone.key)) {
        faults.absent = ZONES
            .iter()
            .copied()
            .filter(|known| zones.iter().all(|zone| zone.key != *known))
            .collect();
    }
    for zone in zones {
        let pointer = below("", &zone.key);
        if !ZONES.contains(&&*zone.key) {
            faults.ignored.add(&pointer, Why::Key(ZONES));
        } else if !zone.node.is_object() {
            faults.stops.add_type(&pointer, &zone.node, "an object");
        }
        for member in zone
            .node
            .effective_members()
            .into_iter()
            .filter(|_| ZONES.contains(&&*zone.key))
        {
            let is_known = SKIN_KEYS.contains(&&*member.key);
            let is_colour = is_known.then_some(member.key == SKIN_COLOUR);
            faults.take(
                &below(&pointer, &member.key),
                &member.node,
                is_colour,
                SKIN_KEYS,
            );
        }
    }
    faults
}

impl LoaderFaults {
    /// Checks a value: a colour, a number, or that of a key that is not known.
    fn take(
        &mut self,
        pointer: &str,
        node: &Node,
        is_colour: Option<bool>,
        known: &'static [&'static str],
    ) {
        match is_colour {
            None => self.ignored.add(pointer, Why::Key(known)),
            Some(false) if !is_number(node) => self.stops.add_type(pointer, node, "a number"),
            Some(false) => {}
            Some(true) if !node.is_array() => {
                self.stops.add_type(pointer, node, "a list of 4 numbers");
            }
            Some(true) if node.elements().len() != 4 => {
                self.stops
                    .add(pointer, Why::Length(node.elements().len(), 4));
            }
            Some(true) => {
                if let Some(odd) = node.elements().iter().find(|one| !is_number(one)) {
                    self.stops.add_type(pointer, odd, "a number in each place");
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unfit::Unfits;
    use mhlint_json::parse;

    fn pointers(faults: &Unfits) -> Vec<&str> {
        faults.all().iter().map(|one| &*one.pointer).collect()
    }

    #[test]
    fn the_keys_of_eyes_are_numbers_and_colours() {
        assert!(EYE_COLOURS.iter().all(|key| EYE_KEYS.contains(key)));
        assert_eq!((EYE_KEYS.len(), EYE_COLOURS.len()), (22, 6));
        let of = |text: &str| eyes(&parse(text.as_bytes()).unwrap());
        assert_eq!(
            of(r#"{"PupilSize": 1, "PupilColor": [0, 0.5, NaN, 1]}"#),
            LoaderFaults::default()
        );
        let bad = of(
            r#"{"PupilSize": "big", "PupilColor": [0, 0, 0], "OuterLayerColor": [0, 0, 0, "1"], "Pupil": 1}"#,
        );
        assert_eq!(
            pointers(&bad.stops),
            ["/PupilSize", "/PupilColor", "/OuterLayerColor"]
        );
        assert_eq!(pointers(&bad.ignored), ["/Pupil"]);
    }

    #[test]
    fn zones_of_the_skin_have_settings() {
        let of = |text: &str| skin(&parse(text.as_bytes()).unwrap());
        let found = of(
            r#"{"body": {"Roughness": 0.5, "Rougness": 1}, "lips": 5, "nose": {"x": 1}, "ears": {}}"#,
        );
        assert_eq!(
            (pointers(&found.stops), pointers(&found.ignored)),
            (vec!["/lips"], vec!["/body/Rougness", "/nose"])
        );
        assert_eq!(pointers(&of("null").stops), [""]);
    }
}
