//! What each kind of case computes. Kinds are those of the reference files of MakeHuman 2.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Map, Value};

use super::inputs::{self, File};
use super::roots::Roots;
use crate::discover::kind_of;
use crate::engine::evaluate::outputs::{
    fit_json, mesh_json, skeleton_json, skin_json, weight_lists_json, weights_json,
};
use crate::engine::evaluate::weights::{WeightLists, read_weights, transferred};
use crate::engine::evaluate::{Error, Evaluation, pose, read_asset, read_skeleton};
use crate::eval::vector::Point;
use crate::formats::mhw;
use crate::json::{Node, Value as Json};

type Outputs = Map<String, Value>;

#[derive(Clone, Copy)]
enum Kind {
    Macros,
    Morph,
    Joints,
    Weights,
    Transfer,
    Skinning,
    Fit,
}

const KINDS: [(&str, Kind); 7] = [
    ("mh2_macro_weights", Kind::Macros),
    ("mh2_morph", Kind::Morph),
    ("mh2_joints", Kind::Joints),
    ("mh2_weights", Kind::Weights),
    ("mh2_weights_transfer", Kind::Transfer),
    ("mh2_skinning", Kind::Skinning),
    ("mh2_fit", Kind::Fit),
];

/// Computes the cases of one file; bases are opened once.
pub(super) struct Computer<'a> {
    roots: &'a Roots,
    file: &'a Node,
    kind: Kind,
    bases: BTreeMap<Option<String>, Result<Evaluation, Error>>,
}

impl<'a> Computer<'a> {
    pub(super) fn new(roots: &'a Roots, file: &File<'a>) -> Result<Self, Error> {
        let known = KINDS.iter().find(|(name, _)| *name == file.kind);
        let unknown = || {
            let names: Vec<&str> = KINDS.iter().map(|(name, _)| *name).collect();
            Error::Input(format!("cases of kind `{}` are not supported yet (known: {})", file.kind, names.join(", ")))
        };
        let (_, kind) = known.ok_or_else(unknown)?;
        Ok(Self { roots, file: file.root, kind: *kind, bases: BTreeMap::new() })
    }

    pub(super) fn outputs(&mut self, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
        match self.kind {
            Kind::Macros => self.macros(case, notes),
            Kind::Morph => self.morph(case, notes),
            Kind::Joints => self.joints(case, notes),
            Kind::Weights => self.weights(case),
            Kind::Transfer => self.transfer(case),
            Kind::Skinning => self.skinning(case, notes),
            Kind::Fit => self.fit(case, notes),
        }
    }

    /// The base that a case names, or else the file; without one the only base, or the only one with macros.
    fn base(&mut self, case: &Node) -> Result<&mut Evaluation, Error> {
        let common = || self.file.get("inputs").and_then(|inputs| inputs.get("base"));
        let name = inputs::field(case, "base").or_else(common).and_then(Node::as_str);
        self.base_called(name)
    }

    fn base_called(&mut self, name: Option<&str>) -> Result<&mut Evaluation, Error> {
        let data = self.roots.data()?;
        let opened = self.bases.entry(name.map(str::to_owned)).or_insert_with(|| open(&data, name));
        opened.as_mut().map_err(|error| error.clone())
    }

    fn macros(&mut self, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
        let modifiers = inputs::modifiers(case)?.unwrap_or_default();
        let base = self.base(case)?;
        let (setting, unknown) = base.model_setting(&modifiers);
        note_unknown(unknown, notes);
        let (table, result) = base.macros(&setting)?;
        Ok(base.macro_outputs(table, &result))
    }

    fn morph(&mut self, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
        let (file, modifiers) = (self.file, inputs::modifiers(case)?);
        let base = self.base(case)?;
        let positions = morphed(base, modifiers, notes)?;
        let mut outputs = mesh_json(&positions, &inputs::vertex_ids(file, case, base.base())?)?;
        outputs.insert("bbox_upstream".to_owned(), base.visible_box(&positions));
        Ok(outputs)
    }

    fn joints(&mut self, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
        let rig = self.roots.file(inputs::text(case, "rig")?)?;
        let modifiers = inputs::modifiers(case)?;
        let positions = morphed(self.base(case)?, modifiers, notes)?;
        Ok(skeleton_json(&read_skeleton(&rig)?.rest(&positions)?))
    }

    fn weights(&mut self, case: &Node) -> Result<Outputs, Error> {
        let root = inputs::text(case, "root")?;
        let count = inputs::count(case, "vertex_count")?;
        if let Some(lists) = inputs::field(case, "weights").filter(|lists| lists.as_str().is_none()) {
            return Ok(weight_lists_json(&inline(lists)?.load(root, count)?));
        }
        let written = inputs::text(case, "file")?;
        let path = self.roots.file(written)?;
        let weights = if is_asset(&path) {
            let asset = read_asset(&path)?;
            // Assets of MakeHuman 2 lie in a folder of their base; others say nothing about it.
            let named = inputs::field(case, "base").and_then(Node::as_str).map(str::to_owned);
            let base = named.or_else(|| kind_of(written.strip_prefix("data/")?).1.map(str::to_owned));
            asset.derived_weights(self.base_called(base.as_deref())?, root)?
        } else {
            read_weights(&path)?.load(root, count)?
        };
        let mut outputs = weights_json(&weights, count, &inputs::weighted_vertices(case))?;
        outputs.remove("vertex_sum_range");
        Ok(outputs)
    }

