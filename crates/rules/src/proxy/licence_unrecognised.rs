//! A licence is recorded as it is written.

use super::super::{Check, Rule, RuleCx};
use super::blender;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Mpfb, "records another licence for the asset")],
    docs: "The comment `# license` names a licence that MPFB records as another one.\n\n\
        MPFB takes every line with `by` in it for CC-BY, and everything else for CC0: `AGPL3`, `CC-BY-SA` and the like are lost.\n\n\
        Nothing has to be done if the right licence stands elsewhere. Otherwise use CC0 or CC-BY.",
    ..RuleInfo::new("proxy-licence-unrecognised", Level::Warning, "a licence that is recorded as another one")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    blender::names::licence(&RULE, body, out);
}
