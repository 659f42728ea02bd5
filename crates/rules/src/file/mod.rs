//! Rules on any file, whatever is in it: whether it can be read at all, its name, its links, its
//! twins.

mod absolute_path;
mod backslash_path;
mod byte_order_mark;
mod case_conflict;
mod case_mismatch;
mod decompression_bomb;
mod duplicate_content;
mod empty;
mod gzip_corrupt;
mod in_place_of_folder;
mod lfs_pointer;
mod link_loop;
mod merge_conflict;
mod not_utf8;
mod path_escape;
mod too_large;
mod unportable_name;
mod unreadable;
mod unreferenced;

mod fixed_names;
mod folders;
mod icons;
mod named;
mod references;
mod spelling;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &absolute_path::RULE,
    &backslash_path::RULE,
    &byte_order_mark::RULE,
    &case_conflict::RULE,
    &case_mismatch::RULE,
    &decompression_bomb::RULE,
    &duplicate_content::RULE,
    &empty::RULE,
    &gzip_corrupt::RULE,
    &in_place_of_folder::RULE,
    &lfs_pointer::RULE,
    &link_loop::RULE,
    &merge_conflict::RULE,
    &not_utf8::RULE,
    &path_escape::RULE,
    &too_large::RULE,
    &unportable_name::RULE,
    &unreadable::RULE,
    &unreferenced::RULE,
];
