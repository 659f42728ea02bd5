//! Older names of modifiers lead to ones that exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "loses the value of this slider when it loads a model of version 1.0",
    )],
    docs: include_str!("renamed.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-renamed",
        Level::Warning,
        "an older name that leads to no modifier",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() || !view.modifiers.is_whole() {
        return;
    }
    let unpaired = unpaired(view);
    let files = view
        .layers
        .checked
        .files
        .values()
        .filter(|file| file.kind == Kind::ModifierMapping);
    for file in files {
        let rows = file
            .modifier_mapping()
            .map(|mapping| mapping.rows.as_slice())
            .unwrap_or_default();
        let is_of_unpaired = |name: &str| {
            let mut shorter = name
                .rmatch_indices('-')
                .filter_map(|(at, _)| name.get(..at));
            shorter.any(|name| unpaired.contains(name))
        };
        let is_lost =
            |name: &str| view.modifiers.called(name).next().is_none() && !is_of_unpaired(name);
        let lost: Vec<_> = rows.iter().filter(|row| is_lost(&row.new)).collect();
        let Some(first) = lost.first() else { continue };
        let message = format!(
            "modifier `{}` does not exist{}",
            first.new,
            such(lost.len(), "rows")
        );
        let near = cx.suggestions.nearest(&first.new, view.modifiers.names());
        let finding = RULE.at(file, Place::Line(first.line), message).key("rows");
        let finding = finding.parts(lost.iter().map(|row| row.new.as_str()));
        let finding = finding.evidence(Evidence::of_cases(lost.iter().map(|row| row.new.as_str())));
        out.push(finding.help(did_you_mean(near, "correct the name")));
    }
}

/// The modifiers that lack one of their two ends, which has a finding of its own: they have the
/// name without both.
fn unpaired<'v>(view: &'v View<'_>) -> BTreeSet<&'v str> {
    let unpaired = view
        .modifiers
        .all
        .iter()
        .filter(|one| one.modifier.tails.unpaired().is_some());
    unpaired.map(|one| one.name.as_str()).collect()
}
