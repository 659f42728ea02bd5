//! Patterns, groups and entries named in `base.json` must exist.

use std::collections::BTreeMap;

use super::super::cause::overlay::has_sliders;
use super::super::{Check, Rule, RuleCx};
use super::NO_MEASURE;
use super::names::{Names, Unknown};
use super::other_base::of_other_base;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo, pointer};
use mhlint_formats::base_json::{BaseJson, Random};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "ignores names that do not exist: their settings have no effect",
    )],
    docs: include_str!("unknown_preset.md").trim_ascii_end(),
    ..RuleInfo::new(
        "base-unknown-preset",
        Level::Warning,
        "a name in `base.json` that does not exist",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings().filter(|_| has_sliders(base)) else {
        return;
    };
    let names = Names::of(view, base, &cx.suggestions);
    let mut found = Vec::new();
    for (pattern, _) in &settings.presets {
        let at = ["modifier-presets", pattern];
        let unknown = names.pattern(pattern);
        found.extend(unknown.map(|unknown| at_key(unknown_name(file, &at, unknown), &at)));
    }
    measures(file, &names, settings, &mut found);
    for (index, head) in settings.head_pattern.iter().flatten().enumerate() {
        let at = ["head-pattern", &index.to_string()];
        let unknown = names.head(head);
        found.extend(unknown.map(|unknown| unknown_name(file, &at, unknown)));
    }
    if let Some(random) = &settings.random {
        randomizer(file, &names, random, &mut found);
    }
    if let Some((sliders, _)) = base.modelling.winner() {
        for finding in &mut found {
            finding.against.push(sliders.path.clone());
        }
    }
    out.extend(of_other_base(view, base, settings, found));
}

fn finding(file: &FileFacts, at: &[&str], message: String, name: &str) -> Finding {
    // Places in a list change with every entry before them.
    let mut key: Vec<&str> = at
        .iter()
        .copied()
        .filter(|part| part.parse::<usize>().is_err())
        .collect();
    if key.last() != Some(&name) {
        key.push(name);
    }
    RULE.at(file, Place::Pointer(pointer(at)), message)
        .key(key.join(" "))
}

/// Marks the key: the value beside it is sound.
fn at_key(finding: Finding, at: &[&str]) -> Finding {
    Finding {
        place: Place::Key(pointer(at)),
        ..finding
    }
}

fn unknown_name(file: &FileFacts, at: &[&str], unknown: Unknown) -> Finding {
    finding(file, at, unknown.message, &unknown.name)
        .help(unknown.help)
        .parts([&unknown.name])
}

fn measures(file: &FileFacts, names: &Names<'_, '_>, settings: &BaseJson, out: &mut Vec<Finding>) {
    for (purpose, pattern) in settings
        .measure
        .iter()
        .filter(|(_, pattern)| pattern != NO_MEASURE)
    {
        let at = ["measure", purpose.as_str()];
        let slider = names.base.slider(pattern).map(|bound| bound.slider);
        out.extend(match (purpose.as_str(), slider) {
            ("size", Some(_)) => {
                let message = format!("`size` names the slider `{pattern}`, expected `none`");
                let finding =
                    finding(file, &at, message, pattern).effect("does not show the height");
                Some(finding.help("write `\"size\": \"none\"`"))
            }
            ("age", Some(slider)) if slider.display.is_none() => {
                let message = format!("`age` names `{}`, which has no `display`", slider.key);
                let effect = "crashes with `AttributeError` when it shows the size information";
                let finding = finding(file, &at, message, pattern).level(Level::Error);
                Some(
                    finding
                        .effect(effect)
                        .help("use the pattern of the slider that displays the age"),
                )
            }
            ("chest" | "waist" | "hips" | "underbust", Some(slider))
                if slider.measure.is_none() =>
            {
                let message = format!("`{purpose}` names `{}`, which has no `measure`", slider.key);
                let finding = finding(file, &at, message, pattern)
                    .effect("ignores the setting: the measure is not shown");
                Some(finding.help("use the pattern of an entry with `measure`, or `none`"))
            }
            // Not a pattern is what `size` needs; other keys are read by nobody.
            ("gender" | "age" | "chest" | "waist" | "hips" | "underbust", None) => names
                .pattern(pattern)
                .map(|unknown| unknown_name(file, &at, unknown)),
            _ => None,
        });
    }
}

fn randomizer(file: &FileFacts, names: &Names<'_, '_>, random: &Random, out: &mut Vec<Finding>) {
    for (member, key) in [("gender", &random.gender), ("ideal", &random.ideal)] {
        let unknown = key.as_ref().and_then(|key| names.entry(key));
        out.extend(unknown.map(|unknown| unknown_name(file, &["random", member], unknown)));
    }
    let mut earlier: BTreeMap<&str, bool> = BTreeMap::new();
    for (group, selected) in &random.groups {
        let category = group.split_once('|').map(|(category, _)| category);
        match category.and_then(|category| earlier.get_key_value(category)) {
            Some((category, also)) => out.push(nested(file, group, category, *selected && *also)),
            None => out.extend(random_group(file, names, group, *selected)),
        }
        earlier.insert(group, *selected);
    }
    for (key, conditions) in &random.rules {
        if let Some(unknown) = names.entry(key) {
            let at = ["random", "rules", key];
            out.push(at_key(unknown_name(file, &at, unknown), &at));
            continue;
        }
        for condition in conditions {
            let Some(unknown) = names.entry(&condition.slider) else {
                continue;
            };
            let at = ["random", "rules", key, &condition.slider];
            let finding = unknown_name(file, &at, unknown)
                .effect("always resets the slider of the rule to 0");
            out.push(at_key(finding, &at));
        }
    }
}

fn random_group(
    file: &FileFacts,
    names: &Names<'_, '_>,
    group: &str,
    selected: bool,
) -> Option<Finding> {
    let at = ["random", "groups", group];
    if group.matches('|').count() < 2 {
        return names
            .group(group)
            .map(|unknown| at_key(unknown_name(file, &at, unknown), &at));
    }
    let message = format!("random group `{group}` has more than two parts");
    let when = if selected {
        "at start, because the group is preselected"
    } else {
        "when the group is selected"
    };
    let effect = format!("crashes with `ValueError` {when}");
    let finding = finding(file, &at, message, group)
        .level(Level::Error)
        .effect(effect);
    Some(at_key(finding, &at).help("write `category` or `category|subcategory`"))
}

/// A whole category that stands before one of its own groups.
fn nested(file: &FileFacts, group: &str, category: &str, selected: bool) -> Finding {
    let message = format!("random group `{group}` comes after its category `{category}`");
    let at = ["random", "groups", group];
    let finding = at_key(finding(file, &at, message, group), &at);
    let finding = if selected {
        finding
            .level(Level::Error)
            .effect("crashes with `AttributeError` at start, because both are preselected")
    } else {
        finding.effect(
            "crashes with `AttributeError` when it makes a random character with both selected",
        )
    };
    finding.help("keep either the category or its groups")
}
