//! An asset pack must have its files where the importer takes them from.

use super::super::{Check, Rule, RuleCx};
use super::{Packed, lost, moved, named, unpacked};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::makehuman2::View;

// A zip for MakeHuman 1 is unpacked by people, who have their own ways.
pub(crate) static RULE: Rule = Check::LibrariesOfAll(
    run,
    |_, _, _| {},
    |view, _, out| unpacked::report(&RULE, view, out),
)
.rule(RuleInfo {
    breaks: &[
        (Makehuman2, "ignores the files on import"),
        (Mpfb, "rejects the zip"),
    ],
    docs: include_str!("layout.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pack-layout",
        Level::Error,
        "an asset pack that importing rejects, or with files that it loses, renames or overwrites",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(pack) = Packed::of(view.layers.checked) else {
        return;
    };
    lost::report(&RULE, &pack, out);
    moved::report(&RULE, &pack, view, out);
    named::report(&RULE, pack.layer, pack.pack, out);
}