    fn transfer(&mut self, case: &Node) -> Result<Outputs, Error> {
        let other = read_skeleton(&self.roots.file(inputs::text(case, "rig")?)?)?;
        let written = inputs::text(case, "weights")?;
        let path = self.roots.file(written)?;
        let named = inputs::field(case, "base").and_then(Node::as_str);
        let base = named.or_else(|| written.strip_prefix("data/rigs/")?.split('/').next());
        let base = self.base_called(base)?;
        let default = base.pose_skeleton()?.clone();
        let vertices = base.scene().positions.len();
        let count =
            if inputs::field(case, "vertex_count").is_some() { inputs::count(case, "vertex_count")? } else { vertices };
        let loaded = read_weights(&path)?.load(default.root()?, count)?;
        let (moved, _) = transferred(&loaded, &default, &other)?;
        weights_json(&moved, count, &inputs::weighted_vertices(case))
    }

    fn skinning(&mut self, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
        let (file, modifiers) = (self.file, inputs::modifiers(case)?);
        let poses = pose::poses(inputs::wanted(case, "poses")?).map_err(Error::Input)?;
        let base = self.base(case)?;
        let positions = morphed(base, modifiers, notes)?;
        skin_json(&base.posed(&positions, &poses)?, &inputs::vertex_ids(file, case, base.base())?)
    }

    fn fit(&mut self, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
        let (file, modifiers) = (self.file, inputs::modifiers(case)?);
        let asset = read_asset(&self.roots.file(inputs::text(case, "file")?)?)?;
        let is_proxy = match inputs::field(case, "type").and_then(Node::as_str) {
            Some(category) => category == "proxy",
            None => asset.is_proxy(),
        };
        let attached = inputs::field(case, "attached").and_then(Node::as_str).unwrap_or("same mesh");
        let base = self.base(case)?;
        let positions = morphed(base, modifiers, notes)?;
        let measured = match attached {
            "before the morph" => base.scene().positions.as_slice(),
            "after the morph" | "same mesh" => positions.as_slice(),
            other => return Err(Error::Input(format!("`attached` is neither before nor after the morph: `{other}`"))),
        };
        let fitted = asset.fit(&positions, measured, is_proxy)?;
        let mut outputs = fit_json(&asset, &fitted, &inputs::vertex_ids(file, case, base.base())?)?;
        if attached != "same mesh" {
            // Counts do not depend on the mesh; the files give them once an asset, on the plain mesh.
            outputs.retain(|key, _| !matches!(key.as_str(), "vertex_count" | "ref_count" | "delete_verts"));
        }
        Ok(outputs)
    }
}

fn open(data: &Path, name: Option<&str>) -> Result<Evaluation, Error> {
    match Evaluation::open(data, None, name) {
        Err(Error::BaseNeeded { known, with_macros }) => match with_macros.as_slice() {
            [only] => Evaluation::open(data, None, Some(only)),
            _ => Err(Error::Input(format!("the case names no base ({})", known.join(", ")))),
        },
        other => other,
    }
}

fn morphed(
    base: &mut Evaluation,
    modifiers: Option<Vec<(String, f64)>>,
    notes: &mut Vec<String>,
) -> Result<Vec<Point>, Error> {
    let Some(modifiers) = modifiers else { return Ok(base.scene().positions.clone()) };
    let (setting, unknown) = base.model_setting(&modifiers);
    note_unknown(unknown, notes);
    base.morphed(&setting)
}

fn note_unknown(unknown: Vec<String>, notes: &mut Vec<String>) {
    notes.extend(unknown.into_iter().map(|name| format!("no slider `{name}`: left out, as MakeHuman 2 does")));
}

fn is_asset(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    matches!(ending.to_ascii_lowercase().as_str(), "mhclo" | "proxy")
}

/// The `weights` object of a weights file that stands in the case itself.
fn inline(node: &Node) -> Result<WeightLists, Error> {
    let stop = |exception, reason: String| Err(Error::Stops { exception, reason });
    if !node.is_object() {
        return stop("AttributeError", "`weights` is no object".to_owned());
    }
    for member in node.effective_members() {
        if let Some((exception, reason)) = member.node.elements().iter().find_map(pair_fault) {
            return stop(exception, format!("bone `{}`: {reason}", member.key));
        }
        if !member.node.is_array() {
            return stop("TypeError", format!("bone `{}` has no list", member.key));
        }
    }
    let mut lists = WeightLists::default();
    for member in node.effective_members() {
        let pairs = (0..).zip(member.node.elements()).filter_map(|(position, pair)| {
            let [vertex, weight] = pair.elements() else { return None };
            let weight = crate::eval::vector::round_to_f32(weight.as_f64()?);
            Some(mhw::Pair { position, vertex: vertex.as_i64()?, weight })
        });
        lists.bones.push((member.key.clone(), pairs.collect()));
    }
    Ok(lists)
}

/// What Python raises over a pair (formats/makehuman2.md §11).
fn pair_fault(pair: &Node) -> Option<(&'static str, &'static str)> {
    match (pair.is_array(), pair.elements()) {
        (false, _) => Some(("TypeError", "an entry is no pair")),
        (true, [vertex, weight]) => {
            if weight.as_f64().is_none() {
                Some(("TypeError", "a weight is no number"))
            } else if matches!(vertex.value, Json::Null | Json::Array(_) | Json::Object(_) | Json::Bool(_)) {
                Some(("TypeError", "a vertex is no number"))
            } else if vertex.as_i64().is_none() {
                Some(("IndexError", "a vertex is no integer"))
            } else {
                None
            }
        }
        (true, _) => Some(("ValueError", "an entry has not two members")),
    }
}
