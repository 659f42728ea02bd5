//! `*_modifiers_desc.json` of MakeHuman 1: what the status line says of a slider
//! (`docs/loaders/makehuman1/modifiers.md#descriptions`).

use crate::unfit::{NamedAt, below, keep};
use mhlint_json::{Document, Value};

/// The file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ModifierTexts {
    /// The modifiers that have a description, with the pointer to it.
    pub described: Vec<NamedAt>,
    /// Those whose description is no text, and what it is instead.
    pub no_texts: Vec<(NamedAt, &'static str)>,
}

/// Takes all entries.
pub fn read(document: &Document) -> ModifierTexts {
    let mut texts = ModifierTexts::default();
    for member in document.root.effective_members() {
        let pointer = below("", &member.key);
        if !matches!(member.node.value, Value::String(_)) {
            let at = NamedAt {
                pointer: pointer.clone(),
                name: member.key.clone(),
            };
            texts.no_texts.push((at, member.node.type_word()));
        }
        keep(&mut texts.described, &pointer, &member.key);
    }
    texts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn descriptions_are_texts() {
        let read = read(&mhlint_json::parse(br#"{"a/b-in|out": "", "c": null, "d": 3}"#).unwrap());
        assert_eq!(read.described.len(), 3);
        assert_eq!(read.described[0].pointer, "/a~1b-in|out");
        assert_eq!(
            read.no_texts
                .iter()
                .map(|(at, _)| &*at.name)
                .collect::<Vec<_>>(),
            ["c", "d"]
        );
    }
}
