//! What is where: data roots in a listing, kinds of files, layers. Looks at paths only, opens nothing.

mod kind;
mod roots;

pub use kind::{Kind, kind_of};
pub use roots::{DataRoot, SCANNED, find_roots, root_above};
