//! Bones lie on the side that their names say.

use super::super::units::centimetres_of_metres;
use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::at_bones;
use super::located::{Placed, of_body};
use super::pairs::is_across;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_formats::rig::Rig;
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "builds the bone where it is written: it moves what lies on the side opposite to its name",
    )],
    docs: include_str!("wrong_side.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-wrong-side",
        Level::Warning,
        "a bone is not on the side its name says",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig, bones) in of_body(view) {
        out.extend(finding(file, rig, &bones));
    }
}

fn finding(file: &RigFile<'_>, rig: &Rig, bones: &[Placed<'_>]) -> Option<Finding> {
    let across: Vec<&Placed<'_>> = bones.iter().filter(|placed| is_across(placed)).collect();
    let (head, _) = across.first()?.found()?;
    let names: Vec<&str> = across
        .iter()
        .map(|placed| placed.bone.name.as_str())
        .collect();
    let is_not = if names.len() == 1 {
        "is not on the side its name says"
    } else {
        "are not on the side their names say"
    };
    let at = centimetres_of_metres(head[0]);
    let message = format!(
        "{} {is_not}: `{}` begins at x = {at}",
        bones_in_words(&names),
        names.first()?
    );
    let finding = at_bones(&RULE, file, rig, &names, "", message)?;
    Some(finding.help("swap the left and right joints, or name the vertices of the correct side"))
}
