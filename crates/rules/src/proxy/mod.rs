//! Assets that are worn: `.mhclo` and `.proxy` with what they name, as MakeHuman 2 loads them
//! (`docs/loaders/makehuman2/clothes.md#keywords`).

mod archives;
mod blender;
mod companion_weights;
mod custom_weights;
mod degenerate_triple;
mod delete_list_lost;
mod delete_range;
mod deprecated_keyword;
mod extension_case;
mod fit_drift;
mod foreign;
mod hides_body;
mod keyword_after_verts;
mod keyword_spelling;
mod keywords;
mod label_clash;
mod licence_keyword;
mod licence_lost;
mod licence_unrecognised;
mod mask_length;
mod mask_uncovered;
mod metadata;
mod missing;
mod missing_material;
mod missing_mesh;
mod missing_name;
mod missing_uuid;
mod missing_weights;
mod non_finite;
mod offsets_lost;
mod packed_proxy;
mod ranges_before_verts;
mod rows_reordered;
mod scale;
mod scale_lines;
mod scale_vertices;
mod section_keyword;
mod sections;
mod shear;
mod shifted_rows;
mod special_pose;
mod stale_binary;
mod syntax;
mod tag;
mod topology;
mod unknown_basemesh;
mod unknown_keyword;
mod uvlayer;
mod version;
mod vertex_count;
mod vertex_out_of_range;
mod weight_table_short;
mod weights_sum;
mod z_depth;

use super::Rule;
use mhlint_source::parent;
use std::fmt::Display;
use std::ops::RangeInclusive;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &companion_weights::RULE,
    &custom_weights::RULE,
    &degenerate_triple::RULE,
    &delete_range::RULE,
    &deprecated_keyword::RULE,
    &extension_case::RULE,
    &fit_drift::RULE,
    &hides_body::RULE,
    &keyword_after_verts::RULE,
    &keyword_spelling::RULE,
    &licence_keyword::RULE,
    &licence_lost::RULE,
    &mask_length::RULE,
    &mask_uncovered::RULE,
    &metadata::RULE,
    &missing_material::RULE,
    &missing_mesh::RULE,
    &missing_name::RULE,
    &missing_uuid::RULE,
    &missing_weights::RULE,
    &non_finite::RULE,
    &offsets_lost::RULE,
    &rows_reordered::RULE,
    &scale::RULE,
    &section_keyword::RULE,
    &shifted_rows::RULE,
    &special_pose::RULE,
    &stale_binary::RULE,
    &syntax::RULE,
    &tag::RULE,
    &topology::RULE,
    &unknown_basemesh::RULE,
    &unknown_keyword::RULE,
    &uvlayer::RULE,
    &version::RULE,
    &vertex_count::RULE,
    &vertex_out_of_range::RULE,
    &weight_table_short::RULE,
    &weights_sum::RULE,
    &z_depth::RULE,
    &delete_list_lost::RULE,
    &label_clash::RULE,
    &licence_unrecognised::RULE,
    &ranges_before_verts::RULE,
];

use archives::{Archive, Lone, archives, lone_archives, rebuild};

