//! An archive with Python objects, which would have to be unpickled.

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
            "reads the text in its place; a program that unpickles the array runs \
            whatever is in it",
        ),
    ],
    docs: include_str!("object_array.md").trim_ascii_end(),
    counts: "members",
    cannot_be_ignored: true,
    ..RuleInfo::new(
        "archive-object-array",
        Level::Error,
        "an archive contains Python objects",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    report(&RULE, Sort::ObjectArray, view, file, out);
}
