//! Everything in a repository that names a file, and what the application would find there.

use super::{Base, BoundSlider, FileFacts, Layer, Repository, TargetFolder};
use crate::diag::Place;
use crate::formats::macro_json::{MacroFile, without_suffix};

/// A name of a file in a file.
#[derive(Debug)]
pub struct Reference<'a> {
    /// What names it.
    pub kind: ReferenceKind,
    /// Base mesh it is for.
    pub base: &'a str,
    /// File in which the name stands.
    pub from: &'a FileFacts,
    /// Place of the name.
    pub place: Place,
    /// The name as written.
    pub text: &'a str,
    /// What the name belongs to: a combination, a slider, a skeleton.
    pub owner: &'a str,
    /// Place and text of the folder that is put in front, where that is at fault and not the name.
    pub folder_at_fault: Option<(Place, &'a str)>,
    /// Path relative to the data root that the application would open.
    pub rel: String,
    /// What is there.
    pub resolution: Resolution<'a>,
}

/// What names a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ReferenceKind {
    /// `t` in `macro.json`.
    MacroTarget,
    /// `incr` in `modelling.json`.
    Incr,
    /// `decr` in `modelling.json`.
    Decr,
    /// `icon` in `modelling.json`.
    Icon,
    /// `weights_file` in a skeleton (or its default).
    WeightsFile,
    /// `pose-skeleton` in `base.json`.
    PoseSkeleton,
    /// `mhm` in `base.json`.
    Model,
}

