//! `.mhskel`: joints, planes and bones of a skeleton
//! (`docs/loaders/makehuman2/skeletons.md#keys-of-a-skeleton`).
//!
//! Keeps what the loader would see and, beside it, which values have a shape that the schema
//! rejects: what hangs on those must not be checked again.

use std::collections::BTreeMap;

use super::macro_json::{text, texts};
use super::python_int;
use mhlint_json::{Document, Node, Value};

/// The file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Skeleton {
    /// Whether the file is an object at all.
    pub is_object: bool,
    /// Name, also its identity in the asset library.
    pub name: Option<String>,
    /// Whether `joints` is there.
    pub joints_section: Section,
    /// Whether `bones` is there.
    pub bones_section: Section,
    /// Whether `planes` is there.
    pub planes_section: Section,
    /// Joints in file order.
    pub joints: Vec<Joint>,
    /// Planes in file order.
    pub planes: Vec<Plane>,
    /// Bones in file order.
    pub bones: Vec<Bone>,
    /// `weights_file` as written.
    pub weights_file: Option<String>,
    /// `weights_file` is something else than a text.
    pub weights_file_misshapen: bool,
    /// Texts of which Python makes no whole number, where MakeHuman 1 wants one.
    pub texts_for_numbers: Vec<(&'static str, String)>,
}

/// A part of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Section {
    /// No such key.
    #[default]
    Absent,
    /// Something else than an object, which the schema rejects.
    Misshapen,
    /// An object.
    Present,
}

/// A joint.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Vertices whose mean it is; `None` if it is no list of integers.
    pub vertices: Option<Vec<i64>>,
    /// Number of its entries, whatever they are; 0 if it is no list. The loader drops joints
    /// without.
    pub listed: usize,
    /// Positions of whole numbers written with a point or exponent, which the schema accepts and
    /// `NumPy` does not take for an index.
    pub floats: Vec<usize>,
}

/// A plane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plane {
    /// Its name.
    pub name: String,
    /// Names of its joints, `None` in place of `null` and other types; `None` as a whole if it is
    /// no list.
    pub joints: Option<Vec<Option<String>>>,
    /// Whether it is `[null, null, null]`.
    pub is_null: bool,
}

/// A bone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bone {
    /// Its name.
    pub name: String,
    /// Joint at its beginning.
    pub head: Option<String>,
    /// Joint at its end.
    pub tail: Option<String>,
    /// Which of `head` and `tail` it does not have.
    pub missing: Vec<&'static str>,
    /// Parent bone; `None` for a root.
    pub parent: Option<String>,
    /// `parent` is neither text nor `null`, or the bone is no object: no one knows what is above
    /// it.
    pub parent_misshapen: bool,
    /// Plane that gives its roll.
    pub rotation_plane: RotationPlane,
    /// Bones of the default skeleton whose weights and pose it takes; a text letter by letter.
    pub reference: Option<Vec<String>>,
    /// The same for weights alone.
    pub weights_reference: Option<Vec<String>>,
    /// Which of the two is a text instead of a list.
    pub text_references: Vec<(&'static str, String)>,
}

/// `rotation_plane` of a bone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RotationPlane {
    /// The key is missing: the normal is (0, 1, 0).
    Absent,
    /// The name of a plane.
    Named(String),
    /// Something that is no text, which the schema rejects.
    Malformed,
}

impl Skeleton {
    /// The bones that MakeHuman 1 has, in its order, by name.
    pub fn names_in_order(&self) -> Vec<String> {
        let places = self.breadth_first().into_iter().map(|(place, _)| place);
        places
            .filter_map(|place| Some(self.bones.get(place)?.name.clone()))
            .collect()
    }

    /// Places of bones in the order of MakeHuman 1, each with the number of its parent: all roots,
    /// then breadth first. Bones below an unknown parent or in a circle do not exist for it
    /// (`docs/loaders/makehuman1/skeletons.md#order-and-orientation`).
    pub fn breadth_first(&self) -> Vec<(usize, Option<usize>)> {
        let places: BTreeMap<&str, usize> = self
            .bones
            .iter()
            .enumerate()
            .rev()
            .map(|(place, bone)| (bone.name.as_str(), place))
            .collect();
        let mut children: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let mut found: Vec<(usize, Option<usize>)> = Vec::new();
        for (place, bone) in self.bones.iter().enumerate() {
            match bone.parent.as_deref().filter(|parent| !parent.is_empty()) {
                // What is no name is an unknown one.
                None if bone.parent_misshapen => {}
                None => found.push((place, None)),
                Some(parent) => {
                    if let Some(parent) = places.get(parent) {
                        children.entry(*parent).or_default().push(place);
                    }
                }
            }
        }
        let mut next = 0;
        while let Some((place, _)) = found.get(next).copied() {
            found.extend(
                children
                    .remove(&place)
                    .into_iter()
                    .flatten()
                    .map(|child| (child, Some(next))),
            );
            next += 1;
        }
        found
    }
}

