//! A slider with two ends says so.

use super::super::{Check, Rule, RuleCx};
use super::{checked, forgotten_ends, key, place, sliders};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "asks for a target of the slider's own name and fails whenever it moves",
    )],
    docs: include_str!("missing_opposites.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-missing-opposites",
        Level::Error,
        "a slider with two ends that has no `opposites`",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    for (section, category) in sliders(&catalog) {
        let Some([negative, positive]) = forgotten_ends(&catalog, section, category) else {
            continue;
        };
        let message = format!(
            "`{}` has no `opposites`, although both its ends exist",
            category.name
        );
        let finding = RULE.at(catalog.file, place(section, Some(category), &[]), message);
        let help = format!("add `opposites` with the targets `{negative}` and `{positive}`");
        out.push(finding.key(key(section, category)).help(help));
    }
}
