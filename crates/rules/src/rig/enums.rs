//! Words in a rig are those that Blender knows.

use super::super::unfit::findings_in;
use super::super::{Check, Rule, RuleCx};
use super::{IN_BONES, STOPS, stops};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("enums.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-enum",
        Level::Error,
        "a word in a rig that Blender does not know",
    )
});

const KEEPS_ROLL: Case = &[(
    Mpfb,
    Level::Warning,
    "passes over the strategy: the bone keeps the number of `roll`",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.words, cx);
        out.extend(found.map(|(_, finding)| stops(file, finding)));
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.ignored_words, cx);
        out.extend(found.map(|(_, finding)| finding.case(KEEPS_ROLL)));
    }
}
