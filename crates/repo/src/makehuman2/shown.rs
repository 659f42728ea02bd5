//! Which slider shows a target.

use super::{Base, View};
use crate::{FileFacts, ReferenceKind, Shown};
use mhlint_formats::macro_json::MacroFile;

impl<'a> View<'a> {
    /// A setting that applies a target fully, of several uses the first; `None` if nothing uses it.
    pub(crate) fn shown_at(&self, file: &FileFacts) -> Option<Shown<'a>> {
        let reference = self
            .references
            .to_file(file)
            .find(|reference| reference.kind.is_target())?;
        let base = self.base(reference.base)?;
        match reference.kind {
            ReferenceKind::MacroTarget => Some(corner(base.macro_file()?.1, reference.owner)),
            ReferenceKind::Decr => side(base, reference.owner, -1.0),
            _ => side(base, reference.owner, 1.0),
        }
    }
}

fn side<'a>(base: &Base<'a>, key: &str, value: f64) -> Option<Shown<'a>> {
    let name = base.entry(key)?.pattern.names().first()?;
    Some(Shown::At(vec![(name.clone(), value)]))
}

/// The macro sliders at which a combination is applied alone.
fn corner<'a>(file: &MacroFile, combination: &'a str) -> Shown<'a> {
    let mut macrodefs = file.macrodefs.iter();
    let macrodef =
        macrodefs.find(|macrodef| macrodef.links.iter().any(|link| link.name == combination));
    let settings = macrodef.and_then(|macrodef| {
        let mut rest = combination;
        let settings = macrodef.components.iter().map(|name| {
            let component = file
                .components
                .iter()
                .find(|component| component.name == *name)?;
            let fits = |value: &&String| {
                rest.strip_prefix(value.as_str())
                    .is_some_and(|left| left.is_empty() || left.starts_with('-'))
            };
            // The longest value that fits: one may be the beginning of another.
            let value = component
                .values
                .iter()
                .filter(fits)
                .max_by_key(|value| value.len())?;
            let place = component.values.iter().position(|other| other == value)?;
            rest = rest.strip_prefix(value.as_str())?.trim_start_matches('-');
            let pattern = component.pattern.as_deref()?;
            match (&component.steps, &component.sum) {
                (Some(steps), _) => Some((pattern.to_owned(), *steps.get(place)?)),
                (None, Some(ends)) => Some((format!("{pattern}{}", ends.get(place)?), 1.0)),
                (None, None) => None,
            }
        });
        settings.collect::<Option<Vec<(String, f64)>>>()
    });
    settings.map_or(Shown::Combination(combination), Shown::At)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_formats::macro_json::{Component, Link, Macrodef};

    #[test]
    fn a_combination_is_told_by_its_sliders() {
        let texts = |list: &[&str]| {
            list.iter()
                .map(|text| (*text).to_owned())
                .collect::<Vec<_>>()
        };
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
        let link = Link {
            index: 0,
            name: "older-b".to_owned(),
            target: None,
        };
        let macrodef = Macrodef {
            components: texts(&["age", "type"]),
            links: vec![link],
            ..Macrodef::default()
        };
        let file = MacroFile {
            components: vec![steps, sum],
            macrodefs: vec![macrodef],
            ..MacroFile::default()
        };
        let at = |name: &str| (name.to_owned(), 1.0);
        assert_eq!(
            corner(&file, "older-b"),
            Shown::At(vec![at("macro/Age"), at("macro/B")])
        );
        assert_eq!(corner(&file, "x"), Shown::Combination("x"));
    }
}
