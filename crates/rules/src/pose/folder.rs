//! A stored pose of MPFB lies in the folder of a rig.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, counted, did_you_mean};
use super::mpfb_rigs::RIGS;
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo, grouped, nearest};
use mhlint_discover::Kind;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{POSE_ENDINGS, RigPart, View, rig_of_pose};
use mhlint_source::{file_name, parent};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "never offers the poses")],
    docs: include_str!("folder.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-folder",
        Level::Error,
        "poses of MPFB in a folder that no rig reads",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let poses = view.own(Kind::StoredPose).filter(|file| !file.is_loose);
    let poses = poses.filter(|file| file.stored_pose().is_some_and(|pose| pose.is_pose));
    let rigs = view.rigs.iter().filter(|rig| rig.part != RigPart::Asset);
    let rigs: BTreeSet<&str> = rigs.map(|rig| rig.name).collect();
    for (folder, files) in grouped(poses.map(|file| (parent(&file.rel), file))) {
        let right = match rig_of_pose(files.first().map_or("", |file| &file.rel)) {
            Some(rig) => match other_rig(rig, &rigs) {
                Some(right) => renamed(folder, rig, right),
                None => continue,
            },
            None => meant(folder),
        };
        out.extend(finding(folder, &files, right.as_deref()));
    }
}

/// The rig that is meant by one that does not exist.
fn other_rig(rig: &str, rigs: &BTreeSet<&str>) -> Option<&'static str> {
    let known = || RIGS.iter().map(|(name, _)| *name);
    if known().any(|name| name == rig) || rigs.contains(rig) {
        return None;
    }
    // No rig has a dash in its name.
    let in_other_case = known().find(|name| name.eq_ignore_ascii_case(&rig.replace('-', "_")));
    let shared = (rig == "default_no_toes").then_some("default");
    in_other_case.or(shared).or_else(|| nearest(rig, known()))
}

fn renamed(folder: &str, rig: &str, right: &str) -> Option<String> {
    let ending = folder
        .split('/')
        .rev()
        .find_map(|name| name.strip_prefix(rig))?;
    Some(format!("{right}{ending}"))
}

/// The name that a folder without the ending of a rig is meant to have.
fn meant(folder: &str) -> Option<String> {
    let name = file_name(folder);
    let known = RIGS.iter().flat_map(|(rig, _)| {
        POSE_ENDINGS
            .iter()
            .map(move |ending| format!("{rig}{ending}"))
    });
    let known: Vec<String> = known.collect();
    let in_other_case = known.iter().find(|one| one.eq_ignore_ascii_case(name));
    let alone = || {
        RIGS.iter()
            .find(|(rig, _)| rig.eq_ignore_ascii_case(name))
            .map(|(rig, _)| format!("{rig}_fk"))
    };
    in_other_case.cloned().or_else(alone)
}

fn finding(folder: &str, files: &[&FileFacts], right: Option<&str>) -> Option<Finding> {
    let name = file_name(folder);
    let count = counted(files.len(), "pose");
    let (message, otherwise) = if folder == "poses" {
        (
            format!("{count} in `poses` itself, not in the folder of a rig"),
            "move them to a folder such as `default_fk`",
        )
    } else {
        let otherwise = "name the folder after the rig, with `_fk`, `_ik` or `_partial`";
        (
            format!("{count} in `{name}`, which is not the folder of a rig"),
            otherwise,
        )
    };
    let finding = RULE
        .at(files.first()?, Place::File, message)
        .key(format!("folder {folder}"));
    let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
    let evidence = Evidence::of_cases(files.iter().map(|file| file.shown()));
    Some(
        finding
            .evidence(evidence)
            .help(did_you_mean(right, otherwise)),
    )
}
