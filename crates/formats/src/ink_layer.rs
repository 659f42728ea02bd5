//! Ink layers of MPFB, `ink_layers/**/*.json`: a picture that is laid over the skin
//! (`docs/loaders/mpfb/materials.md#keys-of-ink-layers`).

use super::unfit::{NamedAt, Unfits};
use mhlint_json::{Document, Node, Value};

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InkLayer {
    /// What stops the loader.
    pub stops: Unfits,
    /// The picture, which lies beside the file.
    pub image: Option<NamedAt>,
    /// The UV layer that the picture is laid out for; `None` for that of the base mesh.
    pub focus: Option<NamedAt>,
}

/// Takes what the loader would take: both keys must be there, and `focus` may be empty.
pub fn read(document: &Document) -> InkLayer {
    let root = &document.root;
    let mut layer = InkLayer::default();
    if !root.is_object() {
        layer.stops.add_type("", root, "an object");
        return layer;
    }
    for key in ["focus", "image_name"]
        .into_iter()
        .filter(|key| root.get(key).is_none())
    {
        layer.stops.add("", super::unfit::Why::Lacks(key));
    }
    let text = |key: &str| {
        root.get(key)
            .and_then(Node::as_str)
            .filter(|text| !text.is_empty())
    };
    layer.focus = text("focus").map(|focus| NamedAt::new("/focus", focus));
    layer.image = text("image_name").map(|image| NamedAt::new("/image_name", image));
    let is_other = |node: &&Node| !matches!(node.value, Value::String(_)) && !node.is_falsy();
    if let Some(focus) = root.get("focus").filter(is_other) {
        layer.stops.add_type("/focus", focus, "a string");
    }
    match root.get("image_name") {
        Some(Node {
            value: Value::String(text),
            ..
        }) if !text.is_empty() => {}
        Some(image) => layer
            .stops
            .add_type("/image_name", image, "the name of a picture"),
        None => {}
    }
    layer
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::parse;

    fn of(text: &str) -> InkLayer {
        read(&parse(text.as_bytes()).unwrap())
    }

    fn pointers(layer: &InkLayer) -> Vec<&str> {
        layer.stops.all().iter().map(|one| &*one.pointer).collect()
    }

    #[test]
    fn both_keys_must_be_there() {
        assert_eq!(pointers(&of("{}")), ["", ""]);
        assert_eq!(pointers(&of("[]")), [""]);
        assert_eq!(
            pointers(&of(r#"{"focus": 5, "image_name": ""}"#)),
            ["/focus", "/image_name"]
        );
        for focus in ["null", "\"\"", "\"face solid\""] {
            assert!(
                pointers(&of(&format!(
                    r#"{{"focus": {focus}, "image_name": "a.png"}}"#
                )))
                .is_empty(),
                "{focus}"
            );
        }
    }
}
