//! The data of `MakeHuman` 1 as it sees them. Connected so far: its libraries, which are what is worn with its materials
//! and weights, skins, and poses.

mod library;
mod surfaces;
mod view;

pub(crate) use library::Asset;
pub(in crate::repo) use view::target;
pub(crate) use view::{HIDDEN, View, is_of_library, mesh, shows, worn};
