//! The lists of MPFB: what is in them, and by which label
//! (`docs/loaders/mpfb/libraries.md#sections`, `docs/loaders/mpfb/libraries.md#labels`).

use std::collections::BTreeSet;

use super::super::cause::outdated::is_outdated;
use super::super::{Rule, counted};
use super::{as_copy, mpfb, of_folder};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, grouped};
use mhlint_discover::extension;
use mhlint_repo::mpfb::{View, uuid};
use mhlint_repo::{FileFacts, Layer};

/// Folders with a list, and the suffix of what is in it.
const SHELVES: [(&str, &str); 9] = [
    ("clothes", "mhclo"),
    ("hair", "mhclo"),
    ("eyes", "mhclo"),
    ("eyebrows", "mhclo"),
    ("eyelashes", "mhclo"),
    ("teeth", "mhclo"),
    ("tongue", "mhclo"),
    ("proxymeshes", "proxy"),
    ("skins", "mhmat"),
];

/// The folder that a file is listed in.
fn shelf(file: &FileFacts) -> Option<&'static str> {
    let (folder, suffix) = shelf_around(file)?;
    (extension(&file.rel) == suffix).then_some(folder)
}

fn shelf_around(file: &FileFacts) -> Option<(&'static str, &'static str)> {
    let (top, _) = file.rel.split_once('/')?;
    SHELVES.into_iter().find(|(folder, _)| *folder == top)
}

/// Whether files that end in `suffix` are listed where a file lies.
pub(super) fn lists(file: &FileFacts, suffix: &str) -> bool {
    shelf_around(file).is_some_and(|(_, listed)| listed == suffix)
}

/// What the list shows in place of the file name.
pub(super) fn label(file: &FileFacts) -> String {
    file.stem().to_lowercase().replace('_', " ")
}

/// What is listed of a layer; links to folders are not followed.
pub(super) fn listed(layer: &Layer) -> impl Iterator<Item = (&'static str, &FileFacts)> {
    let files = layer
        .files
        .values()
        .filter(|file| !layer.is_behind_link(&file.rel) && !file.is_loose);
    files.filter_map(|file| Some((shelf(file)?, file)))
}

const COPY: Case = &[(Mpfb, Level::Warning, "lists one of the copies alone")];

/// Assets of one list with the same label.
pub(crate) fn same_labels(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let labelled = listed(view.layers.checked).map(|(folder, file)| ((folder, label(file)), file));
    for ((folder, label), mut files) in grouped(labelled) {
        files.sort_by_key(|file| as_copy(file));
        let [first, .., last] = files.as_slice() else {
            continue;
        };
        let more = if files.len() > 2 {
            format!(" and {} more", files.len() - 2)
        } else {
            String::new()
        };
        let message = format!(
            "has the label `{label}` in the list of `{folder}`, like `{}`{more}",
            first.rel
        );
        let finding = rule
            .at(last, Place::File, message)
            .key(format!("{folder} {label}"));
        let finding = finding.related(first.path.clone(), Place::File, "the other asset");
        let finding = finding.between(files.iter().map(|file| file.path.as_str()));
        let is_copy =
            |file: &&&FileFacts| (file.size, file.content_hash) == (first.size, first.content_hash);
        let are_copies = files.iter().all(|file| is_copy(&file));
        let finding = finding
            .help("rename one of the files: capitals and `_` for a space make no difference");
        out.push(if are_copies {
            finding.case(COPY)
        } else {
            finding
        });
    }
}

/// Assets of the system that one of the user hides.
pub(crate) fn hidden(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let Some(system) = view.layers.system.filter(|_| !view.layers.checks_system()) else {
        return;
    };
    let shipped = grouped(listed(system).map(|(folder, file)| ((folder, label(file)), file)));
    for (folder, file) in listed(view.layers.checked) {
        let Some(other) = shipped
            .get(&(folder, label(file)))
            .and_then(|files| files.first())
        else {
            continue;
        };
        let message = format!("replaces the system's `{}` in the list", other.rel);
        let finding = rule.at(file, Place::File, message).key(&file.rel);
        let finding = finding.related(other.path.clone(), Place::File, "the replaced asset");
        out.push(finding.help("rename it if both are to be listed"));
    }
}

