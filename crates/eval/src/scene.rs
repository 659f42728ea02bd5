//! Everything of one base mesh that evaluation needs, as plain arrays, and a setting of its
//! sliders.
//!
//! Filled by the caller from files that could be read; what could not is absent here. Source of the
//! order of application: MakeHuman 2, morph evaluation
//! (`docs/loaders/makehuman2/targets.md#evaluation`).

use std::collections::BTreeMap;
use std::sync::Arc;

use super::error::EvalError;
use super::faces::Faces;
use super::fit::Reference;
use super::macros::{MacroFault, MacroWork, Macros};
use super::morph::{Side, apply, detail_factor};
use super::settings::Dimension;
use super::skeleton::SceneSkeleton;
use super::vector::{Point, Vec3};
use super::weights::{BoneWeights, LoadedWeights};

/// A base mesh with its targets, sliders, skeleton and weights.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// Vertices of the base mesh, without seam duplicates, in mesh units.
    pub positions: Vec<Point>,
    /// Vertices of all faces, one after the other.
    pub corners: Vec<u32>,
    /// Where each face begins in `corners`, and one entry for the end.
    pub face_starts: Vec<u32>,
    /// Number of the group of each face.
    pub face_groups: Vec<u32>,
    /// Names of the groups.
    pub groups: Vec<String>,
    /// Whether a group is drawn.
    pub visible: Vec<bool>,
    /// Targets that some slider or macro uses.
    pub targets: Vec<MorphTarget>,
    /// Sliders in the order in which the application applies them.
    pub sliders: Vec<SceneSlider>,
    /// The macros; `None` without a macro system.
    pub macros: Option<Macros>,
    /// What the factors of detail sliders are limited to, if to anything.
    pub most_factor: Option<f64>,
    /// Whether there is a macro system with more in it than is evaluated.
    pub lacks_macros: bool,
    /// For each target number of the macros its place in `targets`.
    pub macro_targets: Vec<usize>,
    /// Macro settings after a reset.
    pub macro_defaults: Vec<f64>,
    /// Macro sliders that work together: of each macrodef those of its components, in order of its
    /// `comp`.
    pub products: Vec<Vec<Dimension>>,
    /// The pose skeleton.
    pub skeleton: Option<SceneSkeleton>,
    /// Weights of the pose skeleton, bones numbered as in `skeleton`; bones the skeleton lacks are
    /// left out.
    pub weights: Option<LoadedWeights>,
    /// What is worn.
    pub worn: Vec<WornAsset>,
}

/// An asset that is worn, as it was put on.
#[derive(Debug, Clone, Default)]
pub struct WornAsset {
    /// Where it came from, for messages of the caller.
    pub path: String,
    /// A row for each of its vertices.
    pub references: Vec<Reference>,
    /// What offsets are multiplied by; `None` for 1.
    pub scales: Option<Vec3>,
    /// Bone weights of its own, with where they came from.
    pub weights: Option<(String, Vec<BoneWeights>)>,
}

/// A morph target.
#[derive(Debug, Clone, Default)]
pub struct MorphTarget {
    /// Path below the target folder without suffix.
    pub name: String,
    /// Where it came from, for messages of the caller.
    pub path: String,
    /// Vertex and displacement; `None` if there is no such file or it cannot be used.
    pub rows: Option<Arc<Vec<(u32, Point)>>>,
    /// Reported for its own rows already (not finite, out of proportion): looked past when settings
    /// are surveyed.
    pub suspect: bool,
}

/// A slider as a model file sets it.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneSlider {
    /// Its pattern.
    pub pattern: String,
    /// What it moves.
    pub kind: SliderKind,
    /// Value after a reset.
    pub default: f64,
}

/// What a slider moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SliderKind {
    /// A number of the macro settings.
    Macro(usize),
    /// Targets of its sides, places in [`Scene::targets`].
    Detail {
        /// For positive values.
        incr: Option<usize>,
        /// For negative values.
        decr: Option<usize>,
        /// Whether the window offers negative values.
        two_sided: bool,
    },
}

