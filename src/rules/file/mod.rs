//! Rules on any file, whatever is in it: whether it can be read at all, its name, its links, its twins.

pub(super) mod absolute_path;
pub(super) mod backslash_path;
pub(super) mod byte_order_mark;
pub(super) mod case_conflict;
pub(super) mod case_mismatch;
pub(super) mod decompression_bomb;
pub(super) mod duplicate_content;
pub(super) mod empty;
pub(super) mod gzip_corrupt;
pub(super) mod in_place_of_folder;
pub(super) mod lfs_pointer;
pub(super) mod link_loop;
pub(super) mod not_utf8;
pub(super) mod path_escape;
pub(super) mod too_large;
pub(super) mod unportable_name;
pub(super) mod unreadable;
pub(super) mod unreferenced;

mod fixed_names;
mod folders;
mod icons;
mod named;
mod spelling;
