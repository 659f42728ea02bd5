//! Fields of a case, or what is wrong with them.

use crate::{Error, SliderSetting};
use mhlint_json::{Node, Value};

/// A file of cases.
pub(super) struct File<'a> {
    pub(super) kind: &'a str,
    pub(super) root: &'a Node,
    pub(super) cases: &'a [Node],
}

impl<'a> File<'a> {
    pub(super) fn new(path: &str, root: &'a Node) -> Result<Self, Error> {
        let kind = root.get("kind").and_then(Node::as_str);
        let kind = kind.ok_or_else(|| Error::file(path, "it has no `kind`"))?;
        if !root.get("cases").is_some_and(Node::is_array) {
            return Err(Error::file(path, "it has no `cases` list"));
        }
        Ok(Self {
            kind,
            root,
            cases: cases(root),
        })
    }
}

/// The cases of a file.
pub(super) fn cases(root: &Node) -> &[Node] {
    root.get("cases").map(Node::elements).unwrap_or_default()
}

/// Base, rig and name of a case.
pub(super) fn title(case: &Node) -> String {
    // Cases of one input stand as lists that begin with it.
    if let Some(first) = case.elements().first().and_then(Node::as_str) {
        return first.to_owned();
    }
    let text = |key| case.get(key).and_then(Node::as_str);
    let parts: Vec<&str> = [text("base"), text("kind"), text("name")]
        .into_iter()
        .flatten()
        .collect();
    if parts.is_empty() {
        "(unnamed case)".to_owned()
    } else {
        parts.join(" ")
    }
}

/// A field of the `inputs` of a case, or of the case itself.
pub(crate) fn field<'a>(case: &'a Node, key: &str) -> Option<&'a Node> {
    case.get("inputs")
        .and_then(|inputs| inputs.get(key))
        .or_else(|| case.get(key))
}

pub(crate) fn wanted<'a>(case: &'a Node, key: &str) -> Result<&'a Node, Error> {
    field(case, key).ok_or_else(|| Error::Input(format!("the case has no `inputs.{key}`")))
}

pub(crate) fn text<'a>(case: &'a Node, key: &str) -> Result<&'a str, Error> {
    wanted(case, key)?
        .as_str()
        .ok_or_else(|| Error::Input(format!("`{key}` of the case is not a string")))
}

pub(crate) fn count(case: &Node, key: &str) -> Result<usize, Error> {
    let number = wanted(case, key)?
        .as_i64()
        .and_then(|number| usize::try_from(number).ok());
    number.ok_or_else(|| {
        Error::Input(format!(
            "`{key}` of the case is not a whole number, 0 or more"
        ))
    })
}

/// Slider settings; `None` for `null`: the mesh as it is, without even the defaults.
pub(crate) fn modifiers(case: &Node) -> Result<Option<Vec<SliderSetting>>, Error> {
    let node = wanted(case, "modifiers")?;
    if matches!(node.value, Value::Null) {
        return Ok(None);
    }
    let read = crate::settings::modifiers(node);
    read.map(Some)
        .map_err(|reason| Error::Input(format!("`modifiers` of the case: {reason}")))
}

/// The vertices to report: those of the case, or those that the file has for the base.
pub(crate) fn vertex_ids(file: &Node, case: &Node, base: &str) -> Result<Vec<i64>, Error> {
    let common = || {
        let ids = file.get("inputs")?.get("vertex_ids")?;
        if ids.is_array() {
            Some(ids)
        } else {
            ids.get(base)
        }
    };
    let Some(ids) = field(case, "vertex_ids").or_else(common) else {
        return Ok(Vec::new());
    };
    let wrong = || Error::Input("`vertex_ids` of the case is not a list of vertices".to_owned());
    if !ids.is_array() {
        return Err(wrong());
    }
    ids.elements()
        .iter()
        .map(|id| id.as_i64().ok_or_else(wrong))
        .collect()
}

/// The vertices whose weights are reported: those in the outputs that are there.
pub(crate) fn weighted_vertices(case: &Node) -> Vec<i64> {
    let listed = case
        .get("outputs")
        .and_then(|outputs| outputs.get("vertices"))
        .map(Node::elements);
    listed
        .unwrap_or_default()
        .iter()
        .filter_map(|pair| pair.elements().first()?.as_i64())
        .collect()
}