use super::such;
use mhlint_diag::{
    Application::{self, Makehuman1, Makehuman2},
    Case, Evidence, Level,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::worn::{Numbering, WornMeasure};
use mhlint_formats::mhclo::{Clothes, Entry, Fault, Reading, Scale};
use mhlint_formats::target::MeshSize;
use mhlint_repo::{Body, FileFacts, Reference, Resolution, Worn, worn_reader};

/// An asset of the checked layer with its text.
#[derive(Clone, Copy)]
struct Text<'b, 'v> {
    /// Whose body wears it.
    application: Application,
    worn: &'b Worn<'v>,
    file: &'v FileFacts,
    clothes: &'v Clothes,
    /// What the application takes of it.
    reading: Reading<'v>,
}

/// The assets of the checked layer of which the text can be relied on. A file of something else has
/// one finding.
fn texts<'b, 'v>(body: &'b Body<'v>) -> impl Iterator<Item = Text<'b, 'v>> {
    all_texts(body).filter(Text::is_asset)
}

/// Those of something else as well.
fn all_texts<'b, 'v>(body: &'b Body<'v>) -> impl Iterator<Item = Text<'b, 'v>> {
    let own = body
        .worn
        .iter()
        .filter(|worn| body.layers.is_checked(worn.file));
    let application = body.application();
    own.filter_map(move |worn| {
        let clothes = worn.clothes()?;
        Some(Text {
            application,
            worn,
            file: worn.file,
            clothes,
            reading: worn_reader(application).of(clothes),
        })
    })
}

impl<'v> Text<'_, 'v> {
    /// Whether any line has a keyword of assets.
    fn is_asset(&self) -> bool {
        self.clothes.entries.iter().any(keywords::is_known)
    }

    /// Whether a byte order mark hides the keyword of the first line; that has a finding of its
    /// own.
    fn has_hidden(&self, keyword: &str) -> bool {
        let first = self
            .clothes
            .entries
            .first()
            .filter(|_| self.file.encoding.byte_order_mark);
        first.is_some_and(|entry| entry.keyword.trim_start_matches('\u{feff}') == keyword)
    }

    /// A line that is meant to have this keyword and has it spelt in another way, or without a
    /// value.
    fn misspelt(&self, keyword: &str) -> Option<&'v Entry> {
        self.clothes
            .entries
            .iter()
            .find(|entry| keywords::meant_in(self.application, entry) == Some(keyword))
    }

    /// The rows are those of the base mesh as it is: nothing keeps them from being counted against
    /// it.
    fn size_of_base(&self, body: &Body<'_>) -> Option<MeshSize> {
        let size = body.whole_mesh()?.size();
        (self.clothes.rows.mesh == Some(size)).then_some(size)
    }

    /// Whether `MakeHuman` 1 wears it, which reads some lines otherwise than its successor.
    fn is_makehuman1(&self) -> bool {
        self.application == Makehuman1
    }

    /// A vertex of the asset, with its group in the mesh.
    fn vertex(&self, vertex: impl TryInto<u32> + Display + Copy) -> String {
        self.worn.mesh().map_or_else(
            || format!("vertex {vertex}"),
            |(_, mesh)| mesh.named(vertex),
        )
    }
}

/// The assets whose rows fit the mesh, with what was measured of them.
fn measured<'b, 'v>(
    body: &'b Body<'v>,
    measures: &'b Measures,
) -> impl Iterator<Item = (Text<'b, 'v>, &'b WornMeasure)> {
    let sound = texts(body).filter(|text| !text.reading.stops());
    sound.filter_map(|text| Some((text, measures.worn.get(&text.file.path)?)))
}

/// Times that two vertices are as far apart as a scale line says, as figures differ: beyond them
/// the line was written for other vertices or in another unit.
const USUAL_SHARE: RangeInclusive<f32> = 0.2..=5.0;
/// The same where nothing else that is wrong with a shape is looked for in its rows.
const SOUND_SHARE: RangeInclusive<f32> = 0.5..=2.0;

/// How far the vertices of a scale line are apart on the base mesh, along its axis.
fn apart(body: &Body<'_>, axis: usize, scale: &Scale) -> Option<f32> {
    let mesh = body.whole_mesh().filter(|_| body.doubt.is_none())?;
    let at = |vertex: i64| {
        mesh.positions
            .get(usize::try_from(vertex).ok()?)?
            .get(axis)
            .copied()
    };
    let [one, other] = scale.vertices;
    Some((at(one)? - at(other)?).abs())
}

/// Whether `proxy-scale` reports the distances.
fn is_told_by_scale(body: &Body<'_>, text: &Text<'_, '_>) -> bool {
    shares(body, text).any(|share| !USUAL_SHARE.contains(&share))
}

/// How many times as far apart as they say the vertices of the scale lines are.
fn shares(body: &Body<'_>, text: &Text<'_, '_>) -> impl Iterator<Item = f32> {
    let scales = text
        .clothes
        .scales
        .iter()
        .enumerate()
        .filter_map(|(axis, scale)| Some((axis, scale.as_ref()?)));
    scales.filter_map(|(axis, scale)| Some(apart(body, axis, scale)? / scale.distance))
}

