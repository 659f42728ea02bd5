//! There must be as many frames as announced, each with a number for every channel.

use super::super::{Check, Rule, RuleCx};
use super::frame_fault::{self, NOT_SHOWN};
use super::imported::{self, About};
use super::of_units;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::bvh::{Fault, FaultKind, Motion};
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` when the pose is chosen",
        ),
        (
            Makehuman1,
            "does not show the pose: `RuntimeError` when it reads the file",
        ),
        (
            Mpfb,
            "lists the pose, and rejects the file with a message when it is chosen",
        ),
    ],
    docs: include_str!("frames.md").trim_ascii_end(),
    ..RuleInfo::new(
        "bvh-frames",
        Level::Error,
        "the frames of a BVH file do not fit its header",
    )
});

const FRAMES_IGNORED: Case = &[
    (Makehuman2, Level::Warning, "ignores the extra frames"),
    (Makehuman1, Level::Warning, "ignores the extra frames"),
];
const NUMBERS_IGNORED: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "ignores the extra numbers at the end of the line",
    ),
    (
        Makehuman1,
        Level::Warning,
        "ignores the extra numbers at the end of the line",
    ),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    imported::faults(&RULE, About::Frames, body, out);
    for (file, motion) in &body.motions {
        let stops = motion
            .fault
            .as_ref()
            .and_then(|fault| at_fault(file, motion, fault));
        out.extend(
            stops
                .into_iter()
                .chain(timeless(body, file, motion))
                .map(|one| of_units(body, file, one)),
        );
        out.extend(surplus_frames(file, motion));
        out.extend(surplus_numbers(file, motion));
    }
}

fn at_fault(file: &FileFacts, motion: &Motion, fault: &Fault) -> Option<Finding> {
    let (message, case, help) = frame_fault::words(motion, fault)?;
    // What is missing at the end is told where it is announced.
    let announced = motion
        .frames
        .as_ref()
        .filter(|_| matches!(fault.kind, FaultKind::TooFew));
    let line = announced.map_or(fault.line, |(_, line)| *line);
    Some(
        RULE.at(file, Place::Line(line), message)
            .case(case)
            .help(help),
    )
}

/// Of motions without time `MakeHuman` 1 divides by that.
fn timeless(body: &Body<'_>, file: &FileFacts, motion: &Motion) -> Option<Finding> {
    let line = motion
        .timeless
        .filter(|_| motion.fault.is_none() && body.is_makehuman1())?;
    let finding = RULE
        .at(
            file,
            Place::Line(line),
            "`Frame Time: 0`: no time between the frames",
        )
        .case(NOT_SHOWN);
    Some(
        finding
            .key("time")
            .help("write the time of a frame in seconds, such as `Frame Time: 0.041667`"),
    )
}

fn surplus_frames(file: &FileFacts, motion: &Motion) -> Option<Finding> {
    let (announced, line) = motion
        .frames
        .as_ref()
        .filter(|_| motion.surplus_frames > 0)?;
    let there = motion.frames_there;
    let message = format!("`Frames: {announced}`, but the file has {there} frames");
    let finding = RULE
        .at(file, Place::Line(*line), message)
        .key("surplus")
        .case(FRAMES_IGNORED);
    Some(finding.help(format!(
        "write `Frames: {there}`, or remove the extra lines"
    )))
}

fn surplus_numbers(file: &FileFacts, motion: &Motion) -> Option<Finding> {
    let line = *motion.surplus_numbers.first.first()?;
    let message = format!(
        "a frame has more numbers than the joints have channels ({})",
        motion.channels
    );
    let evidence = motion.surplus_numbers.evidence();
    let finding = RULE
        .at(file, Place::Line(line), message)
        .key("numbers")
        .case(NUMBERS_IGNORED)
        .evidence(evidence);
    Some(finding.help("remove them, or add the missing channels to the joints"))
}
