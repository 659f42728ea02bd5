//! An archive without something that MakeHuman 2 reads of it.

use super::super::{Check, Rule, RuleCx};
use super::Sort;
use super::report::report;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, RuleInfo,
};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "refuses the asset with a message: it cannot be put on",
        ),
        (Makehuman1, "finds the target no longer, or reads its text"),
    ],
    docs: include_str!("missing_member.md").trim_ascii_end(),
    counts: "members",
    ..RuleInfo::new(
        "archive-missing-member",
        Level::Error,
        "an archive lacks a member",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    report(&RULE, Sort::MissingMember, view, file, out);
}
