//! The data of `MakeHuman` 1 as it sees them. Connected so far: rigs with their weights, and what is worn.

mod view;

pub(crate) use view::View;
pub(in crate::repo) use view::target;
