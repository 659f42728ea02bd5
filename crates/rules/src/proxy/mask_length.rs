//! The archive of an asset fits the base mesh and its own mesh.

use super::super::{Check, Rule, RuleCx, counted};
use super::{Archive, VALUE, archives, rebuild};
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `ValueError` when the asset is put on, or with another one that hides \
            vertices",
    )],
    docs: include_str!("mask_length.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-mask-length",
        Level::Error,
        "the mask or the rows of a packed asset \
        have another length",
    )
});

const SHORT: Case = VALUE;
const LONG: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `ValueError` when it is worn with another asset that hides vertices, in the OBJ \
        export, and in the glTF export if it hides all",
)];
const ROWS: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes when the asset is put on, and again whenever a slider moves",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for archive in archives(body) {
        out.extend(mask(body, &archive));
        out.extend(rows(&archive));
    }
}

fn mask(body: &Body<'_>, archive: &Archive<'_, '_>) -> Option<Finding> {
    let (length, vertices) = (
        archive.asset.mask.as_ref()?.length,
        archive.size_of_base(body)?.vertices,
    );
    if length == vertices {
        return None;
    }
    let message = format!("the mask is for {length} vertices, but the base mesh has {vertices}");
    let finding = RULE
        .at(archive.file, Place::File, message)
        .case(if length < vertices { SHORT } else { LONG });
    Some(finding.help(rebuild(archive.text.is_some())))
}

fn rows(archive: &Archive<'_, '_>) -> Option<Finding> {
    let (rows, vertices) = (archive.asset.rows.count, archive.asset.print.vertices);
    if rows == vertices {
        return None;
    }
    let message = format!(
        "{} for the {vertices} vertices in the archive",
        counted(rows, "row")
    );
    let finding = RULE
        .at(archive.file, Place::File, message)
        .key("rows")
        .case(ROWS);
    Some(finding.help(rebuild(archive.text.is_some())))
}
