//! Keys that nothing reads have no value that somebody may rely on.

use super::super::{Check, Rule, RuleCx, such};
use super::{checked, place};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, RuleInfo};
use mhlint_formats::target_catalog::Section;
use mhlint_repo::mpfb::{Catalog, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "never reads the key: the section is shown as any other",
    )],
    docs: include_str!("unused_key.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-unused-key",
        Level::Info,
        "a key of a section that MPFB never reads",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    let unsorted = sections(&catalog, |section| section.has_unsorted);
    let excluded = sections(&catalog, |section| section.is_excluded);
    for (sections, key, message, help) in [
        (
            unsorted,
            "unsorted",
            "the targets in `unsorted` get no slider",
            "give them sliders",
        ),
        (
            excluded,
            "include_per_default",
            "`include_per_default` has no effect",
            "remove the key",
        ),
    ] {
        let Some(first) = sections.first() else {
            continue;
        };
        let message = format!("{message}{}", such(sections.len(), "sections"));
        let finding = RULE
            .at(catalog.file, place(first, None, &[key]), message)
            .key(key)
            .help(help);
        out.push(finding.evidence(Evidence::of_cases(
            sections.iter().map(|section| section.name.as_str()),
        )));
    }
}

fn sections<'a>(catalog: &Catalog<'a>, is_set: fn(&Section) -> bool) -> Vec<&'a Section> {
    catalog
        .sliders
        .sections
        .iter()
        .filter(|section| is_set(section))
        .collect()
}
