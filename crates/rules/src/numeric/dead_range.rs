//! Stretches of a slider in which a macrodef applies nothing.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::{component, has_sound_steps, title};
use mhlint_diag::{
    Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_eval::measures::{DeadRange, Measures};
use mhlint_formats::macro_json::{Component, MacroFile, Macrodef};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "silently applies none of the targets of the macrodef in this part of the slider",
    )],
    docs: include_str!("dead_range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "numeric-dead-range",
        Level::Warning,
        "a macrodef applies nothing in a part of a slider",
    )
});

const NARROW: Case = &[(
    Makehuman2,
    Level::Info,
    "fades the shape out towards this position, and applies none of the targets of the macrodef \
        there",
)];

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = body.macros else {
        return;
    };
    let dead = measures.macros.dead.iter();
    for (number, ranges) in grouped(dead.map(|range| (range.macrodef, range))) {
        let own = macros.macrodefs.get(number);
        let Some(macrodef) = own.filter(|macrodef| is_sound(macros, macrodef)) else {
            continue;
        };
        let Some(parts) = ranges
            .iter()
            .map(|range| told(macros, range))
            .collect::<Option<Vec<_>>>()
        else {
            continue;
        };
        if parts.is_empty() {
            continue;
        }
        let is_wide = ranges
            .iter()
            .any(|range| range.values.len() > 1 && range.missing > 0);
        let message = format!(
            "macrodef `{}` applies nothing {}",
            title(macrodef),
            parts.join(", ")
        );
        let place = Place::pointer(["macrodef", &macrodef.index.to_string(), "comp"]);
        let finding = RULE
            .at(file, place, message)
            .key(title(macrodef))
            .evidence(Evidence::of_cases(&parts));
        let finding = finding.parts(ranges.iter().flat_map(|range| dead_values(macros, range)));
        out.push(if is_wide {
            finding.help(
                "list the combinations; `null` for those where no shape is meant makes \
                this an info",
            )
        } else {
            finding.case(NARROW).help(
                "leave it if no shape is meant there; otherwise give the \
                combinations targets",
            )
        });
    }
}

/// The values of a stretch, each with its component: their names stay when steps move.
fn dead_values(macros: &MacroFile, range: &DeadRange) -> Vec<String> {
    let Some((_, component)) = component(macros, range.macrodef, range.position) else {
        return Vec::new();
    };
    let values = range
        .values
        .iter()
        .filter_map(|value| component.values.get(*value));
    values
        .map(|value| format!("{}: {value}", component.name))
        .collect()
}

/// `at … = 0 (value baby: 54 combinations not listed)`. `None` where the steps themselves are at
/// fault.
fn told(macros: &MacroFile, range: &DeadRange) -> Option<String> {
    let (_, component) =
        component(macros, range.macrodef, range.position).filter(|(_, c)| has_sound_steps(c))?;
    let steps = component.steps.as_ref()?;
    let (first, last) = (*range.values.first()?, *range.values.last()?);
    let pattern = component.pattern.as_deref()?;
    let stretch = if first == last {
        format!("at `{pattern}` = {}", steps.get(first)?)
    } else {
        format!(
            "from `{pattern}` = {} to {}",
            steps.get(first)?,
            steps.get(last)?
        )
    };
    let names = component.values.get(first..=last)?.join("`, `");
    let counts = match (range.missing, range.null) {
        (1, 0) => "1 combination not listed".to_owned(),
        (0, 1) => "1 combination `null`".to_owned(),
        (missing, 0) => format!("{missing} combinations not listed"),
        (0, null) => format!("{null} combinations `null`"),
        (missing, null) => format!("{missing} combinations not listed, {null} `null`"),
    };
    Some(format!("{stretch} (`{names}`: {counts})"))
}

/// Whether the names of a macrodef are those of its components: others are the cause then.
fn is_sound(macros: &MacroFile, macrodef: &Macrodef) -> bool {
    let named = |name: &String| {
        macros
            .components
            .iter()
            .rev()
            .find(|component| component.name == *name)
    };
    let Some(components) = macrodef
        .components
        .iter()
        .map(named)
        .collect::<Option<Vec<_>>>()
    else {
        return false;
    };
    let spelled = macrodef
        .links
        .iter()
        .all(|link| is_spelled(&link.name, &components));
    spelled && macrodef.unusable.is_empty() && macrodef.incomplete.is_empty()
}

/// Whether a name is a value of each component, joined by `-`. All that may be left of it is
/// followed at once, since values may have `-` in them, too.
fn is_spelled(name: &str, components: &[&Component]) -> bool {
    let Some((last, others)) = components.split_last() else {
        return false;
    };
    let mut left = BTreeSet::from([name]);
    for component in others {
        let mut behind = BTreeSet::new();
        for name in left {
            let tails = component
                .values
                .iter()
                .filter_map(|value| name.strip_prefix(value.as_str()));
            behind.extend(tails.filter_map(|tail| tail.strip_prefix('-')));
        }
        left = behind;
        if left.is_empty() {
            return false;
        }
    }
    left.iter()
        .any(|name| last.values.iter().any(|value| value == name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_followed_through_any_number_of_components() {
        let values = ["a", "a-a", "b"].map(str::to_owned).to_vec();
        let component = Component {
            values,
            ..Component::default()
        };
        let many = |count: usize| vec![&component; count];
        for (name, count, is_spelled_so) in [
            ("a", 1, true),
            ("a-a", 1, true),
            ("a-a", 2, true),
            ("a-a-a", 2, true),
            ("a-b-a", 2, false),
            ("", 0, false),
        ] {
            assert_eq!(
                is_spelled(name, &many(count)),
                is_spelled_so,
                "{name} {count}"
            );
        }
        // Each way to take it apart for itself would be more than there are atoms, and a call for
        // each a stack too deep.
        let long = vec!["a"; 60].join("-");
        assert!(is_spelled(&long, &many(40)) && !is_spelled(&format!("{long}-c"), &many(40)));
        assert!(is_spelled(&vec!["b"; 20_000].join("-"), &many(20_000)));
    }
}