/// Whether a scale line says another distance than its vertices have: then all offsets are wrong,
/// and the rows are not.
fn is_scaled_wrongly(body: &Body<'_>, text: &Text<'_, '_>) -> bool {
    shares(body, text).any(|share| !SOUND_SHARE.contains(&share))
}

/// The help where another numbering gives the shape that was drawn.
const fn numbering(numbering: Numbering) -> &'static str {
    match numbering {
        Numbering::Reversed => {
            "the rows are in reverse order: with the last one first the asset has the shape of \
                its OBJ"
        }
        Numbering::RowBefore => {
            "the rows are one behind: if the first one is moved to the end, the asset has the \
                shape of its OBJ"
        }
        Numbering::RowBehind => {
            "the rows are one ahead: if the last one is moved to the beginning, the asset has the \
                shape of its OBJ"
        }
        Numbering::OneLess => {
            "the rows count the vertices of the base mesh from 1: with every number one less the \
                asset has the shape of its OBJ"
        }
        Numbering::OneMore => {
            "the vertices in the rows are one too low: with every number one more the asset has \
                the shape of its OBJ"
        }
    }
}

/// Names of the files of a sort beside the asset, as it would write them.
fn neighbours<'v>(body: &Body<'v>, text: &Text<'_, '_>, extension: &str) -> Vec<&'v str> {
    let folder = parent(&text.file.rel);
    // In the folder of a library, or of the base mesh in it, lie the files of all assets.
    let levels = if text.is_makehuman1() { 1 } else { 2 };
    if folder.matches('/').count() < levels {
        return Vec::new();
    }
    let beside = body.layers.checked.below(folder).take(NEIGHBOURS);
    let own = beside.filter(|file| mhlint_discover::extension(&file.rel) == extension);
    own.filter_map(|file: &FileFacts| file.rel.strip_prefix(folder)?.strip_prefix('/'))
        .collect()
}

/// Files of a folder that are looked at for a name: among more of them nobody finds one that was
/// mistyped.
const NEIGHBOURS: usize = 300;

/// Whether what is named cannot be walked: a broken link, or a folder without permission, has a
/// finding of its own.
fn is_unwalked(body: &Body<'_>, reference: &Reference<'_>) -> bool {
    let has_fault = || {
        body.layers
            .strongest_first()
            .any(|layer| layer.has_fault(&reference.rel))
    };
    matches!(reference.resolution, Resolution::Unusable) && has_fault()
}

/// The keywords of a scale.
const AXES: [&str; 3] = ["x_scale", "y_scale", "z_scale"];

/// How many lines have a fault, with the first of them.
fn lines(faults: &[&Fault], count: u64) -> Evidence {
    let told = Evidence::of_unnamed(faults.iter().map(|fault| format!("line {}", fault.line)));
    Evidence { count, ..told }
}

/// ` (3 lines)` behind a message on the first of several.
fn more(count: u64) -> String {
    such(count, "lines")
}

pub(super) const STOPS_WITH_VALUE: &str =
    "crashes with `ValueError` when the asset is put on; models that wear it load only in part";
pub(super) const STOPS_WITH_INDEX: &str =
    "crashes with `IndexError` when the asset is put on; models that wear it load only in part";
pub(super) const STOPS_WITH_OVERFLOW: &str =
    "crashes with `OverflowError` when the asset is put on; models that wear it load only in part";

const VALUE: Case = &[
    (Makehuman2, Level::Error, STOPS_WITH_VALUE),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: `ValueError` when it reads the file",
    ),
];
const INDEX: Case = &[
    (Makehuman2, Level::Error, STOPS_WITH_INDEX),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: `IndexError`",
    ),
];
const OVERFLOW: Case = &[
    (Makehuman2, Level::Error, STOPS_WITH_OVERFLOW),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: no vertex has this number",
    ),
];

/// Words one after the other.
fn listed(kinds: &[&str]) -> String {
    match kinds.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
        None => String::new(),
    }
}
