//! A pose sets units.

use super::super::cause::schema::misspelt;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::UNITS;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "crashes with `KeyError` when the pose is shown"),
        (
            Makehuman1,
            "fails with `KeyError` when the expression is chosen",
        ),
    ],
    docs: include_str!("no_units.md").trim_ascii_end(),
    ..RuleInfo::new("pose-no-units", Level::Error, "a pose has no `unit_poses`")
});

const REST: Case = &[
    (Makehuman2, Level::Info, "shows the rest pose"),
    (
        Makehuman1,
        Level::Error,
        "fails with `RuntimeError` when the expression is chosen",
    ),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for pose in body
        .poses
        .iter()
        .filter(|pose| !pose.file.is_misshapen() || !pose.pose.has_units)
    {
        let file = pose.file;
        // What is no object at all is a matter of the schema, and so is nothing at all.
        let is_object = !super::super::cause::schema::is_of_wrong_type(file) && !file.json.falsy;
        if !pose.pose.has_units && is_object {
            let near = misspelt(file, UNITS).map(|unknown| unknown.key.as_str());
            let help = near.map_or_else(
                || did_you_mean(None, "add `unit_poses` with the units and their values"),
                |key| format!("did you mean `{UNITS}` instead of `{key}`?"),
            );
            out.push(
                RULE.at(file, Place::File, "`unit_poses` is missing")
                    .help(help),
            );
        } else if pose.pose.has_units
            && pose.pose.values.is_empty()
            && file.schema.faults.is_empty()
        {
            let finding = RULE
                .at(file, Place::pointer([UNITS]), "`unit_poses` is empty")
                .case(REST);
            out.push(finding.help("add units with their values"));
        }
    }
}
