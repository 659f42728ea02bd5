//! `face-poseunits.json` of MakeHuman 1: a name for each frame of the motion beside it, of which
//! expressions are made (`docs/loaders/makehuman1/expressions.md#units`).

use mhlint_json::{Document, Node};

/// The file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FaceUnits {
    /// The names, one a frame; `None` where the list is missing or is none.
    pub names: Option<Vec<String>>,
}

/// Takes what the program would take; what is no text is a name that nobody can write.
pub fn read(document: &Document) -> FaceUnits {
    let list = document
        .root
        .get("framemapping")
        .filter(|list| list.is_array());
    let name = |node: &Node| node.as_str().unwrap_or_default().to_owned();
    FaceUnits {
        names: list.map(|list| list.elements().iter().map(name).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_for_each_frame() {
        let of = |text: &str| read(&mhlint_json::parse(text.as_bytes()).unwrap()).names;
        assert_eq!(
            of(r#"{"framemapping": ["Rest", 3, "A"]}"#).unwrap(),
            ["Rest", "", "A"]
        );
        assert_eq!(of("{}"), None);
        assert_eq!(of("[]"), None);
    }
}
