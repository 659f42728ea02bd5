//! `macro.json` of MPFB: settings in parts, each part a range between two names
//! (`docs/loaders/mpfb/macros.md#keys-of-macros`).

use super::macro_json::texts;
use mhlint_diag::pointer;
use mhlint_json::{Document, Node, Value};

/// The keys of `macrotargets` that the program asks for; others are ignored.
pub const SETTINGS: [&str; 8] = [
    "gender",
    "age",
    "muscle",
    "weight",
    "proportions",
    "height",
    "cupsize",
    "firmness",
];

/// The races, which have no parts, as they stand in names.
pub const RACES: [&str; 3] = ["asian", "caucasian", "african"];

/// The file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MacroParts {
    /// Those of [`SETTINGS`] that have a list of parts, in that order.
    pub settings: Vec<Setting>,
    /// What is looked up by its key and is not there.
    pub absent: Vec<Absent>,
    /// `combinations`: key and names. No program reads them.
    pub combinations: Vec<(String, Vec<String>)>,
}

/// A setting.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Setting {
    /// Place in [`SETTINGS`].
    pub place: usize,
    /// Its parts in file order, only those that could be read.
    pub parts: Vec<Part>,
    /// Whether these are all parts that the file has.
    pub is_whole: bool,
}

/// A range of a setting: at `lowest` its shape is `low`, at `highest` it is `high`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Part {
    /// Position in `parts`.
    pub index: usize,
    /// Where it begins; this value itself is outside.
    pub lowest: f64,
    /// Where it ends; this value itself is outside.
    pub highest: f64,
    /// Name at the beginning; `None` for no shape.
    pub low: Option<String>,
    /// Name at the end; `None` for no shape.
    pub high: Option<String>,
}

/// A key that is not there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Absent {
    /// Pointer to the object that lacks it.
    pub owner: String,
    /// The key.
    pub key: &'static str,
}

impl Setting {
    /// Its key.
    pub fn name(&self) -> &'static str {
        SETTINGS.get(self.place).copied().unwrap_or_default()
    }

    /// Pointer to a member of a part.
    pub fn pointer(&self, part: &Part, member: &str) -> String {
        pointer(&[
            "macrotargets",
            self.name(),
            "parts",
            &part.index.to_string(),
            member,
        ])
    }
}

impl MacroParts {
    /// Whether all that the program looks up is there and of the right type.
    pub fn is_whole(&self) -> bool {
        self.settings.len() == SETTINGS.len()
            && self.settings.iter().all(|setting| setting.is_whole)
    }
}

/// Takes what the program would take.
pub fn read(document: &Document) -> MacroParts {
    let mut file = MacroParts::default();
    let root = &document.root;
    if let Some(targets) = file.member(root, "", "macrotargets") {
        for (place, name) in SETTINGS.into_iter().enumerate() {
            let Some(setting) = file.member(targets, "/macrotargets", name) else {
                continue;
            };
            let owner = pointer(&["macrotargets", name]);
            if let Some(parts) = file
                .member(setting, &owner, "parts")
                .filter(|parts| parts.is_array())
            {
                let setting = file.setting(place, parts, &owner);
                file.settings.push(setting);
            }
        }
    }
    let combinations = root
        .get("combinations")
        .map(Node::effective_members)
        .unwrap_or_default();
    let combination = |node: &Node| texts(node).unwrap_or_default();
    file.combinations = combinations
        .into_iter()
        .map(|member| (member.key.clone(), combination(&member.node)))
        .collect();
    file
}

impl MacroParts {
    /// A member of an object, noted where it is absent. What is no object has a fault of its own.
    fn member<'n>(&mut self, node: &'n Node, owner: &str, key: &'static str) -> Option<&'n Node> {
        let found = node.get(key);
        if found.is_none() && node.is_object() {
            self.absent.push(Absent {
                owner: owner.to_owned(),
                key,
            });
        }
        found
    }

