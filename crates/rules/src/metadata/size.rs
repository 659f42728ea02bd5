//! The size, the axes and the order of the base mesh of MPFB
//! (`docs/loaders/mpfb/base-mesh.md#the-mesh`).

use super::super::Rule;
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place};
use mhlint_repo::FileFacts;
use mhlint_repo::cubes::Strays;
use mhlint_repo::mpfb::misplaced::{HEIGHT, Misplaced};

const GIANT: Case = &[(
    Mpfb,
    Level::Warning,
    "makes a figure of another size; sliders move it as far as before, which is too much or too \
        little",
)];
const LYING: Case = &[(
    Mpfb,
    Level::Warning,
    "makes a figure that does not stand, and moves it along other axes",
)];
const EXCHANGED: Case = &[(
    Mpfb,
    Level::Warning,
    "moves the right side of the figure with sliders and bones of the left one, and the other way \
        round",
)];

fn of_cubes(
    Strays {
        are_torn,
        strayed,
        of,
    }: Strays,
) -> String {
    let how = if are_torn {
        "are torn apart"
    } else {
        "are not where `basemesh_vertex_groups.json` has them"
    };
    format!("vertices have other numbers: {strayed} of {of} cubes of joints {how}")
}

/// What is wrong with where the vertices lie.
pub(super) fn fault(rule: &Rule, file: &FileFacts, misplaced: Misplaced) -> Finding {
    let (message, key, help) = match misplaced {
        Misplaced::Lying(axis) => (
            format!("the mesh is largest along {axis}, not along y: it does not stand upright"),
            "axes",
            "export the mesh with y up, or restore it",
        ),
        Misplaced::OtherSize(high) => (
            format!(
                "the mesh is {:.2} m ({high:.3}) high, expected about {:.1} m",
                high / 10.0,
                HEIGHT / 10.0
            ),
            "size",
            "export the mesh in decimetres, or restore it",
        ),
        Misplaced::Mirrored(across, sided) => (
            format!(
                "left and right are exchanged: {across} of {sided} vertices lie across from where \
                    `hm08.mirror` puts them"
            ),
            "mirrored",
            "restore the base mesh",
        ),
        Misplaced::Order(strayed, rows) => (
            format!(
                "vertices have other numbers: {strayed} of {rows} do not mirror the ones that \
                    `hm08.mirror` names"
            ),
            "order",
            "restore the base mesh, or export it with the order of its vertices kept",
        ),
        Misplaced::Cubes(strays) => (
            of_cubes(strays),
            "order",
            "restore the base mesh, or export it with the order of its vertices kept",
        ),
    };
    let finding = rule.at(file, Place::File, message).key(key).help(help);
    match misplaced {
        Misplaced::Lying(_) => finding.case(LYING),
        Misplaced::OtherSize(_) => finding.case(GIANT),
        Misplaced::Mirrored(..) => finding.case(EXCHANGED),
        Misplaced::Order(..) | Misplaced::Cubes(_) => finding,
    }
}
