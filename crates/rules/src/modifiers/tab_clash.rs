//! A tab has a name of its own.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_formats::modifiers::sliders::Tab;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails with `KeyError`: the tabs of the plugin that comes later are missing",
    )],
    docs: include_str!("tab_clash.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-tab-clash",
        Level::Error,
        "two tabs with one name",
    )
});

/// Tabs that plugins have of their own (`docs/loaders/makehuman1/modifiers.md#faults-of-sliders`).
const OF_PLUGINS: [&str; 2] = ["Custom", "Random"];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    let mut first: BTreeMap<&str, (&FileFacts, &Tab)> = BTreeMap::new();
    for (file, sliders) in view.modifiers.sets.iter().filter_map(|set| set.sliders) {
        for tab in &sliders.tabs {
            let told = |message: String| {
                RULE.at(file, Place::Key(tab.pointer.clone()), message)
                    .key(&tab.name)
            };
            if OF_PLUGINS.contains(&tab.name.as_str()) {
                let message = format!("the program has a tab `{}` of its own", tab.name);
                out.push(told(message).help("rename the tab"));
            } else if let Some((other, earlier)) = first.get(tab.name.as_str()) {
                let message = format!("a tab `{}` exists already", tab.name);
                let finding = told(message).related(
                    other.path.clone(),
                    Place::Key(earlier.pointer.clone()),
                    "the first",
                );
                out.push(finding.help("rename one of the tabs"));
            } else {
                first.insert(&tab.name, (file, tab));
            }
        }
    }
}
