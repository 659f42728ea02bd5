//! Where bytes come from: a tree of files on disk or in memory behind one type.
//!
//! The only reader of assets. Gives listings, bytes, unpacked bytes and lines; knows no format and
//! writes nothing. Everything read is bounded, because assets come from strangers.

#![expect(clippy::disallowed_methods, reason = "the only reader of assets")]

mod folder;
mod gunzip;
mod limits;
mod lines;
mod place;
mod text;
mod tree;
mod walk;
mod zip_size;

pub use folder::{Folder, holds, is_below};
pub use gunzip::{GzipFault, gunzip, try_gunzip};
pub use limits::Limits;
pub use lines::{Lines, Position};
pub use place::{canonical, folder_of, link_targets, resolved, slashed};
pub use text::Encoding;
pub use tree::{Entry, EntryKind, ReadFault, Tree, WalkFault, WalkFaultKind, read_file};
pub use walk::Wanted;
pub use zip_size::zip_bomb;
