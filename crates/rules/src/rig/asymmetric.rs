//! Left and right bones mirror each other.

use super::super::{Check, Rule, RuleCx, such};
use super::ends::is_negative;
use super::located::{Placed, apart, by_name, of_body};
use super::{at_bones, pairs};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_eval::side::Side;
use mhlint_eval::vector::Vec3;
use mhlint_formats::rig::{End, Rig};
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "builds the bones as they are written; poses that are mirrored do not fit",
    )],
    docs: include_str!("asymmetric.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-asymmetric",
        Level::Info,
        "a left bone is unlike its right one",
    )
});

/// Two places mirror each other if the mirror image of the one is nearer than this to the other, in
/// metres.
const NEAR: f64 = 5e-3;

/// How a left bone and its right counterpart differ.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Unlike {
    Connected,
    Head,
    Tail,
}

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig, bones) in of_body(view) {
        out.extend(finding(file, rig, &bones));
    }
}

fn finding(file: &RigFile<'_>, rig: &Rig, bones: &[Placed<'_>]) -> Option<Finding> {
    let known = by_name(bones);
    let pair = |placed: &Placed<'_>| {
        // Only from the left bone, so that each pair is compared once.
        let (_, partner) = pairs::of(&placed.bone.name).filter(|(side, _)| *side == Side::Left)?;
        known.get(partner.as_str()).copied()
    };
    // Bones on the wrong side and bones with swapped ends are reported by `rig-wrong-side` and
    // `rig-swapped-ends`.
    let swapped = pairs::swapped(bones);
    let is_told =
        |one: &Placed<'_>| pairs::is_across(one) || swapped.contains(&one.bone.name.as_str());
    let unlike: Vec<(&str, &str, Unlike)> = bones
        .iter()
        .filter_map(|left| {
            let right = pair(left).filter(|right| !is_told(left) && !is_told(right))?;
            Some((
                left.bone.name.as_str(),
                right.bone.name.as_str(),
                unlike(left, right)?,
            ))
        })
        .collect();
    let (left, right, how) = unlike.first()?;
    let how = match how {
        Unlike::Connected => "is connected with its parent, or not, unlike",
        Unlike::Head => "does not begin where it mirrors",
        Unlike::Tail => "does not end where it mirrors",
    };
    let message = format!(
        "bone `{left}` {how} `{right}`{}",
        such(unlike.len(), "bones")
    );
    let names: Vec<&str> = unlike.iter().map(|(left, ..)| *left).collect();
    let finding = at_bones(&RULE, file, rig, &names, "", message)?;
    Some(
        finding
            .help("give both bones the same keys, and joints or vertices that mirror each other"),
    )
}

fn unlike(left: &Placed<'_>, right: &Placed<'_>) -> Option<Unlike> {
    if left.bone.use_connect != right.bone.use_connect {
        return Some(Unlike::Connected);
    }
    let ((left_head, left_tail), (right_head, right_tail)) = (left.found()?, right.found()?);
    let is_off = |own: Vec3, other: Vec3| apart([-own[0], own[1], own[2]], other) > NEAR;
    let is_told = |ends: [&Option<End>; 2]| ends.into_iter().flatten().any(is_negative);
    let (own, other) = (left.bone, right.bone);
    if is_off(left_head, right_head) && !is_told([&own.head, &other.head]) {
        return Some(Unlike::Head);
    }
    let is_unlike = is_off(left_tail, right_tail) && !is_told([&own.tail, &other.tail]);
    is_unlike.then_some(Unlike::Tail)
}
