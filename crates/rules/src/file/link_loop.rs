//! Links that lead in a circle.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::View;
use mhlint_source::{WalkFault, WalkFaultKind};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "lists the same files over and over, or fails to open the link",
        ),
        (Makehuman1, "passes over the link"),
        (Mpfb, "passes over the link"),
    ],
    levels: &[(Makehuman1, Level::Info)],
    docs: include_str!("link_loop.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-link-loop",
        Level::Error,
        "a symbolic link that leads back to itself or a folder above it",
    )
});

/// Targets are looked for without following links to folders.
const NOT_FOLLOWED: Case = &[(
    Makehuman2,
    Level::Info,
    "ignores it: links to folders are not followed in target folders",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let is_loop = |fault: &&WalkFault| matches!(fault.kind, WalkFaultKind::LinkLoop { .. });
    let loops = layer.walk_faults.iter().filter(is_loop);
    let loops: BTreeSet<&str> = loops.map(|fault| fault.path.as_str()).collect();
    for fault in &layer.walk_faults {
        let WalkFaultKind::LinkLoop { back_to } = &fault.kind else {
            continue;
        };
        // Links that point to each other are one circle, told at one of them.
        if *back_to != fault.path && loops.contains(back_to.as_str()) {
            continue;
        }
        let message = if *back_to == fault.path || back_to.is_empty() {
            "the link leads back to itself or the data folder".to_owned()
        } else {
            format!("the link leads back to `{back_to}`")
        };
        let finding = RULE
            .in_layer(layer, &fault.path, message)
            .help("remove the link");
        let leads_up = back_to.is_empty() || fault.path.starts_with(&format!("{back_to}/"));
        let is_in_targets = ["target/", "contarget/"]
            .iter()
            .any(|folder| fault.path.starts_with(folder));
        out.push(if leads_up && is_in_targets {
            finding.case(NOT_FOLLOWED)
        } else {
            finding
        });
    }
}
