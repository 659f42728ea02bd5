//! A bone begins where its parent ends, and not the other way about.

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::at_bones;
use super::located::{Placed, of_body};
use super::pairs::swapped;
use mhlint_diag::{Application::Mpfb, Confidence, Finding, Level, RuleInfo};
use mhlint_formats::rig::Rig;
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "builds the bone as it is written: it turns about the wrong end",
    )],
    docs: include_str!("swapped_ends.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-swapped-ends",
        Level::Warning,
        "head and tail of a bone are swapped",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig, bones) in of_body(view) {
        out.extend(finding(file, rig, &bones));
    }
}

fn finding(file: &RigFile<'_>, rig: &Rig, bones: &[Placed<'_>]) -> Option<Finding> {
    let swapped = swapped(bones);
    let message = match swapped.as_slice() {
        [one] => format!("bone `{one}` ends where its parent ends, and begins beyond it"),
        _ => format!(
            "{} end where their parents end, and begin beyond them",
            bones_in_words(&swapped)
        ),
    };
    let finding = at_bones(&RULE, file, rig, &swapped, "", message)?;
    Some(
        finding
            .confidence(Confidence::Medium)
            .help("swap `head` and `tail`"),
    )
}
