//! What an asset hides of the body, it covers.

use super::super::{Check, Rule, RuleCx, counted};
use super::{Text, measured};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::worn::Uncovered;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows a hole in the figure where it wears the asset",
        ),
        (
            Makehuman1,
            "shows a hole in the figure where it wears the asset",
        ),
    ],
    docs: include_str!("mask_uncovered.md").trim_ascii_end(),
    counts: "faces",
    ..RuleInfo::new(
        "proxy-mask-uncovered",
        Level::Warning,
        "`delete_verts` hides skin that the asset does not cover",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (text, measure) in measured(body, measures).filter(|(text, _)| is_told_here(text)) {
        // What hides (almost) everything is told as such.
        let told =
            |bare: &&Uncovered| bare.hidden.saturating_mul(20) > bare.shown.saturating_mul(19);
        let Some(bare) = measure.uncovered.as_ref().filter(|bare| !told(bare)) else {
            continue;
        };
        let list = text
            .clothes
            .entries
            .iter()
            .find(|entry| &*entry.keyword == "delete_verts");
        let place = list.map_or(Place::File, |entry| Place::Line(entry.line));
        let message = format!(
            "`delete_verts` hides {} of the body that nothing of the asset covers, around {}",
            counted(bare.count, "face"),
            body.vertex(bare.middle)
        );
        let named = bare
            .vertices
            .iter()
            .map(|vertex| format!("vertex {vertex}"));
        let evidence = Evidence {
            count: bare.count as u64,
            ..Evidence::of_unnamed(named)
        };
        out.push(
            RULE.at(text.file, place, message)
                .evidence(evidence.out_of(bare.hidden))
                .help(
                    "take the vertices there out of the list: name only those that lie under \
                    the asset",
                ),
        );
    }
}

/// A topology stands for the skin; a list that names vertices that do not exist hides nothing, as
/// the application stops.
fn is_told_here(text: &Text<'_, '_>) -> bool {
    !text.worn.is_topology() && text.clothes.deletes.out_of_range.count == 0
}
