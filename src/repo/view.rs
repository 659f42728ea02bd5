//! The data of one application as it sees them.

use super::{Body, Layers, References, makehuman1, makehuman2, mpfb};
use crate::diag::Application;

/// Layers that were connected as an application does it.
#[derive(Debug)]
pub(crate) enum View<'a> {
    /// `MakeHuman` 2.
    Makehuman2(Box<makehuman2::View<'a>>),
    /// `MakeHuman` 1.
    Makehuman1(makehuman1::View<'a>),
    /// MPFB.
    Mpfb(mpfb::View<'a>),
}

impl<'a> View<'a> {
    /// Connects layers.
    pub(crate) fn connect(application: Application, layers: Layers<'a>) -> Self {
        match application {
            Application::Makehuman2 => Self::Makehuman2(Box::new(makehuman2::View::connect(layers))),
            Application::Makehuman1 => Self::Makehuman1(makehuman1::View::connect(layers)),
            Application::Mpfb => Self::Mpfb(mpfb::View::connect(layers)),
        }
    }

    /// Whose view it is.
    pub(crate) const fn application(&self) -> Application {
        match self {
            Self::Makehuman2(_) => Application::Makehuman2,
            Self::Makehuman1(_) => Application::Makehuman1,
            Self::Mpfb(_) => Application::Mpfb,
        }
    }

    /// Its layers.
    pub(crate) const fn layers(&self) -> Layers<'a> {
        match self {
            Self::Makehuman2(view) => view.layers,
            Self::Makehuman1(view) => view.layers,
            Self::Mpfb(view) => view.layers,
        }
    }

    /// Everything that names a file, and what it leads to.
    pub(crate) const fn references(&self) -> &References<'a> {
        match self {
            Self::Makehuman2(view) => &view.references,
            Self::Makehuman1(view) => &view.references,
            Self::Mpfb(view) => &view.references,
        }
    }

    /// Its bodies.
    pub(crate) fn bodies(&self) -> Vec<Body<'_>> {
        match self {
            Self::Makehuman2(view) => view.bodies(self),
            Self::Mpfb(view) => view.body(self).into_iter().collect(),
            Self::Makehuman1(_) => Vec::new(),
        }
    }

    /// The names of its bodies.
    pub(crate) fn body_names(&self) -> Vec<&'a str> {
        match self {
            Self::Makehuman2(view) => view.bases.iter().map(|base| base.name).collect(),
            Self::Mpfb(view) => view.body_name().into_iter().collect(),
            Self::Makehuman1(_) => Vec::new(),
        }
    }

    /// As a view of `MakeHuman` 2.
    pub(crate) fn makehuman2(&self) -> Option<&makehuman2::View<'a>> {
        if let Self::Makehuman2(view) = self { Some(view) } else { None }
    }
}
