//! `base.json`: what a base mesh consists of and how its window is set up
//! (`docs/loaders/makehuman2/base.md#keys`).

use std::collections::BTreeSet;

use super::expression::{self, Fault};
use super::macro_json::{text, texts};
use super::modelling::fault_in;
use mhlint_json::{Document, Node};

/// The file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BaseJson {
    /// Groups of the OBJ that are drawn. Without it the program stops.
    pub visible_groups: Option<Vec<String>>,
    /// The same to be looked up.
    pub shown: Option<BTreeSet<String>>,
    /// `visible groups` as a plain text: groups whose name is part of it are drawn.
    pub visible_text: Option<String>,
    /// Whether `visible groups` is there, of whatever type.
    pub has_visible_groups: bool,
    /// Vertex count as claimed.
    pub numverts: Option<i64>,
    /// Whether it is there, whatever it is.
    pub has_numverts: bool,
    /// Pairs of suffixes, negative then positive, in file order.
    pub opposites: Vec<(String, String)>,
    /// Folders of equipment that are offered.
    pub equipment: Option<Vec<String>>,
    /// File name of the skeleton for poses.
    pub pose_skeleton: Option<String>,
    /// File name of the model loaded at start.
    pub mhm: Option<String>,
    /// Pattern and value of sliders at start.
    pub presets: Vec<(String, Option<f64>)>,
    /// Purpose and pattern of the measures shown.
    pub measure: Vec<(String, String)>,
    /// The randomizer.
    pub random: Option<Random>,
    /// Beginnings of groups that belong to the head.
    pub head_pattern: Option<Vec<String>>,
}

impl BaseJson {
    /// Whether a group of the mesh is drawn.
    pub fn shows(&self, group: &str) -> bool {
        self.shown
            .as_ref()
            .is_none_or(|shown| shown.contains(group))
    }
}

/// `random` of a base.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Random {
    /// Suffixes of targets that may be asymmetric.
    pub nonsym: Vec<String>,
    /// Key of the gender slider.
    pub gender: Option<String>,
    /// Key of the proportions slider.
    pub ideal: Option<String>,
    /// `category` or `category|subcategory` and whether it is preselected.
    pub groups: Vec<(String, bool)>,
    /// Slider key to conditions.
    pub rules: Vec<(String, Vec<Condition>)>,
}

/// A condition of a rule of the randomizer.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Condition {
    /// Key of the slider it looks at.
    pub slider: String,
    /// Python expression in `x`.
    pub expression: String,
    /// Why the expression must not or cannot be evaluated; span in the file.
    pub fault: Option<Fault>,
    /// Whether its value can be the one that forbids something: `False`.
    pub can_forbid: bool,
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> BaseJson {
    let root = &document.root;
    BaseJson {
        visible_groups: root.get("visible groups").and_then(texts),
        shown: root
            .get("visible groups")
            .and_then(texts)
            .map(BTreeSet::from_iter),
        visible_text: text(root, "visible groups"),
        has_visible_groups: root.get("visible groups").is_some(),
        has_numverts: root.get("numverts").is_some(),
        numverts: root.get("numverts").and_then(Node::as_i64),
        opposites: text_members(root.get("target-opposites")),
        equipment: root.get("equipment").and_then(texts),
        pose_skeleton: text(root, "pose-skeleton"),
        mhm: text(root, "mhm"),
        presets: root
            .get("modifier-presets")
            .map(presets)
            .unwrap_or_default(),
        measure: text_members(root.get("measure")),
        random: root
            .get("random")
            .filter(|node| node.is_object())
            .map(random),
        head_pattern: root.get("head-pattern").and_then(texts),
    }
}

/// Values go through `float()`, so numbers in quotes count.
fn presets(node: &Node) -> Vec<(String, Option<f64>)> {
    let value = |node: &Node| match node.as_str() {
        Some(text) => super::python_float(text.trim().as_bytes()),
        None => node.as_python_number(),
    };
    let members = node.effective_members().into_iter();
    members
        .map(|member| (member.key.clone(), value(&member.node)))
        .collect()
}

fn random(node: &Node) -> Random {
    let groups = node
        .get("groups")
        .map(Node::effective_members)
        .unwrap_or_default();
    let rules = node
        .get("rules")
        .map(Node::effective_members)
        .unwrap_or_default();
    Random {
        nonsym: node.get("nonsym").and_then(texts).unwrap_or_default(),
        gender: text(node, "gender"),
        ideal: text(node, "ideal"),
        groups: groups
            .into_iter()
            .map(|member| (member.key.clone(), !member.node.is_falsy()))
            .collect(),
        rules: rules
            .into_iter()
            .map(|member| (member.key.clone(), conditions(&member.node)))
            .collect(),
    }
}

fn conditions(node: &Node) -> Vec<Condition> {
    let members = node.effective_members().into_iter();
    members
        .filter_map(|member| {
            let text = member.node.as_str()?;
            Some(Condition {
                slider: member.key.clone(),
                expression: text.to_owned(),
                fault: fault_in(&member.node, |text| expression::check(text, "x")),
                can_forbid: expression::results(text, "x").is_ok_and(|results| results.truth),
            })
        })
        .collect()
}

/// Members of an object whose values are texts.
fn text_members(node: Option<&Node>) -> Vec<(String, String)> {
    let members = node
        .map(Node::effective_members)
        .unwrap_or_default()
        .into_iter();
    members
        .filter_map(|member| Some((member.key.clone(), member.node.as_str()?.to_owned())))
        .collect()
}
