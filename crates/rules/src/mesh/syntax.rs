//! Every line of a mesh must be readable.

use super::super::cause::consequence::NO_LAMP;
use super::super::{Check, Rule, RuleCx, such};
use super::{ASSET_INDEX, ASSET_VALUE, ReadMesh, lamp_symbol, read};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::obj::BadLine;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `ValueError` or `IndexError` while loading the base mesh",
        ),
        (
            Makehuman1,
            "does not put the asset on: its mesh cannot be loaded",
        ),
        (
            Mpfb,
            "takes other numbers for those that it cannot read: the figure is displaced",
        ),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("syntax.md").trim_ascii_end(),
    counts: "lines",
    ..RuleInfo::new(
        "mesh-syntax",
        Level::Error,
        "a line of a mesh cannot be read",
    )
});

const LOST_FACES: Case = &[(Mpfb, Level::Warning, "drops faces that it cannot read")];
const OTHER_PLACES: Case = &[(
    Mpfb,
    Level::Info,
    "takes other numbers for those that it cannot read, and never uses them: places come from the \
        rows of the asset",
)];

const NO_LAMP_SYMBOL: Case = &[(Makehuman2, Level::Error, NO_LAMP)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let of_lamp = lamp_symbol(view, file);
    let Some(mesh) = of_lamp.or_else(|| read(view, file)) else {
        return;
    };
    let short = short_face(view, file, &mesh);
    out.extend(short.map(|finding| mesh.weigh(view, file, finding, ASSET_INDEX)));
    if view.is_makehuman1() {
        out.extend(nameless(file, &mesh));
    }
    let Some(first) = mesh.facts.unreadable.first() else {
        return;
    };
    let more = if mesh.facts.unreadable_lines > 1 {
        format!(" ({} lines cannot be read)", mesh.facts.unreadable_lines)
    } else {
        String::new()
    };
    let cases = mesh
        .facts
        .unreadable
        .iter()
        .map(|bad| format!("line {}", bad.line));
    let mut evidence = Evidence::of_unnamed(cases);
    evidence.count = mesh.facts.unreadable_lines;
    let finding = RULE
        .at(
            file,
            Place::Line(first.line),
            format!("`{}`: {}{more}", first.text, first.what),
        )
        .help("fix the line, or export the mesh again")
        .parts(mesh.facts.unreadable_names.names())
        .evidence(evidence);
    let is_face = |bad: &BadLine| bad.text.starts_with('f');
    let case = match view.is_mpfb() {
        true if mesh.facts.unreadable.iter().any(is_face) => LOST_FACES,
        true => OTHER_PLACES,
        false if of_lamp.is_some() => NO_LAMP_SYMBOL,
        false => ASSET_VALUE,
    };
    out.push(mesh.weigh(view, file, finding, case));
}

/// The first face with one or two corners among those that are drawn.
fn short_face(view: &View<'_>, file: &FileFacts, mesh: &ReadMesh<'_>) -> Option<Finding> {
    let mut drawn = mesh
        .facts
        .short_faces
        .iter()
        .filter(|face| mesh.draws(view, file, &face.group));
    let first = drawn.next()?;
    let message = format!("`{}`: a face needs at least three corners", first.text);
    let help = "fix the line, or remove it in a text editor; keep all `v` lines";
    Some(
        RULE.at(file, Place::Line(first.line), message)
            .key("corners")
            .help(help),
    )
}

/// MakeHuman 1 wants a name behind `g` and `o`.
fn nameless(file: &FileFacts, mesh: &ReadMesh<'_>) -> Option<Finding> {
    let tally = &mesh.facts.nameless;
    let (line, _) = tally.first.first()?;
    let more = such(tally.count, "lines");
    let message = format!("a line `g` or `o` has no name{more}");
    Some(
        RULE.at(file, Place::Line(*line), message)
            .key("name")
            .help("write a name, or remove the line"),
    )
}
