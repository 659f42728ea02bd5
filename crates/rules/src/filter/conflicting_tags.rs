//! The labels of an asset must not exclude one another.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::selection_filter::SelectionFilter;
use mhlint_repo::makehuman2::{Asset, Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "shows the asset under none of these labels")],
    docs: include_str!("conflicting_tags.md").trim_ascii_end(),
    ..RuleInfo::new(
        "filter-conflicting-tags",
        Level::Warning,
        "tags of an asset lead to labels that exclude one another",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut filters: BTreeMap<&str, Option<&SelectionFilter>> = BTreeMap::new();
    for asset in view
        .library
        .of_base(base.name)
        .iter()
        .filter(|asset| view.layers.is_checked(asset.file))
    {
        let filter = *filters
            .entry(asset.category)
            .or_insert_with(|| view.filter(asset.category, base.name));
        out.extend(filter.and_then(|filter| finding(asset, filter)));
    }
}

/// The labels that the tags of an asset lead to, with what gave them.
fn labels<'a>(asset: &'a Asset<'_>, filter: &SelectionFilter) -> Vec<(String, &'a str)> {
    // What leads nowhere has a finding of its own: `filter-dead-entry`.
    let is_dead = |tag: &str| {
        let target = filter.translate.get(&tag.trim().to_lowercase());
        target
            .and_then(|led| led.to.as_deref())
            .is_some_and(|target| filter.is_dead(target))
    };
    let tags = asset
        .tags
        .iter()
        .filter(|tag| !is_dead(tag))
        .filter_map(|tag| Some((filter.path_of(tag)?, tag.as_str())));
    let guessed = filter
        .guessed(&asset.name)
        .filter(|path| !filter.is_dead(path))
        .map(|path| (path.to_owned(), asset.name.as_str()));
    let is_chosen_by = |path: &str| path.contains(':') && filter.paths.contains(root(path));
    tags.chain(guessed)
        .filter(|(path, _)| is_chosen_by(path))
        .collect()
}

fn finding(asset: &Asset<'_>, filter: &SelectionFilter) -> Option<Finding> {
    let mut labels = labels(asset, filter);
    labels.sort_unstable();
    labels.dedup_by(|one, other| one.0 == other.0);
    // Sorted, a label comes right before those below it; the first that is not below excludes both.
    let excludes = |one: &str, other: &str| {
        let is_below = other
            .strip_prefix(one)
            .is_some_and(|rest| rest.starts_with(':'));
        root(one) == root(other) && !is_below
    };
    let mut deepest: Option<&(String, &str)> = None;
    let mut pair = None;
    for label in &labels {
        if let Some(before) = deepest.filter(|before| excludes(&before.0, &label.0)) {
            pair = Some((before, label));
            break;
        }
        deepest = Some(label);
    }
    let ((one, first), (other, second)) = pair?;
    let label = |path: &str, given: &str| match given {
        given if given == path => format!("`{path}`"),
        given => format!("`{path}` (from `{given}`)"),
    };
    let message = format!(
        "{} and {} exclude each other",
        label(one, first),
        label(other, second)
    );
    let finding = RULE
        .at(asset.file, Place::File, message)
        .key(format!("{one} {other}"));
    let finding = finding.evidence(Evidence::of_cases(labels.iter().map(|(path, _)| path)));
    Some(finding.help(
        "use tags that lead to one label, or write `null` for one of them under `Translate` in \
            selection_filter.json",
    ))
}

fn root(path: &str) -> &str {
    path.split(':').next().unwrap_or(path)
}
