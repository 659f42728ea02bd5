//! Entries of the baseline that no longer occur.

use super::FIX_FIRST;
use crate::{Check, Rule, RuleCx};
use mhlint_diag::{Evidence, Finding, Level, Place, RuleInfo, Upkeep};

pub(crate) static RULE: Rule = Check::Upkeep(run).rule(RuleInfo {
    docs: include_str!("baseline_stale.md").trim_ascii_end(),
    counts: "findings",
    ..RuleInfo::new(
        "baseline-stale",
        Level::Info,
        "baseline entries that no longer occur",
    )
});

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(baseline) = upkeep
        .baseline
        .as_ref()
        .filter(|baseline| !baseline.stale.is_empty())
    else {
        return;
    };
    let (stale, checked) = (baseline.stale.len(), baseline.checked);
    let (message, help) = match (stale, checked) {
        (stale, checked) if upkeep.errors => {
            let verb = if stale == 1 { "was" } else { "were" };
            (
                format!("{stale} of {checked} baseline entries {verb} not found again"),
                FIX_FIRST,
            )
        }
        (1, 1) => ("the only baseline entry no longer occurs".to_owned(), PRUNE),
        (stale, checked) if stale == checked => (
            format!(
                "none of the {checked} baseline entries occurs; it may be the baseline of another \
                    repository"
            ),
            "use the baseline of this repository, or rewrite it with `--write-baseline`",
        ),
        (1, checked) => (
            format!("1 of {checked} baseline entries no longer occurs"),
            PRUNE,
        ),
        (stale, checked) => (
            format!("{stale} of {checked} baseline entries no longer occur"),
            PRUNE,
        ),
    };
    let finding = Finding::new(&RULE.info, baseline.path.clone(), Place::File, message).help(help);
    out.push(finding.evidence(Evidence::of_cases(&baseline.stale).out_of(checked)));
}

const PRUNE: &str = "run again with `--write-baseline` to update the baseline";
