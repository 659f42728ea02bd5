//! `modelling.json`: the sliders (`docs/loaders/makehuman2/sliders.md#keys-of-a-slider`). Formulas
//! are checked here, never evaluated.

use std::collections::BTreeSet;

use super::expression::{self, Fault};
use super::format_text;
use super::macro_json::{text, texts};
use mhlint_diag::nearest;
use mhlint_json::{Document, Node, Value};

/// The file: sliders in file order, of equal keys the last.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Modelling {
    /// The sliders.
    pub sliders: Vec<Slider>,
    /// Keys of entries that are no object: nothing can be said about what they were meant to be.
    pub unreadable: Vec<String>,
    /// Whether there is a slider that is not marked as the user's.
    pub has_unmarked: bool,
}

/// An entry.
#[derive(Debug, Clone, PartialEq, Default)]
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
    /// Elements of `barycentric`, texts or not.
    pub barycentric_len: usize,
    /// Lengths of the colours of `barycentric_diffuse`.
    pub barycentric_colours: Option<Vec<usize>>,
    /// Value after a reset, nominally 0..1.
    pub default: Option<f64>,
    /// Vertex indices of a polyline whose length is shown.
    pub measure: Option<Vec<i64>>,
    /// Whole numbers in `measure` that are written with a point, which is no index to Python.
    pub measure_floats: Vec<f64>,
    /// Text in the status line.
    pub display: Option<Display>,
    /// Generated from a user target: the file is looked for in the user's target folder.
    pub user: bool,
    /// Keys that are there and not a deliberate `null`, whatever their type.
    pub keys: Vec<String>,
    /// The entry with its misspelt keys corrected, if it has any.
    pub meant: Option<Box<Slider>>,
    /// Misspelt keys and what they were meant to be.
    pub misspelt: Vec<(String, &'static str)>,
}

/// Keys that do something; names of other keys are not guessed at.
const KEYS: [&str; 16] = [
    "group",
    "incr",
    "decr",
    "name",
    "icon",
    "tip",
    "rsym",
    "lsym",
    "macro",
    "macro_influence",
    "barycentric",
    "barycentric_diffuse",
    "default",
    "measure",
    "display",
    "user",
];

/// Keys that give a slider its effect.
pub const EFFECTS: [&str; 4] = ["incr", "decr", "macro", "barycentric"];

/// Keys for people, which are no slips of the pen.
const NOTES: [&str; 8] = [
    "description",
    "comment",
    "author",
    "copyright",
    "license",
    "tags",
    "uuid",
    "version",
];

/// `display` of a slider.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Display {
    /// Line of the status text, 1..5.
    pub slot: Option<f64>,
    /// Whether that is a whole number written with a point, which is no index to Python.
    pub slot_is_float: bool,
    /// Format string.
    pub text: Option<String>,
    /// Python expression in `val`.
    pub formula: Option<String>,
    /// Why the formula must not or cannot be evaluated; span in the file.
    pub formula_fault: Option<Fault>,
    /// Why the text must not or cannot be formatted with the result; span in the file.
    pub text_fault: Option<Fault>,
}

impl Slider {
    /// Whether a key is there, whatever its type. Wrong types are reported by the schema.
    pub fn has(&self, key: &str) -> bool {
        self.keys.iter().any(|other| other == key)
    }

    /// What a key was meant to be whose absence gives the slider no effect, or none on its positive
    /// side: the finding on the effect names it.
    pub fn misspelt_effect(&self) -> Option<(&str, &'static str)> {
        let wanted: &[&str] = match EFFECTS.iter().any(|key| self.has(key)) {
            false => &EFFECTS,
            true if self.lacks_incr() => &["incr"],
            true => &[],
        };
        let found = self
            .misspelt
            .iter()
            .find(|(_, meant)| wanted.contains(meant));
        found.map(|(key, meant)| (key.as_str(), *meant))
    }

    /// Whether it has a negative side and no positive one.
    pub fn lacks_incr(&self) -> bool {
        self.has("decr") && !self.has("incr") && !self.is_macro()
    }

    /// Whether a part of what it does is unknown because of a wrong type, an empty name or a
    /// missing key, so that nobody can tell what it would have used. Each of these is a finding on
    /// the slider itself.
    pub fn is_incomplete(&self) -> bool {
        if self.meant.is_some() {
            return false;
        }
        let lost =
            |key: &str, value: Option<&String>| self.has(key) && value.is_none_or(String::is_empty);
        let short = self
            .barycentric
            .as_ref()
            .is_some_and(|patterns| patterns.len() < self.barycentric_len);
        lost("incr", self.incr.as_ref())
            || lost("decr", self.decr.as_ref())
            || lost("macro", self.macro_pattern.as_ref())
            || self.has("barycentric") && self.barycentric.is_none()
            || short
            || self.lacks_incr()
            || !EFFECTS.iter().any(|key| self.has(key))
    }

