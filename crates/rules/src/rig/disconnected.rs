//! A connected bone begins where its parent ends.

use super::super::units::centimetres_of_metres;
use super::super::{Check, Rule, RuleCx, such};
use super::at_bones;
use super::located::{Placed, apart, by_name, of_body};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_eval::mpfb::rest::NO_LENGTH;
use mhlint_formats::rig::Rig;
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "silently moves the head of the bone to the tail of its parent",
    )],
    docs: include_str!("disconnected.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-disconnected",
        Level::Warning,
        "a connected bone does not begin where its parent ends",
    )
});

/// Distances up to this come from rounded coordinates, in metres.
const GAP: f64 = 1e-5;

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig, bones) in of_body(view) {
        out.extend(finding(file, rig, &bones));
    }
}

fn finding(file: &RigFile<'_>, rig: &Rig, bones: &[Placed<'_>]) -> Option<Finding> {
    let known = by_name(bones);
    let gap = |placed: &Placed<'_>| {
        let parent = known.get(
            placed
                .bone
                .parent
                .as_deref()
                .filter(|_| placed.bone.use_connect)?,
        )?;
        let ((head, tail), (_, end)) = (placed.found()?, parent.found()?);
        // A bone of no length is reported by `rig-zero-length-bone`.
        Some(apart(head, end)).filter(|_| apart(tail, end) >= NO_LENGTH)
    };
    let found: Vec<(&str, f64)> = bones
        .iter()
        .filter_map(|placed| {
            Some((
                placed.bone.name.as_str(),
                gap(placed).filter(|gap| *gap > GAP)?,
            ))
        })
        .collect();
    let (worst, gap) = found.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let message = format!(
        "bone `{worst}` is connected and begins {} away from where its parent ends{}",
        centimetres_of_metres(*gap),
        such(found.len(), "bones")
    );
    let mut names = vec![*worst];
    names.extend(
        found
            .iter()
            .map(|(name, _)| *name)
            .filter(|name| name != worst),
    );
    let finding = at_bones(&RULE, file, rig, &names, "use_connect", message)?;
    Some(finding.help(
        "give `head` the strategy of the parent's `tail`, or write `false` for `use_connect`",
    ))
}
