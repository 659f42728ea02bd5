//! Patterns, groups and entries named in `base.json` must exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::has_sliders;
use crate::diag::{Application, Finding, Level, Place, RuleInfo, nearest};
use crate::formats::base_json::{BaseJson, Random};
use crate::repo::{Base, FileFacts, Repository};

/// The way to leave a measure out.
const NO_MEASURE: &str = "none";
/// Beginning of the groups of user targets, which come and go.
const USER: &str = "user";

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "ignores the name; what it was for has no effect")],
        docs: "`modifier-presets` and `measure` name sliders by their pattern, `random.gender`, `random.ideal` and `random.rules` by their key, \
            `random.groups` and `head-pattern` name groups of sliders.\n\nA name that does not exist is ignored, mostly without a message; a rule of \
            the randomizer on an unknown slider always resets its target. Errors are what stops the program: an `age` whose slider \
            has no `display`, a random group with two `|`, and a category that is selected before one of its own groups. Groups of \
            user targets are not judged, and `none` is the way to leave a measure out.\n\nCorrect the name, or remove it.",
        ..RuleInfo::new(
            "base-unknown-preset",
            Level::Warning,
            "a preset, measure or random rule names what does not exist",
        )
    },
    check: Check::Base(run),
};

fn run(_: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings().filter(|_| has_sliders(base)) else { return };
    let names = Names { file, base };
    for (pattern, _) in &settings.presets {
        out.extend(names.pattern(&["modifier-presets", pattern], pattern));
    }
    measures(&names, settings, out);
    for (index, head) in settings.head_pattern.iter().flatten().enumerate() {
        out.extend(names.head(&["head-pattern", &index.to_string()], head));
    }
    if let Some(random) = &settings.random {
        randomizer(&names, random, out);
    }
}

fn measures(names: &Names<'_, '_>, settings: &BaseJson, out: &mut Vec<Finding>) {
    for (purpose, pattern) in settings.measure.iter().filter(|(_, pattern)| pattern != NO_MEASURE) {
        let at = ["measure", purpose.as_str()];
        let slider = names.base.slider(pattern).map(|bound| bound.slider);
        let finding = match (purpose.as_str(), slider) {
            ("size", None) | ("comment", _) => None,
            ("size", Some(_)) => {
                let message = format!("`size` names the pattern `{pattern}`: the height is then not shown");
                Some(names.finding(&at, message, pattern).help("write `\"size\": \"none\"`"))
            }
            (_, None) => names.pattern(&at, pattern),
            ("gender", Some(_)) => None,
            ("age", Some(slider)) => slider.display.is_none().then(|| {
                let message = format!("`age` names `{}`, which has no `display`", slider.key);
                let effect = "stops with an AttributeError when the size information is shown";
                let finding = names.finding(&at, message, pattern).level(Level::Error);
                finding.breaks(Application::Makehuman2, effect).help("name the slider that displays the age")
            }),
            (_, Some(slider)) => slider.measure.is_none().then(|| {
                let message = format!("`{purpose}` names `{}`, which has no `measure`", slider.key);
                let help = "name an entry with `measure`, or `none`";
                names.finding(&at, message, pattern).help(help)
            }),
        };
        out.extend(finding);
    }
}

fn randomizer(names: &Names<'_, '_>, random: &Random, out: &mut Vec<Finding>) {
    for (member, key) in [("gender", &random.gender), ("ideal", &random.ideal)] {
        out.extend(key.as_ref().and_then(|key| names.entry(&["random", member], key)));
    }
    for (at, (group, selected)) in random.groups.iter().enumerate() {
        let earlier = random.groups.iter().take(at);
        let whole = earlier.filter(|(other, _)| group.split_once('|').is_some_and(|(category, _)| category == other));
        match whole.last() {
            Some((category, also)) => out.push(names.nested(group, category, *selected && *also)),
            None => out.extend(names.group(group)),
        }
    }
    for (key, conditions) in &random.rules {
        if let Some(finding) = names.entry(&["random", "rules", key], key) {
            out.push(finding);
            continue;
        }
        for condition in conditions {
            let finding = names.entry(&["random", "rules", key, &condition.slider], &condition.slider);
            let effect = "always resets the target of the rule to 0";
            out.extend(finding.map(|finding| finding.breaks(Application::Makehuman2, effect)));
        }
    }
}

/// What names in `base.json` are looked up in.
struct Names<'n, 'a> {
    file: &'a FileFacts,
    base: &'n Base<'a>,
}