/// What a reference leads to.
#[derive(Debug, Clone, Copy)]
pub enum Resolution<'a> {
    /// The file; the archive for a target that only the archive holds.
    Found(&'a FileFacts),
    /// A file whose path differs in case only, or in the form of its accented letters.
    CaseOnly(&'a FileFacts),
    /// A file that only a system which takes `\` for a separator finds.
    Backslash(Option<&'a FileFacts>),
    /// Begins with `/` or a drive letter.
    Absolute,
    /// Leaves the data root.
    Escapes,
    /// Nothing in the folder in use, but the file exists in the layer that lost.
    OtherLayer(&'a FileFacts),
    /// Something that cannot be opened: a folder, a broken link, a link that leaves the root.
    Unusable,
    /// Nothing.
    Missing,
    /// Only system data that was not given could tell.
    NeedsSystem,
}

impl ReferenceKind {
    /// Whether it is a morph target.
    pub const fn is_target(self) -> bool {
        matches!(self, Self::MacroTarget | Self::Incr | Self::Decr)
    }
}

impl<'a> Resolution<'a> {
    /// The file that is meant, also where the name is not quite right: that has a finding of its own.
    pub fn meant(self) -> Option<&'a FileFacts> {
        match self {
            Self::Found(file) | Self::CaseOnly(file) | Self::Backslash(Some(file)) => Some(file),
            _ => None,
        }
    }
}

impl<'a> Reference<'a> {
    /// As [`Resolution::meant`].
    pub fn meant(&self) -> Option<&'a FileFacts> {
        self.resolution.meant()
    }
}

/// All references of a base.
pub(super) fn collect<'a>(repository: &Repository<'a>, base: &Base<'a>) -> Vec<Reference<'a>> {
    let mut references = Vec::new();
    macro_references(base, &mut references);
    for slider in &base.sliders {
        slider_references(base, slider, &mut references);
    }
    skeleton_references(repository, base, &mut references);
    base_references(repository, base, &mut references);
    references
}

fn macro_references<'a>(base: &Base<'a>, out: &mut Vec<Reference<'a>>) {
    let Some((from, file)) = base.macro_file() else { return };
    for macrodef in &file.macrodefs {
        let folder = macrodef.effective_folder.as_deref();
        for link in &macrodef.links {
            // An empty name is a finding of its own, not a missing file.
            let Some(text) = link.target.as_deref().filter(|text| !text.is_empty()) else { continue };
            let name = folder.map_or_else(|| text.to_owned(), |folder| format!("{folder}/{text}"));
            let (rel, resolution) = resolve_macro_target(base, &name);
            // Behind a folder the beginning of the name would be hidden.
            let resolution = if is_absolute(text) { Resolution::Absolute } else { resolution };
            let folder_at_fault = folder.filter(|folder| is_fault_of_folder(folder, text, &resolution));
            let folder_at = Place::pointer(["macrodef", &folder_owner(file, macrodef.index).to_string(), "folder"]);
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

/// A suffix too much is a finding of its own; what else is wrong with such a name is not hidden by it.
fn resolve_macro_target<'a>(base: &Base<'a>, name: &str) -> (String, Resolution<'a>) {
    let (rel, resolution) = resolve_target(base, base.targets, name);
    let stem = without_suffix(name);
    if stem.len() == name.len() || !matches!(resolution, Resolution::Missing | Resolution::Backslash(None)) {
        return (rel, resolution);
    }
    match resolve_target(base, base.targets, stem) {
        found @ (_, Resolution::CaseOnly(_) | Resolution::Backslash(Some(_))) => found,
        _ => (rel, resolution),
    }
}

/// Whether the folder alone makes the whole name absolute, or brings the backslash, the way out or the other
/// capitals into it.
fn is_fault_of_folder(folder: &str, text: &str, resolution: &Resolution<'_>) -> bool {
    match resolution {
        Resolution::Absolute => !is_absolute(text),
        Resolution::Backslash(_) => !text.contains('\\'),
        Resolution::Escapes => folder.contains("..") && !text.contains(".."),
        Resolution::CaseOnly(file) => {
            let found = file.rel.strip_suffix(".target").and_then(|stem| stem.strip_suffix(text));
            found.is_some_and(|found| !found.trim_end_matches('/').ends_with(folder.trim_matches('/')))
        }
        _ => false,
    }
}

/// The definition whose `folder` is in use for one: itself, or the last before it that has any.
fn folder_owner(file: &MacroFile, index: usize) -> usize {
    let owner = file.macrodefs.iter().take(index + 1).rev().find(|macrodef| macrodef.folder.is_some());
    owner.map_or(index, |macrodef| macrodef.index)
}

fn slider_references<'a>(base: &Base<'a>, bound: &BoundSlider<'a>, out: &mut Vec<Reference<'a>>) {
    let slider = bound.slider;
    let folder = base.folder_of(bound);
    let named = [
        (ReferenceKind::Incr, "incr", slider.incr.as_deref()),
        (ReferenceKind::Decr, "decr", slider.decr.as_deref()),
        (ReferenceKind::Icon, "icon", slider.icon.as_deref()),
    ];
    for (kind, member, text) in named {
        let Some(text) = text else { continue };
        let (rel, resolution) = if kind == ReferenceKind::Icon {
            resolve_icon(base, folder, text)
        } else {
            resolve_target(base, folder, text)
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

fn resolve_target<'a>(base: &Base<'a>, folder: Option<TargetFolder<'a>>, name: &str) -> (String, Resolution<'a>) {
    let Some(folder) = folder else {
        return (format!("{name}.target"), Resolution::NeedsSystem);
    };
    let rel = format!("{}/{name}.target", folder.rel());
    let found = resolve(&[folder.layer], name, &rel);
    if !matches!(found, Resolution::Missing) {
        return (rel, found);
    }
    // The archive is asked by the name as written (formats/makehuman2.md §6.2).
    let archive = folder.archive().filter(|file| file.archive().is_some_and(|archive| archive.member(name).is_some()));
    let other = || base.other_targets.and_then(|other| other.target(name)).map(Resolution::OtherLayer);
    (rel, archive.map(Resolution::Found).or_else(other).unwrap_or(found))
}

fn resolve_icon<'a>(base: &Base<'a>, folder: Option<TargetFolder<'a>>, name: &str) -> (String, Resolution<'a>) {
    let Some(folder) = folder else {
        return (format!("icons/{name}"), Resolution::NeedsSystem);
    };
    let rel = format!("{}/icons/{name}", folder.rel());
    let other = base.other_targets.and_then(|other| other.layer.file(&format!("{}/icons/{name}", other.rel())));
    match (resolve(&[folder.layer], name, &rel), other) {
        (Resolution::Missing, Some(file)) => (rel, Resolution::OtherLayer(file)),
        (found, _) => (rel, found),
    }
}

/// Weights are searched as `rigs/<base>/<weights_file>`, never beside the skeleton.
fn skeleton_references<'a>(repository: &Repository<'a>, base: &Base<'a>, out: &mut Vec<Reference<'a>>) {
    for from in &base.skeletons {
        // Anything but a text is refused by the schema; what it would lead to is not known.
        let Some(skeleton) = from.skeleton().filter(|skeleton| !skeleton.weights_file_misshapen) else { continue };
        let text = skeleton.weights_file.as_deref().unwrap_or("default_weights.mhw");
        out.push(Reference {
            kind: ReferenceKind::WeightsFile,
            base: base.name,
            from,
            place: match skeleton.weights_file {
                Some(_) => Place::pointer(["weights_file"]),
                None => Place::File,
            },
            text,
            owner: from.stem(),
            folder_at_fault: None,
            rel: format!("rigs/{}/{text}", base.name),
            resolution: resolve_layered(repository, base, text, &format!("rigs/{}/{text}", base.name)),
        });
    }
}

fn base_references<'a>(repository: &Repository<'a>, base: &Base<'a>, out: &mut Vec<Reference<'a>>) {
    let Some((from, settings)) = base.settings() else { return };
    let named = [
        (ReferenceKind::PoseSkeleton, "pose-skeleton", "rigs", settings.pose_skeleton.as_deref()),
        (ReferenceKind::Model, "mhm", "base", settings.mhm.as_deref()),
    ];
    for (kind, member, folder, text) in named {
        let Some(text) = text else { continue };
        let rel = format!("{folder}/{}/{text}", base.name);
        out.push(Reference {
            kind,
            base: base.name,
            from,
            place: Place::pointer([member]),
            text,
            owner: member,
            folder_at_fault: None,
            resolution: resolve_layered(repository, base, text, &rel),
            rel,
        });
    }
}

