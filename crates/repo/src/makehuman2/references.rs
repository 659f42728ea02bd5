//! Everything in MakeHuman 2's data that names a file, and what the application would find there.

use super::{Base, BoundSlider, TargetFolder};
use crate::path::{is_absolute, resolve, shortened};
use crate::{Reference, ReferenceKind, Resolution};
use mhlint_diag::Place;
use mhlint_formats::macro_json::without_suffix;

/// All references of a base.
pub(super) fn collect<'a>(base: &Base<'a>) -> Vec<Reference<'a>> {
    let mut references = Vec::new();
    macro_references(base, &mut references);
    for slider in &base.sliders {
        slider_references(base, slider, &mut references);
    }
    references.extend(base.rigs.iter().filter_map(|rig| rig.weights.clone()));
    references.extend(base.named.iter().cloned());
    references
}

fn macro_references<'a>(base: &Base<'a>, out: &mut Vec<Reference<'a>>) {
    let Some((from, file)) = base.macro_file() else {
        return;
    };
    // The last definition with a `folder`: it is in use for those behind it that have none.
    let mut owner = None;
    for macrodef in &file.macrodefs {
        owner = if macrodef.folder.is_some() {
            Some(macrodef.index)
        } else {
            owner
        };
        let folder = macrodef.effective_folder.as_deref();
        for link in &macrodef.links {
            // An empty name is a finding of its own, not a missing file.
            let Some(text) = link.target.as_deref().filter(|text| !text.is_empty()) else {
                continue;
            };
            let name = folder.map_or_else(
                || text.to_owned(),
                |folder| format!("{}/{}", shortened(folder), shortened(text)),
            );
            let (rel, resolution) = resolve_macro_target(base, &name);
            // Behind a folder the beginning of the name would be hidden.
            let resolution = if is_absolute(text) {
                Resolution::Absolute
            } else {
                resolution
            };
            let folder_at_fault =
                folder.filter(|folder| is_fault_of_folder(folder, text, &resolution));
            let folder_at = Place::pointer([
                "macrodef",
                &owner.unwrap_or(macrodef.index).to_string(),
                "folder",
            ]);
            out.push(Reference {
                kind: ReferenceKind::MacroTarget,
                base: base.name,
                from,
                place: Place::Pointer(macrodef.link_pointer(link, "t")),
                text,
                owner: &link.name,
                folder_at_fault: folder_at_fault.map(|folder| (folder_at, folder)),
                rel,
                resolution,
            });
        }
    }
}

/// A suffix too much is a finding of its own; what else is wrong with such a name is not hidden by
/// it.
fn resolve_macro_target<'a>(base: &Base<'a>, name: &str) -> (String, Resolution<'a>) {
    let (rel, resolution) = resolve_target(base, base.targets, name);
    let stem = without_suffix(name);
    if stem.len() == name.len()
        || !matches!(
            resolution,
            Resolution::Missing | Resolution::Backslash(None)
        )
    {
        return (rel, resolution);
    }
    match resolve_target(base, base.targets, stem) {
        found @ (_, Resolution::CaseOnly(_) | Resolution::Backslash(Some(_))) => found,
        _ => (rel, resolution),
    }
}

/// Whether the folder alone makes the whole name absolute, or brings the backslash, the way out or
/// the other capitals into it.
fn is_fault_of_folder(folder: &str, text: &str, resolution: &Resolution<'_>) -> bool {
    match resolution {
        Resolution::Absolute => !is_absolute(text),
        Resolution::Backslash(_) => !text.contains('\\'),
        Resolution::Escapes => folder.contains("..") && !text.contains(".."),
        Resolution::CaseOnly(file) => {
            let found = file
                .rel
                .strip_suffix(".target")
                .and_then(|stem| stem.strip_suffix(text));
            found.is_some_and(|found| {
                !found
                    .trim_end_matches('/')
                    .ends_with(folder.trim_matches('/'))
            })
        }
        _ => false,
    }
}

fn slider_references<'a>(base: &Base<'a>, bound: &BoundSlider<'a>, out: &mut Vec<Reference<'a>>) {
    let slider = bound.slider;
    let folder = base.folder_of(bound);
    let marked = base.is_marked_as_users(bound);
    let named = [
        (ReferenceKind::Incr, "incr", slider.incr.as_deref()),
        (ReferenceKind::Decr, "decr", slider.decr.as_deref()),
        (ReferenceKind::Icon, "icon", slider.icon.as_deref()),
    ];
    for (kind, member, text) in named {
        let Some(text) = text else { continue };
        let (rel, resolution) = match kind {
            // The picture is missing with the target, which is told.
            ReferenceKind::Icon if marked => resolve_icon(base, base.targets, text),
            ReferenceKind::Icon => resolve_icon(base, folder, text),
            _ if marked => resolve_marked(base, text),
            _ => resolve_target(base, folder, text),
        };
        out.push(Reference {
            kind,
            base: base.name,
            from: bound.file,
            place: Place::pointer([&slider.key, member]),
            text,
            owner: &slider.key,
            folder_at_fault: None,
            rel,
            resolution,
        });
    }
}

fn resolve_target<'a>(
    base: &Base<'a>,
    folder: Option<TargetFolder<'a>>,
    name: &str,
) -> (String, Resolution<'a>) {
    let Some(folder) = folder else {
        return (format!("{name}.target"), Resolution::NeedsSystem);
    };
    let rel = format!("{}/{name}.target", folder.rel());
    let found = resolve(&[folder.layer], name, &rel);
    if !matches!(found, Resolution::Missing) {
        return (rel, found);
    }
    // The archive is asked by the name as written
    // (`docs/loaders/makehuman2/targets.md#the-archive`).
    let archive = folder.archive().filter(|file| {
        file.archive()
            .is_some_and(|archive| archive.member(name).is_some())
    });
    let other = || {
        base.other_targets
            .and_then(|other| other.target(name))
            .map(Resolution::OtherLayer)
    };
    (
        rel,
        archive
            .map(Resolution::Found)
            .or_else(other)
            .unwrap_or(found),
    )
}

/// A target of the system's slider that is looked for in the user's folder. What a user has there
/// nobody else has.
fn resolve_marked<'a>(base: &Base<'a>, name: &str) -> (String, Resolution<'a>) {
    match base
        .user_targets
        .filter(|folder| folder.target(name).is_some())
    {
        Some(folder) => resolve_target(base, Some(folder), name),
        None => (
            format!("target/{}/{name}.target", base.name),
            Resolution::Missing,
        ),
    }
}

fn resolve_icon<'a>(
    base: &Base<'a>,
    folder: Option<TargetFolder<'a>>,
    name: &str,
) -> (String, Resolution<'a>) {
    let Some(folder) = folder else {
        return (format!("icons/{name}"), Resolution::NeedsSystem);
    };
    let rel = format!("{}/icons/{name}", folder.rel());
    let other = base
        .other_targets
        .and_then(|other| other.layer.file(&format!("{}/icons/{name}", other.rel())));
    match (resolve(&[folder.layer], name, &rel), other) {
        (Resolution::Missing, Some(file)) => (rel, Resolution::OtherLayer(file)),
        (found, _) => (rel, found),
    }
}

impl<'a> Base<'a> {
    /// What a target would be found by this name, which is written without suffix, in the folder in
    /// use.
    pub fn target_named(&self, name: &str) -> Resolution<'a> {
        resolve_target(self, self.targets, name).1
    }
}
