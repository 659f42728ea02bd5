//! `*_sliders.json` of MakeHuman 1: tabs of sliders, and which modifier each one sets
//! (`docs/loaders/makehuman1/modifiers.md#sliders`).

use crate::macro_json::text;
use crate::unfit::{NamedAt, below, nth};
use mhlint_json::{Document, Node, Value};

/// The file: its tabs in order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ModifierSliders {
    /// The tabs.
    pub tabs: Vec<Tab>,
}

/// A tab.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tab {
    /// Pointer to it.
    pub pointer: String,
    /// Its name, which no other tab of its program may have.
    pub name: String,
    /// What lines of models may begin with for its sake, which sets nothing.
    pub saved_as: Option<String>,
    /// Its boxes, in order.
    pub categories: Vec<Category>,
}

/// A box in a tab.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Category {
    /// Pointer to it.
    pub pointer: String,
    /// Its name.
    pub name: String,
    /// Its sliders.
    pub sliders: Vec<Slider>,
}

/// A slider.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Slider {
    /// The modifier that it sets.
    pub modifier: Option<NamedAt>,
    /// What turns the camera while it is in use.
    pub camera: Option<NamedAt>,
    /// What has to be so for it to be shown.
    pub condition: Option<NamedAt>,
}

impl ModifierSliders {
    /// All sliders.
    pub fn sliders(&self) -> impl Iterator<Item = &Slider> {
        self.tabs
            .iter()
            .flat_map(|tab| &tab.categories)
            .flat_map(|category| &category.sliders)
    }

    /// All modifiers that sliders set.
    pub fn modifiers(&self) -> impl Iterator<Item = &NamedAt> {
        self.sliders().filter_map(|slider| slider.modifier.as_ref())
    }
}

/// Takes what the program would take.
pub fn read(document: &Document) -> ModifierSliders {
    let tabs = document.root.effective_members().into_iter().map(|member| {
        let pointer = below("", &member.key);
        let own = below(&pointer, "modifiers");
        let categories = member
            .node
            .get("modifiers")
            .map(Node::effective_members)
            .unwrap_or_default();
        let categories = categories.into_iter().map(|category| {
            let pointer = below(&own, &category.key);
            let sliders = category
                .node
                .elements()
                .iter()
                .enumerate()
                .map(|(at, node)| slider(node, &nth(&pointer, at)));
            Category {
                sliders: sliders.collect(),
                name: category.key.clone(),
                pointer,
            }
        });
        let saved_as = text(&member.node, "saveName");
        Tab {
            categories: categories.collect(),
            name: member.key.clone(),
            pointer,
            saved_as,
        }
    });
    ModifierSliders {
        tabs: tabs.collect(),
    }
}

fn slider(node: &Node, pointer: &str) -> Slider {
    let named = |key: &str| {
        Some(NamedAt {
            pointer: below(pointer, key),
            name: text(node, key)?,
        })
    };
    // An empty text turns no camera and asks for nothing.
    let filled = |key: &str| {
        let is_filled = node
            .get(key)
            .is_some_and(|value| matches!(&value.value, Value::String(text) if !text.is_empty()));
        is_filled.then(|| named(key)).flatten()
    };
    Slider {
        modifier: named("mod"),
        camera: filled("cam"),
        condition: filled("enabledCondition"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tabs_hold_boxes_of_sliders() {
        let read = read(&mhlint_json::parse(
            br#"{"Face": {"modifiers": {"head": [{"mod": "head/oval", "cam": "frontView"}, {"cam": ""}]}}, "Torso": {}}"#,
        ).unwrap());
        assert_eq!(
            read.tabs.iter().map(|tab| &*tab.name).collect::<Vec<_>>(),
            ["Face", "Torso"]
        );
        let sliders: Vec<&Slider> = read.sliders().collect();
        assert_eq!(
            sliders[0].modifier.as_ref().unwrap().pointer,
            "/Face/modifiers/head/0/mod"
        );
        assert_eq!(sliders[0].camera.as_ref().unwrap().name, "frontView");
        assert_eq!(*sliders[1], Slider::default());
    }
}
