//! Weights of an asset reach its last vertex.

use super::super::cause::weights::has_unusable_entries;
use super::super::cause::worn;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "puts the asset on; each pose then fails with `ValueError`",
    )],
    docs: include_str!("weight_table_short.md").trim_ascii_end(),
    counts: "vertices",
    ..RuleInfo::new(
        "proxy-weight-table-short",
        Level::Error,
        "weights of an asset that end before its last vertex",
    )
});

const WITHOUT_ANY: Case = &[(
    Makehuman1,
    Level::Error,
    "does not put the asset on: `ValueError` at its weights",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for own in worn::all(body) {
        let listed = own.listed();
        let missing = own.vertices.saturating_sub(listed);
        // Entries for vertices that do not exist, or that cannot be used, have a finding of their
        // own.
        if missing == 0 || own.outside().is_some() || has_unusable_entries(own.weights) {
            continue;
        }
        let message = match listed {
            0 => "no vertex of the asset has an entry".to_owned(),
            _ => format!(
                "the weights end after vertex {}, but the asset has {} vertices",
                listed - 1,
                own.vertices
            ),
        };
        let finding = RULE.at(own.file, Place::pointer(["weights"]), message);
        let finding = finding.evidence(Evidence::counted(missing).out_of(own.vertices));
        let help = "give every vertex a weight and export the weights again; without own weights \
            remove `vertexboneweights_file`";
        let finding = finding.help(help);
        out.push(if listed == 0 {
            finding.case(WITHOUT_ANY)
        } else {
            finding
        });
    }
}
