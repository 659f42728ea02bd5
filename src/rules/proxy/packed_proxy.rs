//! The archive that MakeHuman 1 makes of something worn (`.mhpxy`), against its text (makehuman1-observed.md 4.8, 4.11).

use super::super::Rule;
use super::listed;
use crate::diag::{Application::Makehuman1, Case, Finding, Level, Place};
use crate::formats::mhbin_asset::Packed;
use crate::formats::mhclo::Clothes;
use crate::formats::mhpxy::PackedProxy;
use crate::formats::python_int;
use crate::repo::{Body, FileFacts, Layer, Worn, parent};

const FOREIGN: Case = &[(Makehuman1, Level::Error, "does not put the asset on, unless the text is newer")];

/// What differs, or that its mesh is not there.
pub(super) fn finding(rule: &Rule, body: &Body<'_>, worn: &Worn<'_>) -> Option<Finding> {
    let file = worn.binary.filter(|file| body.layers.is_checked(file))?;
    let Packed::Proxy(proxy) = file.packed()? else { return None };
    let clothes = worn.clothes().filter(|_| proxy.fault.is_none())?;
    let at = |message: String| {
        let finding = rule.at(file, Place::File, message).related(worn.file.path.clone(), Place::File, "the text");
        finding.help(
            "if the text and its mesh are up to date, delete the `.mhpxy`: the text is read, and in the data of a user \
            MakeHuman 1 packs it again",
        )
    };
    if let Some(message) = unfit(body, file, proxy) {
        return Some(at(message).key("mesh").case(FOREIGN));
    }
    if let Some((_, mesh)) = worn.mesh().filter(|(_, mesh)| mesh.is_sound() && mesh.facts.vertices != proxy.rows.count)
    {
        let message = format!("has {} rows for {} vertices of its mesh", proxy.rows.count, mesh.facts.vertices);
        return Some(at(message).key("mesh").case(FOREIGN));
    }
    let kinds = kinds(proxy, clothes);
    let differs = (!kinds.is_empty()).then(|| format!("differs from `{}`: {}", worn.file.file_name(), listed(&kinds)));
    differs.map(|message| at(message).parts(kinds.iter().copied()))
}

/// Archives without a text that name what is not there.
pub(super) fn lone(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    let layer = body.layers.checked;
    for file in layer.files.values().filter(|file| file.rel.ends_with(".mhpxy")) {
        if layer.text_of_archive(&file.rel).is_some() {
            continue;
        }
        let Some(Packed::Proxy(proxy)) = file.packed() else { continue };
        let message = unfit(body, file, proxy).filter(|_| proxy.fault.is_none());
        let finding = message.map(|message| rule.at(file, Place::File, message).key("mesh").case(FOREIGN));
        out.extend(finding.map(|finding| finding.help("move it back to its folder, or restore what it names")));
    }
}

/// What it names and is not there.
fn unfit(body: &Body<'_>, file: &FileFacts, proxy: &PackedProxy) -> Option<String> {
    let [mesh, _, weights] = &proxy.files;
    if !has_file(body, file, mesh) {
        return Some(format!("its mesh `{mesh}` does not exist: it was packed in another place"));
    }
    let is_lost = !weights.is_empty() && !has_file(body, file, weights);
    is_lost.then(|| format!("its bone weights `{weights}` do not exist"))
}

/// Names lead on from the folder of the archive, then from the data of the user and of the system; a packed mesh does as well.
fn has_file(body: &Body<'_>, file: &FileFacts, mesh: &str) -> bool {
    let rel = format!("{}/{mesh}", parent(&file.rel));
    let is_there = |layer: &Layer, rel: &str| {
        let packed = rel.rsplit_once('.').map(|(stem, _)| format!("{stem}.npz"));
        layer.file(rel).is_some() || packed.is_some_and(|packed| layer.file(&packed).is_some())
    };
    // What leads up is not followed here.
    mesh.contains("..")
        || is_there(body.layers.checked, &rel)
        || body.layers.strongest_first().any(|layer| is_there(layer, mesh))
}

/// Everything that differs.
fn kinds(proxy: &PackedProxy, clothes: &Clothes) -> Vec<&'static str> {
    let last = |keyword: &str| clothes.all(keyword).rev().find(|entry| !entry.has_colon);
    let value = |keyword: &str| last(keyword).map_or("", |entry| &*entry.value);
    let word = |keyword: &str| last(keyword).map_or("", |entry| entry.word());
    let ([name, uuid], [mesh, material, weights]) = (&proxy.identity, &proxy.files);
    let depth = last("z_depth").and_then(|entry| python_int(entry.word().as_bytes()));
    let file_name = |path: &str| path.rsplit(['/', '\\']).next().unwrap_or_default().to_owned();
    let differs = [
        ("name", last("name").is_some() && **name != *value("name")),
        ("uuid", **uuid != *value("uuid")),
        // Paths are written in another way.
        ("mesh", file_name(mesh) != file_name(word("obj_file"))),
        ("material", file_name(material) != file_name(word("material"))),
        ("bone weights", file_name(weights) != file_name(word("vertexboneweights_file"))),
        ("z_depth", depth.is_some_and(|depth| depth >= 0 && depth != proxy.z_depth)),
        ("scale", has_other_scale(proxy, clothes)),
        ("vertex rows", has_other_rows(proxy, clothes)),
        ("hidden vertices", has_other_mask(proxy, clothes)),
    ];
    differs.into_iter().filter(|(_, differs)| *differs).map(|(kind, _)| kind).collect()
}

fn has_other_rows(proxy: &PackedProxy, clothes: &Clothes) -> bool {
    let (packed, text) = (&proxy.rows, &clothes.rows);
    let ([all, first], [own, own_first]) = (packed.prints, text.prints);
    packed.count != text.count || if proxy.is_exact { first != own_first } else { all != own }
}

fn has_other_scale(proxy: &PackedProxy, clothes: &Clothes) -> bool {
    let written = clothes.scales.map(|scale| scale.map(|scale| (scale.vertices, scale.distance)));
    // Without all three nothing can be fitted, which has a finding of its own.
    written.iter().all(Option::is_some) && written != proxy.scale
}

fn has_other_mask(proxy: &PackedProxy, clothes: &Clothes) -> bool {
    let length = proxy.mask.as_ref().map(|(length, _)| *length).or(proxy.rows.mesh.map(|mesh| mesh.vertices));
    let Some(vertices) = length else { return false };
    let runs = proxy.mask.as_ref().map(|(_, runs)| runs.as_slice()).unwrap_or_default();
    clothes.merged_deletes(vertices) != runs
}
