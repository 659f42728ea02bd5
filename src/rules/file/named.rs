//! References that stand in the judged layer, by file and cause, and what follows if they lead nowhere.

use std::collections::BTreeMap;

use super::super::Rule;
use crate::diag::{Change, Evidence, Finding, Fix, Level, Place};
use crate::repo::makehuman2::View;
use crate::repo::{Reference, ReferenceKind, Resolution, composed, fold};

/// References of one cause in one file, in the order of the file.
pub(super) struct Cause<'r, 'a> {
    /// Name of the cause inside the file.
    pub(super) key: String,
    /// The references, at least one.
    pub(super) references: Vec<&'r Reference<'a>>,
}

/// The references that `key` gives a cause for, one [`Cause`] for each file and key.
pub(super) fn causes<'r, 'a>(view: &'r View<'a>, key: impl Fn(&Reference<'a>) -> Option<String>) -> Vec<Cause<'r, 'a>> {
    let mut causes: BTreeMap<(&str, String), Vec<&Reference<'a>>> = BTreeMap::new();
    for reference in view.references.iter().filter(|reference| view.layers.is_checked(reference.from)) {
        if let Some(key) = key(reference) {
            // A faulty folder is one cause for all names behind it, and another than a name of its own.
            let folder = reference.folder_at_fault.as_ref().map(|(_, folder)| format!("folder {folder}"));
            let key = [Some(key), folder].into_iter().flatten().filter(|part| !part.is_empty());
            let key = key.collect::<Vec<_>>().join("/");
            causes.entry((reference.from.path.as_str(), key)).or_default().push(reference);
        }
    }
    causes.into_iter().map(|((_, key), references)| Cause { key, references }).collect()
}

impl Cause<'_, '_> {
    /// The text to blame: the folder in front of the names, or the first name.
    pub(super) fn text(&self) -> &str {
        let first = self.references.first();
        first.map_or("", |first| first.folder_at_fault.as_ref().map_or(first.text, |(_, folder)| folder))
    }

    /// A finding at the first reference, or at its folder; the others are counted, the worst sets the level.
    pub(super) fn finding(&self, rule: &Rule, message: impl FnOnce(&str) -> String) -> Option<Finding> {
        let first = self.references.first()?;
        let mut message = message(self.text());
        let place = first.folder_at_fault.as_ref().map_or_else(|| first.place.clone(), |(place, _)| place.clone());
        if self.references.len() > 1 {
            message = format!("{message} ({} references like it)", self.references.len());
        }
        let names = self.references.iter().map(|reference| reference.text);
        let worst = self.references.iter().map(|reference| level(reference.kind)).max().unwrap_or(Level::Error);
        let finding = rule.at(first.from, place, message).key(&self.key).level(worst);
        Some(finding.evidence(Evidence::of_cases(names)))
    }
}

/// Whether a slider must keep its name: it is part of a pattern by which something else knows the slider, or would,
/// rightly written, give the pattern of another one.
pub(super) fn is_known_by(view: &View<'_>, reference: &Reference<'_>) -> bool {
    is_slider(reference.kind) && (is_part_of_pattern(view, reference) || has_double(view, reference))
}

fn is_slider(kind: ReferenceKind) -> bool {
    matches!(kind, ReferenceKind::Incr | ReferenceKind::Decr)
}

fn is_part_of_pattern(view: &View<'_>, reference: &Reference<'_>) -> bool {
    let names_it = |pattern: &str| pattern.starts_with(reference.text);
    let mut bases = view.bases.iter().filter(|base| base.name == reference.base);
    bases.any(|base| {
        let mut partners = base.sliders.iter().flat_map(|bound| [&bound.slider.lsym, &bound.slider.rsym]);
        let presets = base.settings().map(|(_, settings)| settings.presets.as_slice()).unwrap_or_default();
        partners.any(|partner| partner.as_deref().is_some_and(names_it))
            || presets.iter().any(|(pattern, _)| names_it(pattern))
    })
}

/// Whether another slider moves the same targets.
fn has_double(view: &View<'_>, reference: &Reference<'_>) -> bool {
    let mut by_slider: BTreeMap<&str, BTreeMap<ReferenceKind, &str>> = BTreeMap::new();
    let of_base = view.references.iter().filter(|other| other.base == reference.base && is_slider(other.kind));
    for other in of_base {
        if let Some(file) = other.meant() {
            by_slider.entry(other.owner).or_default().insert(other.kind, &file.path);
        }
    }
    let own = by_slider.remove(reference.owner);
    own.is_some_and(|own| by_slider.values().any(|other| *other == own))
}

/// A fix that also writes `text` for a name.
pub(super) fn written(fix: Fix, reference: &Reference<'_>, text: Option<String>) -> Fix {
    match &reference.place {
        Place::Pointer(pointer) => fix.step(&reference.from.path, Change::Value { pointer: pointer.clone(), text }),
        // A name that is not written, such as that of a default.
        _ => fix,
    }
}

/// How bad it is if the application finds nothing.
fn level(kind: ReferenceKind) -> Level {
    if matches!(kind, ReferenceKind::Icon | ReferenceKind::Texture) { Level::Warning } else { Level::Error }
}

/// What the application that has such names does if it finds nothing (formats/makehuman2.md §3.6, §4.3, §7, §10, §17;
/// formats/mpfb.md §2.3).
pub(super) fn effect(kind: ReferenceKind) -> &'static str {
    match kind {
        ReferenceKind::MacroTarget | ReferenceKind::Incr | ReferenceKind::Decr => {
            "does not find the target: an exception when its slider moves, or at start if the start character uses it"
        }
        ReferenceKind::Slot | ReferenceKind::SliderName => {
            "does not find the target: an exception when its slider moves"
        }
        ReferenceKind::Icon => "shows a button without a picture",
        ReferenceKind::WeightsFile => "refuses the skeleton",
        ReferenceKind::PoseSkeleton => "has no poses and no bone weights for assets, without a word",
        ReferenceKind::Model => "stops at start with a TypeError",
        ReferenceKind::Texture => "goes without the texture, without a message",
    }
}

/// Whether a reference names its file in another form of accented letters, and not just with other capitals.
pub(super) fn differs_in_form(reference: &Reference<'_>) -> bool {
    matches!(reference.resolution, Resolution::CaseOnly(file) if composed(&reference.rel) == composed(&file.rel))
}

/// Other files of the layer that the name fits as well, but for capitals.
pub(super) fn alike<'r>(view: &'r View<'_>, target: &str) -> Vec<&'r str> {
    let layer = view.layers.strongest_first().find(|layer| layer.file(target).is_some());
    let wanted = fold(target);
    let is_alike = |rel: &&str| *rel != target && fold(rel) == wanted;
    layer.into_iter().flat_map(|layer| layer.files.values().map(|file| file.rel.as_str())).filter(is_alike).collect()
}
