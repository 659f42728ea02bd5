//! `licence` in a pose, which nobody reads.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Change, Finding, Fix, FixKind, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "ignores the key: the pose has no license in the editor, and none after it is saved there",
    )],
    docs: include_str!("licence_spelling.md").trim_ascii_end(),
    fix: FixKind::Safe,
    ..RuleInfo::new(
        "pose-licence-spelling",
        Level::Info,
        "`licence` in a pose is not read",
    )
});

/// The key as the editor writes it, and as it is read.
const WRITTEN: &str = "licence";
const READ: &str = "license";

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if file.kind != Kind::Pose {
        return;
    }
    let Some(unknown) = file
        .schema
        .unknown
        .iter()
        .find(|unknown| unknown.pointer == "/licence")
    else {
        return;
    };
    let finding = RULE.at(
        file,
        Place::Key(unknown.pointer.clone()),
        format!("`{WRITTEN}` is not read"),
    );
    let finding = finding.help(format!("write `{READ}`"));
    // With both there would be two of one key.
    let has_both = file.pose().is_some_and(|pose| pose.has_license);
    let change = Change::Key {
        pointer: unknown.pointer.clone(),
        key: READ,
    };
    let fix = || {
        Fix::new(RULE.info.fix, format!("rename `{WRITTEN}` to `{READ}`")).step(&file.path, change)
    };
    out.push(if has_both {
        finding.help("remove the key")
    } else {
        finding.fix(fix())
    });
}
