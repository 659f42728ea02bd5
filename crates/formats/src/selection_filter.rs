//! `selection_filter.json`: the tree of labels by which the assets of a category are chosen
//! (`docs/loaders/makehuman2/libraries.md#filters`).
//!
//! Labels are in small letters, those of a path joined by `:`. The elements of a list also stand
//! for themselves: a tag of that name gets their path.

use std::collections::{BTreeMap, BTreeSet};

use mhlint_json::{Document, Node, Value};

/// The file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SelectionFilter {
    /// Paths of all labels.
    pub paths: BTreeSet<String>,
    /// Labels at the ends of the tree, and their paths.
    pub leaves: BTreeMap<String, String>,
    /// What tags, in small letters, are replaced by; `None` for those that are dropped.
    pub translate: BTreeMap<String, Led<Option<String>>>,
    /// Parts of names, in small letters, and the paths that they stand for.
    pub guess: BTreeMap<String, Led<String>>,
    /// The lengths of these parts.
    guess_lengths: BTreeSet<usize>,
    /// The rules of the buttons, by position.
    pub shortcuts: Vec<(usize, String)>,
    /// Keys that are special but for their spelling.
    pub misspelt: Vec<Misspelt>,
    /// Whether the tree has more paths than are kept.
    pub is_cut: bool,
}

/// Where something leads to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Led<T> {
    /// The key as it is written.
    pub key: String,
    /// What it leads to, as it is written.
    pub to: T,
}

/// A special key that is not recognised.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Misspelt {
    /// As it is written.
    pub key: String,
    /// The key that is meant.
    pub meant: &'static str,
    /// What the program does when it takes the value for labels.
    pub outcome: Outcome,
}

/// What becomes of values that are no labels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// They become labels.
    Labels,
    /// The program crashes when it shows them.
    CrashesInList,
    /// The program crashes when it builds the lists.
    CrashesAtStart,
}

/// Keys that are no labels.
pub const SPECIAL: [&str; 3] = ["Translate", "GuessName", "Shortcut"];
/// Longer paths of labels are no paths; together they would outgrow the file.
const LONGEST: usize = 1000;
/// Bytes of all paths that are kept.
const ROOM: usize = 16 << 20;

/// Takes what the program would take.
pub fn read(document: &Document) -> SelectionFilter {
    let (mut filter, mut room) = (SelectionFilter::default(), ROOM);
    for member in document.root.effective_members() {
        match member.key.as_str() {
            "Translate" => filter.translate = translations(&member.node),
            "GuessName" => {
                filter.guess = guesses(&member.node);
                filter.guess_lengths = filter.guess.keys().map(String::len).collect();
            }
            "Shortcut" => filter.shortcuts = shortcuts(&member.node),
            key => match meant(key) {
                Some(meant) => filter.misspelt.push(misspelt(key, meant, &member.node)),
                None => filter.add("", key, &member.node, &mut room),
            },
        }
    }
    filter
}

impl SelectionFilter {
    fn add(&mut self, above: &str, label: &str, node: &Node, room: &mut usize) {
        let label = label.to_lowercase();
        let path = if above.is_empty() {
            label.clone()
        } else {
            format!("{above}:{label}")
        };
        if path.len() > LONGEST || path.len() > *room {
            self.is_cut = true;
            return;
        }
        *room -= path.len();
        for member in node.effective_members() {
            self.add(&path, &member.key, &member.node, room);
        }
        for leaf in node
            .elements()
            .iter()
            .filter_map(Node::as_str)
            .map(str::to_lowercase)
        {
            let below = format!("{path}:{leaf}");
            let Some(left) = room.checked_sub(below.len()) else {
                self.is_cut = true;
                break;
            };
            *room = left;
            self.paths.insert(below.clone());
            self.leaves.insert(leaf, below);
        }
        self.paths.insert(path);
    }

    /// Whether what a tag or a part of a name leads to is no label. Labels are in small letters,
    /// paths as they are written.
    pub fn is_dead(&self, target: &str) -> bool {
        let path = target.strip_prefix('=').unwrap_or(target);
        !path.is_empty() && !self.is_cut && !self.paths.contains(path)
    }

    /// The path that a tag leads to; `None` if it is dropped.
    pub fn path_of(&self, tag: &str) -> Option<String> {
        let tag = tag.trim().to_lowercase();
        match self.translate.get(&tag).map(|led| &led.to) {
            Some(None) => None,
            Some(Some(target)) => Some(match target.strip_prefix('=') {
                Some(path) => path.to_owned(),
                None => format!("{target}:{tag}"),
            }),
            None => Some(self.leaves.get(&tag).cloned().unwrap_or(tag)),
        }
    }

    /// The path that the name of an asset stands for: that of its longest part.
    pub fn guessed(&self, name: &str) -> Option<&str> {
        // Of each length that a part has, longest first, the parts of the name are looked up.
        let lengths = self.guess_lengths.iter().rev().copied();
        let longest = lengths
            .filter(|length| *length <= name.len())
            .find_map(|length| {
                let starts = 0..=name.len() - length;
                let parts = starts.filter_map(|start| name.get(start..start + length));
                parts
                    .filter_map(|part| self.guess.get_key_value(part))
                    .max_by_key(|(part, _)| *part)
            });
        longest.map(|(_, led)| led.to.as_str())
    }
}

