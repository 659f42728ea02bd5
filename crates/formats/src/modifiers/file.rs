//! `*_modifiers.json` of MakeHuman 1: what sliders there are, and which targets they move
//! (`docs/loaders/makehuman1/modifiers.md#modifier-file`).

use crate::macro_json::text;
use crate::unfit::NamedAt;
use mhlint_json::{Document, Node, Value};

/// The file: modifiers of all groups, in its order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ModifierFile {
    /// Those that have a name.
    pub modifiers: Vec<Modifier>,
    /// Whether these are all.
    pub is_whole: bool,
}

/// A modifier.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Modifier {
    /// Pointer to it.
    pub pointer: String,
    /// The group that it is in.
    pub group: String,
    /// The part of the names of its targets behind the group.
    pub target: String,
    /// What follows on the side of negative values, in the middle, and on that of positive values.
    pub tails: Tails,
    /// The macro variable; with one, the targets are those of the group.
    pub variable: Option<NamedAt>,
    /// The class that is to make it.
    pub class: Option<NamedAt>,
    /// The value of a reset.
    pub default: Option<f64>,
}

/// What follows the part of the name.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Tails {
    /// `min`.
    pub min: Option<String>,
    /// `mid`.
    pub mid: Option<String>,
    /// `max`.
    pub max: Option<String>,
}

impl Tails {
    /// Both sides: one alone is not read.
    pub fn sides(&self) -> Option<(&str, &str)> {
        self.min.as_deref().zip(self.max.as_deref())
    }

    /// The tail that stands alone, by its key.
    pub fn unpaired(&self) -> Option<&'static str> {
        match (&self.min, &self.mid, &self.max) {
            (Some(_), _, None) => Some("min"),
            (None, _, Some(_)) => Some("max"),
            (None, Some(_), None) => Some("mid"),
            _ => None,
        }
    }
}

impl Modifier {
    /// The name by which sliders, descriptions and models know it.
    pub fn full_name(&self) -> String {
        let name = match (&self.variable, self.tails.sides(), &self.tails.mid) {
            (Some(variable), ..) => variable.name.clone(),
            (None, Some((min, max)), Some(mid)) => format!("{}-{min}|{mid}|{max}", self.target),
            (None, Some((min, max)), None) => format!("{}-{min}|{max}", self.target),
            (None, None, _) => self.target.clone(),
        };
        format!(
            "{}/{}",
            self.group.replace('/', "-"),
            name.replace('/', "-")
        )
    }

    /// The groups of targets that it asks for, with what each is for.
    pub fn target_groups(&self) -> Vec<(Part, String)> {
        if self.variable.is_some() {
            return vec![(Part::Macro, self.group.clone())];
        }
        let own = format!("{}-{}", self.group, self.target);
        let Some((min, max)) = self.tails.sides() else {
            return vec![(Part::Only, own)];
        };
        let mid = self
            .tails
            .mid
            .iter()
            .map(|mid| (Part::Centre, format!("{own}-{mid}")));
        [(Part::Left, format!("{own}-{min}"))]
            .into_iter()
            .chain(mid)
            .chain([(Part::Right, format!("{own}-{max}"))])
            .collect()
    }
}

/// What targets are for in a modifier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// All of a macro.
    Macro,
    /// Negative values.
    Left,
    /// The middle.
    Centre,
    /// Positive values.
    Right,
    /// The only side.
    Only,
}

/// Takes what the loader would take, as far as it has a name.
pub fn read(document: &Document) -> ModifierFile {
    let groups = document.root.elements();
    let mut file = ModifierFile {
        modifiers: Vec::new(),
        is_whole: document.root.is_array(),
    };
    for (at, group) in groups.iter().enumerate() {
        let list = group.get("modifiers").filter(|list| list.is_array());
        let (Some(name), Some(list)) = (text(group, "group"), list) else {
            file.is_whole = false;
            continue;
        };
        let found = list
            .elements()
            .iter()
            .enumerate()
            .map(|(place, node)| modifier(node, &name, format!("/{at}/modifiers/{place}")));
        for one in found {
            file.is_whole &= one.is_some();
            file.modifiers.extend(one);
        }
    }
    file
}

fn modifier(node: &Node, group: &str, pointer: String) -> Option<Modifier> {
    let named = |key: &str| {
        let name = text(node, key).filter(|name| !name.is_empty())?;
        Some(NamedAt {
            pointer: format!("{pointer}/{key}"),
            name,
        })
    };
    let variable = named("macrovar");
    let target = text(node, "target");
    if variable.is_none() && target.is_none() {
        return None;
    }
    let tail = |key: &str| text(node, key).filter(|tail| !tail.is_empty());
    let default = node
        .get("defaultValue")
        .filter(|value| matches!(value.value, Value::Number(..)));
    Some(Modifier {
        group: group.to_owned(),
        target: target.unwrap_or_default(),
        tails: Tails {
            min: tail("min"),
            mid: tail("mid"),
            max: tail("max"),
        },
        variable,
        class: named("modifierType"),
        default: default.and_then(Node::as_python_number),
        pointer,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::parse;

    fn of(modifiers: &str) -> ModifierFile {
        read(
            &parse(format!(r#"[{{"group": "head/top", "modifiers": [{modifiers}]}}]"#).as_bytes())
                .unwrap(),
        )
    }

    #[test]
    fn names_have_both_sides_or_none() {
        let all = of(
            r#"{"target": "a", "min": "in", "max": "out"}, {"target": "a", "min": "in"},
            {"target": "a/b", "min": "in", "mid": "up", "max": "out"}, {"macrovar": "Age", "target": "a", "min": "x"},
            {"target": "a", "min": "in", "max": null}"#,
        );
        let names: Vec<String> = all.modifiers.iter().map(Modifier::full_name).collect();
        assert_eq!(
            names,
            [
                "head-top/a-in|out",
                "head-top/a",
                "head-top/a-b-in|up|out",
                "head-top/Age",
                "head-top/a"
            ]
        );
        assert_eq!(all.modifiers[2].target_groups().len(), 3);
        assert_eq!(
            all.modifiers[3].target_groups(),
            [(Part::Macro, "head/top".to_owned())]
        );
        assert_eq!(all.modifiers[1].tails.unpaired(), Some("min"));
        assert_eq!(all.modifiers[4].tails.unpaired(), Some("min"));
        assert_eq!(all.modifiers[2].tails.unpaired(), None);
        assert!(all.is_whole);
    }

    #[test]
    fn what_has_no_name_is_left_out() {
        let all = of(
            r#"{"min": "in", "max": "out"}, {"target": "a", "defaultValue": "1"}, 3, {"target": 5}"#,
        );
        assert_eq!((all.modifiers.len(), all.is_whole), (1, false));
        assert_eq!(
            (all.modifiers[0].pointer.as_str(), all.modifiers[0].default),
            ("/0/modifiers/1", None)
        );
        assert!(!read(&parse(b"{}").unwrap()).is_whole);
        assert!(!read(&parse(br#"[null, {"group": "a"}]"#).unwrap()).is_whole);
    }
}
