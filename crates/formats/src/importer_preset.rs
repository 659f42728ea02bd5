//! Presets of MPFB that are kept beside saved characters: for its importer, and for makeup
//! (`docs/loaders/mpfb/models.md#presets-of-the-importer`,
//! `docs/loaders/mpfb/models.md#makeup-presets`).

use super::unfit::{LoaderFaults, NamedAt, Unfits, Why, below, keep, nth};
use mhlint_json::{Document, Node, Value};

/// `makeup.<name>.json`: ink layers, one over the other.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Makeup {
    /// What stops the loader.
    pub stops: Unfits,
    /// Files of ink layers.
    pub layers: Vec<NamedAt>,
}

/// All keys of a preset for the importer: those that are true or false, then the others.
const KEYS: &[&str] = &[
    "import_body",
    "import_body_proxy",
    "import_body_parts",
    "import_clothes",
    "import_rig",
    "rig_as_parent",
    "feet_on_ground",
    "create_collection",
    "collections_as_children",
    "prefix_object_names",
    "mask_base_mesh",
    "add_subdiv_modifier",
    "detailed_helpers",
    "extra_vertex_groups",
    "material_named_from_object",
    "prefix_material_names",
    "material_instances",
    "procedural_eyes",
    "fix_bad_roughness",
    "name",
    "subdiv_levels",
    "scale_factor",
    "handle_helpers",
    "skin_material_type",
    "material_creation_policy",
];
/// How many of these are true or false.
const SWITCHES: usize = 19;

/// Keys with a few words to choose from.
const CHOICES: [(&str, &[&str]); 4] = [
    ("scale_factor", &["METER", "DECIMETER", "CENTIMETER"]),
    ("handle_helpers", &["MASK", "NOTHING", "DELETE"]),
    ("skin_material_type", &["ENHANCED", "SSS", "PLAIN"]),
    (
        "material_creation_policy",
        &["REUSE", "NEWNAME", "OVERWRITE"],
    ),
];

/// Takes what the loader would take. Of a list it takes nothing, and unknown keys it passes over.
pub fn importer(document: &Document) -> LoaderFaults {
    let root = &document.root;
    let mut faults = LoaderFaults::default();
    if root.is_array() {
        faults.ignored.add_type("", root, "an object");
    }
    for member in root.effective_members() {
        let (key, node, pointer) = (&*member.key, &member.node, below("", &member.key));
        if let Some((_, words)) = CHOICES.iter().find(|(choice, _)| *choice == key) {
            match node.as_str() {
                Some(_) => faults.stops.check_word(&pointer, node, words),
                None => faults.stops.add_type(&pointer, node, "a string"),
            }
        } else if KEYS.iter().take(SWITCHES).any(|known| *known == key) {
            if !matches!(node.value, Value::Bool(_) | Value::Number(..)) {
                faults.stops.add_type(&pointer, node, "true or false");
            }
        } else if !KEYS.contains(&key) {
            faults.ignored.add(&pointer, Why::Key(KEYS));
        } else if key == "subdiv_levels"
            && !matches!(node.value, Value::Bool(_) | Value::Number(_, true))
        {
            faults.stops.add_type(&pointer, node, "a whole number");
        }
    }
    faults
}

/// Takes what the loader would take.
pub fn makeup(document: &Document) -> Makeup {
    let root = &document.root;
    let mut makeup = Makeup::default();
    let is_empty = root.is_falsy() && matches!(root.value, Value::String(_) | Value::Object(_));
    if !root.is_array() && !is_empty {
        makeup.stops.add_type("", root, "a list");
    }
    for (at, entry) in root.elements().iter().enumerate() {
        match Node::as_str(entry) {
            Some(name) => keep(&mut makeup.layers, &nth("", at), name),
            None => makeup.stops.add_type(&nth("", at), entry, "a string"),
        }
    }
    makeup
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::parse;

    fn pointers(faults: &Unfits) -> Vec<&str> {
        faults.all().iter().map(|one| &*one.pointer).collect()
    }

    #[test]
    fn an_importer_preset_takes_its_own_types() {
        let of = |text: &str| importer(&parse(text.as_bytes()).unwrap());
        let good = r#"{"import_body": true, "import_rig": 0, "subdiv_levels": 9, "scale_factor": "METER"}"#;
        assert_eq!(of(good), LoaderFaults::default());
        assert_eq!(
            pointers(&of(r#"{"import_clohtes": false}"#).ignored),
            ["/import_clohtes"]
        );
        let bad = of(
            r#"{"import_body": "yes", "subdiv_levels": 1.5, "handle_helpers": "HIDE", "scale_factor": 1}"#,
        );
        assert_eq!(
            pointers(&bad.stops),
            [
                "/import_body",
                "/subdiv_levels",
                "/handle_helpers",
                "/scale_factor"
            ]
        );
        assert_eq!(pointers(&of("[]").ignored), [""]);
    }

    #[test]
    fn makeup_is_a_list_of_names() {
        let of = |text: &str| makeup(&parse(text.as_bytes()).unwrap());
        let found = of(r#"["lips.json", 5]"#);
        assert_eq!(
            (found.layers.len(), pointers(&found.stops)),
            (1, vec!["/1"])
        );
        assert_eq!(pointers(&of(r#""lips.json""#).stops), [""]);
        assert_eq!(of("[]"), Makeup::default());
    }
}
