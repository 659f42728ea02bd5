//! Nesting has a limit.

use super::super::cause::consequence::{Damage, consequence};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::formats::Content;
use crate::formats::json_file::JsonFault;
use crate::json::SyntaxKind;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops with a RecursionError: the nesting passes Python's limit of about 1000 levels",
        )],
        docs: "No format of the family nests deeper than a handful of levels. A file that goes beyond 990 was not made for \
            any of them: it is damaged, or meant to bring a reader down.\n\n`mhlint` stops reading there, so nothing else \
            can be said about the file. Python's reader gives up at about 1000 levels with an exception that MakeHuman 2 \
            does not expect.\n\nReplace the file.",
        ..RuleInfo::new("json-too-deep", Level::Error, "a JSON is nested beyond the limit")
    },
    check: Check::File(run),
};

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Content::Broken(JsonFault::Syntax(fault)) = &*file.content else { return };
    if fault.kind == SyntaxKind::TooDeep {
        let finding = RULE.at(file, Place::Span(fault.span.clone()), fault.to_string());
        let finding = finding.help("no format needs more than ten levels; replace the file");
        out.extend(consequence(view, &file.rel, Damage::TooDeep).map(|loss| loss.of(view, finding)));
    }
}
