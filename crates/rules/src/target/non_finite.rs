//! Displacements are finite numbers.

use super::super::{Check, Rule, RuleCx};
use super::shown::with_setting;
use super::{first_row, targets};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "loses such vertices when the target is applied, with all normals, joints and clothes \
                that depend on them",
        ),
        (
            Makehuman1,
            "silently loses the vertex when the target is applied",
        ),
        (
            Mpfb,
            "leaves the vertex without a position as soon as the slider moves",
        ),
    ],
    levels: &[(Mpfb, Level::Warning), (Makehuman1, Level::Warning)],
    docs: include_str!("non_finite.md").trim_ascii_end(),
    counts: "rows, by vertex",
    ..RuleInfo::new(
        "target-non-finite",
        Level::Error,
        "a displacement is NaN or infinite",
    )
});

const OUTDATED: Case = &[(
    Makehuman2,
    Level::Warning,
    "applies the numbers in the archive; loses the vertex once the archive is deleted and rebuilt",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body) {
        let Some((_, index)) = facts.non_finite.first.first() else {
            continue;
        };
        let vertex = body.vertex(*index);
        let message = match facts.non_finite.count {
            1 => format!("the displacement of {vertex} is NaN or infinite"),
            count => format!("{count} displacements are NaN or infinite, first that of {vertex}"),
        };
        let finding = RULE
            .at(file, first_row(&facts.non_finite), message)
            .help("export the target again, or correct the numbers")
            .evidence(facts.non_finite.evidence(facts.rows));
        let is_outdated = target.is_outdated();
        out.push(if is_outdated {
            finding.case(OUTDATED)
        } else {
            with_setting(finding, body, file)
        });
    }
}
