//! Every line of a motion must be the one that is expected there.

use super::super::{Check, Rule, RuleCx};
use super::imported::{self, About};
use super::{INDEX, REJECTED, VALUE, of_units};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::bvh::{Fault, FaultKind};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "rejects the file or crashes when the pose is chosen",
        ),
        (Makehuman1, "does not show the pose: it rejects the file"),
        (
            Mpfb,
            "lists the pose, and rejects the file with a message when it is chosen",
        ),
    ],
    docs: include_str!("syntax.md").trim_ascii_end(),
    ..RuleInfo::new(
        "bvh-syntax",
        Level::Error,
        "a line of a BVH file is not what is expected there",
    )
});

const BEFORE_ROOT: Case = &[(
    Makehuman2,
    Level::Error,
    "rejects the file with a message and shows the rest pose",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    imported::faults(&RULE, About::Lines, body, out);
    for (file, motion) in &body.motions {
        let is_other = |kind: &FaultKind| kind.is_of_frames() || kind.is_of_channels();
        let Some(fault) = motion.fault.as_ref().filter(|fault| !is_other(&fault.kind)) else {
            continue;
        };
        let Some((message, case, help)) = words(fault) else {
            continue;
        };
        let finding = RULE
            .at(file, Place::Line(fault.line), message)
            .case(case)
            .help(help);
        out.push(of_units(body, file, finding));
    }
}

/// What to write in place of a word.
fn instead(expected: &str, found: &str) -> String {
    let keyword = expected.trim_matches('`');
    match found
        .strip_prefix(keyword)
        .filter(|rest| keyword.ends_with(':') && !rest.is_empty())
    {
        Some(value) => format!("write `{keyword} {value}`, with a space between them"),
        None if found == "ROOT" && keyword != "HIERARCHY" => {
            "keep one `ROOT`, and make the other a `JOINT` in it".to_owned()
        }
        None => format!("write {expected} on a line of its own here"),
    }
}

/// Message, consequence and help.
fn words(fault: &Fault) -> Option<(String, Case, String)> {
    Some(match &fault.kind {
        FaultKind::Expected(expected, found) => {
            let case = if fault.is_inside {
                REJECTED
            } else {
                BEFORE_ROOT
            };
            (
                format!("expected {expected}, found `{found}`"),
                case,
                instead(expected, found),
            )
        }
        FaultKind::Blank(expected) => (
            format!("expected {expected}, found a blank line"),
            INDEX,
            "remove the blank line".to_owned(),
        ),
        FaultKind::End(expected) => {
            let help = "export the motion again: the end of the file is missing";
            (
                format!("the file ends before {expected}"),
                INDEX,
                help.to_owned(),
            )
        }
        FaultKind::NoName => (
            "the joint has no name".to_owned(),
            INDEX,
            "write the name of its bone".to_owned(),
        ),
        FaultKind::Missing(of) => (
            format!("{of} has too few values"),
            INDEX,
            "add the missing value".to_owned(),
        ),
        FaultKind::NotANumber(of, word) => (
            format!("`{word}` of {of} is not a number"),
            VALUE,
            "write the number with a decimal point".to_owned(),
        ),
        _ => return None,
    })
}
