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
    breaks: &[(Makehuman2, "refuses the asset with a message: it cannot be put on"), (Makehuman1, "finds the target no longer, or reads its text")],
    docs: "A member of an archive does not exist. `base.mhbin` of a base mesh needs `header`, `grpNames`, `coord`, `uvs`, \
        `overflow`, `groupinfo`, `vertsperface` and `faceverts`; `.mhbin` of an asset needs the same, `asset` and what \
        that says.\n\n\
        MakeHuman 2 rejects a base mesh without one of them, so that the window opens without a base. Without `asset` it \
        crashes at start while scanning the assets, and the next start has no assets at all. With any other member missing \
        the asset is refused with a message.\n\n\
        Delete the archive if the text that it was made from is beside it, or rebuild it.",
    counts: "members",
    ..RuleInfo::new("archive-missing-member", Level::Error, "an archive lacks a member")
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    report(&RULE, Sort::MissingMember, view, file, out);
}
