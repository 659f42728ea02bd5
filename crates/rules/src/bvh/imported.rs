//! Motions as a less strict importer reads them (`docs/loaders/mpfb/poses.md#motions`).

use super::super::{Rule, such};
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_formats::bvh::Joint;
use mhlint_formats::bvh::blender::{ImportFault, ImportFaultKind, ImportedMotion};
use mhlint_repo::{Body, FileFacts};

/// Which of the faults a rule is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum About {
    Lines,
    Frames,
}

/// Findings on the lines at which the importer stops.
pub(super) fn faults(rule: &Rule, about: About, body: &Body<'_>, out: &mut Vec<Finding>) {
    for (file, motion) in &body.imported_motions {
        let Some(fault) = motion
            .fault
            .as_ref()
            .filter(|fault| of(&fault.kind) == about)
        else {
            continue;
        };
        let (message, help) = words(fault);
        out.push(rule.at(file, Place::Line(fault.line), message).help(help));
    }
}

fn of(kind: &ImportFaultKind) -> About {
    match kind {
        ImportFaultKind::NotANumber(of, _) if *of != "`OFFSET`" => About::Frames,
        ImportFaultKind::NoTime | ImportFaultKind::ShortFrame(..) => About::Frames,
        _ => About::Lines,
    }
}

/// Message and help.
fn words(fault: &ImportFault) -> (String, String) {
    let again = "export the motion again".to_owned();
    match &fault.kind {
        ImportFaultKind::NotBvh(word) => (
            format!("expected `HIERARCHY`, found `{word}`"),
            "write `HIERARCHY` on the first line".to_owned(),
        ),
        ImportFaultKind::NoName => (
            "the joint has no name".to_owned(),
            "write the name of its bone".to_owned(),
        ),
        ImportFaultKind::ShortOffset => (
            "`OFFSET` has too few values".to_owned(),
            "write three numbers".to_owned(),
        ),
        ImportFaultKind::NotANumber(of, word) => {
            let point = word.replace(',', ".");
            let is_comma = word.contains(',') && point.parse::<f64>().is_ok();
            let help = if is_comma {
                format!("write `{point}`")
            } else {
                "write a number".to_owned()
            };
            (format!("`{word}` of {of} is not a number"), help)
        }
        ImportFaultKind::NoMotion => ("the file ends before `MOTION`".to_owned(), again),
        ImportFaultKind::NoTime => (
            "there is no line `Frame Time:` with a number".to_owned(),
            "write the time of a frame".to_owned(),
        ),
        ImportFaultKind::ShortFrame(there, needed) => {
            let numbers = if *there == 1 { "number" } else { "numbers" };
            (
                format!("the frame has {there} {numbers}, but the joints have {needed} channels"),
                again,
            )
        }
    }
}

/// Channels that mean nothing.
pub(super) fn unknown_channels(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for (file, motion) in &body.imported_motions {
        let Some((line, first)) = motion.unknown_channels.first() else {
            continue;
        };
        let count = motion.unknown_channels.len();
        let message = format!(
            "`{first}` is not the name of a channel{}",
            such(count, "channels")
        );
        let finding = rule.at(file, Place::Line(*line), message).key("unknown");
        let finding =
            finding.help("use the names `Xposition` to `Zposition` and `Xrotation` to `Zrotation`");
        out.push(finding.evidence(Evidence::counted(count)));
    }
}

/// Joints that have one name.
pub(super) fn repeated_joints(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    out.extend(
        body.imported_motions
            .iter()
            .filter_map(|(file, motion)| repeated(rule, file, motion)),
    );
}

fn repeated(rule: &Rule, file: &FileFacts, motion: &ImportedMotion) -> Option<Finding> {
    let pairs = motion.repeated.iter();
    let pairs = pairs
        .filter_map(|(at, before)| Some((motion.joints.get(*at)?, motion.joints.get(*before)?)));
    let again: Vec<(&Joint, &Joint)> = pairs.collect();
    let (joint, before) = again.first()?;
    let message = format!(
        "joint `{}` appears twice{}",
        joint.name,
        such(again.len(), "joints")
    );
    let finding = rule.at(file, Place::Span(joint.span.clone()), message);
    let finding = finding.related(
        file.path.clone(),
        Place::Span(before.span.clone()),
        "the first joint of that name",
    );
    let evidence = Evidence::of_cases(again.iter().map(|(joint, _)| joint.name.to_string()));
    Some(
        finding
            .help("give every joint the name of its bone")
            .evidence(evidence.out_of(motion.joints.len())),
    )
}
