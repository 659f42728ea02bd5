//! A licence is recorded as it is written.

use super::super::{Check, Rule, RuleCx};
use super::blender;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Mpfb, "records another licence for the asset")],
    docs: include_str!("licence_unrecognised.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-licence-unrecognised",
        Level::Warning,
        "a licence that is recorded as another one",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    blender::names::licence(&RULE, body, out);
}
