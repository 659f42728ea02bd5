//! Stored poses of MPFB, `poses/<rig>_<fk|ik|partial>/<name>.json`
//! (`docs/loaders/mpfb/poses.md#stored-poses`).

use std::collections::BTreeMap;

use super::unfit::{NamedAt, Unfits, Why, below, is_number, keep, nth};
use mhlint_json::{Document, Node, Value};

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StoredPose {
    /// What stops the loader.
    pub stops: Unfits,
    /// Whether the pose is for a default rig, whose spine and shoulders are measured when it is
    /// loaded.
    pub is_default: bool,
    /// Whether it has a key that only poses have: any other JSON may lie in `poses`, too.
    pub is_pose: bool,
    /// Rotations and translations with NaN or infinity.
    pub non_finite: Vec<NamedAt>,
    /// Quaternions of which all numbers are 0.
    pub zero: Vec<NamedAt>,
    /// Bones that are turned or moved.
    pub bones: Vec<NamedAt>,
}

const ROTATIONS: &str = "bone_rotations";
const MODES: &str = "bone_rotation_modes";
const TRANSLATIONS: &str = "bone_translations";
/// Read only for default rigs.
const LENGTHS: [&str; 2] = ["original_spine_length", "original_shoulder_width"];

/// How a bone turns.
const ROTATION_MODES: &[&str] = &[
    "QUATERNION",
    "AXIS_ANGLE",
    "XYZ",
    "XZY",
    "YXZ",
    "YZX",
    "ZXY",
    "ZYX",
];

/// Takes what the loader would take.
pub fn read(document: &Document) -> StoredPose {
    let root = &document.root;
    let mut pose = StoredPose::default();
    if !root.is_object() {
        pose.stops.add_type("", root, "an object");
        return pose;
    }
    pose.is_pose = ["skeleton_type", ROTATIONS, TRANSLATIONS]
        .iter()
        .any(|key| root.get(key).is_some());
    for key in ["skeleton_type", ROTATIONS, TRANSLATIONS]
        .into_iter()
        .filter(|key| root.get(key).is_none())
    {
        pose.stops.add("", Why::Lacks(key));
    }
    match root.get("skeleton_type") {
        Some(Node {
            value: Value::String(text),
            ..
        }) => pose.is_default = text.contains("default"),
        Some(other) => pose.stops.add_type("/skeleton_type", other, "a string"),
        None => {}
    }
    if let Some(modes) = root
        .get(MODES)
        .filter(|node| !node.is_object() && !is_empty_list(node))
    {
        pose.stops
            .add_type("/bone_rotation_modes", modes, "an object");
    }
    for key in LENGTHS.into_iter().filter(|_| pose.is_default) {
        if let Some(length) = root.get(key).filter(|node| !is_number(node)) {
            pose.stops.add_type(&below("", key), length, "a number");
        }
    }
    let modes = root
        .get(MODES)
        .map(Node::effective_members)
        .unwrap_or_default();
    let modes: BTreeMap<&str, &Node> = modes
        .into_iter()
        .map(|member| (member.key.as_str(), &member.node))
        .collect();
    pose.each(root, ROTATIONS, |pose, pointer, bone, node| {
        let mode = modes.get(bone).copied().filter(|mode| !mode.is_falsy());
        pose.rotation(pointer, bone, node, mode);
    });
    pose.each(root, TRANSLATIONS, |pose, pointer, bone, node| {
        // Numbers behind the third are not read.
        pose.numbers(
            pointer,
            bone,
            node,
            |length| if length < 3 { Some(3) } else { None },
        );
    });
    pose
}

fn is_empty_list(node: &Node) -> bool {
    node.is_array() && node.elements().is_empty()
}

impl StoredPose {
    fn each(&mut self, root: &Node, key: &str, take: impl Fn(&mut Self, &str, &str, &Node)) {
        let Some(bones) = root.get(key) else { return };
        let pointer = below("", key);
        if !bones.is_object() && !is_empty_list(bones) {
            self.stops.add_type(&pointer, bones, "an object");
        }
        for member in bones.effective_members() {
            let pointer = below(&pointer, &member.key);
            keep(&mut self.bones, &pointer, &member.key);
            take(self, &pointer, &member.key, &member.node);
        }
    }

    /// Without a mode four numbers are a quaternion, and three are angles.
    fn rotation(&mut self, pointer: &str, bone: &str, node: &Node, mode: Option<&Node>) {
        let mode_at = below(&below("", MODES), bone);
        if let Some(other) = mode.filter(|mode| mode.as_str().is_none()) {
            self.stops.add_type(&mode_at, other, "a mode of rotation");
            return;
        }
        if let Some(mode) = mode {
            self.stops.check_word(&mode_at, mode, ROTATION_MODES);
        }
        let wanted = match mode.and_then(Node::as_str) {
            Some("QUATERNION" | "AXIS_ANGLE") => Some(4),
            Some(_) => Some(3),
            None => None,
        };
        self.numbers(pointer, bone, node, |length| match (wanted, length) {
            (Some(wanted), length) => Some(wanted).filter(|wanted| *wanted != length),
            (None, 3 | 4) => None,
            (None, _) => Some(3),
        });
        let is_quaternion = matches!(mode.map(Node::as_str), None | Some(Some("QUATERNION")));
        let is_zero = |node: &Node| node.as_python_number() == Some(0.0);
        if is_quaternion && node.elements().len() == 4 && node.elements().iter().all(is_zero) {
            keep(&mut self.zero, pointer, bone);
        }
    }

