//! A mesh has faces.

use super::super::cause::is_unmet;
use super::super::cause::mesh::{is_in_archive, weigh};
use super::super::proxy::STOPS_WITH_INDEX;
use super::super::{Check, Rule, RuleCx};
use super::{of_asset, of_body};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::obj::{Mesh, MeshFacts};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows nothing and a height of 0 cm; the glTF export crashes with `ValueError`",
        ),
        (
            Makehuman1,
            "does not put the asset on: its mesh cannot be loaded",
        ),
        (
            Mpfb,
            "loads the vertices alone: nothing of the mesh is seen",
        ),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("no_faces.md").trim_ascii_end(),
    ..RuleInfo::new("mesh-no-faces", Level::Error, "a mesh has no faces")
});

const NO_MESH: Case = &[
    (
        Makehuman2,
        Level::Error,
        "crashes at start with `IndexError` while loading the base mesh",
    ),
    (
        Mpfb,
        Level::Error,
        "fails with `IndexError` when a character is made",
    ),
];

const NO_VERTICES: Case = &[
    (Makehuman2, Level::Error, STOPS_WITH_INDEX),
    (
        Mpfb,
        Level::Error,
        "fails with `IndexError` when the asset is put on",
    ),
];

/// Of an asset it is the export that fails.
const OF_ASSET: Case = &[
    (
        Makehuman2,
        Level::Error,
        "shows nothing; the glTF export of a figure that wears the asset crashes with `ValueError`",
    ),
    (
        Mpfb,
        Level::Warning,
        "puts the asset on without faces: nothing of it is seen",
    ),
];
fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some(mesh) = of_asset(view, file) {
        let is_cloud = mesh.faces == 0 && is_read(&mesh.facts) && mesh.facts.short_faces.is_empty();
        return out.extend(is_cloud.then(|| of_worn(file, mesh.facts.vertices)));
    }
    let Some(mesh) = of_body(file).filter(|mesh| is_cloud(mesh)) else {
        return;
    };
    if is_in_archive(view, file, is_cloud) {
        return;
    }
    if mesh.facts.vertices == 0 {
        if is_other_text(view, file) {
            let message = format!(
                "`{}` is not an OBJ file: it has neither vertices nor faces",
                file.file_name()
            );
            let help = "restore the mesh: this file is something else, such as a web page";
            let finding = RULE.at(file, Place::File, message).case(NO_MESH).help(help);
            out.push(weigh(view, file, finding));
        }
        return;
    }
    let vertices = mesh.facts.vertices;
    let finding = RULE
        .at(
            file,
            Place::File,
            format!("the mesh has {vertices} vertices but no faces"),
        )
        .help("export the mesh again, with its faces")
        .evidence(Evidence::counted(vertices).out_of(vertices));
    out.push(weigh(view, file, finding));
}

/// Faces that could not be read would be some, too.
fn is_cloud(mesh: &Mesh) -> bool {
    mesh.faces.is_empty() && is_read(&mesh.facts)
}

fn is_read(facts: &MeshFacts) -> bool {
    facts.unreadable_lines == 0 && facts.face_out_of_range.count == 0
}

/// The finding on the mesh of an asset.
fn of_worn(file: &FileFacts, vertices: usize) -> Finding {
    if vertices == 0 {
        let message = format!(
            "`{}` is not an OBJ file: it has neither vertices nor faces",
            file.file_name()
        );
        let help = "restore the mesh: this file is something else, such as a web page";
        return RULE
            .at(file, Place::File, message)
            .case(NO_VERTICES)
            .help(help);
    }
    let finding = RULE
        .at(
            file,
            Place::File,
            format!("the mesh has {vertices} vertices but no faces"),
        )
        .case(OF_ASSET);
    finding
        .help("export the mesh again, with its faces")
        .evidence(Evidence::counted(vertices).out_of(vertices))
}

/// Whether there is a text of which the loader takes no line. An empty file, and one that is not
/// UTF-8, have findings of their own.
fn is_other_text(view: &View<'_>, file: &FileFacts) -> bool {
    let encoding = &file.encoding;
    let is_empty = file.size == 0 || encoding.blank || encoding.only_comments;
    !is_empty && encoding.invalid_utf8_at.is_none() && !is_unmet(view, file)
}
