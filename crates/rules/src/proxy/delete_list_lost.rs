//! The list of vertices to hide begins where it is looked for.

use super::super::{Check, Rule, RuleCx};
use super::blender;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "hides nothing, or less: the body shows through the asset",
    )],
    docs: include_str!("delete_list_lost.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-delete-list-lost",
        Level::Warning,
        "a list of vertices to hide that is not seen",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    blender::list::lost(&RULE, body, out);
}
