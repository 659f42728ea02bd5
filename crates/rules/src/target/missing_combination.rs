//! A macro has a target for each combination of values.

use super::super::{Check, Rule, RuleCx, such};
use super::macro_group::macro_groups;
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "leaves the figure without this part of its shape at these settings",
    )],
    docs: include_str!("missing_combination.md").trim_ascii_end(),
    ..RuleInfo::new(
        "target-missing-combination",
        Level::Warning,
        "a combination of macro values without a target",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for group in macro_groups(view) {
        let holes: Vec<String> = group
            .holes()
            .into_iter()
            .map(|values| values.join("-"))
            .collect();
        let (Some(first), Some(target)) = (holes.first(), group.targets.first()) else {
            continue;
        };
        let message = format!(
            "no target of `{}` has the values `{first}`{}",
            group.name,
            such(holes.len(), "combinations")
        );
        let finding = RULE
            .at(target.file, Place::File, message)
            .key(group.name)
            .asset(view.layers.checked.display(target.file.folder()));
        let finding = finding.parts(holes.iter().map(String::as_str));
        out.push(
            finding
                .evidence(Evidence::of_cases(holes.iter().map(String::as_str)))
                .help("add the target; it may be empty"),
        );
    }
}
