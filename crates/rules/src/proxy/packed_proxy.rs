//! The archive that MakeHuman 1 makes of something worn (`.mhpxy`), against its text
//! (`docs/loaders/makehuman1/compiled-clothes.md#when-it-is-read`).

use super::super::Rule;
use super::{Lone, listed};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place};
use mhlint_formats::mhclo::{Clothes, RowFacts, makehuman1};
use mhlint_formats::packed::asset::{Mask, Packed};
use mhlint_formats::packed::proxy::PackedProxy;
use mhlint_formats::python_int;
use mhlint_repo::makehuman1::{named_by_archive, narrow_mesh};
use mhlint_repo::{Body, FileFacts, Reference, ReferenceKind, Resolution, Worn};

const FOREIGN: Case = &[(
    Makehuman1,
    Level::Error,
    "does not put the asset on, unless the text is newer",
)];

/// What differs, or that its mesh is not there.
pub(super) fn finding<'v>(rule: &Rule, body: &Body<'v>, worn: &Worn<'v>) -> Option<Finding> {
    let file = worn.binary.filter(|file| body.layers.is_checked(file))?;
    let proxy = Packed::proxy_of(file.packed())?;
    let clothes = worn.clothes()?;
    let at = |message: String| {
        let finding = rule.at(file, Place::File, message).related(
            worn.file.path.clone(),
            Place::File,
            "the text",
        );
        finding.help(
            "if the text and its mesh are up to date, delete the `.mhpxy`: the text is read, and \
             in the data of a user MakeHuman 1 packs it again",
        )
    };
    if let Some(message) = unfit(body, file) {
        return Some(at(message).key("mesh").case(FOREIGN));
    }
    if let Some((_, mesh)) = worn
        .mesh()
        .filter(|(_, mesh)| mesh.is_sound() && mesh.facts.vertices != proxy.rows.count)
    {
        let message = format!(
            "has {} rows for {} vertices of its mesh",
            proxy.rows.count, mesh.facts.vertices
        );
        return Some(at(message).key("mesh").case(FOREIGN));
    }
    // What the text does not find either is told of that.
    let has_material = worn
        .reference(ReferenceKind::AssetMaterial)
        .is_some_and(|one| one.found().is_some());
    let is_bare = has_material && missing(body, file, ReferenceKind::AssetMaterial).is_some();
    // A text whose offsets would be lost has a finding of its own where it is packed anew.
    let is_cut = body.layers.checks_system() && proxy.is_exact && clothes.rows.has_offsets;
    let mut kinds = kinds(proxy, clothes);
    kinds.extend((is_bare && !kinds.contains(&"material")).then_some("material"));
    kinds.extend(is_cut.then_some("offsets"));
    let differs = (!kinds.is_empty()).then(|| {
        format!(
            "differs from `{}`: {}",
            worn.file.file_name(),
            listed(&kinds)
        )
    });
    differs.map(|message| at(message).parts(kinds.iter().copied()))
}

/// What it names and is not there.
fn unfit<'v>(body: &Body<'v>, file: &'v FileFacts) -> Option<String> {
    let missing = |kind| missing(body, file, kind);
    let mesh = missing(ReferenceKind::AssetMesh)
        .map(|mesh| format!("its mesh `{mesh}` does not exist: it was packed in another place"));
    mesh.or_else(|| {
        Some(format!(
            "its bone weights `{}` do not exist",
            missing(ReferenceKind::AssetWeights)?
        ))
    })
}

/// The name of a file in it that is not there.
fn missing<'v>(body: &Body<'v>, file: &'v FileFacts, kind: ReferenceKind) -> Option<&'v str> {
    let mut named = named_by_archive(body.layers, file)?
        .into_iter()
        .filter(|one| one.kind == kind);
    named
        .find(|one| matches!(one.resolution, Resolution::Missing))
        .map(|one| one.text)
}

