//! What is where: data roots in a listing, kinds of files, layers. Looks at paths only, opens nothing.

mod kind;
mod loose;
mod roots;

pub use kind::{Kind, is_read_though_hidden, kind_of};
pub use loose::loose_place;
pub use roots::{DataRoot, SCANNED, find_roots, root_above};
