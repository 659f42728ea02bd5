//! `target_cat.json`: the categories under which sliders are shown
//! (`docs/loaders/makehuman2/sliders.md#categories`).

use super::macro_json::text;
use mhlint_json::{Document, Node};

/// The file: categories in file order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TargetCategories {
    /// The categories.
    pub categories: Vec<Category>,
}

/// A category.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Category {
    /// Display name.
    pub name: String,
    /// First half of the groups it shows.
    pub group: Option<String>,
    /// Its items.
    pub items: Vec<Item>,
}

/// An item of a category.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Item {
    /// Display name.
    pub title: Option<String>,
    /// Second half of the group it shows.
    pub cat: Option<String>,
}

impl Category {
    /// The group an item shows: `group|cat`, compared as text with the sliders' `group`.
    pub fn group_of(&self, item: &Item) -> Option<String> {
        Some(format!(
            "{}|{}",
            self.group.as_deref().unwrap_or("default"),
            item.cat.as_deref()?
        ))
    }
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> TargetCategories {
    let members = document.root.effective_members().into_iter();
    TargetCategories {
        categories: members
            .map(|member| Category {
                name: member.key.clone(),
                group: text(&member.node, "group"),
                items: member
                    .node
                    .get("items")
                    .map(Node::elements)
                    .unwrap_or_default()
                    .iter()
                    .map(item)
                    .collect(),
            })
            .collect(),
    }
}

fn item(node: &Node) -> Item {
    Item {
        title: text(node, "title"),
        cat: text(node, "cat"),
    }
}