impl Bone {
    /// The bones of the base skeleton whose weights MakeHuman 1 gives it by name, and whether they
    /// stand in `weights_reference`. A text is one name.
    pub fn weight_references(&self) -> (Vec<&str>, bool) {
        let explicit = self.references_of("weights_reference", self.weights_reference.as_ref());
        if explicit.is_empty() {
            (self.references(), false)
        } else {
            (explicit, true)
        }
    }

    /// The names in `reference`. A text is one name.
    pub fn references(&self) -> Vec<&str> {
        self.references_of("reference", self.reference.as_ref())
    }

    fn references_of<'b>(&'b self, key: &str, list: Option<&'b Vec<String>>) -> Vec<&'b str> {
        match self.text_references.iter().find(|(own, _)| *own == key) {
            Some((_, text)) => vec![text.as_str()],
            None => list.into_iter().flatten().map(String::as_str).collect(),
        }
    }
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> Skeleton {
    let root = &document.root;
    Skeleton {
        is_object: root.is_object(),
        name: text(root, "name"),
        joints_section: section(root, "joints"),
        bones_section: section(root, "bones"),
        planes_section: section(root, "planes"),
        joints: members(root, "joints", joint),
        planes: members(root, "planes", plane),
        bones: members(root, "bones", bone),
        weights_file: text(root, "weights_file"),
        weights_file_misshapen: root
            .get("weights_file")
            .is_some_and(|node| node.as_str().is_none()),
        texts_for_numbers: ["version", "plane_map_strategy"]
            .into_iter()
            .filter_map(|key| no_number(root, key))
            .collect(),
    }
}

fn no_number(root: &Node, key: &'static str) -> Option<(&'static str, String)> {
    let text = text(root, key)?;
    python_int(text.trim().as_bytes())
        .is_none()
        .then_some((key, text))
}

fn section(root: &Node, key: &str) -> Section {
    match root.get(key) {
        None => Section::Absent,
        Some(node) if node.is_object() => Section::Present,
        Some(_) => Section::Misshapen,
    }
}

fn members<T>(root: &Node, key: &str, read: impl Fn(String, &Node) -> T) -> Vec<T> {
    let members = root
        .get(key)
        .map(Node::effective_members)
        .unwrap_or_default();
    let members = members.into_iter();
    members
        .map(|member| read(member.key.clone(), &member.node))
        .collect()
}

fn joint(name: String, node: &Node) -> Joint {
    let elements = node.elements();
    let integers: Vec<i64> = elements.iter().filter_map(Node::as_i64).collect();
    let is_float =
        |node: &Node| matches!(node.value, Value::Number(number, false) if number.fract() == 0.0);
    Joint {
        name,
        vertices: (node.is_array() && integers.len() == elements.len()).then_some(integers),
        listed: elements.len(),
        floats: elements
            .iter()
            .enumerate()
            .filter(|(_, node)| is_float(node))
            .map(|(at, _)| at)
            .collect(),
    }
}

fn plane(name: String, node: &Node) -> Plane {
    let elements = node.elements();
    let is_null = elements.len() == 3 && elements.iter().all(|joint| joint.value == Value::Null);
    Plane {
        name,
        joints: plane_joints(node),
        is_null,
    }
}

fn plane_joints(node: &Node) -> Option<Vec<Option<String>>> {
    let elements = node.is_array().then(|| node.elements())?;
    Some(
        elements
            .iter()
            .map(|joint| joint.as_str().map(str::to_owned))
            .collect(),
    )
}

fn bone(name: String, node: &Node) -> Bone {
    let parent = node.get("parent").map(|parent| &parent.value);
    let absent = |key: &&'static str| node.is_object() && node.get(key).is_none();
    let as_text = |key: &'static str| Some((key, text(node, key)?));
    Bone {
        name,
        head: text(node, "head"),
        tail: text(node, "tail"),
        missing: ["head", "tail"].into_iter().filter(absent).collect(),
        parent: text(node, "parent"),
        parent_misshapen: !node.is_object()
            || !matches!(parent, None | Some(Value::Null | Value::String(_))),
        rotation_plane: match node.get("rotation_plane").map(|plane| &plane.value) {
            None => RotationPlane::Absent,
            Some(Value::String(plane)) => RotationPlane::Named(plane.clone()),
            Some(_) => RotationPlane::Malformed,
        },
        reference: node.get("reference").and_then(names),
        weights_reference: node.get("weights_reference").and_then(names),
        text_references: ["reference", "weights_reference"]
            .into_iter()
            .filter_map(as_text)
            .collect(),
    }
}

/// The loader iterates over whatever is there: a text gives its letters.
fn names(node: &Node) -> Option<Vec<String>> {
    match node.as_str() {
        Some(text) => Some(text.chars().map(String::from).collect()),
        None => texts(node),
    }
}

impl Bone {
    /// Whether it has no parent.
    pub fn is_root(&self) -> bool {
        self.parent.is_none() && !self.parent_misshapen
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    fn skeleton(text: &str) -> Skeleton {
        read(&parse(text.as_bytes()).unwrap())
    }

    #[test]
    fn shapes_that_the_schema_refuses_are_kept_apart() {
        let file = skeleton(
            r#"{"weights_file": null, "joints": [], "bones": {"a": 5, "b": {"head": 1, "parent": 2},
            "c": {"tail": "t", "parent": null, "rotation_plane": null}}}"#,
        );
        assert_eq!(
            (file.joints_section, file.bones_section),
            (Section::Misshapen, Section::Present)
        );
        assert!(file.weights_file_misshapen);
        assert_eq!(
            file.bones.iter().map(Bone::is_root).collect::<Vec<_>>(),
            [false, false, true]
        );
        let missing: Vec<_> = file
            .bones
            .iter()
            .map(|bone| bone.missing.as_slice())
            .collect();
        assert_eq!(missing, [&[] as &[&str], &["tail"], &["head"]]);
        assert_eq!(file.bones[2].rotation_plane, RotationPlane::Malformed);
    }