    /// Checks a list of numbers; `wanted` says of a length that does not fit which one would.
    fn numbers(
        &mut self,
        pointer: &str,
        bone: &str,
        node: &Node,
        wanted: impl Fn(usize) -> Option<usize>,
    ) {
        if !node.is_array() {
            return self.stops.add_type(pointer, node, "a list of numbers");
        }
        let elements = node.elements();
        if let Some(wanted) = wanted(elements.len()) {
            return self.stops.add(pointer, Why::Length(elements.len(), wanted));
        }
        match elements.iter().enumerate().find(|(_, one)| !is_number(one)) {
            Some((at, odd)) => self.stops.add_type(&nth(pointer, at), odd, "a number"),
            None if elements
                .iter()
                .all(|one| one.as_python_number().is_some_and(f64::is_finite)) => {}
            None => keep(&mut self.non_finite, pointer, bone),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::parse;

    fn of(text: &str) -> StoredPose {
        read(&parse(text.as_bytes()).unwrap())
    }

    fn stops(keys: &str) -> Vec<String> {
        let text = format!(
            r#"{{"skeleton_type": "default", "bone_rotations": {{}}, "bone_translations": {{}}, {keys}}}"#
        );
        of(&text)
            .stops
            .all()
            .iter()
            .map(|one| one.pointer.clone())
            .collect()
    }

    #[test]
    fn three_keys_must_be_there() {
        assert_eq!(of("{}").stops.all().len(), 3);
        assert!(!of("{}").is_pose);
        assert_eq!(of("[]").stops.all().len(), 1);
        assert!(stops(r#""x": 1"#).is_empty());
        assert_eq!(stops(r#""skeleton_type": null"#), ["/skeleton_type"]);
        assert_eq!(
            stops(r#""bone_rotations": [], "bone_translations": 5"#),
            ["/bone_translations"]
        );
    }

    #[test]
    fn numbers_fit_the_mode_of_the_bone() {
        let turned = |list: &str, mode: &str| {
            stops(&format!(
                r#""bone_rotations": {{"a": {list}}}, "bone_rotation_modes": {{"a": {mode}}}"#
            ))
            .len()
        };
        for (list, mode, count) in [
            ("[1, 2, 3]", "null", 0),
            ("[1, 2, 3, 4]", "null", 0),
            ("[1, 2]", "null", 1),
            ("[1, 2, 3, 4, 5]", "null", 1),
            ("[1, 2, 3]", "\"ZYX\"", 0),
            ("[1, 2, 3, 4]", "\"ZYX\"", 1),
            ("[1, 2, 3]", "\"QUATERNION\"", 1),
            ("[1, 2, 3, 4]", "\"AXIS_ANGLE\"", 0),
            ("[1, 2, 3]", "\"ZYX1\"", 1),
            ("[1, 2, \"3\"]", "null", 1),
            ("[1, true, NaN]", "null", 0),
            ("\"abc\"", "null", 1),
            ("[1, 2, 3]", "5", 1),
        ] {
            assert_eq!(turned(list, mode), count, "{list} {mode}");
        }
        assert_eq!(
            stops(r#""bone_rotation_modes": null"#),
            ["/bone_rotation_modes"]
        );
    }

    #[test]
    fn translations_have_three_numbers_or_more() {
        let moved = |list: &str| stops(&format!(r#""bone_translations": {{"a": {list}}}"#)).len();
        assert_eq!(
            [
                moved("[1, 2, 3]"),
                moved("[1, 2, 3, 4]"),
                moved("[1, 2]"),
                moved("5")
            ],
            [0, 0, 1, 1]
        );
    }

    #[test]
    fn lengths_are_read_for_default_rigs() {
        assert_eq!(
            stops(r#""original_spine_length": "0.5""#),
            ["/original_spine_length"]
        );
        assert!(stops(r#""skeleton_type": "mixamo", "original_spine_length": "0.5""#).is_empty());
    }

    #[test]
    fn numbers_that_mean_no_rotation_are_kept() {
        let pose = of(
            r#"{"skeleton_type": "x", "bone_rotations": {"a": [0, 0, 0, 0], "b": [NaN, 0, 0], "c": [0, 0, 0]},
            "bone_translations": {"a": [0, 0, Infinity]}}"#,
        );
        assert_eq!(
            pose.zero.iter().map(|one| &*one.name).collect::<Vec<_>>(),
            ["a"]
        );
        assert_eq!(
            pose.non_finite
                .iter()
                .map(|one| &*one.name)
                .collect::<Vec<_>>(),
            ["b", "a"]
        );
        assert_eq!(pose.bones.len(), 4);
    }
}