/// Positions of all sliders.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Macro settings; shared by all settings that move detail sliders only.
    pub macros: Arc<Vec<f64>>,
    /// Values of the detail sliders that are not at 0, by their number: a setting moves few of
    /// many.
    pub details: BTreeMap<usize, f64>,
}

/// Why a setting cannot be evaluated.
#[derive(Debug, Clone, PartialEq)]
pub enum SettingError {
    /// A target with a factor has no usable file; the application stops.
    Unusable {
        /// Place in [`Scene::targets`].
        target: usize,
    },
    /// The macros stop the application.
    Macro(MacroFault),
    /// A target moves a vertex the mesh does not have.
    Morph(EvalError),
}

impl Setting {
    /// Puts a number of the macro settings to a value.
    pub(super) fn put(&mut self, place: usize, value: f64) {
        if let Some(slot) = Arc::make_mut(&mut self.macros).get_mut(place) {
            *slot = value;
        }
    }
}

impl Scene {
    /// All sliders as a reset leaves them.
    pub fn defaults(&self) -> Setting {
        let details = self
            .sliders
            .iter()
            .enumerate()
            .filter_map(|(number, slider)| match slider.kind {
                SliderKind::Detail { .. } if slider.default != 0.0 => {
                    Some((number, slider.default))
                }
                _ => None,
            });
        Setting {
            macros: Arc::new(self.macro_defaults.clone()),
            details: details.collect(),
        }
    }

    /// The slider registered under a pattern; of several the last.
    pub fn slider(&self, pattern: &str) -> Option<usize> {
        self.sliders
            .iter()
            .rposition(|slider| slider.pattern == pattern)
    }

    /// Puts a slider to a value, as a model file does: not clamped.
    pub fn set(&self, setting: &mut Setting, slider: usize, value: f64) {
        match self.sliders.get(slider).map(|slider| slider.kind) {
            Some(SliderKind::Macro(place)) => setting.put(place, value),
            Some(SliderKind::Detail { .. }) => {
                setting.details.remove(&slider);
                setting
                    .details
                    .extend((value != 0.0).then_some((slider, value)));
            }
            None => {}
        }
    }

    /// Value of a slider.
    pub fn value(&self, setting: &Setting, slider: usize) -> Option<f64> {
        match self.sliders.get(slider)?.kind {
            SliderKind::Macro(place) => setting.macros.get(place).copied(),
            SliderKind::Detail { .. } => {
                Some(setting.details.get(&slider).copied().unwrap_or_default())
            }
        }
    }

    /// The targets of a setting with their factors, in the order of application: details, then
    /// macros.
    ///
    /// # Errors
    /// Where the macros stop the application.
    pub fn factors(
        &self,
        setting: &Setting,
        work: &mut MacroWork,
    ) -> Result<Vec<(usize, f64)>, SettingError> {
        let mut factors: Vec<(usize, f64)> = self.detail_factors(setting).collect();
        factors.extend(self.macro_factors(setting, work)?);
        Ok(factors)
    }

    /// The targets of the detail sliders of a setting.
    pub(super) fn detail_factors(&self, setting: &Setting) -> impl Iterator<Item = (usize, f64)> {
        setting.details.iter().filter_map(|(number, value)| {
            let SliderKind::Detail { incr, decr, .. } = self.sliders.get(*number)?.kind else {
                return None;
            };
            let (side, factor) = detail_factor(*value)?;
            let target = if side == Side::Incr { incr } else { decr };
            // NaN stays.
            let limited = self
                .most_factor
                .filter(|most| factor > *most)
                .unwrap_or(factor);
            target.map(|target| (target, limited))
        })
    }