    #[test]
    fn whole_numbers_with_a_point_are_no_indices() {
        let file = skeleton(r#"{"joints": {"a": [1, 2.0, 3e0], "b": [], "c": "x", "d": [1.5]}}"#);
        let joints: Vec<_> = file
            .joints
            .iter()
            .map(|j| (j.listed, j.floats.len(), j.vertices.is_some()))
            .collect();
        assert_eq!(
            joints,
            [(3, 2, false), (0, 0, true), (0, 0, false), (1, 0, false)]
        );
    }

    #[test]
    fn a_reference_that_is_a_text_is_read_letter_by_letter() {
        let file = skeleton(r#"{"bones": {"a": {"reference": "ab", "weights_reference": ["c"]}}}"#);
        let [bone] = file.bones.as_slice() else {
            panic!("one bone")
        };
        assert_eq!(
            bone.reference.as_deref(),
            Some(["a".to_owned(), "b".to_owned()].as_slice())
        );
        assert_eq!(bone.text_references, [("reference", "ab".to_owned())]);
    }

    proptest! {
        #[test]
        fn any_json_gives_a_skeleton(
            words in proptest::collection::vec(
                r#"\{|\}|\[|\]|,|:|"(bones|joints|planes|head|parent)"|-?[0-9]{1,3}(\.[0-9]|e[0-9]{1,3})?|null"#, 0..30),
        ) {
            if let Ok(document) = parse(words.concat().as_bytes()) {
                let file = read(&document);
                prop_assert!(file.is_object || file == Skeleton::default());
            }
        }

        #[test]
        fn a_truncated_skeleton_is_no_json(cut in 0usize..90) {
            let text = br#"{"joints": {"j": [1, 2]}, "bones": {"b": {"head": "j", "tail": "j", "parent": null}}}"#;
            prop_assert!(parse(&text[..cut.min(text.len() - 1)]).is_err());
        }
    }

    #[test]
    fn several_roots_and_no_bones_below_unknown_ones() {
        let text = |bones: &str| format!(r#"{{"bones": {{{bones}}}}}"#);
        let of = |bones: &str| read(&parse(text(bones).as_bytes()).unwrap()).breadth_first();
        let found = of(
            r#""c": {"parent": "r"}, "r": {"parent": ""}, "lost": {"parent": "x"}, "d": {"parent": "c"},
               "s": {}, "own": {"parent": "own"}, "below": {"parent": "lost"}"#,
        );
        assert_eq!(found, [(1, None), (4, None), (0, Some(0)), (3, Some(2))]);
    }
}
