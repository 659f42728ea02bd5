//! What makes a folder of assets a library: what is listed, and by what it is known.

mod custom_targets;
pub(crate) mod duplicate_name;
pub(crate) mod header_not_ascii;
pub(crate) mod identity_clash;
pub(crate) mod linked_folder;
mod makehuman1;
mod makehuman2;
pub(crate) mod missing_thumbnail;
mod mpfb;
pub(crate) mod name_cut;
pub(crate) mod old_format;
mod old_words;
pub(crate) mod scan_crash;
pub(crate) mod shelves;
pub(crate) mod side_by_side;
pub(crate) mod too_deep;
pub(crate) mod unreadable_thumbnail;
pub(crate) mod wrong_folder;

use std::collections::BTreeSet;

use super::{Rule, counted, enumerated};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place,
};
use mhlint_discover::extension;
use mhlint_repo::{FileFacts, Layer};
use mhlint_source::{first_name, parent};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &duplicate_name::RULE,
    &duplicate_name::OF_UUID,
    &duplicate_name::OF_WORN,
    &header_not_ascii::RULE,
    &identity_clash::RULE,
    &linked_folder::RULE,
    &missing_thumbnail::RULE,
    &name_cut::RULE,
    &old_format::RULE,
    &scan_crash::RULE,
    &too_deep::RULE,
    &unreadable_thumbnail::RULE,
    &wrong_folder::RULE,
];

/// Suffixes of assets that lists show.
const SUFFIXES: [&str; 6] = ["mhclo", "proxy", "mhskel", "mhpose", "bvh", "mhm"];

/// The suffix of an asset, in small letters, if the name has one.
fn suffix(rel: &str) -> Option<&'static str> {
    let own = extension(rel);
    SUFFIXES
        .into_iter()
        .find(|suffix| suffix.eq_ignore_ascii_case(own))
}

/// What is wrong with a file, or with several of a folder in the same way: then it is one finding,
/// with a message of its own.
fn of_folder(
    layer: &Layer,
    folder: &str,
    files: &[&FileFacts],
    one: Finding,
    message: String,
) -> Finding {
    if files.len() < 2 {
        return one;
    }
    let key = format!("{} {folder}", one.subject.key);
    let many = Finding { message, ..one }
        .key(key)
        .asset(layer.display(folder));
    let many = many.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
    many.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())))
}

/// Whether a file lies where a program writes what others are to read: no list shows it.
fn is_exported(file: &FileFacts) -> bool {
    file.is_loose && file.folder().split('/').any(|part| part == "exports")
}

/// How many assets lack a picture, with the first of them. Loose files have no folder of a library,
/// and may lie in several.
fn unpictured(count: &str, library: &str, first: &FileFacts, name: &str) -> String {
    if first.is_loose {
        return format!("{count} have no picture, first `{}`", first.shown());
    }
    format!("{count} in `{library}` have no picture, first `{name}`")
}

const ASIDE: Case = &[
    (Makehuman2, Level::Info, LISTS_NONE),
    (Makehuman1, Level::Info, LISTS_NONE),
    (Mpfb, Level::Info, LISTS_NONE),
];
const LISTS_NONE: &str = "does not list what is there";

/// What lies beside the libraries of a pack, in folders that are not read.
fn aside(rule: &Rule, files: &[&FileFacts]) -> Option<Finding> {
    let mut folders: Vec<String> = files
        .iter()
        .map(|file| format!("`{}`", top(file)))
        .collect();
    folders.dedup();
    let word = if folders.len() > 1 {
        "folders"
    } else {
        "folder"
    };
    let message = format!(
        "{} in {word} {}, beside those that are read",
        counted(files.len(), "asset"),
        enumerated(&folders)
    );
    let finding = rule
        .at(files.first()?, Place::File, message)
        .key("aside")
        .case(ASIDE);
    let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
    let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())));
    let are_targets = files.iter().all(|file| extension(&file.rel) == "target");
    let example = if are_targets { "custom" } else { "clothes" };
    let help = format!(
        "move them to the folder of their kind, such as `{example}`, if they belong to the pack"
    );
    Some(finding.help(help))
}

/// Files by name and content, so that copies of them are known.
struct Contents<'f>(BTreeSet<(&'f str, u64)>);

impl<'f> Contents<'f> {
    fn of(files: impl Iterator<Item = &'f FileFacts>) -> Self {
        Self(
            files
                .filter_map(|file| Some((file.file_name(), file.content_hash?)))
                .collect(),
        )
    }

    fn has(&self, file: &FileFacts) -> bool {
        file.content_hash
            .is_some_and(|hash| self.0.contains(&(file.file_name(), hash)))
    }
}

/// By what files are sorted that have something in common: the copy, with a longer or a hidden
/// name, comes last.
fn as_copy(file: &FileFacts) -> (bool, usize, &str) {
    (
        file.file_name().starts_with('.'),
        file.shown().len(),
        file.shown(),
    )
}

/// The first folder of a path.
fn top(file: &FileFacts) -> &str {
    first_name(&file.rel)
}

/// Folders with the suffixes of the assets that lie directly in them.
type Homes<'l> = BTreeSet<(&'l str, &'l str)>;

fn homes(layer: &Layer) -> Homes<'_> {
    let all = layer
        .files
        .values()
        .map(|file| (parent(&file.rel), extension(&file.rel)));
    all.filter(|(_, suffix)| SUFFIXES.contains(suffix))
        .collect()
}
