//! Entries of the baseline that no longer occur.

use super::FIX_FIRST;
use crate::diag::{Evidence, Finding, Level, Place, RuleInfo, Upkeep};
use crate::rules::{Check, Rule, RuleCx};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        docs: "The baseline holds findings that were not found again: they are mended. As long as they are in it \
               they would be hidden if they came back.\n\nRun again with `--write-baseline`: that prunes them, and \
               keeps what this run could not look at (with another PATH, `--only` and the like). If no entry at all \
               is found again the file probably belongs to another repository.\n\nWhere errors are found beside those of \
               the baseline, mend them first: a file that cannot be read hides what else was found in it and in what \
               it names, and all of that is new again once the file is restored.",
        ..RuleInfo::new("baseline-stale", Level::Info, "entries of the baseline that no longer occur")
    },
    check: Check::Upkeep(run),
};

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(baseline) = upkeep.baseline.as_ref().filter(|baseline| !baseline.stale.is_empty()) else { return };
    let (stale, checked) = (baseline.stale.len(), baseline.checked);
    let (message, help) = match (stale, checked) {
        (stale, checked) if upkeep.errors => {
            let verb = if stale == 1 { "was" } else { "were" };
            (format!("{stale} of {checked} entries of the baseline {verb} not found again"), FIX_FIRST)
        }
        (1, 1) => ("the only entry of the baseline no longer occurs".to_owned(), PRUNE),
        (stale, checked) if stale == checked => (
            format!("none of the {checked} entries of the baseline occurs: is it that of another repository?"),
            "name the baseline of this repository, or write it anew with `--write-baseline`",
        ),
        (1, checked) => (format!("1 of {checked} entries of the baseline no longer occurs"), PRUNE),
        (stale, checked) => (format!("{stale} of {checked} entries of the baseline no longer occur"), PRUNE),
    };
    let finding = Finding::new(&RULE.info, baseline.path.clone(), Place::File, message).help(help);
    out.push(finding.evidence(Evidence::of_cases(&baseline.stale).out_of(checked)));
}

const PRUNE: &str = "run again with `--write-baseline`, which prunes them";
