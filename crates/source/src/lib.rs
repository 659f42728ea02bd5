//! Where bytes come from: a tree of files on disk or in memory behind one type.
//!
//! The only reader of assets. Gives listings, bytes, unpacked bytes and lines; knows no format and
//! writes nothing. Everything read is bounded, because assets come from strangers.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]
#![expect(clippy::disallowed_methods, reason = "the only reader of assets")]

mod folder;
mod gunzip;
mod limits;
mod lines;
mod listing;
mod pack;
mod path;
mod place;
mod read;
mod text;
mod tree;
mod walk;
mod zip_size;

pub use limits::Limits;
pub use text::Encoding;
pub use text::{BYTE_ORDER_MARK, Guess};
pub use tree::Tree;

pub use folder::{Folder, Outer, holds};
pub use gunzip::{GzipFault, gunzip, gunzip_at_most};
#[cfg(any(test, feature = "counted"))]
pub use lines::PASSED;
pub use lines::{Lines, first_line, lines};
pub use pack::{MemberFault, PackFacts, PackFault};
pub use path::{
    depth, extension, file_name, first_name, folder_and_name, folders_above, has_hidden_part,
    inside, is_below, is_below_any, normalized, parent, without_extension, without_slashes,
};
pub use place::{canonical, folder_name, folder_of, link_targets, own_place, resolved, slashed};
pub use read::read_file;
pub use tree::{Contents, Entry, EntryKind, ReadFault, WalkFault, WalkFaultKind};
pub use walk::JOURNAL;
pub use zip_size::zip_bomb;