fn resolve_layered<'a>(repository: &Repository<'a>, base: &Base<'a>, text: &str, rel: &str) -> Resolution<'a> {
    let layers: Vec<&Layer> = repository.strongest_first().collect();
    match resolve(&layers, text, rel) {
        Resolution::Missing if !base.has_system => Resolution::NeedsSystem,
        found => found,
    }
}

fn is_absolute(text: &str) -> bool {
    text.starts_with(['/', '\\']) || text.get(1..2) == Some(":")
}

fn resolve<'a>(layers: &[&'a Layer], text: &str, rel: &str) -> Resolution<'a> {
    if is_absolute(text) {
        return Resolution::Absolute;
    }
    let Some(normal) = normalized(rel) else {
        return Resolution::Escapes;
    };
    if let Some(file) = layers.iter().find_map(|layer| layer.file(&normal)) {
        return Resolution::Found(file);
    }
    if layers.iter().any(|layer| layer.has_unusable(&normal)) {
        return Resolution::Unusable;
    }
    if text.contains('\\') {
        let Some(slashed) = normalized(&rel.replace('\\', "/")) else {
            return Resolution::Escapes;
        };
        let exact = layers.iter().find_map(|layer| layer.file(&slashed));
        // Where `\` separates folders, capitals make no difference either.
        let found = exact.or_else(|| layers.iter().find_map(|layer| layer.file_ignoring_case(&slashed)));
        return Resolution::Backslash(found);
    }
    match layers.iter().find_map(|layer| layer.file_ignoring_case(&normal)) {
        Some(file) => Resolution::CaseOnly(file),
        None => Resolution::Missing,
    }
}

/// The path without `.` and `..`, or nothing if it leaves the root.
fn normalized(rel: &str) -> Option<String> {
    let mut parts: Vec<&str> = Vec::new();
    for part in rel.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop()?;
            }
            other => parts.push(other),
        }
    }
    Some(parts.join("/"))
}

impl<'a> Base<'a> {
    /// What a target would be found by this name, which is written without suffix, in the folder in use.
    pub fn target_named(&self, name: &str) -> Resolution<'a> {
        resolve_target(self, self.targets, name).1
    }
}

impl<'a> Repository<'a> {
    /// Connects the layers. `judged` must be one of them.
    pub fn connect(
        application: crate::diag::Application,
        system: Option<&'a Layer>,
        user: Option<&'a Layer>,
        judged: &'a Layer,
    ) -> Self {
        let mut repository = Self { application, system, user, judged, bases: Vec::new(), references: Vec::new() };
        let layers = super::base::Layers::new(system, user);
        let names = super::base::base_names(layers);
        let bases: Vec<Base<'a>> = names.into_iter().map(|name| super::base::resolve(name, layers)).collect();
        repository.references = bases.iter().flat_map(|base| collect(&repository, base)).collect();
        repository.bases = bases;
        repository
    }

    /// References of a base.
    pub fn references_of<'s>(&'s self, base: &'s Base<'a>) -> impl Iterator<Item = &'s Reference<'a>> {
        self.references.iter().filter(|reference| reference.base == base.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_normalized_inside_the_root_only() {
        assert_eq!(normalized("target/b/a/../c.target").as_deref(), Some("target/b/c.target"));
        assert_eq!(normalized("target/../../x"), None);
    }
}
