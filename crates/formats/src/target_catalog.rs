//! `target.json` of MPFB: the sliders, section by section (`docs/loaders/mpfb/sliders.md#schema`,
//! `docs/loaders/mpfb/sliders.md#what-a-slider-does`).

use super::macro_json::text;
use mhlint_json::{Document, Node, Value};

/// The file: sections in file order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TargetCatalog {
    /// The sections.
    pub sections: Vec<Section>,
}

/// Sliders whose targets lie in one folder.
#[derive(Debug, Clone, PartialEq, Default)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each says one thing of the section"
)]
pub struct Section {
    /// Its key, which is the name of the folder.
    pub name: String,
    /// Its sliders.
    pub categories: Vec<Category>,
    /// Whether all of its sliders are known: there is a list, and each has a name.
    pub is_whole: bool,
    /// Whether its list of sliders is there and empty.
    pub is_empty: bool,
    /// Whether `unsorted` names targets, which nothing reads.
    pub has_unsorted: bool,
    /// Whether `include_per_default` is false, which nothing reads either.
    pub is_excluded: bool,
}

/// A slider, or one for each side.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Category {
    /// Position in `categories`.
    pub index: usize,
    /// Its name: without `opposites` that of the target, too.
    pub name: String,
    /// What the panel calls it.
    pub label: Option<String>,
    /// Whether there is one for each side. Any value that Python takes for true counts.
    pub is_sided: bool,
    /// The slots of `opposites`; `None` where the category has none, and the slider but one end.
    pub slots: Option<Vec<Slot>>,
    /// Whether `full_path` says where the target of a slider with one end is.
    pub has_full_path: bool,
    /// Position and name of the entries of `targets`, of which no file is looked for.
    pub targets: Vec<(usize, String)>,
}

/// An end of a slider.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slot {
    /// Its key.
    pub key: &'static str,
    /// Whether it is that of a side.
    pub is_sided: bool,
    /// Name of the target, empty for none.
    pub stem: String,
}

/// The keys of `opposites`, and whether they are for a side.
const SLOTS: [(&str, bool); 6] = [
    ("negative-left", true),
    ("negative-right", true),
    ("negative-unsided", false),
    ("positive-left", true),
    ("positive-right", true),
    ("positive-unsided", false),
];

impl Category {
    /// The slots that the slider asks for. If all of them are empty the targets are those of the
    /// other kind.
    pub fn slots_in_use(&self) -> impl Iterator<Item = &Slot> {
        let slots = self
            .slots
            .iter()
            .flatten()
            .filter(|slot| slot.is_sided == self.is_sided);
        let is_filled = slots.clone().any(|slot| !slot.stem.is_empty());
        slots.filter(move |_| is_filled)
    }

    /// Whether no slot of the sides that it has names a target, and one of the other kind does.
    pub fn has_slots_of_other_kind(&self) -> bool {
        let filled = |is_sided: bool| {
            let mut slots = self
                .slots
                .iter()
                .flatten()
                .filter(|slot| slot.is_sided == is_sided);
            slots.any(|slot| !slot.stem.is_empty())
        };
        !filled(self.is_sided) && filled(!self.is_sided)
    }

    /// The target in a slot.
    pub fn slot(&self, key: &str) -> Option<&str> {
        let slot = self.slots.iter().flatten().find(|slot| slot.key == key)?;
        (!slot.stem.is_empty()).then_some(slot.stem.as_str())
    }

    /// What stands before the name, for each side.
    pub const fn sides(&self) -> &'static [&'static str] {
        if self.is_sided { &["l-", "r-"] } else { &[""] }
    }
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> TargetCatalog {
    let sections = document.root.effective_members().into_iter().map(|member| {
        let list = member
            .node
            .get("categories")
            .map(Node::elements)
            .unwrap_or_default();
        let categories: Vec<Category> = list
            .iter()
            .enumerate()
            .filter_map(|(index, node)| category(index, node))
            .collect();
        let is_list = member
            .node
            .get("categories")
            .is_some_and(|node| matches!(node.value, Value::Array(_)));
        Section {
            name: member.key.clone(),
            is_whole: is_list && categories.len() == list.len(),
            categories,
            is_empty: member.node.get("categories").is_some_and(is_empty_list),
            has_unsorted: member
                .node
                .get("unsorted")
                .is_some_and(|list| !list.elements().is_empty()),
            is_excluded: member
                .node
                .get("include_per_default")
                .is_some_and(Node::is_falsy),
        }
    });
    TargetCatalog {
        sections: sections.collect(),
    }
}

fn is_empty_list(node: &Node) -> bool {
    matches!(&node.value, Value::Array(elements) if elements.is_empty())
}

/// One without a name stops the add-on.
fn category(index: usize, node: &Node) -> Option<Category> {
    let targets = node
        .get("targets")
        .map(Node::elements)
        .unwrap_or_default()
        .iter()
        .enumerate();
    Some(Category {
        index,
        name: text(node, "name")?,
        label: text(node, "label"),
        is_sided: node
            .get("has_left_and_right")
            .is_some_and(|value| !value.is_falsy()),
        slots: node.get("opposites").map(slots),
        has_full_path: node.get("full_path").is_some(),
        targets: targets
            .filter_map(|(at, entry)| Some((at, entry.as_str()?.to_owned())))
            .collect(),
    })
}

fn slots(node: &Node) -> Vec<Slot> {
    let slot = |(key, is_sided): (&'static str, bool)| {
        let stem = match &node.get(key)?.value {
            Value::String(text) => text.clone(),
            Value::Null => String::new(),
            _ => return None,
        };
        Some(Slot {
            key,
            is_sided,
            stem,
        })
    };
    SLOTS.into_iter().filter_map(slot).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn categories(text: &str) -> Vec<Category> {
        let text = format!(r#"{{"nose": {{"categories": [{text}]}}}}"#);
        let mut read = read(&mhlint_json::parse(text.as_bytes()).unwrap());
        read.sections.remove(0).categories
    }

    #[test]
    fn only_slots_of_the_side_in_use_are_asked_for() {
        let slots = r#""opposites": {"negative-left": "l-a", "negative-unsided": "a", "positive-unsided": null}"#;
        let asked = |sided: &str| {
            let all = categories(&format!(
                r#"{{"name": "a", "has_left_and_right": {sided}, {slots}}}"#
            ));
            all[0]
                .slots_in_use()
                .map(|slot| (slot.key, slot.stem.clone()))
                .collect::<Vec<_>>()
        };
        assert_eq!(asked("\"false\""), [("negative-left", "l-a".to_owned())]);
        assert_eq!(
            asked("0"),
            [
                ("negative-unsided", "a".to_owned()),
                ("positive-unsided", String::new())
            ]
        );
    }

    #[test]
    fn what_has_another_shape_is_left_out() {
        let all = categories(
            r#"{"name": 1}, 3, {"name": "a", "opposites": null, "targets": ["b", 2, "c"]}"#,
        );
        assert_eq!(
            (all.len(), all[0].index, all[0].slots.as_deref()),
            (1, 2, Some([].as_slice()))
        );
        assert_eq!(all[0].targets, [(0, "b".to_owned()), (2, "c".to_owned())]);
        assert!(all[0].slots_in_use().next().is_none());
    }
}
