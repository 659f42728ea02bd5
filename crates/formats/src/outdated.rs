//! Formats of older versions of MakeHuman that no program reads any more, known by what is in a
//! file (`docs/loaders/versions.md#formats-that-are-gone`).

use super::fields::fields;
use super::python_float;
use mhlint_json::{Document, Node};
use mhlint_source::lines;

/// An old format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outdated {
    /// What is worn, with its keywords behind `#`.
    Worn(Alpha),
    /// Clothes that are put on together: lines `# clothing`.
    Costume,
    /// An expression as a model: lines `expression UNIT VALUE`.
    Expression,
    /// A pose with a quaternion for each bone.
    QuaternionPose,
    /// A pose with a matrix for each bone.
    MatrixPose,
    /// A rig in JSON that is not what a skeleton is today.
    Rig,
    /// Weights as a list of groups.
    VertexGroups,
    /// A model of lines such as `gender` and `breastSize`.
    Model,
    /// A model of lines such as `macro Gender` and `face`.
    LaterModel,
    /// A target whose header names an older base mesh.
    Target(Alpha),
}

/// The version of what is worn, and of targets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Alpha {
    /// A base mesh of 15340 vertices.
    Six,
    /// One of 18528.
    Seven,
    /// The months before alpha 8: the keywords of alpha 7 and the base mesh of today.
    BeforeEight,
    /// Another one.
    Other,
}

impl Outdated {
    /// The versions that wrote it, in words.
    pub const fn versions(self) -> &'static [&'static str] {
        match self {
            Self::Worn(alpha) | Self::Target(alpha) => alpha.words(),
            Self::Costume => &["alpha 7", "alpha 8"],
            Self::Expression => &["alpha 7", "alpha 8", "1.0"],
            Self::QuaternionPose => Alpha::BeforeEight.words(),
            Self::Model => Alpha::Other.words(),
            Self::MatrixPose | Self::Rig | Self::VertexGroups => &["alpha 8", "1.0"],
            Self::LaterModel => &["alpha 8"],
        }
    }
}

impl Alpha {
    const fn words(self) -> &'static [&'static str] {
        match self {
            Self::Six => &["alpha 6"],
            Self::Seven => &["alpha 7"],
            Self::BeforeEight => &["the months before alpha 8"],
            Self::Other => &["an alpha version"],
        }
    }

    /// The base mesh of an alpha version, by the name that headers give it, such as `alpha_7`.
    pub fn of_basemesh(name: &str) -> Option<Self> {
        let rest = name.to_ascii_lowercase().strip_prefix("alpha")?.to_owned();
        Some(match rest.trim_start_matches(['_', '-']) {
            "6" => Self::Six,
            "7" => Self::Seven,
            _ => Self::Other,
        })
    }
}

/// A pose of quaternions or matrices, one bone a line.
pub fn of_pose(text: &[u8]) -> Option<Outdated> {
    let number = |(_, word): &(usize, &[u8])| python_float(word).is_some();
    lines(text).find_map(|(_, line)| match fields(line).as_slice() {
        [_, (_, b"quat"), numbers @ ..] if numbers.len() == 4 && numbers.iter().all(number) => {
            Some(Outdated::QuaternionPose)
        }
        [_, (_, b"matrix"), numbers @ ..] if numbers.len() == 16 && numbers.iter().all(number) => {
            Some(Outdated::MatrixPose)
        }
        _ => None,
    })
}

/// A rig, or vertex groups, in JSON.
pub fn of_json(json: &Document) -> Option<Outdated> {
    let root = &json.root;
    let has = |key: &str| root.get(key).is_some();
    match () {
        () if is_groups(root) => Some(Outdated::VertexGroups),
        // Skeletons of today, and rigs of MPFB, have an object for each bone.
        () if has("merge") && root.get("bones").is_some_and(maps_texts) => Some(Outdated::Rig),
        () if has("name")
            && has("description")
            && has("settings")
            && !has("bones")
            && !has("joints") =>
        {
            Some(Outdated::Rig)
        }
        () => None,
    }
}

fn maps_texts(bones: &Node) -> bool {
    !bones.members().is_empty()
        && bones
            .members()
            .iter()
            .all(|bone| bone.node.as_str().is_some())
}

/// `[["group", [[vertex, weight], …]], …]`.
fn is_groups(root: &Node) -> bool {
    let is_pair = |pair: &Node| {
        pair.elements().len() == 2 && pair.elements().iter().all(|one| one.as_f64().is_some())
    };
    let is_group = |group: &Node| match group.elements() {
        [name, pairs] => {
            name.as_str().is_some() && pairs.is_array() && pairs.elements().iter().all(is_pair)
        }
        _ => false,
    };
    !root.elements().is_empty() && root.elements().iter().all(is_group)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    #[test]
    fn rigs_and_groups() {
        for (text, expected) in [
            (
                r#"{"name": "b", "description": "d", "settings": {"a": 1}}"#,
                Some(Outdated::Rig),
            ),
            (
                r#"{"bones": {"Root": "root"}, "merge": {}}"#,
                Some(Outdated::Rig),
            ),
            (
                r#"{"bones": {"Root": {"parent": null}}, "merge": {}}"#,
                None,
            ),
            (
                r#"{"name": "b", "description": "d", "settings": {}, "bones": {}}"#,
                None,
            ),
            (
                r#"[["Root", [[1, 0.5], [2, 1]]], ["Tip", []]]"#,
                Some(Outdated::VertexGroups),
            ),
            (r#"[["Root", [[1, "a"]]]]"#, None),
            ("[]", None),
            ("{}", None),
        ] {
            let document = parse(text.as_bytes()).unwrap();
            assert_eq!(of_json(&document), expected, "{text}");
        }
    }

    #[test]
    fn poses_and_names_of_meshes() {
        assert_eq!(
            of_pose(b"# x\nRoot\tquat\t1 0 0 0\n"),
            Some(Outdated::QuaternionPose)
        );
        assert_eq!(
            of_pose(format!("Root matrix{}", " 1".repeat(16)).as_bytes()),
            Some(Outdated::MatrixPose)
        );
        assert_eq!(of_pose(b"Root quat 1 0 0\n"), None);
        assert_eq!(Alpha::of_basemesh("alpha_7"), Some(Alpha::Seven));
        assert_eq!(Alpha::of_basemesh("hm08"), None);
    }

    proptest! {
        #[test]
        fn no_words_stop_it(words in prop::collection::vec("version|1.0.0|macro|quat|matrix|[0-9]{1,3}|\n", 0..60)) {
            let text = words.join(" ");
            of_pose(text.as_bytes());
        }
    }
}
