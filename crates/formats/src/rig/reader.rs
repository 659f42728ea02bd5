//! A document to a rig (`docs/loaders/mpfb/rigs.md#layouts`).

use super::bone::{Whole, names};
use super::{Identifying, LayoutFault, NEWEST, Rig, RigFaults, bone, rigify};
use crate::unfit::{below, is_number};
use mhlint_json::{Document, Node, Value};

/// Keys of the header.
const HEADER: [&str; 8] = [
    "version",
    "is_subrig",
    "scale_factor",
    "collections",
    "extra_bones",
    "rigify_ui",
    "identifying_bones",
    "joints",
];
/// The version of a file without `bones`.
const PLAIN: f64 = 100.0;
/// Bones that are kept; no rig that anybody made has as many.
const MOST: usize = 200_000;

/// Takes what the loader would take. Only one that is added to another rig can name bones of that;
/// both are read alike.
pub fn read(document: &Document) -> Rig {
    let root = &document.root;
    let mut rig = Rig {
        version: PLAIN,
        ..Rig::default()
    };
    if !root.is_object() {
        rig.faults
            .layout
            .push(LayoutFault::NotObject(root.type_word()));
        return rig;
    }
    let bones = root.get("bones");
    rig.has_header = bones.is_some();
    match bones {
        Some(bones) => with_header(root, bones, &mut rig),
        None => plain(root, &mut rig),
    }
    rig.identifying = identifying(root);
    rig
}

/// Each key at the top is a bone.
fn plain(root: &Node, rig: &mut Rig) {
    // A bone can be called like a key of a header, as long as it is one.
    let is_header = |node: &Node, key: &str| HEADER.contains(&key) && node.get("head").is_none();
    let mut faults = RigFaults::default();
    let header = root
        .members()
        .iter()
        .find(|member| is_header(&member.node, &member.key));
    if let Some(header) = header {
        rig.top_keys = root
            .members()
            .iter()
            .take(HEADER.len() * 2)
            .map(|member| member.key.clone())
            .collect();
        faults
            .layout
            .push(LayoutFault::HeaderWithoutBones(header.key.clone()));
    }
    let whole = Whole { has_layers: true };
    // The finding on the header names them all.
    let bones = if header.is_some() {
        Vec::new()
    } else {
        root.effective_members()
    };
    for member in bones.into_iter().take(MOST) {
        rig.bones.push(bone::read(
            &member.key,
            &below("", &member.key),
            &member.node,
            &whole,
            &mut faults,
        ));
    }
    rig.faults = faults;
}

fn with_header(root: &Node, bones: &Node, rig: &mut Rig) {
    let mut faults = RigFaults::default();
    version(root, rig, &mut faults);
    if root.get("joints").is_some() {
        faults.layout.push(LayoutFault::Skeleton);
    }
    rig.is_subrig = root.get("is_subrig").is_some_and(|value| !value.is_falsy());
    if let Some(scale) = root.get("scale_factor") {
        if !is_number(scale) && scale.value != Value::Null {
            faults.keys.add_type("/scale_factor", scale, "a number");
        }
        rig.scale_factor = scale.as_python_number().unwrap_or(0.0);
    }
    let list = |key: &str, faults: &mut RigFaults| {
        root.get(key)
            .filter(|list| !list.is_falsy())
            .map(|list| names(&below("", key), list, faults))
            .unwrap_or_default()
    };
    rig.collections = list("collections", &mut faults);
    rig.extra_bones = list("extra_bones", &mut faults);
    // What a letter for a collection leads to is told at the bones.
    if let Some(text) = root
        .get("extra_bones")
        .filter(|node| node.as_str().is_some_and(|text| text.len() > 1))
    {
        faults
            .letters
            .add_type("/extra_bones", text, "a list of names");
    }
    let panel = root.get("rigify_ui").filter(|panel| !panel.is_falsy());
    rig.has_rigify_ui = panel.is_some();
    if let Some(panel) = panel {
        faults.needs_rigify.push("/rigify_ui".to_owned());
        if !rig.has_layers() {
            rigify::panel(panel, &rig.collections, &mut faults);
        }
    }
    let whole = Whole {
        has_layers: rig.has_layers(),
    };
    if !bones.is_object() && bones.value != Value::Null {
        faults.keys.add_type("/bones", bones, "an object");
    }
    for member in bones.effective_members().into_iter().take(MOST) {
        let bone = bone::read(
            &member.key,
            &below("/bones", &member.key),
            &member.node,
            &whole,
            &mut faults,
        );
        rig.bones.push(bone);
    }
    rig.faults = faults;
}

fn version(root: &Node, rig: &mut Rig, faults: &mut RigFaults) {
    let Some(version) = root.get("version") else {
        rig.version = NEWEST;
        return faults.layout.push(LayoutFault::WithoutVersion);
    };
    match version.as_python_number() {
        None => {
            rig.version = NEWEST;
            faults
                .layout
                .push(LayoutFault::VersionType(version.type_word()));
        }
        Some(number) => {
            rig.version = number;
            if number > NEWEST {
                faults.layout.push(LayoutFault::TooNew(number));
            }
        }
    }
}

fn identifying(root: &Node) -> Identifying {
    match root.get("identifying_bones") {
        None => Identifying::Absent,
        Some(list) if list.is_array() => {
            let name = |one: &Node| {
                one.as_str()
                    .map_or_else(|| one.type_word().to_owned(), str::to_owned)
            };
            Identifying::Bones(list.elements().iter().map(name).collect())
        }
        Some(other) => Identifying::Other(other.type_word()),
    }
}
