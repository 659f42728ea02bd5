//! `macro_influence` should be the macro definitions that really read the slider.

use super::super::cause::component::{Readers, patterns};
use super::super::cause::schema::is_sound;
use super::super::{Check, Rule, RuleCx};
use super::component::unknown_patterns;
use super::sound::clear_space;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo, pointer};
use mhlint_formats::macro_json::{MacroFile, Macrodef};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, BoundSlider, Pattern, View};
use std::collections::BTreeSet;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "evaluates all macrodefs whatever the list holds; only readers and other programs are \
            misled",
    )],
    docs: include_str!("influence_mismatch.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-influence-mismatch",
        Level::Info,
        "`macro_influence` differs from the macrodefs that read the slider",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let unsure: BTreeSet<i64> = macros
        .macrodefs
        .iter()
        .filter(|macrodef| is_unsure(base, (file, macros), macrodef))
        .map(index)
        .collect();
    let last = i64::try_from(macros.macrodefs.len()).unwrap_or(i64::MAX);
    if base.lacks_macrodef() {
        return; // The positions behind it are off by one.
    }
    let readers = Readers::of(macros, patterns);
    let patterned: BTreeSet<String> = macros.components.iter().flat_map(patterns).collect();
    let doubled = doubled(base);
    for bound in &base.sliders {
        let names = match &bound.pattern {
            Pattern::Macro(_) | Pattern::Barycentric(_) => bound.pattern.names(),
            _ => continue,
        };
        // An empty list is a fault of another kind, and so are indices out of range.
        let listed: BTreeSet<i64> = bound
            .slider
            .macro_influence
            .iter()
            .flatten()
            .copied()
            .collect();
        if listed.is_empty() || is_misshapen(bound) || doubled.contains(names) {
            continue;
        }
        let used: BTreeSet<i64> = readers.of_any(names).into_iter().map(index).collect();
        // Only components that no definition uses read the slider.
        if used.is_empty() && names.iter().any(|name| patterned.contains(name)) {
            continue;
        }
        let missing: Vec<i64> = used
            .difference(&listed)
            .copied()
            .filter(|at| !unsure.contains(at))
            .collect();
        let superfluous: Vec<i64> = listed
            .difference(&used)
            .copied()
            .filter(|at| (0..last).contains(at) && !unsure.contains(at))
            .collect();
        // With nothing right in the list the indices out of range are the cause.
        if missing.is_empty() && superfluous.is_empty()
            || listed.iter().any(|at| !(0..last).contains(at))
        {
            continue;
        }
        let key = &bound.slider.key;
        if used.is_empty() && unsure.is_empty() && !macros.macrodefs.is_empty() {
            out.push(dead(bound, names));
            continue;
        }
        let message = format!(
            "`macro_influence` of `{key}` {}",
            difference(&missing, &superfluous)
        );
        let right = used
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join(", ");
        let finding = RULE
            .at(
                bound.file,
                Place::pointer([key, "macro_influence"]),
                message,
            )
            .key(key);
        out.push(finding.help(format!(
            "list the macrodefs that read the slider: `[{right}]`"
        )));
    }
}

/// A slider that no component reads: the list is the least of its faults.
fn dead(bound: &BoundSlider<'_>, names: &[String]) -> Finding {
    let key = &bound.slider.key;
    let member = if matches!(bound.pattern, Pattern::Macro(_)) {
        "macro"
    } else {
        "barycentric"
    };
    let name = names.first().map_or("", String::as_str);
    let message =
        format!("macro slider `{key}` does nothing: no component reads its pattern `{name}`");
    RULE.at(bound.file, Place::pointer([key, member]), message)
        .key(key)
        .level(Level::Warning)
        .effect("shows a slider that moves nothing")
        .help("use the pattern in a component of macro.json, or remove the slider")
}

/// Patterns of several sliders: that one of them is wrong is the fault.
fn doubled<'b>(base: &'b Base<'_>) -> BTreeSet<&'b [String]> {
    let mut seen = BTreeSet::new();
    base.sliders
        .iter()
        .map(|bound| bound.pattern.names())
        .filter(|names| !seen.insert(*names))
        .collect()
}

/// Whether the schema rejects an element of the list, or the list.
fn is_misshapen(bound: &BoundSlider<'_>) -> bool {
    !is_sound(
        bound.file,
        &pointer(&[&bound.slider.key, "macro_influence"]),
    )
}

fn index(macrodef: &Macrodef) -> i64 {
    i64::try_from(macrodef.index).unwrap_or(i64::MAX)
}

/// Whether a definition might read a slider, were it not for another fault.
fn is_unsure(
    base: &Base<'_>,
    (file, macros): (&FileFacts, &MacroFile),
    macrodef: &Macrodef,
) -> bool {
    clear_space(file, macros, macrodef).is_none()
        || macrodef.components.iter().any(|name| {
            let component = macros
                .components
                .iter()
                .find(|component| component.name == *name);
            component.is_none_or(|component| {
                patterns(component).is_empty() || !unknown_patterns(base, component).is_empty()
            })
        })
}

fn difference(missing: &[i64], superfluous: &[i64]) -> String {
    let list = |indices: &[i64]| {
        let all = indices
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join(", ");
        format!(
            "macrodef{} {all}",
            if indices.len() == 1 { "" } else { "s" }
        )
    };
    let verb = if superfluous.len() == 1 { "does" } else { "do" };
    let surplus = format!(
        "lists {}, which {verb} not read the slider",
        list(superfluous)
    );
    match (missing, superfluous) {
        (missing, []) => format!("lacks {}", list(missing)),
        ([], _) => surplus,
        _ => format!("lacks {} and {surplus}", list(missing)),
    }
}
