//! Rigify knows the types and parameters that a rig has for it.

use super::super::unfit::{findings_in, is_misspelt};
use super::super::{Check, Rule, RuleCx};
use super::{IN_BONES, STOPS, stops};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("rigify_type.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-rigify-type",
        Level::Error,
        "a type or parameter that Rigify does not take",
    )
});

const LATER: Case = &[(
    Mpfb,
    Level::Warning,
    "makes the rig; Rigify fails when it generates one from it, or leaves the parameter out",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.rigify, cx);
        out.extend(found.map(|(_, finding)| stops(file, finding)));
        // Not all parameters of Rigify are known here. An unknown parameter is reported only if it
        // looks like a known one that is misspelt.
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.ignored_rigify, cx);
        out.extend(
            found
                .filter(|(one, _)| is_misspelt(one, cx))
                .map(|(_, finding)| finding.case(LATER)),
        );
    }
}
