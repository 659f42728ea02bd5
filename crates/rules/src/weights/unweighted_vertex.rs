//! Every vertex should have a weight.

use super::super::cause::worn;
use super::super::regions::in_words;
use super::super::{Check, Rule, RuleCx};
use super::{has_unusable_entries, is_empty, readable_own, weigh};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Cases, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhw::Weights;
use mhlint_repo::{Body, FileFacts, Region, Unreached};

const USUAL: &str =
    "assigns such vertices to the root bone: they do not move with the limbs of the body";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, USUAL),
        (Makehuman1, USUAL),
        (
            Mpfb,
            "does not move such vertices: they stay where they are when the body is posed",
        ),
    ],
    docs: include_str!("unweighted_vertex.md").trim_ascii_end(),
    counts: "vertices",
    ..RuleInfo::new(
        "weights-unweighted-vertex",
        Level::Warning,
        "a vertex has no weight",
    )
});

const WITHOUT_ANY: Case = &[
    (Makehuman2, Level::Warning, ALL_ON_ROOT),
    (Makehuman1, Level::Warning, ALL_ON_ROOT),
    (Mpfb, Level::Warning, "creates a rig that moves nothing"),
];
const ALL_ON_ROOT: &str = "assigns the whole mesh to the root bone: no other bone moves anything";

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // To MakeHuman 1 weights that end before the last vertex are worse
    // (`proxy-weight-table-short`).
    let is_short = |own: &worn::Own<'_>| body.is_makehuman1() && own.listed() < own.vertices;
    // MPFB has the weights of the body for vertices that have none.
    out.extend(
        worn::all(body)
            .filter(|own| !is_short(own) && !body.is_mpfb())
            .filter_map(|own| of_asset(&own)),
    );
    let mut room = MOST_NAMED;
    // Entries that cannot be used may be the missing ones.
    for (own, weights) in readable_own(body).filter(|(_, weights)| !has_unusable_entries(weights)) {
        if is_empty(weights) {
            out.push(weigh(own, without_any(own.file, weights)));
            continue;
        }
        let Some(unreached) = body.unreached(&weights.facts.sum.reached) else {
            continue;
        };
        let left = room.checked_sub(unreached.count);
        room = left.unwrap_or(room);
        let finding = RULE
            .at(
                own.file,
                Place::pointer(["weights"]),
                message(body, weights, &unreached),
            )
            .help("paint weights for them with the bones that should move them")
            .evidence(evidence(weights, &unreached, left.is_some()));
        out.push(weigh(
            own,
            if unreached.shown > 0 {
                finding
            } else {
                finding.at_most(Level::Info)
            },
        ));
    }
}

/// The finding on the weights of an asset, which takes nothing from the body.
fn of_asset(own: &worn::Own<'_>) -> Option<Finding> {
    let (count, first) = own
        .unreached()
        .filter(|_| !has_unusable_entries(own.weights) && own.outside().is_none())?;
    let first = own.mesh.named(first);
    let message = match count {
        1 => format!("{first} of the asset has no weight"),
        count => format!(
            "{count} of {} vertices of the asset have no weight, first {first}",
            own.vertices
        ),
    };
    let finding = RULE
        .at(own.file, Place::pointer(["weights"]), message)
        .key("asset");
    let finding = finding.help(
        "give every vertex a weight and export the weights again; without own weights remove \
            `vertexboneweights_file`",
    );
    Some(finding.evidence(Evidence::counted(count).out_of(own.vertices)))
}

fn message(body: &Body<'_>, weights: &Weights, unreached: &Unreached<'_>) -> String {
    let first = || {
        unreached
            .vertices()
            .take(LOOKED_AT)
            .find(|vertex| body.region(*vertex) == Some(Region::Visible))
    };
    let first = first()
        .or_else(|| unreached.vertices().next())
        .map(|vertex| body.vertex(vertex))
        .unwrap_or_default();
    if unreached.count == 1 {
        return format!("{first} has no weight");
    }
    let hidden = unreached.count.saturating_sub(unreached.shown);
    let regions = [(Region::Visible, unreached.shown), (Region::Helper, hidden)];
    let regions = regions
        .into_iter()
        .filter(|(_, count)| *count > 0)
        .collect();
    let regions = in_words(&regions).filter(|_| body.visible_groups.is_some());
    let regions = regions
        .map(|regions| format!(" ({regions})"))
        .unwrap_or_default();
    format!(
        "{} of {} vertices{regions} have no weight, first {first}",
        unreached.count, weights.facts.vertices
    )
}

fn evidence(weights: &Weights, unreached: &Unreached<'_>, are_named: bool) -> Cases {
    if are_named {
        return Evidence::of_cases(unreached.vertices()).out_of(weights.facts.vertices);
    }
    let examples = Evidence::of_unnamed(unreached.vertices().take(EXAMPLES));
    Evidence {
        count: unreached.count as u64,
        ..examples
    }
    .out_of(weights.facts.vertices)
    .into()
}

/// A file without a single entry, which needs no mesh to be told.
fn without_any(file: &FileFacts, weights: &Weights) -> Finding {
    let vertices = weights.facts.vertices;
    let mut finding = RULE
        .at(
            file,
            Place::pointer(["weights"]),
            "no vertex has a weight: the file has no entries",
        )
        .help("paint the weights and export them again, or name another file in the skeleton")
        .case(WITHOUT_ANY);
    if vertices > 0 {
        let evidence = Evidence::counted(vertices);
        finding = finding.evidence(evidence.out_of(vertices));
    }
    finding
}

/// Vertices among which one of the visible body is looked for: files times vertices have no end.
const LOOKED_AT: usize = 4096;
/// Vertices that the findings of a body name: files times vertices have no end. Further findings
/// count theirs.
const MOST_NAMED: usize = 1 << 20;
