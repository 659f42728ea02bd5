//! `modelling.json`: the sliders (formats/makehuman2.md §4).

use serde::Serialize;

use super::macro_json::{text, texts};
use crate::json::{Document, Node};

/// The file: sliders in file order, of equal keys the last.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Modelling {
    /// The sliders.
    pub sliders: Vec<Slider>,
}

/// An entry.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Slider {
    /// Its key, unique in the file.
    pub key: String,
    /// Display name if it differs from the key.
    pub name: Option<String>,
    /// `category|subcategory`.
    pub group: Option<String>,
    /// Target of the positive side, path without suffix below the target folder.
    pub incr: Option<String>,
    /// Target of the negative side.
    pub decr: Option<String>,
    /// Picture in `icons/` of the target folder.
    pub icon: Option<String>,
    /// Pattern of the right-side partner (marks a left-side entry).
    pub rsym: Option<String>,
    /// Pattern of the left-side partner.
    pub lsym: Option<String>,
    /// Pattern under which `macro.json` reads the slider.
    pub macro_pattern: Option<String>,
    /// Indices into `macrodef`.
    pub macro_influence: Option<Vec<i64>>,
    /// Patterns of a barycentric set.
    pub barycentric: Option<Vec<String>>,
    /// Number of colours of `barycentric_diffuse`.
    pub barycentric_colours: Option<usize>,
    /// Value after a reset, nominally 0..1.
    pub default: Option<f64>,
    /// Vertex indices of a polyline whose length is shown.
    pub measure: Option<Vec<i64>>,
    /// Text in the status line.
    pub display: Option<Display>,
    /// Generated from a user target: the file is looked for in the user's target folder.
    pub user: bool,
}

/// `display` of a slider.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Display {
    /// Line of the status text, 1..5.
    pub slot: Option<f64>,
    /// Format string.
    pub text: Option<String>,
    /// Python expression in `val`.
    pub formula: Option<String>,
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> Modelling {
    let members = document.root.effective_members().into_iter();
    Modelling { sliders: members.map(|member| slider(&member.key, &member.node)).collect() }
}

fn slider(key: &str, node: &Node) -> Slider {
    Slider {
        key: key.to_owned(),
        name: text(node, "name"),
        group: text(node, "group"),
        incr: text(node, "incr"),
        decr: text(node, "decr"),
        icon: text(node, "icon"),
        rsym: text(node, "rsym"),
        lsym: text(node, "lsym"),
        macro_pattern: text(node, "macro"),
        macro_influence: node.get("macro_influence").and_then(integers),
        barycentric: node.get("barycentric").and_then(texts),
        barycentric_colours: node.get("barycentric_diffuse").map(|colours| colours.elements().len()),
        default: node.get("default").and_then(Node::as_f64),
        measure: node.get("measure").and_then(integers),
        display: node.get("display").map(|display| Display {
            slot: display.get("slot").and_then(Node::as_f64),
            text: text(display, "text"),
            formula: text(display, "formula"),
        }),
        user: node.get("user").is_some(),
    }
}

/// An array of integers; elements of other types are left out.
pub(super) fn integers(node: &Node) -> Option<Vec<i64>> {
    let elements = node.is_array().then(|| node.elements())?;
    Some(elements.iter().filter_map(Node::as_i64).collect())
}
