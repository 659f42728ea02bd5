//! What a list shows has a label of its own.

use super::super::library::{shelves, side_by_side};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "lists only one of them; the other cannot be chosen")],
    docs: "Two assets of one list have the same label: the name of the file in small letters, with spaces for `_`. \
        `my_shirt.mhclo` and `My Shirt.mhclo` are one, and so are two files of one name in different folders.\n\n\
        MPFB lists the one that it finds last, and hides the other without a message. Of copies with equal content nothing \
        is lost (a warning). Packs that are each named as PATH are held against one another.\n\n\
        Rename one of the files.",
    ..RuleInfo::new("proxy-label-clash", Level::Error, "two assets of one list with the same label")
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    shelves::same_labels(&RULE, view, out);
    side_by_side::in_mpfb(&RULE, view, cx.beside, out);
}
