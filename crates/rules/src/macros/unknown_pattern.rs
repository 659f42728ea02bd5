//! The pattern of a component must be that of a macro slider.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::component::{macro_patterns, sound_components, unknown_patterns, weigh};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "drops the component; the names of its macrodefs are then too short, and none of their \
            targets is applied",
    )],
    docs: include_str!("unknown_pattern.md").trim_ascii_end(),
    counts: "patterns",
    ..RuleInfo::new(
        "macro-unknown-pattern",
        Level::Error,
        "no slider has the pattern of a \
        component",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let known: BTreeSet<&str> = macro_patterns(base).collect();
    let has_doubled = known.len() < macro_patterns(base).count();
    for component in sound_components(file, macros) {
        if component.steps.is_some() && component.sum.is_some() {
            continue; // `macro-steps-and-sum`: which of the two is meant is open.
        }
        let unknown = unknown_patterns(base, component);
        let Some(first) = unknown.first() else {
            continue;
        };
        // A slider with the name of another one leaves its own behind:
        // `modelling-duplicate-pattern`.
        if unknown.len() == 1 && has_doubled {
            continue;
        }
        let name = &component.name;
        let message = match unknown.len() {
            1 => format!("component `{name}` reads the pattern `{first}`, which no slider has"),
            count => {
                format!(
                    "component `{name}` reads the pattern `{first}`, which no slider has ({count} \
                        such patterns)"
                )
            }
        };
        let read = super::super::cause::component::patterns(component);
        let free = known.iter().copied();
        let free = free.filter(|pattern| !read.iter().any(|own| own == pattern));
        let help = did_you_mean(
            cx.suggestions.nearest(first, free),
            "write the `macro`, or a text of `barycentric`, of an entry of modelling.json",
        );
        let is_corner = component.steps.is_none() && unknown.len() < read.len();
        let corner = read
            .iter()
            .position(|own| own == first)
            .filter(|_| is_corner)
            .map(|at| at.to_string());
        let place = match &corner {
            Some(corner) => Place::pointer(["components", name, "sum", corner]),
            None => Place::pointer(["components", name, "pattern"]),
        };
        let mut finding = RULE.at(file, place, message).key(name).help(help);
        if is_corner {
            let effect = "silently skips this corner of the triangle; the targets of its value \
                are never applied";
            finding = finding.effect(effect);
        }
        if let Some((sliders, _)) = base.modelling.winner() {
            finding = finding.against(&sliders.path);
        }
        out.push(weigh(
            finding.evidence(Evidence::of_cases(&unknown).out_of(read.len())),
            macros,
            component,
        ));
    }
}
