//! A section has sliders.

use super::super::{Check, Rule, RuleCx};
use super::{checked, place};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "shows an empty panel")],
    docs: include_str!("empty_section.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-empty-section",
        Level::Info,
        "a section of `target.json` without sliders",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    for section in catalog
        .sliders
        .sections
        .iter()
        .filter(|section| section.is_empty)
    {
        let finding = RULE.at(
            catalog.file,
            place(section, None, &[]),
            format!("section `{}` is empty", section.name),
        );
        out.push(
            finding
                .key(&section.name)
                .help("remove the section, or add sliders"),
        );
    }
}
