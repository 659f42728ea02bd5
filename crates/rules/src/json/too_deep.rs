//! Nesting has a limit.

use super::super::cause::consequence::{Damage, consequence};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_formats::Content;
use mhlint_formats::json_file::JsonFault;
use mhlint_json::SyntaxKind;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `RecursionError` if the nesting exceeds Python's limit of \
            about 1000 levels",
        ),
        (
            Mpfb,
            "fails with `RecursionError` if the nesting exceeds Python's limit of about 1000 \
            levels",
        ),
    ],
    docs: include_str!("too_deep.md").trim_ascii_end(),
    ..RuleInfo::new(
        "json-too-deep",
        Level::Error,
        "a JSON that is nested too deeply",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Content::Broken(JsonFault::Syntax(fault)) = &*file.content else {
        return;
    };
    if fault.kind == SyntaxKind::TooDeep {
        let finding = RULE.at(file, Place::Span(fault.span.clone()), fault.to_string());
        let finding = finding.help("replace the file; no format needs more than ten levels");
        out.extend(
            consequence(view, &file.rel, Damage::TooDeep).map(|loss| loss.of(view, finding)),
        );
    }
}
