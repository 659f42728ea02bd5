//! The data folder of the program has the files without which it does not start.

use super::super::{Check, Rule, RuleCx};
use super::{makehuman1_files, makehuman2_files, mpfb_files};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "exits at start"),
        (Makehuman1, "misses the file at start"),
        (Mpfb, "fails where it needs the file"),
    ],
    docs: include_str!("missing_file.md").trim_ascii_end(),
    of_library: true,
    ..RuleInfo::new(
        "program-missing-file",
        Level::Error,
        "a file of the program does not exist",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let Some(system) = layers
        .system
        .filter(|system| std::ptr::eq(*system, layers.checked))
    else {
        return;
    };
    if view.is_makehuman1() {
        makehuman1_files::missing(&RULE, view, system, out);
    } else if view.is_mpfb() {
        mpfb_files::missing(&RULE, view, system, out);
    } else {
        makehuman2_files::missing(&RULE, view, system, out);
    }
}
