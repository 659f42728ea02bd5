//! The layers of `MakeHuman` 1.

use crate::repo::{Layers, References};

/// The layers of `MakeHuman` 1.
#[derive(Debug)]
pub(crate) struct View<'a> {
    /// System and user data.
    pub layers: Layers<'a>,
    /// What names a file.
    pub references: References<'a>,
}

impl<'a> View<'a> {
    /// Connects layers.
    pub(crate) fn connect(layers: Layers<'a>) -> Self {
        Self { layers, references: References::default() }
    }
}