    /// Whether it drives macros; `incr` and `decr` are then not applied.
    pub fn is_macro(&self) -> bool {
        self.barycentric.is_some() || self.macro_pattern.is_some()
    }
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> Modelling {
    // A text or list is taken for an entry without keys; the schema reports it, no rule needs to
    // see it.
    let (entries, others): (Vec<_>, Vec<_>) = document
        .root
        .effective_members()
        .into_iter()
        .partition(|member| member.node.is_object());
    let sliders: Vec<Slider> = entries
        .into_iter()
        .map(|member| slider_as_meant(&member.key, &member.node))
        .collect();
    Modelling {
        has_unmarked: sliders.iter().any(|slider| !slider.user),
        sliders,
        unreadable: others
            .into_iter()
            .map(|member| member.key.clone())
            .collect(),
    }
}

/// The entry as the loader reads it, beside it as its author meant it.
fn slider_as_meant(key: &str, node: &Node) -> Slider {
    let mut read = slider(key, node);
    if node
        .members()
        .iter()
        .all(|member| misspelt(&member.key).is_none())
    {
        return read;
    }
    let there: BTreeSet<&str> = node
        .members()
        .iter()
        .map(|member| member.key.as_str())
        .collect();
    let mut meant = node.clone();
    if let Value::Object(members) = &mut meant.value {
        for member in members {
            if let Some(right) = misspelt(&member.key).filter(|right| !there.contains(right)) {
                read.misspelt
                    .push((std::mem::replace(&mut member.key, right.to_owned()), right));
            }
        }
    }
    if !read.misspelt.is_empty() {
        read.meant = Some(Box::new(slider(key, &meant)));
    }
    read
}

/// The key that a slip of the pen was meant to be.
fn misspelt(key: &str) -> Option<&'static str> {
    if KEYS.contains(&key) || NOTES.contains(&key) {
        None
    } else {
        nearest(key, KEYS)
    }
}

fn slider(key: &str, node: &Node) -> Slider {
    Slider {
        meant: None,
        misspelt: Vec::new(),
        key: key.to_owned(),
        name: text(node, "name"),
        group: text(node, "group"),
        incr: text(node, "incr"),
        decr: text(node, "decr"),
        icon: text(node, "icon"),
        rsym: text(node, "rsym"),
        lsym: text(node, "lsym"),
        macro_pattern: text(node, "macro"),
        macro_influence: node.get("macro_influence").and_then(indices),
        barycentric: node.get("barycentric").and_then(texts),
        barycentric_len: node
            .get("barycentric")
            .map_or(0, |patterns| patterns.elements().len()),
        barycentric_colours: node
            .get("barycentric_diffuse")
            .filter(|colours| colours.is_array())
            .map(|colours| {
                colours
                    .elements()
                    .iter()
                    .map(|colour| colour.elements().len())
                    .collect()
            }),
        default: node.get("default").and_then(Node::as_f64),
        measure: node.get("measure").and_then(integers),
        measure_floats: node.get("measure").map(floats).unwrap_or_default(),
        display: node.get("display").map(display),
        user: node.get("user").is_some(),
        keys: keys(node),
    }
}

fn display(node: &Node) -> Display {
    let formula = node.get("formula").and_then(Node::as_str);
    let results = formula.and_then(|formula| expression::results(formula, "val").ok());
    Display {
        slot: node.get("slot").and_then(Node::as_f64),
        slot_is_float: node.get("slot").is_some_and(is_float),
        text: text(node, "text"),
        formula: text(node, "formula"),
        formula_fault: node
            .get("formula")
            .and_then(|formula| fault_in(formula, |text| expression::check(text, "val"))),
        text_fault: node
            .get("text")
            .and_then(|text| fault_in(text, |text| format_text::check(text, results))),
    }
}

/// The fault of a text, its span moved to the place in the file.
pub(super) fn fault_in(node: &Node, check: impl Fn(&str) -> Result<(), Fault>) -> Option<Fault> {
    let fault = check(node.as_str()?).err()?;
    Some(Fault {
        span: node.span_of_text(fault.span.clone()),
        ..fault
    })
}

/// `null` is a way to leave out these four; for others it is a wrong type.
fn keys(node: &Node) -> Vec<String> {
    let optional = ["macro", "lsym", "rsym", "measure"];
    let members = node.effective_members().into_iter();
    let there = members.filter(|member| {
        member.node.value != Value::Null || !optional.contains(&member.key.as_str())
    });
    there.map(|member| member.key.clone()).collect()
}

/// Whole numbers, whether written `1` or `1.0`: the loader compares them only.
fn indices(node: &Node) -> Option<Vec<i64>> {
    let elements = node.is_array().then(|| node.elements())?;
    #[expect(
        clippy::cast_possible_truncation,
        reason = "saturates, which is as far out of any range"
    )]
    let whole = |element: &Node| {
        element
            .as_f64()
            .filter(|number| number.fract() == 0.0)
            .map(|number| number as i64)
    };
    Some(elements.iter().filter_map(whole).collect())
}

/// Whether a node is a whole number that is written with a point.
fn is_float(node: &Node) -> bool {
    node.as_i64().is_none() && node.as_f64().is_some_and(|number| number.fract() == 0.0)
}

fn floats(node: &Node) -> Vec<f64> {
    node.elements()
        .iter()
        .filter(|element| is_float(element))
        .filter_map(Node::as_f64)
        .collect()
}

/// An array of integers; elements of other types are left out.
pub(super) fn integers(node: &Node) -> Option<Vec<i64>> {
    let elements = node.is_array().then(|| node.elements())?;
    Some(elements.iter().filter_map(Node::as_i64).collect())
}