    fn setting(&mut self, place: usize, parts: &Node, owner: &str) -> Setting {
        let nodes = parts.elements().iter().enumerate();
        let read =
            nodes.map(|(index, node)| self.part(index, node, &format!("{owner}/parts/{index}")));
        let parts: Vec<Option<Part>> = read.collect();
        let is_whole = parts.iter().all(Option::is_some);
        Setting {
            place,
            parts: parts.into_iter().flatten().collect(),
            is_whole,
        }
    }

    fn part(&mut self, index: usize, node: &Node, owner: &str) -> Option<Part> {
        let [lowest, highest, low, high] =
            ["lowest", "highest", "low", "high"].map(|key| self.member(node, owner, key));
        Some(Part {
            index,
            lowest: lowest?.as_python_number()?,
            highest: highest?.as_python_number()?,
            low: name(low?).ok()?,
            high: name(high?).ok()?,
        })
    }
}

/// A value that the program cannot use.
struct WrongType;

/// A name, or none at all.
fn name(node: &Node) -> Result<Option<String>, WrongType> {
    match &node.value {
        Value::String(text) => Ok(Some(text.clone()).filter(|text| !text.is_empty())),
        Value::Null => Ok(None),
        _ => Err(WrongType),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(text: &str) -> MacroParts {
        read(&mhlint_json::parse(text.as_bytes()).unwrap())
    }

    /// `macrotargets` with one setting of these parts.
    fn age(parts: &str) -> MacroParts {
        file(&format!(
            r#"{{"macrotargets": {{"age": {{"parts": {parts}}}}}}}"#
        ))
    }

    fn absent(file: &MacroParts) -> Vec<String> {
        file.absent
            .iter()
            .map(|absent| format!("{} {}", absent.owner, absent.key))
            .collect()
    }

    #[test]
    fn parts_are_taken_as_they_stand() {
        let file =
            age(r#"[{"lowest": true, "highest": -0.5, "low": "", "high": "young", "more": 1}]"#);
        let setting = &file.settings[0];
        assert_eq!(
            (setting.name(), setting.is_whole, file.is_whole()),
            ("age", true, false)
        );
        let part = Part {
            index: 0,
            lowest: 1.0,
            highest: -0.5,
            low: None,
            high: Some("young".to_owned()),
        };
        assert_eq!(setting.parts, [part]);
        assert_eq!(
            setting.pointer(&setting.parts[0], "low"),
            "/macrotargets/age/parts/0/low"
        );
    }

    #[test]
    fn what_is_absent_is_named_with_its_owner() {
        assert_eq!(absent(&file("{}")), [" macrotargets"]);
        assert_eq!(absent(&file("[]")), Vec::<String>::new());
        let file = age(r#"[{"lowest": 0, "low": null, "high": 1}, 7]"#);
        assert_eq!(
            absent(&file)[..2],
            ["/macrotargets gender", "/macrotargets/age/parts/0 highest"]
        );
        assert_eq!((file.absent.len(), file.settings[0].is_whole), (8, false));
        assert!(file.settings[0].parts.is_empty());
        assert_eq!(absent(&age("3")).len(), 7);
    }

    #[test]
    fn a_part_of_wrong_types_is_left_out() {
        for part in [
            r#""lowest": "0", "low": """#,
            r#""lowest": 0, "low": 5"#,
            r#""lowest": null, "low": """#,
        ] {
            let file = age(&format!(r#"[{{{part}, "highest": 1, "high": null}}]"#));
            assert!(
                file.settings[0].parts.is_empty() && !file.settings[0].is_whole,
                "{part}"
            );
        }
    }

    #[test]
    fn combinations_may_be_anything() {
        let file = file(r#"{"combinations": {"a": ["race", "age"], "b": 3}}"#);
        let pair = |key: &str, names: &[&str]| {
            (
                key.to_owned(),
                names.iter().map(|name| (*name).to_owned()).collect(),
            )
        };
        assert_eq!(
            file.combinations,
            [pair("a", &["race", "age"]), pair("b", &[])]
        );
    }
}
