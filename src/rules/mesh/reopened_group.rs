//! A face group must be opened once.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{Base, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "leaves the faces behind the second `g` in the group that was opened last",
        )],
        docs: "In an OBJ file `g name` starts a group, or continues one that was started before.\n\nMakeHuman 2 \
            understands the start only. After the second `g` of a name the faces stay in the group that was \
            opened last before it. Among invisible helpers this is hardly noticed; faces of a group that \
            `base.json` shows (`visible groups`) vanish when they end up in one that is not shown \
            (`error`).\n\nSort the faces so that each group comes once; exporters have an option for it.",
        ..RuleInfo::new("mesh-reopened-group", Level::Warning, "a face group is opened a second time")
    },
    check: Check::Base(run),
};

fn run(_: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, mesh)) = base.mesh else { return };
    let visible = base.settings().and_then(|(_, settings)| settings.visible_groups.as_deref()).unwrap_or_default();
    let is_visible = |group: &str| visible.iter().any(|name| name == group);
    for group in &mesh.facts.reopened {
        let landings: Vec<String> = group.lands_in.iter().map(|name| format!("`{name}`")).collect();
        let times = if group.openings > 1 { format!("{} times", group.openings) } else { "once".to_owned() };
        let message = format!(
            "group `{}` is opened again {times}: {} of its faces end up in {}",
            group.name,
            group.faces,
            landings.join(", ")
        );
        let mut finding = RULE
            .at(file, Place::Line(group.line), message)
            .key(&group.name)
            .help("sort the faces so that each group comes once")
            .evidence(Evidence { count: group.faces as u64, of: Some(mesh.faces.len() as u64), ..Evidence::default() });
        if is_visible(&group.name) && !group.lands_in.iter().all(|name| is_visible(name)) {
            finding = finding
                .level(Level::Error)
                .breaks(Application::Makehuman2, "loses visible faces: they end up in a group that is not shown");
        }
        out.push(finding);
    }
}
