//! Poses set units that exist, and units have counterparts that exist.

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::{UNITS, foreign_unit, names};
use crate::diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{Body, BodyPose};

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "silently ignores the unit")],
    docs: "A pose sets a unit that `body-poses.json` of its base does not have, or an expression one that `face-poses.json` \
        does not have. The folder decides which of both is asked: `poses/` or `expressions/`.\n\n\
        MakeHuman 2 ignores such units without a message. Names of units in expressions of older versions are converted, \
        except `TongueUp`, `TongueDown`, `TonguePointUp` and `TonguePointDown`, which are lost.\n\n\
        The same rule reports units whose `rsym` or `lsym` does not exist: mirroring does nothing for them.\n\n\
        Correct the name, or move the file to the other folder.",
    ..RuleInfo::new("pose-unknown-unit", Level::Warning, "a pose sets a unit that does not exist")
});

const NO_MIRROR: Case = &[(Makehuman2, Level::Warning, "does nothing for this unit when a pose is mirrored")];

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for pose in &body.poses {
        out.extend(of_pose(body, pose, cx));
    }
    for (file, units) in body.pose_units.iter().filter_map(|own| own.units) {
        let known = names(units);
        let partners = units.units.iter().filter_map(|unit| Some((unit, unit.partner.as_ref()?)));
        let lost: Vec<_> = partners.filter(|(_, (_, partner))| !known.contains(partner.as_str())).collect();
        let Some((unit, (key, partner))) = lost.first().filter(|_| body.layers.is_checked(file)) else { continue };
        let more = such(lost.len(), "units");
        let message = format!("`{key}` of unit `{}` is `{partner}`, which does not exist{more}", unit.name);
        let near = cx.suggestions.nearest(partner, known.iter().copied());
        let finding = RULE.at(file, Place::pointer([unit.name.as_str(), key]), message).key("partner").case(NO_MIRROR);
        let evidence = Evidence::of_cases(lost.iter().map(|(unit, _)| &unit.name));
        out.push(finding.evidence(evidence).help(did_you_mean(near, "name a unit of this file, or remove the key")));
    }
}

fn of_pose(body: &Body<'_>, pose: &BodyPose<'_>, cx: &RuleCx<'_>) -> Option<Finding> {
    let (file, units) = body.units_of(pose)?;
    let known = names(units);
    let is_known = |unit: &str| {
        let today = (pose.renewed)(unit).unwrap_or(unit);
        known.contains(today)
    };
    let unknown: Vec<&str> = pose.pose.values.iter().map(|one| &*one.unit).filter(|unit| !is_known(unit)).collect();
    let first = unknown.first()?;
    let (count, all) = (unknown.len(), pose.pose.values.len());
    let message = match count {
        1 => format!("unit `{first}` does not exist in `{}`", file.file_name()),
        count if count == all => format!("none of the {all} units exists in `{}`, first `{first}`", file.file_name()),
        count => format!("{count} of {all} units do not exist in `{}`, first `{first}`", file.file_name()),
    };
    let near = cx.suggestions.nearest(first, known.iter().copied());
    let help = foreign_unit::help(body, pose, first)
        .unwrap_or_else(|| did_you_mean(near, format!("use a unit of `{}`, or remove it", file.file_name())));
    let evidence = Evidence::of_cases(unknown.iter().copied()).out_of(all);
    let finding = RULE.at(pose.file, Place::pointer([UNITS, first]), message).against(&file.path);
    Some(finding.evidence(evidence).help(help))
}
