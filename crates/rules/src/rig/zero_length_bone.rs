//! The head and the tail of a bone are at different places.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::located::{Placed, apart, of_body};
use super::{STOPS, at_bones};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_eval::mpfb::rest::{Defined, NO_LENGTH, Roll, rest};
use mhlint_formats::rig::Rig;
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("zero_length_bone.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-zero-length-bone",
        Level::Error,
        "head and tail of a bone coincide",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig, bones) in of_body(view) {
        out.extend(finding(file, rig, &bones));
    }
}

fn finding(file: &RigFile<'_>, rig: &Rig, bones: &[Placed<'_>]) -> Option<Finding> {
    let known: Vec<(&Placed<'_>, _)> = bones
        .iter()
        .filter_map(|placed| Some((placed, placed.ends()?)))
        .collect();
    let numbers: BTreeMap<&str, usize> = known
        .iter()
        .enumerate()
        .map(|(at, (placed, _))| (placed.bone.name.as_str(), at))
        .collect();
    let defined: Vec<Defined> = known
        .iter()
        .map(|(placed, (head, tail))| Defined {
            head: *head,
            tail: *tail,
            roll: Roll::Angle(0.0),
            parent: placed
                .bone
                .parent
                .as_deref()
                .and_then(|parent| numbers.get(parent))
                .copied(),
            use_connect: placed.bone.use_connect,
        })
        .collect();
    let rested = rest(&defined);
    let is_short = |head, tail| apart(head, tail) < NO_LENGTH;
    let short = known
        .iter()
        .zip(&rested)
        .filter(|(_, bone)| is_short(bone.head, bone.tail));
    let short: Vec<(&str, bool)> = short
        .map(|((placed, (head, tail)), _)| (placed.bone.name.as_str(), is_short(*head, *tail)))
        .collect();
    let names: Vec<&str> = short.iter().map(|(name, _)| *name).collect();
    let (_, was_short) = short.first()?;
    let have = if names.len() == 1 { "has" } else { "have" };
    let why = if *was_short {
        ""
    } else {
        " once it is connected with its parent"
    };
    let message = format!("{} {have} no length{why}", bones_in_words(&names));
    let finding = at_bones(&RULE, file, rig, &names, "tail", message)?;
    Some(finding.help(if *was_short {
        "give the bone two different ends"
    } else {
        "write `false` for `use_connect`"
    }))
}
