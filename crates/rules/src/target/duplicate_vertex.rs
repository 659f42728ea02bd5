//! A target names each vertex once.

use super::super::{Check, Rule, RuleCx};
use super::{first_row, targets};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Change, Finding, Fix, FixKind, Level, Rewrite, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    fix: FixKind::Unsafe,
    breaks: &[
        (
            Makehuman2,
            "applies only the last row of a vertex, not the sum",
        ),
        (
            Makehuman1,
            "applies only the last row of a vertex, not the sum",
        ),
        (
            Mpfb,
            "adds up all rows of a vertex; MakeHuman applies the last one",
        ),
    ],
    docs: include_str!("duplicate_vertex.md").trim_ascii_end(),
    counts: "rows, by vertex",
    ..RuleInfo::new(
        "target-duplicate-vertex",
        Level::Warning,
        "a vertex appears more than once in a target",
    )
});

const ONE: &str = "applies one of the equal rows; programs that add them up double the shape";
const EQUAL: Case = &[
    (Makehuman2, Level::Info, ONE),
    (Makehuman1, Level::Info, ONE),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body) {
        let Some((_, index)) = facts
            .duplicate
            .first
            .first()
            .filter(|_| facts.conflict.is_none())
        else {
            continue;
        };
        let vertex = body.vertex(*index);
        let message = match facts.duplicate.count {
            1 if facts.repeats_are_equal => {
                format!("{vertex} appears twice, with the same numbers")
            }
            count if facts.repeats_are_equal => {
                format!("{count} rows repeat an earlier row of their vertex, first {vertex}")
            }
            1 if body.is_mpfb() => format!("{vertex} appears twice; both rows are added"),
            count if body.is_mpfb() => {
                format!("{count} rows repeat a vertex, first {vertex}; all are added")
            }
            1 => format!("{vertex} appears twice; only the last row counts"),
            count => {
                format!(
                    "{count} rows repeat a vertex, first {vertex}; only the last row of each counts"
                )
            }
        };
        let mut fix = Fix::new(
            RULE.info.fix,
            "keep only the last row of each vertex, the one that MakeHuman applies",
        );
        if target.packed_in.is_none() && !body.is_mpfb() {
            fix = fix.step(&file.path, Change::Rewrite(Rewrite::KeepLastRows));
        }
        let finding = RULE
            .at(file, first_row(&facts.duplicate), message)
            .help("keep one row per vertex")
            .fix(fix)
            .evidence(facts.duplicate.evidence(facts.rows));
        out.push(if facts.repeats_are_equal {
            finding.case(EQUAL)
        } else {
            finding
        });
    }
}
