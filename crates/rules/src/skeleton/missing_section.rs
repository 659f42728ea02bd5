//! A skeleton needs `bones` and `joints`, a bone `head` and `tail`.

use super::super::cause::consequence::NOT_SCANNED;
use super::super::cause::schema::misspelt;
use super::super::{Check, Rule, RuleCx};
use super::{Rig, rigs};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhskel::{Bone, Section};
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "rejects the skeleton and logs a line; poses and exports cannot use it",
        ),
        (
            Makehuman1,
            "fails with `KeyError` when the skeleton is chosen",
        ),
    ],
    docs: include_str!("missing_section.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-missing-section",
        Level::Error,
        "a required part of a skeleton is missing",
    )
});

const EMPTY: Case = &[(Makehuman2, Level::Error, NOT_SCANNED)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        missing_sections(body, &rig, out);
        for member in ["head", "tail"] {
            let end = |bone: &Bone| {
                if member == "head" {
                    bone.head.clone()
                } else {
                    bone.tail.clone()
                }
            };
            let is_empty =
                |bone: &Bone| body.is_makehuman1() && end(bone).is_some_and(|name| name.is_empty());
            let bones = rig
                .skeleton
                .bones
                .iter()
                .filter(|bone| bone.missing.contains(&member) || is_empty(bone));
            let names: Vec<&str> = bones.map(|bone| bone.name.as_str()).collect();
            let Some(first) = names.first() else { continue };
            let message = match names.len() {
                1 => format!("bone `{first}` has no `{member}`"),
                count => format!("{count} bones have no `{member}`, first `{first}`"),
            };
            out.push(
                RULE.at(rig.file, Place::pointer(["bones", first]), message)
                    .key(member)
                    .help(format!(
                        "set `{member}` to the joint where the bone {}",
                        if member == "head" { "begins" } else { "ends" }
                    ))
                    .evidence(Evidence::of_cases(&names).out_of(rig.skeleton.bones.len())),
            );
        }
    }
}

fn missing_sections(body: &Body<'_>, rig: &Rig<'_>, out: &mut Vec<Finding>) {
    if rig.file.json.falsy && !body.is_makehuman1() {
        let finding = RULE.at(
            rig.file,
            Place::File,
            "the skeleton is empty: `bones` and `joints` are missing",
        );
        out.push(
            finding
                .case(EMPTY)
                .help("remove the file, or export the skeleton again"),
        );
        return;
    }
    for (name, section) in [
        ("bones", rig.skeleton.bones_section),
        ("joints", rig.skeleton.joints_section),
    ] {
        if section == Section::Absent && (name == "bones" || !body.is_makehuman1()) {
            let message = format!("the skeleton has no `{name}`");
            out.push(
                RULE.at(rig.file, Place::File, message)
                    .key(name)
                    .help(help(rig.file, name)),
            );
        }
    }
}

fn help(file: &FileFacts, section: &str) -> String {
    match misspelt(file, section) {
        Some(key) => format!("rename `{}` to `{section}`", key.key),
        None => format!("add an object `{section}`"),
    }
}
