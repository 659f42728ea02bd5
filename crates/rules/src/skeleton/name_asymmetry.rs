//! Bones of the left and right side come in pairs.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::hierarchy::hierarchy;
use super::rigs;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::side;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "loads and poses such bones like any other; only tools that mirror by name \
            miss the counterparts",
        ),
        (Makehuman1, "loads and poses such bones like any other"),
    ],
    docs: include_str!("name_asymmetry.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-name-asymmetry",
        Level::Info,
        "a bone has no left/right counterpart",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        let names: BTreeSet<&str> = rig
            .skeleton
            .bones
            .iter()
            .map(|bone| bone.name.as_str())
            .collect();
        let lonely = names
            .iter()
            .filter_map(|name| Some((*name, side::of_bone(name)?.1)));
        // A partner that others name as their parent is `skeleton-unknown-parent`.
        let asked = hierarchy(rig.skeleton).unknown_parents;
        let is_absent = |name: &str| !names.contains(name) && !asked.contains_key(name);
        let lonely: Vec<(&str, String)> =
            lonely.filter(|(_, partner)| is_absent(partner)).collect();
        let Some((name, partner)) = lonely.first() else {
            continue;
        };
        let message = match lonely.len() {
            1 => format!("bone `{name}` has no counterpart `{partner}`"),
            count => {
                format!("{count} bones have no left/right counterpart: `{name}` has no `{partner}`")
            }
        };
        let help = match cx
            .suggestions
            .nearest(partner, names.iter().copied().filter(|other| other != name))
        {
            Some(other) => format!("did you mean `{other}`?"),
            None => format!("leave it if the bone has no counterpart; otherwise add `{partner}`"),
        };
        let evidence = Evidence::of_cases(lonely.iter().map(|(name, _)| name)).out_of(names.len());
        out.push(
            RULE.at(rig.file, Place::key(["bones", name]), message)
                .help(help)
                .evidence(evidence),
        );
    }
}