    /// The targets of the macros of a setting.
    pub(super) fn macro_factors(
        &self,
        setting: &Setting,
        work: &mut MacroWork,
    ) -> Result<Vec<(usize, f64)>, SettingError> {
        let Some(macros) = &self.macros else {
            return Ok(Vec::new());
        };
        let factors = macros
            .factors(&setting.macros, work)
            .map_err(SettingError::Macro)?;
        let place = |(number, factor): &(u32, f64)| {
            Some((*self.macro_targets.get(*number as usize)?, *factor))
        };
        Ok(factors.iter().filter_map(place).collect())
    }

    /// Adds targets with their factors to positions.
    ///
    /// # Errors
    /// A target without usable file, or one that moves a vertex outside the mesh.
    pub fn add(
        &self,
        positions: &mut [Point],
        factors: &[(usize, f64)],
    ) -> Result<(), SettingError> {
        for (target, factor) in factors {
            let rows = self
                .targets
                .get(*target)
                .and_then(|found| found.rows.as_ref());
            let rows = rows.ok_or(SettingError::Unusable { target: *target })?;
            apply(positions, rows.iter().copied(), *factor).map_err(SettingError::Morph)?;
        }
        Ok(())
    }

    /// The mesh at a setting.
    ///
    /// # Errors
    /// As [`Scene::factors`] and [`Scene::add`].
    pub fn morphed(&self, setting: &Setting) -> Result<Vec<Point>, SettingError> {
        let factors = self.factors(setting, &mut MacroWork::default())?;
        let mut positions = self.positions.clone();
        self.add(&mut positions, &factors)?;
        Ok(positions)
    }

    /// Number of faces.
    pub fn face_count(&self) -> usize {
        self.all_faces().count()
    }

    /// Vertices of a face.
    pub fn face(&self, face: usize) -> &[u32] {
        self.all_faces().face(face)
    }

    /// All faces in order.
    pub fn faces(&self) -> impl Iterator<Item = &[u32]> + Clone {
        self.all_faces().all()
    }

    fn all_faces(&self) -> Faces<'_> {
        Faces {
            corners: &self.corners,
            starts: &self.face_starts,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        let target = |name: &str, x: f32| MorphTarget {
            name: name.to_owned(),
            rows: Some(Arc::new(vec![(0, [x, 0.0, 0.0])])),
            ..MorphTarget::default()
        };
        let kind = SliderKind::Detail {
            incr: Some(0),
            decr: Some(1),
            two_sided: true,
        };
        Scene {
            positions: vec![[0.0; 3], [1.0; 3]],
            targets: vec![
                target("a-incr", 1.0),
                target("a-decr", -2.0),
                MorphTarget::default(),
            ],
            sliders: vec![
                SceneSlider {
                    pattern: "a-decr|incr".to_owned(),
                    kind,
                    default: 0.0,
                },
                SceneSlider {
                    pattern: "b".to_owned(),
                    kind: SliderKind::Detail {
                        incr: Some(2),
                        decr: None,
                        two_sided: false,
                    },
                    default: 0.0,
                },
            ],
            ..Scene::default()
        }
    }

    #[test]
    fn negative_values_use_the_other_target_with_the_absolute_value() {
        let scene = scene();
        let mut setting = scene.defaults();
        scene.set(&mut setting, scene.slider("a-decr|incr").unwrap(), -0.5);
        assert_eq!(
            scene.morphed(&setting).unwrap(),
            [[-1.0, 0.0, 0.0], [1.0; 3]]
        );
    }

    #[test]
    fn an_unusable_target_stops_only_settings_that_need_it() {
        let scene = scene();
        let mut setting = scene.defaults();
        assert!(scene.morphed(&setting).is_ok());
        scene.set(&mut setting, 1, 0.1);
        assert_eq!(
            scene.morphed(&setting),
            Err(SettingError::Unusable { target: 2 })
        );
        scene.set(&mut setting, 1, -0.1);
        assert!(scene.morphed(&setting).is_ok());
    }
}
