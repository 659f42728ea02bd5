//! Names of groups must be ASCII.

use super::super::cause::mesh::weigh;
use super::super::{Check, Rule, RuleCx};
use super::of_asset;
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `UnicodeEncodeError` while loading the base mesh",
    )],
    docs: include_str!("group_name.md").trim_ascii_end(),
    ..RuleInfo::new("mesh-group-name", Level::Error, "a group name is not ASCII")
});

const OF_ASSET: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `UnicodeEncodeError` when the asset is put on; models that wear it load only in \
        part",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some(mesh) = of_asset(view, file) {
        let odd: Vec<(&str, u32)> = mesh
            .odd_groups
            .iter()
            .map(|(name, line)| (&**name, *line))
            .collect();
        return out.extend(finding(file, &odd).map(|finding| finding.case(OF_ASSET)));
    }
    // An archive has them packed, and unpacking does not mind.
    let Some(mesh) = file.mesh().filter(|_| file.kind == Kind::BaseMesh) else {
        return;
    };
    let odd = mesh
        .groups
        .iter()
        .filter(|group| group.faces > 0 && !group.name.is_ascii());
    let odd: Vec<(&str, u32)> = odd.map(|group| (&*group.name, group.line)).collect();
    out.extend(finding(file, &odd).map(|finding| weigh(view, file, finding)));
}

fn finding(file: &FileFacts, odd: &[(&str, u32)]) -> Option<Finding> {
    let (name, line) = odd.first()?;
    let message = match odd.len() {
        1 => format!("group name `{name}` is not ASCII"),
        count => format!("{count} group names are not ASCII, first `{name}`"),
    };
    let names = || odd.iter().map(|(name, _)| *name);
    let finding = RULE
        .at(file, Place::Line(*line), message)
        .parts(names())
        .evidence(Evidence::of_cases(names()));
    Some(finding.help("rename it with letters a to z, digits, `-` and `_` only"))
}
