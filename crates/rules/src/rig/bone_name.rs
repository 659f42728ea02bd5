//! Names of bones are short enough for Blender to keep, and are not names of vertex groups of the
//! figure.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::{STOPS, at_bones, stops};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("bone_name.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-bone-name",
        Level::Error,
        "a bone has a name that Blender changes, or that of a vertex group",
    )
});

/// Blender keeps this many bytes of a name.
const LONGEST: usize = 63;

const MOVES: Case = &[(
    Mpfb,
    Level::Warning,
    "moves all vertices of that group with the bone, whatever the weights say",
)];

/// Vertex groups that MPFB adds to each figure, besides those in its table of groups.
const MADE: [&str; 8] = [
    "nippleTip",
    "nipple",
    "lips",
    "fingernails",
    "toenails",
    "ears",
    "genitals",
    "scalp",
];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let groups = view
        .groups
        .iter()
        .flat_map(|groups| &groups.groups)
        .map(|group| group.name.as_str());
    let groups: BTreeSet<&str> = groups.chain(MADE).collect();
    for (file, rig) in view.own_rigs() {
        let names = || rig.bones.iter().map(|bone| bone.name.as_str());
        if names().any(str::is_empty) {
            let finding = at_bones(&RULE, file, rig, &[""], "", "a bone has no name".to_owned());
            out.extend(
                finding
                    .map(|finding| stops(file, finding.key("empty").help("give the bone a name"))),
            );
        }
        let long: Vec<&str> = names().filter(|name| name.len() > LONGEST).collect();
        if let Some(first) = long.first() {
            let start: String = first.chars().take(20).collect();
            let message = format!(
                "the name of a bone has {} bytes, more than {LONGEST}: `{start}…`",
                first.len()
            );
            let finding = at_bones(&RULE, file, rig, &long, "", message);
            out.extend(
                finding.map(|finding| stops(file, finding.key("long").help("shorten the name"))),
            );
        }
        let shared: Vec<&str> = names().filter(|name| groups.contains(name)).collect();
        let message = format!(
            "{} bears the name of a vertex group of the base mesh",
            bones_in_words(&shared)
        );
        let finding = at_bones(&RULE, file, rig, &shared, "", message);
        out.extend(finding.map(|finding| {
            finding
                .key("group")
                .case(MOVES)
                .help("give the bone another name")
        }));
    }
}
