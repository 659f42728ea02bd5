//! The default position of the end of a bone is near the place that the strategy of the end finds.

use super::super::{Check, Rule, RuleCx, such};
use super::at_bones;
use super::ends::is_negative;
use super::located::{Placed, apart, of_body, place_in_words};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_eval::mpfb::joints::Located;
use mhlint_eval::vector::{Vec3, sub};
use mhlint_eval::worn::median;
use mhlint_formats::rig::{DefaultPosition, Rig};
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "uses the place that the strategy finds; only where it finds none the end lies elsewhere",
    )],
    docs: include_str!("default_position_drift.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-default-position-drift",
        Level::Info,
        "a default position is far from where the end is found",
    )
});

/// Distance in metres from which a default position is reported. Rigs that are in order stay within
/// 0.078 on the base mesh (`docs/loaders/mpfb/shipped-rigs.md#drift-of-default-positions`).
const FAR: f64 = 0.1;

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig, bones) in of_body(view) {
        out.extend(finding(file, rig, &bones));
    }
}

/// An end of a bone with the place that its strategy finds and its default position.
struct Known<'r> {
    bone: &'r str,
    which: &'static str,
    found: Vec3,
    written: Vec3,
}

fn finding(file: &RigFile<'_>, rig: &Rig, bones: &[Placed<'_>]) -> Option<Finding> {
    let known = known(bones);
    let shift: Vec<f64> = (0..3)
        .map(|axis| {
            median(
                known
                    .iter()
                    .map(|one| one.written[axis] - one.found[axis])
                    .collect(),
            )
        })
        .collect();
    let [x, y, z] = shift.as_slice() else {
        return None;
    };
    let off = |one: &Known<'_>| apart(sub(one.written, one.found), [*x, *y, *z]);
    let far: Vec<&Known<'_>> = known.iter().filter(|one| off(one) > FAR).collect();
    let worst = far.iter().max_by(|a, b| off(a).total_cmp(&off(b)))?;
    let message = format!(
        "`default_position` of `{}` of bone `{}` is {:.2} m from where the end is found{}",
        worst.which,
        worst.bone,
        off(worst),
        such(far.len(), "ends")
    );
    let mut names: Vec<&str> = vec![worst.bone];
    names.extend(
        far.iter()
            .map(|one| one.bone)
            .filter(|bone| *bone != worst.bone),
    );
    names.dedup();
    let finding = at_bones(&RULE, file, rig, &names, worst.which, message)?;
    let meant = place_in_words(
        [0, 1, 2].map(|axis| worst.found[axis] + shift.get(axis).copied().unwrap_or(0.0)),
    );
    Some(finding.help(format!(
        "save the rig again in MPFB; this one is found at {meant}"
    )))
}

fn known<'r>(bones: &[Placed<'r>]) -> Vec<Known<'r>> {
    let ends = bones.iter().flat_map(|placed| {
        let bone = placed.bone;
        [
            (bone, "head", &bone.head, placed.head),
            (bone, "tail", &bone.tail, placed.tail),
        ]
    });
    let known = ends.filter_map(|(bone, which, end, located)| {
        let end = end.as_ref().filter(|end| !is_negative(end))?;
        let (DefaultPosition::At(written), Located::Found(found)) = (end.default_position, located)
        else {
            return None;
        };
        written.iter().all(|one| one.is_finite()).then_some(Known {
            bone: &bone.name,
            which,
            found,
            written,
        })
    });
    known.collect()
}
