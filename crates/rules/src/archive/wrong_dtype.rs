//! An archive with arrays of other types than MakeHuman 2 reads.

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
            "crashes at every start until the archive is deleted by hand",
        ),
        (
            Makehuman1,
            "stops each update of the figure that uses the target",
        ),
    ],
    docs: include_str!("wrong_dtype.md").trim_ascii_end(),
    counts: "members",
    ..RuleInfo::new(
        "archive-wrong-dtype",
        Level::Error,
        "an array of an archive has another type than is read",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    report(&RULE, Sort::WrongDtype, view, file, out);
}
