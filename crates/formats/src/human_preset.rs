//! Saved characters of MPFB, `human.<name>.json` (`docs/loaders/mpfb/models.md#saved-characters`).

use std::collections::BTreeSet;

use super::macro_parts::{RACES, SETTINGS};
use super::python_float;
use super::unfit::{NamedAt, Unfits, Why, below, is_number, keep, nth};
use mhlint_json::{Document, Node, Value};

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct HumanPreset {
    /// What stops the loading.
    pub stops: Unfits,
    /// What is passed over, or taken otherwise than it is meant.
    pub ignored: Unfits,
    /// Keys that nothing reads.
    pub unread: Unfits,
    /// The targets, by name.
    pub targets: Vec<NamedAt>,
    /// The skeleton, if there is to be one.
    pub rig: Option<NamedAt>,
    /// What is worn: files of assets.
    pub worn: Vec<NamedAt>,
    /// The material of the skin, if it has one.
    pub skin: Option<NamedAt>,
    /// Files of expressions.
    pub expressions: Vec<NamedAt>,
    /// Files of ink layers.
    pub makeup: Vec<NamedAt>,
}

/// All keys of the file.
const KEYS: &[&str] = &[
    "name",
    "phenotype",
    "targets",
    "rig",
    "eyes",
    "eyebrows",
    "eyelashes",
    "tongue",
    "teeth",
    "hair",
    "proxy",
    "clothes",
    "expressions",
    "makeup",
    "skin_mhmat",
    "skin_material_type",
    "skin_material_settings",
    "eyes_material_type",
    "eyes_material_settings",
    "color_adjustments",
    "alternative_materials",
    "clothes_material_type",
];
/// All keys of `phenotype`.
const PHENOTYPE: &[&str] = &[
    "gender",
    "age",
    "muscle",
    "weight",
    "proportions",
    "height",
    "cupsize",
    "firmness",
    "race",
];
/// What the body has one of each.
const BODY_PARTS: [&str; 7] = [
    "eyes",
    "eyebrows",
    "eyelashes",
    "tongue",
    "teeth",
    "hair",
    "proxy",
];
/// The kinds of materials that a skin can be made.
const SKIN_KINDS: &[&str] = &[
    "NONE",
    "MAKESKIN",
    "ENHANCED",
    "ENHANCED_SSS",
    "LAYERED",
    "GAMEENGINE",
];

