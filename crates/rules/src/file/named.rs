//! References that stand in the checked layer, by file and cause, and what follows if they lead
//! nowhere.

use super::super::Rule;
use super::super::cause::consequence::unfound;
use mhlint_diag::{Change, Evidence, Finding, Fix, Place, grouped};
use mhlint_repo::{Reference, Resolution, View, composed};

/// References of one cause in one file, in the order of the file.
pub(super) struct Cause<'r, 'a> {
    /// Name of the cause inside the file.
    pub(super) key: String,
    /// The references, at least one.
    pub(super) references: Vec<&'r Reference<'a>>,
}

/// The references that `key` gives a cause for, one [`Cause`] for each file and key.
pub(super) fn causes<'r, 'a>(
    view: &'r View<'a>,
    key: impl Fn(&Reference<'a>) -> Option<String>,
) -> Vec<Cause<'r, 'a>> {
    let layers = view.layers();
    let own = view
        .references()
        .iter()
        .filter(|reference| layers.is_checked(reference.from));
    let causes = grouped(own.filter_map(|reference| {
        // A faulty folder is one cause for all names behind it, and another than a name of its own.
        let folder = reference
            .folder_at_fault
            .as_ref()
            .map(|(_, folder)| format!("folder {folder}"));
        let key = [Some(key(reference)?), folder]
            .into_iter()
            .flatten()
            .filter(|part| !part.is_empty());
        Some((
            (
                reference.from.path.as_str(),
                key.collect::<Vec<_>>().join("/"),
            ),
            reference,
        ))
    }));
    causes
        .into_iter()
        .map(|((_, key), references)| Cause { key, references })
        .collect()
}

impl Cause<'_, '_> {
    /// The text to blame: the folder in front of the names, or the first name.
    pub(super) fn text(&self) -> &str {
        let first = self.references.first();
        first.map_or("", |first| {
            first
                .folder_at_fault
                .as_ref()
                .map_or(first.text, |(_, folder)| folder)
        })
    }

    /// A finding at the first reference, or at its folder; the others are counted.
    pub(super) fn finding(
        &self,
        rule: &Rule,
        message: impl FnOnce(&str) -> String,
    ) -> Option<Finding> {
        let first = self.references.first()?;
        let mut message = message(self.text());
        let place = first
            .folder_at_fault
            .as_ref()
            .map_or_else(|| first.place.clone(), |(place, _)| place.clone());
        if self.references.len() > 1 {
            message = format!("{message} ({} such references)", self.references.len());
        }
        let names = self.references.iter().map(|reference| reference.text);
        Some(
            rule.at(first.from, place, message)
                .key(&self.key)
                .evidence(Evidence::of_cases(names)),
        )
    }

    /// The finding with what the application of the view does where it finds nothing, `on` these
    /// systems or on all; the worst sets the level.
    pub(super) fn unfound(&self, view: &View<'_>, finding: Finding, on: &str) -> Finding {
        let losses: Vec<_> = self
            .references
            .iter()
            .filter_map(|reference| unfound(view, reference.kind))
            .collect();
        let worst = losses.iter().map(|loss| loss.level).max();
        let on = if on.is_empty() {
            String::new()
        } else {
            format!("{on}, ")
        };
        let effect = losses
            .first()
            .and_then(|loss| loss.effect)
            .map(|effect| format!("{on}{effect}"));
        let (Some(worst), Some(effect)) = (worst, effect) else {
            return finding;
        };
        finding
            .level_in(view.application(), worst)
            .effect_in(view.application(), effect)
    }
}

/// A fix that also writes `text` for a name.
pub(super) fn written(fix: Fix, reference: &Reference<'_>, text: Option<String>) -> Fix {
    match &reference.place {
        Place::Pointer(pointer) => fix.step(
            &reference.from.path,
            Change::Value {
                pointer: pointer.clone(),
                text,
            },
        ),
        // A name that is not written, such as that of a default.
        _ => fix,
    }
}

/// Whether a reference names its file in another form of accented letters, and not just with other
/// capitals.
pub(super) fn differs_in_form(reference: &Reference<'_>) -> bool {
    match reference.resolution {
        Resolution::CaseOnly(file) => composed(&reference.rel) == composed(&file.rel),
        _ => false,
    }
}
