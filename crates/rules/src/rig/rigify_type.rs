//! What a rig says to Rigify is what Rigify knows.

use super::super::unfit::{findings_in, is_misspelt};
use super::super::{Check, Rule, RuleCx};
use super::{IN_BONES, STOPS, stops};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: "`rigify_parameters` are set as parameters of Rigify. One of another type, or with a word that Rigify does not know, \
        raises an exception when the rig is added.\n\n\
        An unknown `rigify_type` is stored, and fails when Rigify generates the rig; an unknown parameter is left out with a \
        line in the log (warnings). The parameters that mhlint knows are those of the rigs that MPFB brings.\n\n\
        Correct the value, or export the rig again.",
    ..RuleInfo::new("rig-rigify-type", Level::Error, "a type or parameter that Rigify does not take")
});

const LATER: Case =
    &[(Mpfb, Level::Warning, "makes the rig; Rigify fails when it generates one from it, or leaves the parameter out")];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.rigify, cx);
        out.extend(found.map(|(_, finding)| stops(file, finding)));
        // Rigify has more parameters than those which are known: one that is like none of them is its own.
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.ignored_rigify, cx);
        out.extend(found.filter(|(one, _)| is_misspelt(one, cx)).map(|(_, finding)| finding.case(LATER)));
    }
}