fn translations(node: &Node) -> BTreeMap<String, Led<Option<String>>> {
    let value = |node: &Node| match &node.value {
        Value::Null => Some(None),
        Value::String(text) => Some(Some(text.clone())),
        _ => None,
    };
    led(node, value)
}

fn guesses(node: &Node) -> BTreeMap<String, Led<String>> {
    led(node, |node| node.as_str().map(str::to_owned))
}

fn led<T>(node: &Node, value: impl Fn(&Node) -> Option<T>) -> BTreeMap<String, Led<T>> {
    let members = node.effective_members().into_iter();
    let all = members.filter_map(|one| {
        Some(Led {
            key: one.key.clone(),
            to: value(&one.node)?,
        })
    });
    all.map(|led| (led.key.to_lowercase(), led)).collect()
}

fn shortcuts(node: &Node) -> Vec<(usize, String)> {
    let rule = |node: &Node| {
        node.elements()
            .get(1)
            .and_then(Node::as_str)
            .map(str::to_owned)
    };
    node.elements()
        .iter()
        .enumerate()
        .filter_map(|(at, node)| Some((at, rule(node)?)))
        .collect()
}

/// The special key that a key is but for capitals and a plural.
fn meant(key: &str) -> Option<&'static str> {
    let lower = key.to_lowercase();
    let bare: String = lower.chars().filter(char::is_ascii_alphabetic).collect();
    SPECIAL.into_iter().find(|known| {
        let known = known.to_lowercase();
        bare == known || bare.strip_suffix('s') == Some(&known)
    })
}

fn misspelt(key: &str, meant: &'static str, node: &Node) -> Misspelt {
    // Labels are texts; a list in a list is none, and neither is null.
    let outcome = if node
        .elements()
        .iter()
        .any(|element| element.as_str().is_none())
    {
        Outcome::CrashesAtStart
    } else if node
        .effective_members()
        .iter()
        .any(|member| member.node.value == Value::Null)
    {
        Outcome::CrashesInList
    } else {
        Outcome::Labels
    };
    Misspelt {
        key: key.to_owned(),
        meant,
        outcome,
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    fn of(text: &str) -> SelectionFilter {
        read(&parse(text.as_bytes()).unwrap())
    }

    #[test]
    fn labels_are_paths_and_tags_lead_to_them() {
        let filter = of(
            r#"{"Slot": {"Top": ["Vest", "Shirt"]}, "Translate": {"hat": "=slot:head", "old": null, "red": "slot"},
                "GuessName": {"vest": "slot:top", "longvest": "slot"}, "Shortcut": [["i", "slot:top", "t"], ["i"]]}"#,
        );
        let paths: Vec<&str> = filter.paths.iter().map(String::as_str).collect();
        assert_eq!(
            paths,
            ["slot", "slot:top", "slot:top:shirt", "slot:top:vest"]
        );
        let led = ["vest", "VEST", "hat", "old", "red", "other"].map(|tag| filter.path_of(tag));
        let some = |path: &str| Some(path.to_owned());
        assert_eq!(
            led,
            [
                some("slot:top:vest"),
                some("slot:top:vest"),
                some("slot:head"),
                None,
                some("slot:red"),
                some("other")
            ]
        );
        assert_eq!(filter.guessed("my_longvest"), Some("slot"));
        assert_eq!(filter.shortcuts, [(0, "slot:top".to_owned())]);
    }

    #[test]
    fn special_keys_are_written_in_one_way() {
        let filter =
            of(r#"{"shortcut": [["a", "b", "c"]], "translate": {"a": "b"}, "Shortcuts": []}"#);
        let told: Vec<_> = filter
            .misspelt
            .iter()
            .map(|one| (&*one.key, one.meant, one.outcome))
            .collect();
        assert_eq!(
            told,
            [
                ("shortcut", "Shortcut", Outcome::CrashesAtStart),
                ("translate", "Translate", Outcome::Labels),
                ("Shortcuts", "Shortcut", Outcome::Labels)
            ]
        );
        assert!(filter.paths.is_empty());
    }

    #[test]
    fn deep_trees_do_not_outgrow_the_file() {
        let depth = 900;
        let text = format!(
            "{}[]{}",
            r#"{"abcdefghij": "#.repeat(depth),
            "}".repeat(depth)
        );
        assert!(of(&text).paths.len() < depth);
    }

    proptest! {
        #[test]
        fn every_leaf_is_a_path(labels in prop::collection::btree_set("[a-z]{1,5}", 0..9)) {
            let filter = of(&serde_json::json!({ "top": labels }).to_string());
            for label in &labels {
                prop_assert_eq!(filter.path_of(label), Some(format!("top:{label}")));
            }
        }

        #[test]
        fn no_json_stops_the_reader(text in r#"[\[\]{},:"0-9a-c ]{0,40}"#) {
            let text = format!(r#"{{"a": {text}, "Translate": {text}, "GuessName": {text}, "Shortcut": {text}}}"#);
            if let Ok(document) = parse(text.as_bytes()) {
                read(&document);
            }
        }
    }
}
