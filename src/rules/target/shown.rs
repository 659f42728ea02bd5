//! Which slider shows a target: what somebody must move to see it.
//!
//! Gets a base and the file of a target, returns words to append to a message; empty where nothing shows it, which is
//! a finding of its own.

use crate::formats::macro_json::{Component, MacroFile, Macrodef};
use crate::repo::{Base, FileFacts, Pattern};

/// `; shown by ...` with one slider setting that applies the target in full.
pub(super) fn shown_by(base: &Base<'_>, file: &FileFacts) -> String {
    match by_slider(base, file).or_else(|| by_macro(base, file)) {
        Some(setting) => format!("; shown by {setting}"),
        None => String::new(),
    }
}

fn by_slider(base: &Base<'_>, file: &FileFacts) -> Option<String> {
    base.sliders.iter().find_map(|bound| {
        let folder = base.folder_of(bound)?;
        let is_file = |name: &Option<String>| {
            name.as_deref().and_then(|name| folder.target(name)).is_some_and(|found| std::ptr::eq(found, file))
        };
        let pattern = match &bound.pattern {
            Pattern::Pair(pattern) | Pattern::Single(pattern) => pattern,
            Pattern::Barycentric(_) | Pattern::Macro(_) | Pattern::None => return None,
        };
        let is_pair = matches!(bound.pattern, Pattern::Pair(_));
        if is_file(&bound.slider.incr) {
            Some(format!("`{pattern}` = 1"))
        } else if is_pair && is_file(&bound.slider.decr) {
            Some(format!("`{pattern}` = -1"))
        } else {
            None
        }
    })
}

fn by_macro(base: &Base<'_>, file: &FileFacts) -> Option<String> {
    let (_, macros) = base.macro_file()?;
    let folder = base.targets?;
    macros.macrodefs.iter().find_map(|macrodef| {
        let place = macrodef.effective_folder.as_deref()?;
        let is_file = |target: &String| {
            folder.target(&format!("{place}/{target}")).is_some_and(|found| std::ptr::eq(found, file))
        };
        let link = macrodef.links.iter().find(|link| link.target.as_ref().is_some_and(is_file))?;
        Some(combination(macros, macrodef, &link.name))
    })
}

/// The slider positions of a combination, or its name where they cannot be told.
fn combination(macros: &MacroFile, macrodef: &Macrodef, name: &str) -> String {
    let component = |name: &String| macros.components.iter().rev().find(|component| component.name == *name);
    let components: Option<Vec<&Component>> = macrodef.components.iter().map(component).collect();
    let values: Vec<&str> = name.split('-').collect();
    let positions = components.filter(|components| components.len() == values.len()).and_then(|components| {
        let position = |(component, value): (&&Component, &&str)| position(component, value);
        components.iter().zip(&values).map(position).collect::<Option<Vec<String>>>()
    });
    positions.map_or_else(|| format!("the combination `{name}`"), |positions| positions.join(", "))
}

fn position(component: &Component, value: &str) -> Option<String> {
    let at = component.values.iter().position(|other| other == value)?;
    let pattern = component.pattern.as_deref()?;
    match (&component.steps, &component.sum) {
        (Some(steps), _) => Some(format!("`{pattern}` = {}", steps.get(at)?)),
        (None, Some(sum)) => Some(format!("`{pattern}{}` = 1", sum.get(at)?)),
        (None, None) => None,
    }
}
