//! Rows of a target name vertices that the base mesh has.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::beyond_mesh::{first, ignored, mesh_has};
use super::{first_row, targets};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo, Tally,
};
use mhlint_formats::target::TargetFacts;
use mhlint_repo::{Body, Doubt, FileFacts, ReferenceKind, Target};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` when the target is applied",
        ),
        (Makehuman1, NEVER_APPLIED),
        (Mpfb, "silently ignores the row"),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("vertex_out_of_range.md").trim_ascii_end(),
    counts: "rows, by vertex",
    ..RuleInfo::new(
        "target-vertex-out-of-range",
        Level::Error,
        "a target names a vertex that the base mesh does not have",
    )
});

const NEVER_APPLIED: &str = "fails with `IndexError` each time the target is applied, and stops \
    in the middle of the update";

const OVERFLOW: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes at start with `OverflowError` and leaves an empty compressedtargets.npz that crashes \
        every later start",
)];
const OUTDATED: Case = &[(
    Makehuman2,
    Level::Warning,
    "applies the archive; crashes with `IndexError` once the archive is deleted and rebuilt",
)];
const UNUSED: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "loads it, but crashes with `IndexError` once something uses the target",
    ),
    (
        Makehuman1,
        Level::Warning,
        "fails with `IndexError` once something uses the target",
    ),
];
const WRAPPED: Case = &[(
    Makehuman2,
    Level::Error,
    "moves another vertex or crashes with `IndexError`",
)];
const OF_A_MACRO: Case = &[
    (
        Makehuman2,
        Level::Error,
        "crashes with `IndexError` at start, when the macro applies it",
    ),
    (
        Makehuman1,
        Level::Error,
        "stops at start if the neutral figure has this target, else at the first setting that \
            needs it",
    ),
];
const OF_A_SLIDER: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `IndexError` when the slider moves",
)];
const SEAM: Case = &[(
    Makehuman2,
    Level::Warning,
    "moves this copy, which it adds where the UV map is cut, with its original: the row has no \
        effect",
)];

/// First index whose triple no longer fits 32 bits: coordinate 3·index wraps
/// (`docs/loaders/makehuman2/targets.md#rows`).
const FIRST_WRAPPED: i64 = (1 << 32) / 3 + 1;

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let vertices = body.mesh.map(|(_, mesh)| mesh.facts.vertices);
    for (target, file, facts) in targets(body) {
        if facts.overflow.count > 0 {
            out.push(weigh(target, overflow(file, facts)));
        } else if body.doubt == Some(Doubt::Foreign) {
            // All targets fit one another: the mesh is at fault (`base-vertex-count`).
        } else if body.is_mpfb() {
            out.extend(ignored(&RULE, file, facts, vertices));
        } else if let Some(tally) = beyond_mesh(body, facts) {
            let finding = beyond(file, facts, tally, vertices);
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

/// Rows for vertices that there are not. MakeHuman 1 has no copies at seams.
fn beyond_mesh<'f>(body: &Body<'_>, facts: &'f TargetFacts) -> Option<&'f Tally> {
    let seam = Some(&facts.seam).filter(|_| body.is_makehuman1());
    [Some(&facts.out_of_range), seam]
        .into_iter()
        .flatten()
        .find(|tally| tally.count > 0)
}

fn overflow(file: &FileFacts, facts: &TargetFacts) -> Finding {
    let message = format!(
        "vertex index {} does not fit into 32 bits",
        first(&facts.overflow)
    );
    RULE.at(file, first_row(&facts.overflow), message)
        .key("overflow")
        .help("write the index that the base mesh has, or remove the row")
        .evidence(facts.overflow.evidence(facts.rows))
        .case(OVERFLOW)
}

fn beyond(
    file: &FileFacts,
    facts: &TargetFacts,
    tally: &Tally,
    vertices: Option<usize>,
) -> Finding {
    let mesh = mesh_has(file, vertices);
    let message = match tally.count {
        1 => format!("vertex {} does not exist: {mesh}", first(tally)),
        count => {
            let largest = facts.max_index.unwrap_or_default();
            format!("{count} rows name vertices that do not exist (up to {largest}): {mesh}")
        }
    };
    RULE.at(file, first_row(tally), message)
        .help(
            "export the target again from the base mesh of its folder; its other rows may be \
            for another mesh, too",
        )
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
        1 => format!(
            "vertex {} is a UV-seam duplicate and does not move: {}",
            first(tally),
            mesh_has(file, vertices)
        ),
        count => format!(
            "{count} rows name UV-seam duplicates and move nothing: {}",
            mesh_has(file, vertices)
        ),
    };
    RULE.at(file, first_row(tally), message)
        .key("seam")
        .case(SEAM)
        .help("export the target again, or name the original vertices")
        .evidence(tally.evidence(facts.rows))
}
