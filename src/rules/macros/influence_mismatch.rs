//! `macro_influence` should be the macro definitions that really read the slider.

use super::super::cause::component::patterns;
use super::super::cause::schema::is_sound;
use super::super::{Check, Rule, RuleCx};
use super::component::unknown_patterns;
use super::sound::clear_space;
use crate::diag::{Application, Finding, Level, Place, RuleInfo, pointer};
use crate::formats::macro_json::{MacroFile, Macrodef};
use crate::repo::FileFacts;
use crate::repo::makehuman2::{Base, BoundSlider, Pattern, View};
use std::collections::BTreeSet;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "nothing today: it evaluates all macrodefs and only looks whether the list is empty",
        )],
        docs: "`macro_influence` is documented as the list of the macrodefs that a slider takes part \
            in.\n\nMakeHuman 2 evaluates all macrodefs whatever it says, and only cares whether the list is \
            empty. A wrong list is therefore harmless, but it misleads readers and any program that follows the \
            documentation (info).\n\nA slider that no component of `macro.json` reads at all moves nothing \
            (warning).\n\nList the macrodefs whose components read the pattern of the slider.",
        ..RuleInfo::new(
            "macro-influence-mismatch",
            Level::Info,
            "`macro_influence` differs from the macrodefs that read the slider",
        )
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    let unsure: BTreeSet<i64> =
        macros.macrodefs.iter().filter(|macrodef| is_unsure(base, (file, macros), macrodef)).map(index).collect();
    let last = i64::try_from(macros.macrodefs.len()).unwrap_or(i64::MAX);
    if base.lacks_macrodef() {
        return; // The positions behind it are off by one.
    }
    for bound in &base.sliders {
        let names = match &bound.pattern {
            Pattern::Macro(_) | Pattern::Barycentric(_) => bound.pattern.names(),
            _ => continue,
        };
        // An empty list is a fault of another kind, and so are indices out of range.
        let listed: BTreeSet<i64> = bound.slider.macro_influence.iter().flatten().copied().collect();
        if listed.is_empty() || is_only_in_unused(macros, names) || is_misshapen(bound) || is_doubled(base, names) {
            continue;
        }
        let used: BTreeSet<i64> = macros.macrodefs.iter().filter(|m| reads(macros, m, names)).map(index).collect();
        let missing: Vec<i64> = used.difference(&listed).copied().filter(|at| !unsure.contains(at)).collect();
        let superfluous = listed.difference(&used).copied();
        let superfluous: Vec<i64> = superfluous.filter(|at| (0..last).contains(at) && !unsure.contains(at)).collect();
        // With nothing right in the list the indices out of range are the cause.
        if missing.is_empty() && superfluous.is_empty() || listed.iter().any(|at| !(0..last).contains(at)) {
            continue;
        }
        let key = &bound.slider.key;
        if used.is_empty() && unsure.is_empty() && !macros.macrodefs.is_empty() {
            out.push(dead(bound, names));
            continue;
        }
        let message = format!("`macro_influence` of `{key}` {}", difference(&missing, &superfluous));
        let right = used.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let finding = RULE.at(bound.file, Place::pointer([key, "macro_influence"]), message).key(key);
        out.push(finding.help(format!("the macrodefs that read the slider are [{right}]")));
    }
}

/// A slider that no component reads: the list is the least of its faults.
fn dead(bound: &BoundSlider<'_>, names: &[String]) -> Finding {
    let key = &bound.slider.key;
    let member = if matches!(bound.pattern, Pattern::Macro(_)) { "macro" } else { "barycentric" };
    let name = names.first().map_or("", String::as_str);
    let message = format!("the macro slider `{key}` does nothing: no component reads its pattern `{name}`");
    RULE.at(bound.file, Place::pointer([key, member]), message)
        .key(key)
        .level(Level::Warning)
        .effect("shows a slider that moves nothing, and says nothing")
        .help("let the `pattern` of a component in macro.json name it, or remove the slider")
}

/// Whether another slider has the same pattern: that one of them is wrong is the fault.
fn is_doubled(base: &Base<'_>, names: &[String]) -> bool {
    base.sliders.iter().filter(|bound| bound.pattern.names() == names).count() > 1
}

/// Whether the schema refuses an element of the list, or the list.
fn is_misshapen(bound: &BoundSlider<'_>) -> bool {
    !is_sound(bound.file, &pointer(&[&bound.slider.key, "macro_influence"]))
}

fn index(macrodef: &Macrodef) -> i64 {
    i64::try_from(macrodef.index).unwrap_or(i64::MAX)
}

/// Whether a definition reads a slider that is registered under `names`.
fn reads(macros: &MacroFile, macrodef: &Macrodef, names: &[String]) -> bool {
    let components = macros.components.iter().filter(|component| macrodef.components.contains(&component.name));
    components.flat_map(patterns).any(|pattern| names.contains(&pattern))
}

/// Whether a definition might read a slider, were it not for another fault.
fn is_unsure(base: &Base<'_>, (file, macros): (&FileFacts, &MacroFile), macrodef: &Macrodef) -> bool {
    clear_space(file, macros, macrodef).is_none()
        || macrodef.components.iter().any(|name| {
            let component = macros.components.iter().find(|component| component.name == *name);
            component
                .is_none_or(|component| patterns(component).is_empty() || !unknown_patterns(base, component).is_empty())
        })
}

/// Whether only components that no definition uses read the slider.
fn is_only_in_unused(macros: &MacroFile, names: &[String]) -> bool {
    let reading = macros.components.iter().filter(|component| patterns(component).iter().any(|p| names.contains(p)));
    let mut reading = reading.peekable();
    reading.peek().is_some() && !macros.macrodefs.iter().any(|macrodef| reads(macros, macrodef, names))
}

fn difference(missing: &[i64], superfluous: &[i64]) -> String {
    let list = |indices: &[i64]| indices.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    match (missing, superfluous) {
        (missing, []) => format!("lacks {}", list(missing)),
        ([], superfluous) => format!("lists {}, which does not read it", list(superfluous)),
        _ => format!("lacks {} and lists {}, which does not read it", list(missing), list(superfluous)),
    }
}
