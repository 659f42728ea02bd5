//! A component that no macro definition uses.

use super::super::cause::schema::is_sound;
use super::super::{Check, Rule, RuleCx};
use super::sound::clear_space;
use super::space::Space;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_formats::macro_json::{MacroFile, Macrodef};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "never evaluates the component")],
    docs: include_str!("unused_component.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-unused-component",
        Level::Info,
        "a component is not used by any macrodef",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let used: BTreeSet<&str> = macros.used.iter().map(String::as_str).collect();
    let known: BTreeSet<&str> = macros
        .components
        .iter()
        .map(|component| component.name.as_str())
        .collect();
    if macros.macrodefs.is_empty() {
        out.extend(without_macrodefs(base, file, macros));
        return;
    }
    // What belongs into a `comp` that is empty, repeats itself or does not spell its names is open.
    let is_open = |macrodef: &Macrodef| {
        let names: BTreeSet<&String> = macrodef.components.iter().collect();
        names.is_empty()
            || names.len() < macrodef.components.len()
            || (Space::of(macros, macrodef).is_some()
                && clear_space(file, macros, macrodef).is_none())
    };
    if macros.macrodefs.iter().any(is_open) || base.lacks_macrodef() {
        return;
    }
    // An unknown component that is a slip of the pen for this one is the cause, and
    // `macro-unknown-component` names it.
    let unknown = used.difference(&known);
    let meant: BTreeSet<&str> = unknown
        .filter_map(|name| cx.suggestions.nearest(name, known.iter().copied()))
        .collect();
    for component in &macros.components {
        let name = component.name.as_str();
        if !used.contains(name) && !meant.contains(name) {
            let place = Place::key(["components", name]);
            let finding = RULE.at(
                file,
                place,
                format!("component `{name}` is not used by any macrodef"),
            );
            out.push(
                finding
                    .key(name)
                    .help("remove it, or add it to the `comp` of a macrodef"),
            );
        }
    }
}

/// Without macro definitions nothing uses a component; that is one thing to say.
fn without_macrodefs(base: &Base<'_>, file: &FileFacts, macros: &MacroFile) -> Option<Finding> {
    let first = macros
        .components
        .first()
        .filter(|_| is_sound(file, "/macrodef"))?;
    let message = match macros.components.len() {
        1 => format!(
            "component `{}` is never used: macro.json has no macrodefs",
            first.name
        ),
        count => format!("the {count} components are never used: macro.json has no macrodefs"),
    };
    let finding = RULE
        .at(file, Place::pointer(["macrodef"]), message)
        .key("no macrodef");
    let finding = finding.help("add the macrodefs of the components, or remove the components");
    if !base.sliders.iter().any(|bound| bound.slider.is_macro()) {
        return Some(finding);
    }
    Some(finding.level(Level::Error).effect(
        "loads no macros: the macro sliders move nothing, and their targets are never loaded",
    ))
}
