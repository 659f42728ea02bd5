//! Keys that nothing reads have no value that somebody may rely on.

use super::super::{Check, Rule, RuleCx};
use super::{checked, place};
use crate::diag::{Application::Mpfb, Finding, Level, RuleInfo};
use crate::repo::mpfb::View;

pub(in crate::rules) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "never reads the key: the section is shown as any other")],
    docs: "`unsorted` and `include_per_default` of a section are described in the documentation of MPFB, but it never reads \
        them: targets in `unsorted` get no slider, and a section that is not included by default is shown all the same. \
        Only values that say something are reported: a list with names, and false.\n\n\
        Give the targets sliders, or remove the key.",
    ..RuleInfo::new("catalog-unused-key", Level::Info, "a key of a section that MPFB never reads")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    for section in &catalog.sliders.sections {
        let keys = [
            (section.has_unsorted, "unsorted", "the targets in `unsorted` get no slider", "give them sliders"),
            (section.is_excluded, "include_per_default", "`include_per_default` has no effect", "remove the key"),
        ];
        for (_, key, message, help) in keys.into_iter().filter(|(is_set, ..)| *is_set) {
            let finding = RULE.at(catalog.file, place(section, None, &[key]), message);
            out.push(finding.key(format!("{} {key}", section.name)).help(help));
        }
    }
}
