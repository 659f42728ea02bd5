//! Files of the program itself: `makehuman2_version.json` and `shaders/shader.json`
//! (`docs/loaders/makehuman2/program.md#version-and-settings`).

use super::macro_json::text;
use mhlint_json::{Document, Node, Value};

/// `makehuman2_version.json`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Version {
    /// The base mesh that is chosen first.
    pub standard_mesh: Option<String>,
    /// All keys at the top.
    pub keys: Vec<String>,
    /// Labels of the menu, and the keys whose addresses they open.
    pub support: Vec<(String, String)>,
}

/// `shaders/shader.json`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Shaders {
    /// Whether a skybox is shown at start.
    pub has_skybox: bool,
    /// Its folder.
    pub skybox: Option<String>,
}

/// Takes what the program would take.
pub fn version(document: &Document) -> Version {
    let root = &document.root;
    let support = root
        .get("support_urls")
        .map(Node::effective_members)
        .unwrap_or_default()
        .into_iter();
    Version {
        standard_mesh: text(root, "standardmesh"),
        keys: root
            .members()
            .iter()
            .map(|member| member.key.clone())
            .collect(),
        support: support
            .filter_map(|one| Some((one.key.clone(), one.node.as_str()?.to_owned())))
            .collect(),
    }
}

/// Takes what the program would take.
pub fn shaders(document: &Document) -> Shaders {
    let root = &document.root;
    Shaders {
        has_skybox: root
            .get("skybox")
            .is_some_and(|node| node.value == Value::Bool(true)),
        skybox: text(root, "skyboxname"),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    #[test]
    fn what_is_named_is_kept() {
        let text =
            br#"{"standardmesh": "figure", "url_a": "x", "support_urls": {"A": "url_a", "B": 5}}"#;
        let found = version(&parse(text).unwrap());
        assert_eq!(found.standard_mesh.as_deref(), Some("figure"));
        assert_eq!(found.support, [("A".to_owned(), "url_a".to_owned())]);
        let found = shaders(&parse(br#"{"skybox": true, "skyboxname": "default"}"#).unwrap());
        assert!(found.has_skybox && found.skybox.as_deref() == Some("default"));
    }

    proptest! {
        #[test]
        fn no_json_stops_the_readers(text in r#"[\[\]{},:"0-9a-c ]{0,40}"#) {
            let text = format!(r#"{{"support_urls": {text}, "skybox": {text}}}"#);
            if let Ok(document) = parse(text.as_bytes()) {
                version(&document);
                shaders(&document);
            }
        }
    }
}
