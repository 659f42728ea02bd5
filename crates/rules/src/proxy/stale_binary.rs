//! The archive of an asset is that of its text.

use super::super::{Check, Rule, RuleCx};
use super::{Archive, Text, archives, listed, packed_proxy, rebuild, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Grouped, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::mhclo::{Clothes, Scanned};
use mhlint_formats::packed::asset::PackedAsset;
use mhlint_formats::python_int;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "loads the archive unless the text is newer; until then the text has no effect",
        ),
        (
            Makehuman1,
            "loads the archive unless the text is newer; until then the text has no effect",
        ),
    ],
    docs: include_str!("stale_binary.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-stale-binary",
        Level::Warning,
        "a packed asset differs from its text",
    )
});

/// The binary still has the identity of the asset that it was copied with.
const COPY: Case = &[(
    Makehuman2,
    Level::Error,
    "lists the archive, unless the text is newer, and of two assets with the same name and uuid \
        only one",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_makehuman1() {
        return out.extend(
            body.worn
                .iter()
                .filter_map(|worn| packed_proxy::finding(&RULE, body, worn)),
        );
    }
    let known = identities(body);
    for archive in archives(body) {
        let Some(text) = archive.text.filter(|text| !text.reading.stops()) else {
            continue;
        };
        let kinds = kinds(&archive, &text);
        if kinds.is_empty() {
            continue;
        }
        let message = format!(
            "differs from `{}`: {}",
            text.file.file_name(),
            listed(&kinds)
        );
        let finding = RULE
            .at(archive.file, Place::File, message)
            .parts(kinds.iter().copied());
        let finding = finding.related(
            text.file.path.clone(),
            Place::File,
            "the `.mhclo` or `.proxy`",
        );
        let other = known
            .get(&identity(archive.asset))
            .into_iter()
            .flatten()
            .copied()
            .find(|other| *other != text.file.path);
        let finding = match other {
            Some(other) => finding.case(COPY).related(
                other.to_owned(),
                Place::File,
                "has the same name and uuid",
            ),
            None => finding,
        };
        out.push(finding.help(rebuild(true)));
    }
}

type Identity<'v> = (&'v str, &'v str);

fn identity(asset: &PackedAsset) -> Identity<'_> {
    let [name, uuid, ..] = &asset.texts;
    (name, uuid)
}

/// The texts by name and uuid.
fn identities<'v>(body: &Body<'v>) -> Grouped<Identity<'v>, &'v str> {
    let known = texts(body).filter_map(|text| {
        let Scanned { name, uuid, .. } = &text.clothes.scanned;
        Some((
            (&*name.as_ref()?.text, &*uuid.as_ref()?.text),
            text.file.path.as_str(),
        ))
    });
    grouped(known)
}

/// Everything that differs.
fn kinds(archive: &Archive<'_, '_>, text: &Text<'_, '_>) -> Vec<&'static str> {
    let (asset, clothes) = (archive.asset, text.clothes);
    let value = |keyword: &str| clothes.last(keyword).map_or("", |entry| &*entry.value);
    let word = |keyword: &str| clothes.last(keyword).map_or("", |entry| entry.word());
    let [name, uuid, ..] = &asset.texts;
    let [material, weights] = &asset.files;
    let mesh = text
        .worn
        .mesh()
        .filter(|(_, mesh)| mesh.is_sound())
        .map(|(_, mesh)| mesh.print);
    let differs = [
        (
            "name",
            clothes.last("name").is_some() && **name != *value("name"),
        ),
        ("uuid", **uuid != *value("uuid")),
        ("material", **material != *word("material")),
        ("bone weights", **weights != *word("vertexboneweights_file")),
        ("z_depth", asset.z_depth != depth(text)),
        ("vertex rows", has_other_rows(archive, clothes)),
        ("scale", has_other_scale(archive, clothes)),
        (
            "hidden vertices",
            packed_proxy::has_other_mask(archive.asset.mask.as_ref(), &archive.asset.rows, clothes),
        ),
        (
            "mesh",
            mesh.is_some_and(|mesh| {
                mesh.vertices != asset.print.vertices || mesh.has_other_corners(&asset.print)
            }),
        ),
    ];
    differs
        .into_iter()
        .filter(|(_, differs)| *differs)
        .map(|(kind, _)| kind)
        .collect()
}

fn depth(text: &Text<'_, '_>) -> i64 {
    let written = text
        .reading
        .last("z_depth")
        .and_then(|entry| python_int(entry.word().as_bytes()));
    if text.worn.is_topology() {
        1
    } else {
        written.unwrap_or(50)
    }
}

fn has_other_rows(archive: &Archive<'_, '_>, clothes: &Clothes) -> bool {
    let (packed, text) = (&archive.asset.rows, &clothes.rows);
    // Rows that cannot be used have a finding of their own.
    if packed.count != archive.asset.print.vertices || packed.out_of_range.count > 0 {
        return false;
    }
    let ([all, first], [own, own_first]) = (packed.prints, text.prints);
    packed.count != text.count
        || if archive.asset.is_exact {
            first != own_first
        } else {
            all != own
        }
}

/// Without three usable distances no scale is packed.
fn has_other_scale(archive: &Archive<'_, '_>, clothes: &Clothes) -> bool {
    let [x, y, z] = clothes
        .scales
        .map(|scale| scale.filter(|scale| scale.distance >= 0.01));
    let written = x
        .zip(y)
        .zip(z)
        .map(|((x, y), z)| [x, y, z].map(|scale| (scale.vertices, scale.distance)));
    let packed = archive
        .asset
        .scale
        .map(|axes| axes.map(|(a, b, distance)| ([a, b], distance)));
    written != packed
}