/// Assets with one uuid.
pub(super) fn same_uuids(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let own = view
        .worn_anywhere()
        .filter(|worn| view.layers.is_checked(worn.file));
    for (uuid, mut assets) in grouped(own.filter_map(|worn| Some((uuid(worn)?, worn.file)))) {
        assets.sort_by_key(|file| as_copy(file));
        let [first, .., last] = assets.as_slice() else {
            continue;
        };
        // Of copies with one label one is listed, which is reported for the label.
        let of_copy = |file: &FileFacts| (file.size, file.content_hash, label(file));
        if assets.iter().all(|file| of_copy(file) == of_copy(first)) {
            continue;
        }
        let more = match assets.len() {
            2 => String::new(),
            count => format!(" and {}", counted(count - 2, "more file")),
        };
        let message = format!("has the same uuid as `{}`{more}: `{uuid}`", first.shown());
        let finding = rule.at(last, Place::File, message).key(uuid);
        let finding = finding.related(first.path.clone(), Place::File, "the other asset");
        let finding = finding.between(assets.iter().map(|file| file.path.as_str()));
        out.push(finding.help("give the newer of the two a uuid of its own"));
    }
}

/// Assets with the suffix of the list, in capitals.
pub(super) fn in_capitals(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let files = view
        .layers
        .checked
        .files
        .values()
        .filter(|file| !file.is_loose);
    let shelved = files.filter_map(|file| Some((file, shelf_around(file)?.1)));
    let in_capitals = shelved.filter(|(file, suffix)| mpfb::is_in_capitals(file, suffix));
    out.extend(in_capitals.map(|(file, suffix)| mpfb::capitals(rule, file, suffix)));
}

/// Topologies in the list of worn assets, and the other way around.
pub(super) fn of_other_kind(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let files = layer
        .files
        .values()
        .filter(|file| !file.is_loose && !is_outdated(file));
    let shelved =
        files.filter_map(|file| Some(((shelf_around(file)?, extension(&file.rel)), file)));
    for (((folder, suffix), own), files) in grouped(shelved) {
        let help = match (own, suffix) {
            ("proxy", "mhclo") => {
                "move it to `proxymeshes` if it stands for the body; rename it to end in `.mhclo` \
                    if it is worn"
            }
            ("mhclo", "proxy") => {
                "move it to the folder of its kind; rename it to end in `.proxy` if it stands for \
                    the body"
            }
            _ => continue,
        };
        let Some(first) = files.first() else { continue };
        let message = format!("a `.{own}` in `{folder}` is not listed");
        let finding = rule
            .at(first, Place::File, message)
            .key("suffix")
            .help(help);
        let message = format!("{} `.{own}` in `{folder}` are not listed", files.len());
        out.push(of_folder(layer, folder, &files, finding, message));
    }
}

/// What is listed without a picture.
pub(super) fn without_pictures(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let all: Vec<(&str, &FileFacts)> = listed(layer).collect();
    let mut seen = BTreeSet::new();
    let bare = all.into_iter().filter(|(folder, file)| {
        if is_outdated(file) {
            return false;
        }
        let stem = file
            .rel
            .rsplit_once('.')
            .map_or(&*file.rel, |(stem, _)| stem);
        // Of one label one has a picture.
        seen.insert((*folder, label(file))) && layer.file(&format!("{stem}.thumb")).is_none()
    });
    for (folder, files) in grouped(bare) {
        let Some(first) = files.first() else { continue };
        let message = match files.len() {
            1 => format!("`{}` has no picture", first.file_name()),
            count => {
                format!(
                    "{} in `{folder}` have no picture, first `{}`",
                    counted(count, "asset"),
                    first.file_name()
                )
            }
        };
        let finding = rule.at(first, Place::File, message).key(folder);
        let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
        let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())));
        out.push(finding.help(
            "add a PNG of at most 256 by 256 pixels, with the name of the asset and \
                the suffix `.thumb`",
        ));
    }
}
