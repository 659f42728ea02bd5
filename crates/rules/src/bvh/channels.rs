//! The channels of a joint must be as many as announced, and have known names.

use super::super::{Check, Rule, RuleCx, are, counted};
use super::{REJECTED, VALUE, imported};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::bvh::{Fault, FaultKind, Motion};
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "rejects the file with a message"),
        (
            Mpfb,
            "ignores the numbers of these channels: the joints do not turn",
        ),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("channels.md").trim_ascii_end(),
    ..RuleInfo::new(
        "bvh-channels",
        Level::Error,
        "the channels of a BVH joint do not fit",
    )
});

const UNUSED: Case = &[(
    Makehuman2,
    Level::Warning,
    "ignores the numbers of these channels: the joints do not turn",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    imported::unknown_channels(&RULE, body, out);
    for (file, motion) in &body.motions {
        out.extend(
            motion
                .fault
                .as_ref()
                .and_then(|fault| miscounted(file, fault)),
        );
        out.extend(unknown(file, motion));
    }
}

const CHANNELS: [&str; 6] = [
    "Xposition",
    "Yposition",
    "Zposition",
    "Xrotation",
    "Yrotation",
    "Zrotation",
];

fn miscounted(file: &FileFacts, fault: &Fault) -> Option<Finding> {
    let (message, help) = match fault.kind {
        FaultKind::NoChannels => (
            "the joint has no channels".to_owned(),
            "export the motion again with rotations for every joint".to_owned(),
        ),
        FaultKind::ChannelsNotWhole(ref word) => (
            format!("`CHANNELS {word}` is not a whole number"),
            "write the number of channels".to_owned(),
        ),
        FaultKind::Channels(announced, listed) => {
            let (channels, are) = (counted(listed, "channel"), are(listed));
            let message = format!("`CHANNELS {announced}`, but {channels} {are} listed");
            (
                message,
                format!("write `CHANNELS {listed}`, and a number for each channel in every frame"),
            )
        }
        _ => return None,
    };
    let case = if matches!(fault.kind, FaultKind::ChannelsNotWhole(_)) {
        VALUE
    } else {
        REJECTED
    };
    Some(
        RULE.at(file, Place::Line(fault.line), message)
            .case(case)
            .help(help),
    )
}

fn unknown(file: &FileFacts, motion: &Motion) -> Option<Finding> {
    let unknown = &motion.unknown_channels;
    let (line, first) = unknown.first.first().zip(motion.first_unknown.as_deref())?;
    let message = match unknown.count {
        1 => format!("`{first}` is not the name of a channel"),
        count => format!(
            "{count} of {} channel names are unknown, first `{first}`",
            motion.channels
        ),
    };
    let finding = RULE
        .at(file, Place::Line(*line), message)
        .case(UNUSED)
        .key("unknown");
    let evidence = unknown.evidence();
    let meant = CHANNELS
        .into_iter()
        .find(|known| known.eq_ignore_ascii_case(first));
    let help = match meant {
        Some(known) => format!("write `{known}`, with these capitals"),
        None => {
            "use the names `Xposition` to `Zposition` and `Xrotation` to `Zrotation`".to_owned()
        }
    };
    Some(
        finding
            .help(help)
            .evidence(evidence.out_of(motion.channels)),
    )
}
