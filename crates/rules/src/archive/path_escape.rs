//! No member of a zip may lead out of the folder that it is unpacked into.

use super::super::{Check, Rule, RuleCx, and_more};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, RuleInfo,
};
use mhlint_repo::View;
use mhlint_source::MemberFault;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    cannot_be_ignored: true,
    breaks: &[
        (
            Makehuman2,
            "strips the way out and puts the files elsewhere, or imports nothing of them",
        ),
        (
            Makehuman1,
            "gets none of the files: they are unpacked outside of its data folder, \
            wherever that leads",
        ),
        (
            Mpfb,
            "strips the way out and puts the files elsewhere in the data of the user, or \
            rejects the zip",
        ),
    ],
    docs: include_str!("path_escape.md").trim_ascii_end(),
    counts: "members",
    ..RuleInfo::new(
        "archive-path-escape",
        Level::Error,
        "a zip with members that lead out of the folder it is unpacked into",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let Some(facts) = layer.pack.as_ref().and_then(|pack| pack.faults.as_ref()) else {
        return;
    };
    let leads_out = |fault: &MemberFault| {
        matches!(fault, MemberFault::Escapes | MemberFault::LinkLeaves { .. })
    };
    let bad: Vec<&(String, MemberFault)> = facts
        .faults
        .iter()
        .filter(|(_, fault)| leads_out(fault))
        .collect();
    let Some((first, fault)) = bad.first() else {
        return;
    };
    let more = and_more(bad.len(), "member");
    let message = match fault {
        MemberFault::LinkLeaves { to } => {
            format!("the link `{first}` leads out of the zip, to `{to}`{more}")
        }
        _ => {
            format!("member `{first}` leads out of the folder that the zip is unpacked into{more}")
        }
    };
    let finding = RULE
        .in_layer(layer, "", message)
        .evidence(Evidence::of_cases(bad.iter().map(|(name, _)| name)));
    out.push(finding.help("do not unpack it; pack the folder again without such names and links"));
}