impl Names<'_, '_> {
    fn finding(&self, at: &[&str], message: String, name: &str) -> Finding {
        let place = at.iter().fold(String::new(), |place, part| {
            let Place::Pointer(step) = Place::pointer([part]) else { return place };
            place + &step
        });
        let purpose = at.first().copied().unwrap_or_default();
        RULE.at(self.file, Place::Pointer(place), message).key(format!("{purpose} {name}"))
    }

    fn pattern(&self, at: &[&str], pattern: &str) -> Option<Finding> {
        if self.base.slider(pattern).is_some() || self.base.names_undeclared_pair(pattern) {
            return None;
        }
        let patterns = self.base.sliders.iter().flat_map(|slider| slider.pattern.names()).map(String::as_str);
        let of_key = self.base.sliders.iter().find(|slider| slider.slider.key == pattern);
        let help = match (of_key.and_then(|slider| slider.pattern.names().first()), nearest(pattern, patterns)) {
            (Some(own), _) => format!("this is the key of an entry; write its pattern `{own}`"),
            (None, Some(near)) => format!("did you mean `{near}`?"),
            (None, None) => "name the pattern of a slider, or remove the line".to_owned(),
        };
        Some(self.finding(at, format!("no slider has the pattern `{pattern}`"), pattern).help(help))
    }

    fn entry(&self, at: &[&str], key: &str) -> Option<Finding> {
        if self.base.sliders.iter().any(|slider| slider.slider.key == key) {
            return None;
        }
        let keys = self.base.sliders.iter().map(|slider| slider.slider.key.as_str());
        let help = match (self.base.slider(key), nearest(key, keys)) {
            (Some(slider), _) => format!("this is a pattern; write the key `{}`", slider.slider.key),
            (None, Some(near)) => format!("did you mean `{near}`?"),
            (None, None) => "name the key of an entry of modelling.json".to_owned(),
        };
        Some(self.finding(at, format!("modelling.json has no entry `{key}`"), key).help(help))
    }

    /// Groups of sliders, and those that an item would show: an empty item is a finding of its own.
    fn groups(&self) -> BTreeSet<String> {
        let own = self.base.sliders.iter().filter_map(|slider| slider.slider.group.clone());
        let categories = [self.base.categories.winner(), self.base.user_categories.accepted()];
        let categories = categories.into_iter().flatten().flat_map(|(_, model)| &model.categories);
        let shown = categories.flat_map(|category| category.items.iter().filter_map(|item| category.group_of(item)));
        own.chain(shown).collect()
    }

    fn group(&self, group: &str) -> Option<Finding> {
        let at = ["random", "groups", group];
        if group.matches('|').count() > 1 {
            let finding = self.finding(&at, format!("the random group `{group}` has more than two parts"), group);
            let effect = "stops with a ValueError when a random character is made";
            let finding = finding.level(Level::Error).breaks(Application::Makehuman2, effect);
            return Some(finding.help("write `category` or `category|subcategory`"));
        }
        let groups = self.groups();
        let categories: BTreeSet<&str> = groups.iter().filter_map(|group| group.split('|').next()).collect();
        let known = groups.contains(group) || categories.contains(group);
        if known || group.split('|').next() == Some(USER) {
            return None;
        }
        let near = if group.contains('|') {
            nearest(group, groups.iter().map(String::as_str))
        } else {
            nearest(group, categories)
        };
        let help = match near {
            Some(near) => format!("did you mean `{near}`?"),
            None => "name a category or group of the sliders, or remove the line".to_owned(),
        };
        Some(self.finding(&at, format!("no slider is in the random group `{group}`"), group).help(help))
    }

    /// A whole category that stands before one of its own groups.
    fn nested(&self, group: &str, category: &str, selected: bool) -> Finding {
        let message = format!("the random group `{group}` follows its whole category `{category}`");
        let effect = "stops with an AttributeError when a random character is made with both selected";
        let level = if selected { Level::Error } else { Level::Warning };
        let finding = self.finding(&["random", "groups", group], message, group).level(level);
        finding.breaks(Application::Makehuman2, effect).help("list either the category or its groups")
    }

    fn head(&self, at: &[&str], beginning: &str) -> Option<Finding> {
        let groups = self.groups();
        let is_user = beginning.split('|').next() == Some(USER);
        if is_user || groups.iter().any(|group| group.starts_with(beginning)) {
            return None;
        }
        let categories: BTreeSet<String> =
            groups.iter().filter_map(|group| group.split('|').next()).map(|category| format!("{category}|")).collect();
        let candidates = groups.iter().chain(&categories).map(String::as_str);
        let help = match nearest(beginning, candidates) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "name the beginning of a group, or remove the line".to_owned(),
        };
        let message = format!("no group of a slider begins with `{beginning}`");
        Some(self.finding(at, message, beginning).help(help))
    }
}
