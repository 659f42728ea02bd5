//! The known findings of `mhlint-baseline/1`.

use serde::{Deserialize, Serialize};

use super::{Figure, Level, Parts};

/// Known findings. [`Baseline::text`] is the file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Baseline {
    /// In any order; the text sorts them.
    pub entries: Vec<Entry>,
}

impl Baseline {
    /// What the file says that it is.
    pub const FORMAT: &str = "mhlint-baseline/1";

    /// The file: sorted, one entry a line, so that changes can be read and merged.
    pub fn text(&self) -> String {
        let mut entries = self.entries.clone();
        // Equal ones stay: two findings may differ in nothing that is kept, and each has its own.
        entries.sort();
        let line = |entry: &Entry| serde_json::to_string(entry).unwrap_or_default();
        let lines: Vec<String> = entries.iter().map(line).collect();
        let list = if lines.is_empty() {
            "[]".to_owned()
        } else {
            format!("[\n{}\n]", lines.join(",\n"))
        };
        format!(
            "{{\"format\": \"{}\", \"entries\": {list}}}\n",
            Self::FORMAT
        )
    }
}

/// One known finding.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Entry {
    /// The asset, relative to the folder of the file. For people, and to tell equal data roots
    /// apart.
    pub path: String,
    /// Id of the rule.
    pub rule: String,
    /// Structural name of the fault in the asset. For people.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub key: String,
    /// What it is recognised by.
    pub fingerprint: String,
    /// How bad it was by its consequence, whatever the settings made of it. What has become worse
    /// is not known.
    #[serde(default = "worst")]
    pub level: Level,
    /// How much of the fault there was; what has grown since is not known. Without it any amount
    /// is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measure: Option<Figure>,
    /// Everything it spoke for, by name, numbers in a row as `first-last`; empty where that is one
    /// thing.
    #[serde(default, skip_serializing_if = "Parts::is_empty")]
    pub parts: Parts,
}

impl Entry {
    /// What it is about, without its parts.
    pub fn subject(&self) -> (&str, &str, &str) {
        (&self.path, &self.rule, &self.key)
    }
}

fn worst() -> Level {
    Level::Error
}
