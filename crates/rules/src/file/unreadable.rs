//! What cannot be opened, listed or read.

use std::cell::LazyCell;
use std::collections::BTreeSet;

use super::super::cause::consequence::{Damage, consequence};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::View;
use mhlint_source::{ReadFault, WalkFaultKind};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "cannot open it either, so its content is missing or the program crashes at start",
        ),
        (
            Makehuman1,
            "cannot open it either: the asset, or with a dead link its whole library, is missing",
        ),
        (Mpfb, "cannot open it either, and fails where it needs it"),
    ],
    docs: include_str!("unreadable.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-unreadable",
        Level::Error,
        "a file or folder that cannot be opened or read",
    )
});

/// What is said of a file on which a reader of ours panicked.
const FAILED: &str = "cannot be read: mhlint failed on this file; please report it with the file";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let finding = |rel: &str, damage: Damage, message: String| {
        let is_lock = rel
            .rsplit('/')
            .next()
            .is_some_and(|name| name.starts_with(".#"));
        let help = if is_lock {
            "delete it: an editor has left it behind"
        } else {
            "fix the link or the permissions, or replace the file"
        };
        let finding = RULE.in_layer(layer, rel, message).help(help);
        consequence(view, rel, damage).map(|loss| loss.of(view, finding))
    };
    let named = LazyCell::new(|| -> BTreeSet<&str> {
        let references = view.references().iter();
        references.map(|reference| &*reference.rel).collect()
    });
    for fault in &layer.walk_faults {
        match &fault.kind {
            WalkFaultKind::Unreadable { reason } => {
                out.extend(finding(
                    &fault.path,
                    Damage::Closed,
                    format!("cannot be read: {reason}"),
                ));
            }
            WalkFaultKind::DeadLink { to } if view.looks_at(view.kind_at(&fault.path)) => {
                let damage = if named.contains(fault.path.as_str()) {
                    Damage::Closed
                } else {
                    Damage::Dangling
                };
                out.extend(finding(
                    &fault.path,
                    damage,
                    format!("cannot be read: broken link to `{to}`"),
                ));
            }
            WalkFaultKind::DeadLink { .. }
            | WalkFaultKind::LinkLoop { .. }
            | WalkFaultKind::LinkLeavesRoot => {}
        }
    }
    for file in view.files() {
        match &file.unreadable {
            Some(ReadFault::Unreadable(reason)) => {
                out.extend(finding(
                    &file.rel,
                    Damage::Closed,
                    format!("cannot be read: {reason}"),
                ));
            }
            _ if file.failed => out.extend(finding(&file.rel, Damage::Closed, FAILED.to_owned())),
            _ => {}
        }
    }
}
