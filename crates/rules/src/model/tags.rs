//! Tags of a model are separated by semicolons.

use super::super::{Check, Rule, RuleCx};
use super::{makehuman1, own};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::EachBase(
    run,
    |view, _, out| makehuman1::tags::faults(&RULE, view, out),
    |_, _, _| {},
)
.rule(RuleInfo {
    breaks: &[
        (Makehuman2, "reads the whole line as one tag"),
        (Makehuman1, "reads the whole line as one tag"),
    ],
    docs: include_str!("tags.md").trim_ascii_end(),
    ..RuleInfo::new(
        "model-tags",
        Level::Warning,
        "tags of a model that are separated by commas",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for saved in own(view, base).filter(|saved| !saved.is_start) {
        let [only] = saved.model.tags.as_slice() else {
            continue;
        };
        if only.split(',').filter(|tag| !tag.trim().is_empty()).count() < 2 {
            continue;
        }
        let tags: Vec<&str> = only
            .split(',')
            .map(str::trim)
            .filter(|tag| !tag.is_empty())
            .collect();
        let finding = RULE.at(
            saved.file,
            Place::Span(saved.model.tags_at.clone()),
            format!("`tags {only}` is one tag"),
        );
        out.push(finding.help(format!("write `tags {}`", tags.join(";"))));
    }
}
