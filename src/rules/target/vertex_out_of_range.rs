//! Rows of a target name vertices that the base mesh has.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::{first_row, targets};
use crate::diag::{Application, Case, Finding, Level, RuleInfo, Tally};
use crate::formats::target::TargetFacts;
use crate::repo::{Body, FileFacts, ReferenceKind, Target};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with an IndexError when the target is applied")],
        docs: "A vertex index that the base mesh of the folder does not have.\n\nMakeHuman 2 loads the target and stops with an \
            IndexError when it is applied: as soon as its slider moves, or at start if a macro uses it. Indices from \
            1431655766 on are not noticed: they wrap around and move another vertex. Beyond 4294967295 the program stops \
            at start, used or not.\n\nBehind the vertices of the file the loaded mesh has a few more, doubles of vertices at \
            texture seams. A row for one of those is overwritten by its original and moves nothing: a warning.\n\nMostly the \
            target was made for another mesh, or for one that was exported with other vertices. Make it for this one.",
        ..RuleInfo::new("target-vertex-out-of-range", Level::Error, "a vertex index the base mesh does not have")
    },
    check: Check::Body(run),
};

const OVERFLOW: Case = &[(
    Application::Makehuman2,
    Level::Error,
    "stops at start with an OverflowError and leaves an empty compressedtargets.npz behind, which stops every \
     later start",
)];
const OUTDATED: Case = &[(
    Application::Makehuman2,
    Level::Warning,
    "applies the archive; it stops with an IndexError once that is deleted to be made anew",
)];
const UNUSED: Case = &[(
    Application::Makehuman2,
    Level::Warning,
    "loads it; it stops with an IndexError once something uses the target",
)];
const WRAPPED: Case = &[(Application::Makehuman2, Level::Error, "moves another vertex or stops with an IndexError")];
const OF_A_MACRO: Case =
    &[(Application::Makehuman2, Level::Error, "stops with an IndexError when the macro applies it, at start already")];
const OF_A_SLIDER: Case = &[(Application::Makehuman2, Level::Error, "stops with an IndexError when the slider moves")];
const SEAM: Case =
    &[(Application::Makehuman2, Level::Warning, "overwrites the double with its original: the row does nothing")];

/// First index whose triple no longer fits 32 bits: coordinate 3·index wraps (formats/makehuman2.md §6.1).
const FIRST_WRAPPED: i64 = (1 << 32) / 3 + 1;

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let vertices = body.mesh.map(|(_, mesh)| mesh.facts.vertices);
    for (target, file, facts) in targets(body) {
        if facts.overflow.count > 0 {
            out.push(weigh(target, overflow(file, facts)));
        } else if body.has_foreign_mesh {
            // All targets fit one another: the mesh is at fault (`base-vertex-count`).
        } else if facts.out_of_range.count > 0 {
            let finding = beyond(file, facts, vertices);
            out.push(if target.is_outdated() {
                finding.case(OUTDATED)
            } else {
                with_consequence(finding, target, facts)
            });
        } else if facts.seam.count > 0 {
            out.push(seam(file, facts, vertices));
        }
    }
}

fn overflow(file: &FileFacts, facts: &TargetFacts) -> Finding {
    let message = format!("vertex index {} does not fit 32 bits", first(&facts.overflow));
    RULE.at(file, first_row(&facts.overflow), message)
        .key("overflow")
        .help("write the index that the base mesh has, or remove the row")
        .evidence(facts.overflow.evidence(facts.rows))
        .case(OVERFLOW)
}

fn beyond(file: &FileFacts, facts: &TargetFacts, vertices: Option<usize>) -> Finding {
    let tally = &facts.out_of_range;
    let mesh = mesh_has(file, vertices);
    let message = match tally.count {
        1 => format!("vertex {} does not exist: {mesh}", first(tally)),
        count => {
            let largest = facts.max_index.unwrap_or_default();
            format!("{count} rows name vertices that do not exist (up to {largest}): {mesh}")
        }
    };
    RULE.at(file, first_row(tally), message)
        .help("make the target for the mesh of its folder, or remove the rows")
        .evidence(tally.evidence(facts.rows))
}

fn with_consequence(finding: Finding, target: &Target<'_>, facts: &TargetFacts) -> Finding {
    finding.case(match target.used_as {
        _ if target.is_unused => UNUSED,
        _ if facts.max_index >= Some(FIRST_WRAPPED) => WRAPPED,
        Some(ReferenceKind::MacroTarget) => OF_A_MACRO,
        _ => OF_A_SLIDER,
    })
}

fn seam(file: &FileFacts, facts: &TargetFacts, vertices: Option<usize>) -> Finding {
    let tally = &facts.seam;
    let message = match tally.count {
        1 => format!("vertex {} is the double of a seam and does not move: {}", first(tally), mesh_has(file, vertices)),
        count => format!("{count} rows name doubles of seam vertices and move nothing: {}", mesh_has(file, vertices)),
    };
    RULE.at(file, first_row(tally), message)
        .key("seam")
        .case(SEAM)
        .help("name the original vertices, or remove the rows")
        .evidence(tally.evidence(facts.rows))
}

fn first(tally: &Tally) -> i64 {
    tally.first.first().map_or(0, |(_, index)| *index)
}

fn mesh_has(file: &FileFacts, vertices: Option<usize>) -> String {
    let base = file.base().unwrap_or_default();
    vertices.map_or_else(
        || format!("the base mesh `{base}` is smaller"),
        |vertices| format!("base mesh `{base}` has {vertices} vertices"),
    )
}
