//! An archive that cannot be loaded: of targets, of a base mesh or of an asset, or a zip of assets.

use super::super::{Check, Rule, RuleCx};
use super::Sort;
use super::pack;
use super::report::report;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes at every start until the archive is deleted by hand",
        ),
        (
            Makehuman1,
            "takes its targets from the texts; without these it finds none",
        ),
        (Mpfb, "rejects the zip: nothing of it is imported"),
    ],
    docs: include_str!("malformed.md").trim_ascii_end(),
    counts: "members",
    ..RuleInfo::new(
        "archive-malformed",
        Level::Error,
        "an archive of targets, of a base mesh or \
        of an asset that cannot be loaded, or a zip of assets that cannot be unpacked",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // MPFB reads no archives.
    if !view.is_mpfb() {
        view.files()
            .for_each(|file| report(&RULE, Sort::Malformed, view, file, out));
    }
    pack::report(&RULE, view.layers().checked, out);
}
