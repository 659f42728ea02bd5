//! Rows and lists of an asset name vertices that the base mesh has.

use super::super::{Check, Rule, RuleCx};
use super::{OVERFLOW, STOPS_WITH_INDEX, Text, archives, blender, rebuild, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo, Tally,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` when the asset is put on, and again whenever a slider moves \
            and in the glTF export",
        ),
        (
            Makehuman1,
            "does not put the asset on: `IndexError` when it is fitted",
        ),
        (
            Mpfb,
            "fails \
        with `IndexError` on a character with a rig; without one the vertex stays where the OBJ \
        has it",
        ),
    ],
    docs: include_str!("vertex_out_of_range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-vertex-out-of-range",
        Level::Error,
        "an asset uses a vertex that the \
        base mesh does not have",
    )
});

const SEAM: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "puts the vertex at the place of a UV-seam duplicate",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: `IndexError` when it is fitted",
    ),
];
const LIST: Case = &[
    (Makehuman2, Level::Error, STOPS_WITH_INDEX),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: `IndexError` when it reads the list",
    ),
];
const FROM_END: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "counts from the end and hides another vertex",
    ),
    (
        Makehuman1,
        Level::Warning,
        "counts from the end and hides another vertex",
    ),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::rows::range(&RULE, body, out);
    }
    for text in texts(body).filter(|text| !text.reading.stops()) {
        let (rows, deletes) = (&text.clothes.rows, &text.clothes.deletes);
        let unstorable = finding(&text, &rows.unstorable, "a vertex row", None)
            .map(|one| one.key("unstorable").case(OVERFLOW));
        out.extend(unstorable);
        let Some(size) = text.size_of_base(body) else {
            continue;
        };
        let last = Some(size.vertices.saturating_sub(1));
        out.extend(finding(&text, &rows.out_of_range, "a vertex row", last));
        let seams = seam(&text, &rows.in_seams, size.vertices);
        let is_listed = || deletes.out_of_range.count > 0 && text.is_foreign(body);
        out.extend(seams.filter(|_| rows.out_of_range.count == 0 && !is_listed()));
        // Beside such rows the list has the same cause.
        let hidden = finding(&text, &deletes.out_of_range, "`delete_verts`", last);
        out.extend(
            hidden
                .filter(|_| rows.out_of_range.count == 0)
                .map(|one| one.key("deleted").case(LIST)),
        );
        out.extend(negative(&text, &deletes.negative));
    }
    for archive in archives(body) {
        let Some(size) = archive.size_of_base(body) else {
            continue;
        };
        let tally = &archive.asset.rows.out_of_range;
        let Some((_, vertex)) = tally.first.first() else {
            continue;
        };
        // As the text has it, it is told there.
        let is_told = archive
            .text
            .is_some_and(|text| text.clothes.rows.out_of_range.count > 0);
        let last = size.vertices.saturating_sub(1);
        let message = format!(
            "a row names vertex {vertex}, which does not exist; the base mesh has 0 to {last}"
        );
        let finding = RULE
            .at(archive.file, Place::File, message)
            .evidence(tally.evidence(archive.asset.rows.count));
        out.extend((!is_told).then(|| finding.help(rebuild(archive.text.is_some()))));
    }
}

fn finding(
    text: &Text<'_, '_>,
    tally: &Tally,
    place: &str,
    last: Option<usize>,
) -> Option<Finding> {
    let (line, vertex) = tally.first.first()?;
    let range = last
        .map(|last| format!("; the base mesh has 0 to {last}"))
        .unwrap_or_default();
    let message = match tally.count {
        1 => format!("{place} names vertex {vertex}, which does not exist{range}"),
        count => format!(
            "{place} names vertex {vertex}, which does not exist ({count} such numbers){range}"
        ),
    };
    let finding = RULE
        .at(text.file, Place::Line(*line), message)
        .evidence(tally.evidence(text.clothes.rows.count));
    let help = "use vertices of this base mesh, counted from 0, or the asset with the base that \
        it was made for";
    Some(finding.help(text.use_with_its_base(help)))
}

fn negative(text: &Text<'_, '_>, tally: &Tally) -> Option<Finding> {
    let (line, vertex) = tally.first.first()?;
    let message = format!("`delete_verts` names vertex {vertex}, which is negative");
    let finding = RULE
        .at(text.file, Place::Line(*line), message)
        .key("negative")
        .case(FROM_END);
    Some(
        finding
            .evidence(tally.evidence(text.clothes.deleted.len()))
            .help("count vertices from 0; a range needs spaces around its dash: `173 - 204`"),
    )
}

fn seam(text: &Text<'_, '_>, tally: &Tally, vertices: usize) -> Option<Finding> {
    // MakeHuman 1 makes no duplicates.
    if text.is_makehuman1() {
        return finding(text, tally, "a vertex row", vertices.checked_sub(1));
    }
    let (line, vertex) = tally.first.first()?;
    let message = match tally.count {
        1 => format!(
            "a vertex row names {vertex}, a UV-seam duplicate: the base mesh has {vertices} \
                vertices"
        ),
        count => format!(
            "{count} vertex rows name UV-seam duplicates, first {vertex}; the base mesh has \
                {vertices} vertices"
        ),
    };
    let finding = RULE
        .at(text.file, Place::Line(*line), message)
        .key("seam")
        .case(SEAM);
    let finding = finding.evidence(tally.evidence(text.clothes.rows.count));
    Some(finding.help("name the vertex itself, counted from 0"))
}
