//! The data of `MakeHuman` 1. Nothing in them is connected yet.

mod view;

pub(crate) use view::View;
