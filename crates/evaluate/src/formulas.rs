//! Whose formulas evaluate what: the one place that asks for an application.
//!
//! To evaluate another one: a folder beside `makehuman2`, and an arm wherever the compiler asks for
//! one.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde_json::{Map, Value};

use super::cases::Kind;
use super::data::{RestSkeleton, SkeletonFile};
use super::gauge::gauge;
use super::{Error, Evaluation, Rows, Setting, SliderSetting, makehuman1, makehuman2, mpfb};
use mhlint_config::Config;
use mhlint_diag::Application;
use mhlint_eval::measures::Measures;
use mhlint_eval::vector::Point;
use mhlint_eval::weights::BoneWeights;
use mhlint_repo::Layers;
use mhlint_repo::makehuman2::Base;
use mhlint_source::Limits;

/// A body of layers that can be opened.
#[derive(Clone, Copy)]
pub struct Openable<'a> {
    pub name: &'a str,
    pub layers: Layers<'a>,
    application: Application,
}

/// Measures a body as an application shows it; `rows` are those of its targets, and may be those of
/// others, too. `None` for an application that is not evaluated, and without a mesh that vertices
/// can be counted on.
///
/// Takes layers, not a view: their targets are not all read yet.
pub fn measure(
    application: Application,
    layers: Layers<'_>,
    name: &str,
    rows: &Rows,
    options: &Config,
) -> Option<Measures> {
    match application {
        Application::Makehuman2 => {
            let base = Base::resolve(name, layers);
            let mut composed = makehuman2::compose::compose(&base, rows)?;
            let own = makehuman2::worn::own(&base, layers);
            let fitted = makehuman2::worn::fit(&base, &own);
            let bones = composed
                .scene
                .skeleton
                .iter()
                .flat_map(|skeleton| skeleton.names.iter().enumerate().rev());
            let bones: BTreeMap<&str, usize> = bones
                .map(|(number, name)| (name.as_str(), number))
                .collect();
            composed.scene.worn = fitted.iter().map(|one| one.on_scene(&bones)).collect();
            let worn = || makehuman2::worn::measure(&base, &fitted);
            let (measures, worn) = rayon::join(|| gauge(&composed, options), worn);
            Some(Measures { worn, ..measures })
        }
        Application::Makehuman1 => Some(makehuman1::measure(layers, rows, options)),
        Application::Mpfb => mpfb::measure(layers, rows, options),
    }
}

/// The bodies that can be opened in layers as an application sees them.
pub fn openable(application: Application, layers: Layers<'_>) -> Vec<Openable<'_>> {
    let names = match application {
        Application::Makehuman2 => makehuman2::base::with_mesh(layers),
        Application::Makehuman1 => makehuman1::base::with_mesh(layers),
        Application::Mpfb => mpfb::base::with_mesh(layers),
    };
    names
        .into_iter()
        .map(|name| Openable {
            name,
            layers,
            application,
        })
        .collect()
}

impl Openable<'_> {
    /// Whether it has a macro system.
    pub fn has_macros(&self) -> bool {
        match self.application {
            Application::Makehuman2 => Base::resolve(self.name, self.layers).macro_file().is_some(),
            Application::Makehuman1 | Application::Mpfb => true,
        }
    }

    /// Takes what its files hold, but for the rows of its targets.
    ///
    /// # Errors
    /// An unusable mesh.
    pub fn open(&self, limits: Limits) -> Result<Evaluation, Error> {
        match self.application {
            Application::Makehuman2 => {
                makehuman2::base::open(&Base::resolve(self.name, self.layers), limits)
            }
            Application::Makehuman1 => makehuman1::base::open(self.name, self.layers, limits),
            Application::Mpfb => mpfb::base::open(self.name, self.layers, limits),
        }
    }
}

impl Evaluation {
    /// The place of the slider that a saved character means by a name which no slider has, and the
    /// sign of its value.
    pub(super) fn slider_of_character(&self, name: &str) -> Option<(usize, f64)> {
        match self.application {
            Application::Makehuman2 | Application::Makehuman1 => None,
            Application::Mpfb => mpfb::names::slider(&self.scene, name),
        }
    }

    /// Whether a vertex of several rows moves by all of them, and one that the mesh lacks is passed
    /// over.
    pub(super) const fn adds_rows(&self) -> bool {
        matches!(self.application, Application::Mpfb)
    }

    /// The weights that a pose moves the mesh by.
    ///
    /// # Errors
    /// Weights of vertices beyond the mesh.
    pub(super) fn posing_weights<'w>(
        &self,
        weights: &'w [BoneWeights],
        vertices: usize,
    ) -> Result<Cow<'w, [BoneWeights]>, Error> {
        match self.application {
            Application::Makehuman1 => {
                makehuman1::posing_weights(weights, vertices).map(Cow::Owned)
            }
            Application::Makehuman2 | Application::Mpfb => Ok(Cow::Borrowed(weights)),
        }
    }

    /// The macros at a setting, as JSON.
    ///
    /// # Errors
    /// No macros, or macros that stop the application.
    pub fn macros_json(&self, setting: &Setting) -> Result<Map<String, Value>, Error> {
        match self.application {
            Application::Makehuman2 => {
                let (table, result) = self.macros(setting)?;
                Ok(makehuman2::macros_json(self, table, &result))
            }
            Application::Makehuman1 => makehuman1::macros::macros_json(self, setting),
            Application::Mpfb => mpfb::macros::macros_json(self, setting),
        }
    }

    /// What modifiers do to their targets at a setting, as JSON: these one by one, then the weights
    /// of all targets.
    ///
    /// # Errors
    /// Data of another application than `MakeHuman` 1; an unknown modifier.
    pub fn modifiers_json(
        &self,
        setting: &Setting,
        asked: &[SliderSetting],
    ) -> Result<Map<String, Value>, Error> {
        match self.application {
            Application::Makehuman1 => makehuman1::modifiers::modifiers_json(self, setting, asked),
            Application::Makehuman2 | Application::Mpfb => {
                let name = self.application.title();
                Err(Error::Input(format!(
                    "modifiers are those of MakeHuman 1; for {name} use `mhlint eval macros`"
                )))
            }
        }
    }

    /// Joints and rest matrices of a skeleton on a mesh.
    ///
    /// # Errors
    /// A skeleton that the application refuses for this mesh.
    pub fn rest(
        &self,
        skeleton: &SkeletonFile,
        positions: &[Point],
    ) -> Result<RestSkeleton, Error> {
        match self.application {
            Application::Makehuman2 => makehuman2::skeleton::rest(skeleton, positions),
            Application::Makehuman1 => makehuman1::skeleton::rest(&self.scene, skeleton, positions),
            Application::Mpfb => Err(mpfb::no_rigs(self.base())),
        }
    }
}

/// Every kind of case, of all applications.
pub(super) fn kinds() -> impl Iterator<Item = &'static Kind> {
    makehuman2::cases::KINDS
        .iter()
        .chain(&makehuman1::cases::KINDS)
        .chain(&mpfb::cases::KINDS)
}
