//! The group of a slider must be shown by an item of `target_cat.json`.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::absent_categories;
use super::foreign;
use super::generated;
use super::groups::{self, Groups, Renamed};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "never shows such sliders; only saved models can set them",
    )],
    docs: include_str!("unknown_group.md").trim_ascii_end(),
    counts: "sliders",
    ..RuleInfo::new(
        "modelling-unknown-group",
        Level::Warning,
        "`group` of a slider is not in `target_cat.json`",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    two_bars(base, out);
    out.extend(generated::hidden(&RULE, base));
    if let Some(groups) = groups::of(base, &cx.suggestions).filter(|_| !base.has_foreign_sliders())
    {
        if let Some(finding) = foreign::categories(&RULE, view, base, &groups) {
            return out.push(finding);
        }
        let mut lost: BTreeMap<&str, Vec<&BoundSlider<'_>>> = BTreeMap::new();
        for (group, sliders) in groups
            .unknown
            .iter()
            .filter(|(group, _)| group.matches('|').count() < 2)
        {
            match group.split_once('|') {
                Some((category, _))
                    if groups.meant(group).is_none() && !groups.knows_category(category) =>
                {
                    lost.entry(if groups.offered.is_empty() {
                        ""
                    } else {
                        category
                    })
                    .or_default()
                    .extend(sliders);
                }
                _ => out.extend(unknown(view, base, &groups, group, sliders)),
            }
        }
        out.extend(
            groups
                .renamed
                .iter()
                .filter_map(|renamed| renamed_category(view, base, renamed)),
        );
        out.extend(
            lost.iter()
                .filter_map(|(category, sliders)| lost_category(view, base, category, sliders)),
        );
    }
    out.extend(absent_categories::finding(&RULE, view, base));
}

/// Beginning of a message on these sliders.
fn are(sliders: &[&BoundSlider<'_>]) -> String {
    match sliders {
        [only] => format!("`{}` is", only.slider.key),
        more => format!("{} sliders are", more.len()),
    }
}

/// A whole category that no item shows is one cause, however many groups it has.
fn lost_category(
    view: &View<'_>,
    base: &Base<'_>,
    category: &str,
    sliders: &[&BoundSlider<'_>],
) -> Option<Finding> {
    let keys = Evidence::of_cases(sliders.iter().map(|slider| &slider.slider.key));
    let subject = are(sliders);
    let message = match category {
        "" => format!("{subject} never shown: target_cat.json has no items"),
        category => format!("{subject} never shown: target_cat.json has no category `{category}`"),
    };
    let (file, place) = groups::whose(view, base, sliders.first()?)?;
    let help = "add the category with an item for every group, or correct the groups";
    Some(
        RULE.at(file, place, message)
            .key(category)
            .help(help)
            .evidence(keys),
    )
}

/// A category that several sliders agree on is called differently in `target_cat.json`.
fn renamed_category(
    view: &View<'_>,
    base: &Base<'_>,
    renamed: &Renamed<'_, '_>,
) -> Option<Finding> {
    let (file, _) = base.categories.winner()?;
    let first = renamed.sliders.first()?;
    let (count, wanted) = (renamed.sliders.len(), &renamed.wanted);
    let message = format!(
        "{count} sliders are never shown: category `{}` has the group `{}`, but their group is \
            `{wanted}`",
        renamed.name, renamed.group
    );
    let finding = if view.layers.is_checked(file) {
        RULE.at(file, Place::pointer([renamed.name, "group"]), message)
    } else {
        RULE.at(
            first.file,
            Place::pointer([first.slider.key.as_str(), "group"]),
            message,
        )
    };
    let keys = Evidence::of_cases(renamed.sliders.iter().map(|slider| &slider.slider.key));
    Some(
        finding
            .key(wanted)
            .help(format!("write `{wanted}` as the group of the category"))
            .evidence(keys),
    )
}

fn unknown(
    view: &View<'_>,
    base: &Base<'_>,
    groups: &Groups<'_, '_>,
    group: &str,
    sliders: &[&BoundSlider<'_>],
) -> Option<Finding> {
    let first = sliders.first()?;
    let keys = Evidence::of_cases(sliders.iter().map(|slider| &slider.slider.key));
    let subject = are(sliders);
    let message = match group {
        "" => format!("{subject} never shown: `group` is missing"),
        group => {
            format!("{subject} never shown: no item of target_cat.json has the group `{group}`")
        }
    };
    let help = match groups.meant(group) {
        Some(near) => format!("did you mean `{near}`?"),
        None if group.is_empty() => "add `group`, the `category|subcategory` of an item".to_owned(),
        None if !group.contains('|') => "write the group as `category|subcategory`".to_owned(),
        None => "correct the group, or add an item to target_cat.json".to_owned(),
    };
    let item = groups
        .meant(group)
        .and_then(|near| groups::item_with_blanks(view, base, near));
    let (file, place, help) = match (item, groups::whose(view, base, first)?) {
        (Some((file, place)), _) => (
            file,
            place,
            format!("remove the space: the group of the sliders is `{group}`"),
        ),
        (None, (file, place)) => (file, place, help),
    };
    Some(
        RULE.at(file, place, message)
            .key(group)
            .help(help)
            .evidence(keys),
    )
}

/// Shown or not, the random character view splits the group in two.
fn two_bars(base: &Base<'_>, out: &mut Vec<Finding>) {
    for slider in groups::hand_made(base) {
        let key = slider.slider.key.as_str();
        let group = slider
            .slider
            .group
            .as_deref()
            .filter(|group| group.matches('|').count() > 1);
        out.extend(group.map(|group| {
            let message = format!("`group` of `{key}` has more than two parts");
            let finding = RULE
                .at(slider.file, Place::pointer([key, "group"]), message)
                .key(key)
                .level(Level::Error);
            let effect = "crashes with `ValueError` when it makes a random character";
            finding
                .effect(effect)
                .help(format!("write `{group}` as `category|subcategory`"))
        }));
    }
}
