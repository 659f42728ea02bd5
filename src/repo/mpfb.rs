//! The data of MPFB. Nothing in them is connected yet.

use super::{Layers, References};

/// The layers of MPFB.
#[derive(Debug)]
pub struct View<'a> {
    /// System and user data.
    pub layers: Layers<'a>,
    /// What names a file.
    pub references: References<'a>,
}

impl<'a> View<'a> {
    /// Connects layers.
    pub fn connect(layers: Layers<'a>) -> Self {
        Self { layers, references: References::default() }
    }
}
