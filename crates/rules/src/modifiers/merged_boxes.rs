//! A box in a tab has a name of its own.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_formats::modifiers::sliders::Category;
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "shows the sliders of both in one box")],
    docs: include_str!("merged_boxes.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-merged-boxes",
        Level::Warning,
        "two boxes that become one",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    for (file, sliders) in view.modifiers.sets.iter().filter_map(|set| set.sliders) {
        for tab in &sliders.tabs {
            let mut first: BTreeMap<String, &Category> = BTreeMap::new();
            for own in &tab.categories {
                let Some(earlier) = first.get(&own.name.to_lowercase()) else {
                    first.insert(own.name.to_lowercase(), own);
                    continue;
                };
                let message = format!(
                    "box `{}` becomes one with `{}`: capitals make no difference",
                    own.name, earlier.name
                );
                let finding = RULE
                    .at(file, Place::Key(own.pointer.clone()), message)
                    .key(&own.pointer);
                let finding = finding.related(
                    file.path.clone(),
                    Place::Key(earlier.pointer.clone()),
                    "the other box",
                );
                out.push(finding.help("rename one of them, or put the sliders together"));
            }
        }
    }
}