/// Everything that differs.
fn kinds(proxy: &PackedProxy, clothes: &Clothes) -> Vec<&'static str> {
    let reading = makehuman1::READER.of(clothes);
    let last = |keyword: &str| reading.last(keyword);
    let value = |keyword: &str| last(keyword).map_or("", |entry| &*entry.value);
    let word = |keyword: &str| last(keyword).map_or("", |entry| entry.word());
    let ([name, uuid], [mesh, material, weights]) = (&proxy.identity, &proxy.files);
    let depth = last("z_depth").and_then(|entry| python_int(entry.word().as_bytes()));
    let file_name = |path: &str| {
        path.rsplit(['/', '\\'])
            .next()
            .unwrap_or_default()
            .to_owned()
    };
    let differs = [
        ("name", last("name").is_some() && **name != *value("name")),
        ("uuid", **uuid != *value("uuid")),
        // Paths are written in another way.
        ("mesh", file_name(mesh) != file_name(word("obj_file"))),
        (
            "material",
            file_name(material) != file_name(word("material")),
        ),
        (
            "bone weights",
            file_name(weights) != file_name(word("vertexboneweights_file")),
        ),
        (
            "z_depth",
            depth.is_some_and(|depth| depth >= 0 && depth != proxy.z_depth),
        ),
        ("scale", has_other_scale(proxy, clothes)),
        ("vertex rows", has_other_rows(proxy, clothes)),
        (
            "hidden vertices",
            has_other_mask(proxy.mask.as_ref(), &proxy.rows, clothes),
        ),
    ];
    differs
        .into_iter()
        .filter(|(_, differs)| *differs)
        .map(|(kind, _)| kind)
        .collect()
}

fn has_other_rows(proxy: &PackedProxy, clothes: &Clothes) -> bool {
    let (packed, text) = (&proxy.rows, &clothes.rows);
    let ([all, first], [own, own_first]) = (packed.prints, text.prints);
    packed.count != text.count
        || if proxy.is_exact {
            text.has_shares || first != own_first
        } else {
            all != own
        }
}

fn has_other_scale(proxy: &PackedProxy, clothes: &Clothes) -> bool {
    let written = clothes
        .scales
        .map(|scale| scale.map(|scale| (scale.vertices, scale.distance)));
    // Without all three nothing can be fitted, which has a finding of its own.
    written.iter().all(Option::is_some) && written != proxy.scale
}

/// Whether an archive hides other vertices than its text.
pub(super) fn has_other_mask(mask: Option<&Mask>, rows: &RowFacts, clothes: &Clothes) -> bool {
    let vertices = mask
        .map(|mask| mask.length)
        .or(rows.mesh.map(|mesh| mesh.vertices));
    let runs = mask.map(|mask| mask.runs.as_slice()).unwrap_or_default();
    vertices.is_some_and(|vertices| clothes.merged_deletes(vertices) != runs)
}

/// The mesh of an archive that is all there is of an asset: the archive was packed elsewhere, or
/// its mesh has no room.
pub(super) fn mesh(rule: &Rule, body: &Body<'_>, archive: &Lone<'_, '_>) -> Option<Finding> {
    let reference = archive.worn.reference(ReferenceKind::AssetMesh)?;
    if archive.has_moved() {
        let text = reference.text;
        let message =
            format!("mesh `{text}` of the archive does not exist: it was packed in another place");
        let finding = rule.at(archive.file, Place::File, message).key(text);
        return Some(finding.help("move the archive back to its folder, or restore the mesh"));
    }
    // An OBJ is read in place of an archive that does not do.
    let is_packed = reference
        .found()
        .is_some_and(|found| found.packed().is_some());
    if is_packed {
        without_room(rule, body, archive.worn, reference)
    } else {
        None
    }
}

/// The archive of a mesh that cannot be used, where there is no OBJ to be read instead.
pub(super) fn without_room(
    rule: &Rule,
    body: &Body<'_>,
    worn: &Worn<'_>,
    reference: &Reference<'_>,
) -> Option<Finding> {
    let (packed, kept, asked) = narrow_mesh(body.layers, worn)?;
    let (text, name, columns) = (reference.text, packed.file_name(), kept.columns);
    let message = format!(
        "mesh `{text}` does not exist, and `{name}` has room for {columns} faces at a vertex, not \
            for {asked}"
    );
    let finding = rule
        .at(worn.file, reference.place.clone(), message)
        .key(text);
    Some(
        finding
            .related(packed.path.clone(), Place::File, "the packed mesh")
            .help("restore the OBJ"),
    )
}
