//! Faults in the frames of a motion, in words.

use super::super::counted;
use super::{INDEX, VALUE};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Level,
};
use mhlint_formats::bvh::{Fault, FaultKind, Motion};

/// What becomes of a motion without frames, or without time between them.
pub(super) const NOT_SHOWN: Case = &[
    (
        Makehuman2,
        Level::Error,
        "crashes with `IndexError` when the pose is shown or exported",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not show the pose: `ZeroDivisionError`",
    ),
];

/// Message, consequence and help.
pub(super) fn words(motion: &Motion, fault: &Fault) -> Option<(String, Case, String)> {
    let again = || "export the motion again, or correct the line".to_owned();
    Some(match &fault.kind {
        FaultKind::NotWhole(word) => (
            format!("`Frames: {word}` is not a whole number"),
            VALUE,
            "write the number of frames".to_owned(),
        ),
        FaultKind::NoFrames(0) => (
            "`Frames: 0`: the motion has no frames".to_owned(),
            NOT_SHOWN,
            again(),
        ),
        FaultKind::NoFrames(count) => (format!("`Frames: {count}` is negative"), VALUE, again()),
        FaultKind::TooFew => {
            let ((announced, _), there) = (motion.frames.as_ref()?, motion.frames_there);
            let help = format!("write `Frames: {there}`, or add the missing frames");
            (
                format!(
                    "`Frames: {announced}`, but the file has {}",
                    counted(there, "frame")
                ),
                INDEX,
                help,
            )
        }
        FaultKind::BlankFrame => (
            "blank line between the frames".to_owned(),
            INDEX,
            "remove the blank line".to_owned(),
        ),
        FaultKind::ShortFrame(there, needed) => (
            format!(
                "the frame has {}, but the joints have {needed} channels",
                counted(there, "number")
            ),
            INDEX,
            again(),
        ),
        FaultKind::WordInFrame(word) => (
            format!("`{word}` in a frame is not a number"),
            VALUE,
            number(word),
        ),
        FaultKind::NotANumber(of, word) if fault.kind.is_of_frames() => (
            format!("`{word}` of {of} is not a number"),
            VALUE,
            number(word),
        ),
        FaultKind::Missing(of) if fault.kind.is_of_frames() => (
            format!("{of} has no value"),
            INDEX,
            format!("write a number after {of}"),
        ),
        _ => return None,
    })
}

/// What to write in place of a word.
fn number(word: &str) -> String {
    match word.split_once(',') {
        Some((whole, part))
            if [whole, part]
                .iter()
                .all(|digits| digits.parse::<i64>().is_ok()) =>
        {
            format!("write `{whole}.{part}`")
        }
        _ => "replace it with a number, or export the motion again".to_owned(),
    }
}