/// Whether Python makes a number of a text.
fn is_python_number(node: &Node) -> bool {
    node.as_str()
        .is_some_and(|text| python_float(text.as_bytes()).is_some())
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> HumanPreset {
    let root = &document.root;
    let mut preset = HumanPreset::default();
    if !root.is_object() {
        preset.stops.add_type("", root, "an object");
        return preset;
    }
    match root.get("phenotype") {
        Some(phenotype) => preset.take_phenotype(phenotype),
        None => preset.stops.add("", Why::Lacks("phenotype")),
    }
    if let Some(targets) = root.get("targets") {
        preset.take_targets(targets);
    }
    preset.take_rig(root);
    BODY_PARTS
        .iter()
        .for_each(|key| preset.take_part(root, key));
    if let Some(expressions) = root.get("expressions") {
        preset.take_expressions(expressions);
    }
    if let Some(clothes) = root.get("clothes") {
        preset.take_clothes(clothes);
    }
    preset.take_skin(root);
    let makeup = root
        .get("makeup")
        .map(Node::elements)
        .unwrap_or_default()
        .iter()
        .enumerate();
    for (at, name) in makeup.filter_map(|(at, node)| Some((at, node.as_str()?))) {
        keep(&mut preset.makeup, &nth("/makeup", at), name);
    }
    let unknown = root
        .effective_members()
        .into_iter()
        .filter(|member| !KEYS.contains(&&*member.key));
    unknown.for_each(|member| preset.unread.add(&below("", &member.key), Why::Key(KEYS)));
    preset
}

impl HumanPreset {
    fn take_phenotype(&mut self, phenotype: &Node) {
        // What Python takes for nothing stands for the defaults.
        if phenotype.is_falsy() {
            return;
        }
        if !phenotype.is_object() {
            return self.stops.add_type("/phenotype", phenotype, "an object");
        }
        for member in phenotype.effective_members() {
            let pointer = below("/phenotype", &member.key);
            if SETTINGS.contains(&&*member.key) {
                self.take_setting(&pointer, &member.node);
            } else if member.key != "race" {
                self.stops.add(&pointer, Why::Key(PHENOTYPE));
            }
        }
        match phenotype.get("race") {
            Some(race) if race.is_object() => self.take_race(race),
            Some(race) => self.stops.add_type("/phenotype/race", race, "an object"),
            None => self.stops.add("/phenotype", Why::Lacks("race")),
        }
    }

    fn take_race(&mut self, race: &Node) {
        for member in race.effective_members() {
            let pointer = below("/phenotype/race", &member.key);
            if RACES.contains(&&*member.key) {
                self.take_setting(&pointer, &member.node);
            } else {
                self.stops.add(&pointer, Why::Key(&RACES));
            }
        }
    }

    /// No value is limited: outside of 0 to 1 the shape of the macro vanishes.
    fn take_setting(&mut self, pointer: &str, node: &Node) {
        match node.as_python_number() {
            Some(value) if is_number(node) && !(0.0..=1.0).contains(&value) => {
                self.ignored.add(pointer, Why::Range(value));
            }
            _ if !is_number(node) => self.stops.add_type(pointer, node, "a number"),
            _ => {}
        }
    }

    fn take_targets(&mut self, targets: &Node) {
        let is_empty =
            matches!(&targets.value, Value::String(_) | Value::Object(_)) && targets.is_falsy();
        if !targets.is_array() && !is_empty {
            return self.stops.add_type("/targets", targets, "a list");
        }
        let mut known = BTreeSet::new();
        for (at, entry) in targets.elements().iter().enumerate() {
            let pointer = nth("/targets", at);
            if !entry.is_object() {
                self.stops.add_type(&pointer, entry, "an object");
                continue;
            }
            for key in ["target", "value"]
                .into_iter()
                .filter(|key| entry.get(key).is_none())
            {
                self.stops.add(&pointer, Why::Lacks(key));
            }
            if let Some(value) = entry.get("value") {
                self.take_value(&below(&pointer, "value"), value);
            }
            if let Some(name) = entry.get("target").and_then(Node::as_str) {
                let pointer = below(&pointer, "target");
                if !known.insert(name.to_lowercase()) {
                    self.ignored.add(&pointer, Why::Twice(name.to_owned()));
                }
                keep(&mut self.targets, &pointer, name);
            }
        }
    }

    fn take_value(&mut self, pointer: &str, node: &Node) {
        match node.as_python_number() {
            None => self.stops.add_type(pointer, node, "a number"),
            Some(value) if !value.is_nan() && !(0.0..=1.0).contains(&value) => {
                self.ignored.add(pointer, Why::Range(value));
            }
            Some(_) => {}
        }
    }

    fn take_rig(&mut self, root: &Node) {
        let Some(rig) = root.get("rig").filter(|rig| !rig.is_falsy()) else {
            return;
        };
        match rig.as_str() {
            Some(name) => self.rig = Some(NamedAt::new("/rig", name)),
            None => self.stops.add_type("/rig", rig, "a string"),
        }
    }

    /// A file, or what stands for none.
    fn take_part(&mut self, root: &Node, key: &str) {
        let Some(part) = root.get(key) else { return };
        let pointer = below("", key);
        match &part.value {
            Value::String(name) if !name.is_empty() => keep(&mut self.worn, &pointer, name),
            Value::String(_) | Value::Null => {}
            _ if part.is_falsy() => {}
            _ => self.stops.add_type(&pointer, part, "a string"),
        }
    }

    fn take_clothes(&mut self, clothes: &Node) {
        match &clothes.value {
            // It is read letter by letter, and no letter is a file.
            Value::String(text) if !text.is_empty() => {
                self.ignored.add_type("/clothes", clothes, "a list");
            }
            Value::Null | Value::Number(..) | Value::Bool(_) => {
                self.stops.add_type("/clothes", clothes, "a list");
            }
            _ => {}
        }
        for (at, entry) in clothes.elements().iter().enumerate() {
            match &entry.value {
                Value::String(name) if !name.is_empty() => {
                    keep(&mut self.worn, &nth("/clothes", at), name);
                }
                Value::Number(..) => self.stops.add_type(&nth("/clothes", at), entry, "a string"),
                _ => {}
            }
        }
    }

    /// An array of which each row has a file and a number; anything else counts for nothing.
    fn take_expressions(&mut self, expressions: &Node) {
        if !expressions.is_array() && !expressions.is_falsy() {
            self.ignored.add_type("/expressions", expressions, "a list");
        }
        for (at, row) in expressions.elements().iter().enumerate() {
            let pointer = nth("/expressions", at);
            if !row.is_object() {
                self.ignored.add_type(&pointer, row, "an object");
                continue;
            }
            match row.get("asset").map(|asset| &asset.value) {
                None => self.ignored.add(&pointer, Why::Lacks("asset")),
                Some(Value::String(name)) if !name.is_empty() => {
                    keep(&mut self.expressions, &below(&pointer, "asset"), name);
                }
                Some(_) => {}
            }
            match row.get("weight") {
                Some(Node {
                    value: Value::Number(weight, _),
                    ..
                }) if !(0.0..=1.0).contains(weight) => {
                    self.ignored
                        .add(&below(&pointer, "weight"), Why::Range(*weight));
                }
                // A text may be a number to Python.
                Some(weight) if !is_number(weight) && !is_python_number(weight) => {
                    self.ignored
                        .add_type(&below(&pointer, "weight"), weight, "a number");
                }
                _ => {}
            }
        }
    }

    fn take_skin(&mut self, root: &Node) {
        let keys = ["skin_mhmat", "skin_material_type"];
        keys.into_iter()
            .filter(|key| root.get(key).is_none())
            .for_each(|key| self.stops.add("", Why::Lacks(key)));
        let Some(skin) = root
            .get("skin_mhmat")
            .and_then(Node::as_str)
            .filter(|skin| !skin.is_empty())
        else {
            return;
        };
        self.skin = Some(NamedAt::new("/skin_mhmat", skin));
        if let Some(kind) = root.get("skin_material_type") {
            self.ignored
                .check_word("/skin_material_type", kind, SKIN_KINDS);
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    const SKIN: &str = r#""skin_mhmat": "a/b.mhmat", "skin_material_type": "MAKESKIN""#;
    const RACE: &str = r#""race": {"asian": 0.33, "caucasian": 1, "african": true}"#;

    fn of(members: &str) -> HumanPreset {
        read(&parse(format!("{{{members}}}").as_bytes()).unwrap())
    }

    /// Pointers of what stops the loading, then of what is passed over.
    fn pointers(preset: &HumanPreset) -> [Vec<&str>; 2] {
        [&preset.stops, &preset.ignored]
            .map(|faults| faults.all().iter().map(|one| &*one.pointer).collect())
    }

    #[test]
    fn what_the_loader_takes_is_no_fault() {
        for members in [
            format!(r#""phenotype": null, {SKIN}"#),
            format!(
                r#""phenotype": {{"age": 1, {RACE}}}, {SKIN}, "targets": [{{"target": "a", "value": 1}}], "rig": null,
                "eyes": null, "hair": "", "clothes": [], "expressions": null, "name": 7, "unknown": {{}}"#
            ),
            format!(
                r#""phenotype": {{{RACE}, "height": 0}}, {SKIN}, "rig": "", "clothes": ["a/a.mhclo"]"#
            ),
        ] {
            assert_eq!(
                pointers(&of(&members)),
                [Vec::<&str>::new(), Vec::new()],
                "{members}"
            );
        }
    }

    #[test]
    fn what_stops_the_loading_is_found() {
        assert_eq!(pointers(&of(""))[0], ["", "", ""]);
        let found = of(&format!(
            r#""phenotype": {{"Age": 1, "height": "tall", "race": [1]}}, {SKIN}"#
        ));
        assert_eq!(
            pointers(&found)[0],
            ["/phenotype/Age", "/phenotype/height", "/phenotype/race"]
        );
        let found = of(&format!(
            r#""phenotype": null, {SKIN}, "rig": 5, "clothes": null, "eyes": 3,
            "targets": ["a", {{"target": "b"}}, {{"target": "c", "value": null}}]"#
        ));
        let expected = [
            "/targets/0",
            "/targets/1",
            "/targets/2/value",
            "/rig",
            "/eyes",
            "/clothes",
        ];
        assert_eq!(pointers(&found)[0], expected);
    }

    #[test]
    fn settings_are_not_limited_and_unknown_keys_not_read() {
        let found = of(&format!(
            r#""phenotype": {{"age": 50, "height": NaN, {RACE}}}, {SKIN}, "Targets": []"#
        ));
        assert_eq!(
            pointers(&found),
            [vec![], vec!["/phenotype/age", "/phenotype/height"]]
        );
        assert_eq!(found.unread.all().len(), 1);
        let found = of(&format!(
            r#""phenotype": null, {SKIN}, "eyes": ["a.mhclo"]"#
        ));
        assert_eq!(pointers(&found)[0], ["/eyes"]);
    }

    #[test]
    fn what_is_passed_over_is_found() {
        let found = of(
            r#""phenotype": null, "skin_mhmat": "a", "skin_material_type": "Makeskin", "clothes": "a/a.mhclo",
            "targets": [{"target": "A", "value": 1.5}, {"target": "a", "value": 0}],
            "expressions": [5, {"weight": 1}, {"asset": "x.json", "weight": null}, {"asset": "y.json", "weight": NaN}]"#,
        );
        let expected = [
            "/targets/0/value",
            "/targets/1/target",
            "/expressions/0",
            "/expressions/1",
            "/expressions/2/weight",
            "/expressions/3/weight",
            "/clothes",
            "/skin_material_type",
        ];
        assert_eq!(pointers(&found), [vec![], expected.to_vec()]);
    }

    proptest! {
        #[test]
        fn no_json_stops_the_reader(text in r#"[\[\]{},:"0-9a-c ]{0,40}"#) {
            let keys = ["phenotype", "targets", "rig", "eyes", "clothes", "expressions", "makeup", "skin_mhmat"];
            let members: Vec<String> = keys.iter().map(|key| format!(r#""{key}": {text}"#)).collect();
            if let Ok(document) = parse(format!("{{{}}}", members.join(",")).as_bytes()) {
                read(&document);
            }
        }
    }
}
