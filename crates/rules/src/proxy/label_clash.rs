//! What a list shows has a label of its own.

use super::super::library::{shelves, side_by_side};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "lists only one of them; the other cannot be chosen")],
    docs: include_str!("label_clash.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-label-clash",
        Level::Error,
        "two assets of one list with the same label",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    shelves::same_labels(&RULE, view, out);
    side_by_side::in_mpfb(&RULE, view, cx.beside, out);
}
