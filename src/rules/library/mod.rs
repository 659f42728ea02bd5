//! What makes a folder of assets a library: what is listed, and by what it is known.

pub(in crate::rules) mod duplicate_name;
pub(in crate::rules) mod header_not_ascii;
pub(in crate::rules) mod identity_clash;
pub(in crate::rules) mod linked_folder;
mod makehuman1;
mod makehuman2;
pub(in crate::rules) mod missing_thumbnail;
mod mpfb;
pub(in crate::rules) mod name_cut;
pub(in crate::rules) mod old_format;
mod old_words;
pub(in crate::rules) mod scan_crash;
pub(in crate::rules) mod shelves;
pub(in crate::rules) mod too_deep;
pub(in crate::rules) mod unreadable_thumbnail;
pub(in crate::rules) mod wrong_folder;

use super::Rule;
use crate::diag::{Evidence, Finding};
use crate::discover::extension;
use crate::repo::{FileFacts, Layer};

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
    SUFFIXES.into_iter().find(|suffix| suffix.eq_ignore_ascii_case(own))
}

/// What is wrong with a file, or with several of a folder in the same way: then it is one finding, with a message of its
/// own.
fn of_folder(layer: &Layer, folder: &str, files: &[&FileFacts], one: Finding, message: String) -> Finding {
    if files.len() < 2 {
        return one;
    }
    let key = format!("{} {folder}", one.subject.key);
    let many = Finding { message, ..one }.key(key).asset(layer.display(folder));
    let many = many.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
    many.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())))
}
