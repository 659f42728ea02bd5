//! The special keys of a selection filter are written in one way.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level, Place, RuleInfo};
use mhlint_formats::selection_filter::Outcome;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "reads the key as a label, and crashes at start with `TypeError`",
    )],
    docs: include_str!("syntax.md").trim_ascii_end(),
    ..RuleInfo::new(
        "filter-syntax",
        Level::Error,
        "a special key of a selection filter in another spelling",
    )
});

const IN_LIST: Case = &[(
    Makehuman2,
    Level::Error,
    "reads the key as a label, and crashes with `TypeError` every time the list is opened",
)];
const LABEL: Case = &[(
    Makehuman2,
    Level::Warning,
    "reads the key as a label and does not use what is in it",
)];

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(filter) = file.filter() else { return };
    for misspelt in &filter.misspelt {
        let (key, meant) = (&misspelt.key, misspelt.meant);
        let finding = RULE.at(
            file,
            Place::Key(mhlint_diag::pointer(&[key])),
            format!("`{key}` is not a special key"),
        );
        let finding = finding.key(key).help(format!("write `{meant}`"));
        out.push(match misspelt.outcome {
            Outcome::CrashesAtStart => finding,
            Outcome::CrashesInList => finding.case(IN_LIST),
            Outcome::Labels => finding.case(LABEL),
        });
    }
}
