//! A bone begins where its parent ends, and not the other way about.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::located::{Placed, apart, by_name, of_body};
use super::{at_bones, bones_in_words};
use crate::diag::{Application::Mpfb, Confidence, Finding, Level, RuleInfo, grouped};
use crate::formats::rig::Rig;
use crate::repo::mpfb::{RigFile, View};

pub(in crate::rules) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "builds the bone as it is written: it turns about the wrong end")],
    docs: "A bone ends where its parent ends, begins beyond that, and no bone below it begins where it ends.\n\n\
        MPFB builds it so. The bone points towards its parent and turns about its far end.\n\n\
        Swap `head` and `tail`.",
    counts: "bones",
    ..RuleInfo::new("rig-swapped-ends", Level::Warning, "head and tail of a bone are swapped")
});

/// Places nearer than this are one, metres.
const ONE_PLACE: f64 = 1e-4;
/// How much farther from the head of the parent than its tail the head must be to lie beyond.
const BEYOND: f64 = 1.05;

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig, bones) in of_body(view) {
        out.extend(finding(file, rig, &bones));
    }
}

fn finding(file: &RigFile<'_>, rig: &Rig, bones: &[Placed<'_>]) -> Option<Finding> {
    let known = by_name(bones);
    let parent = |placed: &Placed<'_>| known.get(placed.bone.parent.as_deref()?).copied();
    let children: BTreeMap<&str, Vec<&Placed<'_>>> =
        grouped(bones.iter().filter_map(|child| Some((child.bone.parent.as_deref()?, child))));
    let is_swapped = |placed: &&Placed<'_>| {
        let ends = placed.found().zip(parent(placed).and_then(Placed::found));
        let Some(((head, tail), (parent_head, parent_tail))) = ends else { return false };
        let length = apart(parent_head, parent_tail);
        let begins_there = |child: &&Placed<'_>| child.found().is_some_and(|(head, _)| apart(head, tail) < ONE_PLACE);
        let own = children.get(placed.bone.name.as_str()).map(Vec::as_slice).unwrap_or_default();
        apart(tail, parent_tail) < ONE_PLACE
            && apart(head, tail) > ONE_PLACE
            && length > ONE_PLACE
            && apart(head, parent_head) > BEYOND * length
            && !own.iter().any(begins_there)
    };
    let swapped = bones.iter().filter(is_swapped).map(|placed| placed.bone.name.as_str());
    let swapped: Vec<&str> = swapped.collect();
    let message = match swapped.as_slice() {
        [one] => format!("bone `{one}` ends where its parent ends, and begins beyond it"),
        _ => format!("{} end where their parents end, and begin beyond them", bones_in_words(&swapped)),
    };
    let finding = at_bones(&RULE, file, rig, &swapped, "", message)?;
    Some(finding.confidence(Confidence::Medium).help("swap `head` and `tail`"))
}
