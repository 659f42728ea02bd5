//! Which slider shows a target: names a setting at which it is applied, as the application spells sliders.
//!
//! Gets a repository and the facts of a target; returns `head/head-oval = 1`, or the corner of the macro sliders.

use crate::formats::macro_json::MacroFile;
use crate::repo::{Base, FileFacts, Reference, ReferenceKind, Repository};

/// A setting that applies the target fully; `None` if nothing uses it.
pub(super) fn shown_by(repository: &Repository<'_>, file: &FileFacts) -> Option<String> {
    let leads_here = |reference: &&Reference<'_>| {
        let found = reference.meant();
        reference.kind.is_target() && found.is_some_and(|found| found.path == file.path)
    };
    let reference = repository.references.iter().find(leads_here)?;
    let base = repository.bases.iter().find(|base| base.name == reference.base)?;
    match reference.kind {
        ReferenceKind::MacroTarget => Some(corner(base.macro_file()?.1, reference.owner)),
        ReferenceKind::Decr => side(base, reference.owner, "-1"),
        _ => side(base, reference.owner, "1"),
    }
}

fn side(base: &Base<'_>, key: &str, value: &str) -> Option<String> {
    let slider = base.entry(key)?;
    Some(format!("`{}` = {value}", slider.pattern.names().first()?))
}

/// The macro sliders at which a combination is applied alone.
fn corner(file: &MacroFile, combination: &str) -> String {
    let mut macrodefs = file.macrodefs.iter();
    let macrodef = macrodefs.find(|macrodef| macrodef.links.iter().any(|link| link.name == combination));
    let settings = macrodef.and_then(|macrodef| {
        let mut rest = combination;
        let settings = macrodef.components.iter().map(|name| {
            let component = file.components.iter().find(|component| component.name == *name)?;
            let fits = |value: &&String| {
                rest.strip_prefix(value.as_str()).is_some_and(|left| left.is_empty() || left.starts_with('-'))
            };
            // The longest value that fits: one may be the beginning of another.
            let value = component.values.iter().filter(fits).max_by_key(|value| value.len())?;
            let place = component.values.iter().position(|other| other == value)?;
            rest = rest.strip_prefix(value.as_str())?.trim_start_matches('-');
            let pattern = component.pattern.as_deref()?;
            match (&component.steps, &component.sum) {
                (Some(steps), _) => Some(format!("`{pattern}` = {}", steps.get(place)?)),
                (None, Some(ends)) => Some(format!("`{pattern}{}` = 1", ends.get(place)?)),
                (None, None) => None,
            }
        });
        settings.collect::<Option<Vec<String>>>()
    });
    settings.map_or_else(|| format!("the macro combination `{combination}`"), |settings| settings.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::macro_json::{Component, Link, Macrodef};

    #[test]
    fn a_combination_is_told_by_its_sliders() {
        let texts = |list: &[&str]| list.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
        let steps = Component {
            name: "age".to_owned(),
            pattern: Some("macro/Age".to_owned()),
            values: texts(&["old", "older"]),
            steps: Some(vec![0.0, 1.0]),
            ..Component::default()
        };
        let sum = Component {
            name: "type".to_owned(),
            pattern: Some("macro/".to_owned()),
            values: texts(&["a", "b", "c"]),
            sum: Some(texts(&["A", "B", "C"])),
            ..Component::default()
        };
        let link = Link { index: 0, name: "older-b".to_owned(), target: None };
        let macrodef = Macrodef { components: texts(&["age", "type"]), links: vec![link], ..Macrodef::default() };
        let file = MacroFile { components: vec![steps, sum], macrodefs: vec![macrodef] };
        assert_eq!(corner(&file, "older-b"), "`macro/Age` = 1, `macro/B` = 1");
        assert_eq!(corner(&file, "x"), "the macro combination `x`");
    }
}
