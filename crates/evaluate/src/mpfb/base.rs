//! The body of MPFB made ready for settings: mesh, sliders of the catalogue, macros.

use std::collections::{BTreeMap, BTreeSet};

use super::NO_RIGS;
use crate::files::take_mesh;
use crate::gauge::Composed;
use crate::opened::{MacroNames, NO_MESH};
use crate::rows::{Suspects, is_usable};
use crate::{Error, Evaluation, Rows};
use mhlint_diag::Application;
use mhlint_discover::Kind;
use mhlint_eval::macros::Macros;
use mhlint_eval::mpfb::MacroLoops;
use mhlint_eval::mpfb::loops::{Axis, DEFAULTS, Source, TargetLoop};
use mhlint_eval::mpfb::shares::Part;
use mhlint_eval::scene::{MorphTarget, Scene, SceneSlider, SliderKind};
use mhlint_eval::settings::Dimension;
use mhlint_formats::macro_parts::{MacroParts, RACES, SETTINGS, Setting};
use mhlint_formats::obj::Mesh;
use mhlint_formats::target_catalog::{Category, Section};
use mhlint_repo::mpfb::loops::{self, LOOPS};
use mhlint_repo::mpfb::{Catalog, Parts, View, identifier};
use mhlint_repo::{FileFacts, Layers};
use mhlint_source::Limits;

/// The group of faces that is seen: helpers and joints are masked.
pub(crate) const SHOWN: &str = "body";

/// The name of the body, if there is a mesh for it.
pub(crate) fn with_mesh(layers: Layers<'_>) -> BTreeSet<&str> {
    let own = Application::Mpfb;
    let files = layers
        .system
        .into_iter()
        .flat_map(|layer| layer.files.values());
    let meshes = files.filter(|file| file.kind_in(own) == Kind::BaseMesh && file.mesh().is_some());
    meshes.filter_map(|file| file.base_in(own)).collect()
}

/// Takes what its files hold, but for the rows of its targets.
///
/// # Errors
/// An unusable mesh.
pub(crate) fn open(name: &str, layers: Layers<'_>, limits: Limits) -> Result<Evaluation, Error> {
    let view = View::connect(layers);
    let (file, mesh) = view
        .mesh
        .ok_or_else(|| Error::file("3dobjs/base.obj", NO_MESH))?;
    if let Some(bad) = mesh.facts.unreadable.first() {
        return Err(Error::file(
            &file.path,
            format!("line {}: {} (`{}`)", bad.line, bad.what, bad.text),
        ));
    }
    let mut composer = Composer::default();
    let macros = composer.all(&view, mesh, |_| true);
    Ok(Evaluation {
        application: Application::Mpfb,
        trees: Vec::new(),
        limits,
        base: name.to_owned(),
        size: mesh.size(),
        scene: composer.scene,
        keys: composer.keys,
        macros,
        mesh_path: file.path.clone(),
        skeleton: Err(NO_RIGS.to_owned()),
        weights_fault: None,
        archive: None,
        groups: groups(&view),
    })
}

/// The vertex groups of the base mesh.
fn groups(view: &View<'_>) -> Vec<(String, Vec<(i64, i64)>)> {
    let groups = view.groups.iter().flat_map(|groups| &groups.groups);
    groups
        .map(|group| (group.name.clone(), group.ranges.clone()))
        .collect()
}

/// The scene, with the rows of its targets. `None` without a mesh.
pub(super) fn compose(view: &View<'_>, rows: &Rows) -> Option<Composed> {
    let (_, mesh) = view
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0 && view.misplaced.is_none())?;
    let mut composer = Composer::default();
    let macros = composer.all(view, mesh, |group| group == SHOWN);
    composer.scene.lacks_macros =
        macros.is_err() && view.parts.as_ref().is_some_and(|parts| parts.is_too_large);
    let (files, suspects) = (
        view.layers.system.map(|system| &system.files),
        Suspects::new(mesh),
    );
    let by_path = files
        .into_iter()
        .flat_map(|files| files.values())
        .map(|file| (file.path.as_str(), file));
    let by_path: BTreeMap<&str, &FileFacts> = by_path.collect();
    let vertices = mesh.positions.len();
    for target in &mut composer.scene.targets {
        let Some(file) = by_path.get(target.path.as_str()) else {
            continue;
        };
        let is_whole = file.target().is_some_and(is_usable);
        let own = rows
            .get(&target.path)
            .cloned()
            .filter(|own| own.iter().all(|row| (row.0 as usize) < vertices));
        target.rows = own.filter(|_| is_whole);
        target.suspect = suspects.has(file);
    }
    Some(Composed {
        scene: composer.scene,
        rigs: Vec::new(),
        is_cut: false,
    })
}

#[derive(Default)]
struct Composer {
    scene: Scene,
    keys: Vec<(String, Vec<String>)>,
    /// Places of the targets by path.
    by_path: BTreeMap<String, usize>,
}

impl Composer {
    /// Takes the mesh, the sliders and the macros; gives the names of these, or why there are none.
    fn all(
        &mut self,
        view: &View<'_>,
        mesh: &Mesh,
        is_visible: impl Fn(&str) -> bool,
    ) -> Result<MacroNames, String> {
        take_mesh(&mut self.scene, mesh, is_visible);
        // Shape keys end at 1.
        self.scene.most_factor = Some(1.0);
        view.catalog
            .iter()
            .for_each(|catalog| self.sliders(catalog));
        self.macros(view.parts.as_ref())
    }

    fn sliders(&mut self, catalog: &Catalog<'_>) {
        for section in &catalog.sliders.sections {
            for category in section
                .categories
                .iter()
                .filter(|category| !category.has_full_path)
            {
                for side in category.sides() {
                    let name = format!("{side}{}", category.name);
                    let pattern = format!("{}/{name}", section.name);
                    let kind = self.kind(catalog, section, category, side);
                    self.keys
                        .push((identifier(&section.name, &name), vec![pattern.clone()]));
                    self.scene.sliders.push(SceneSlider {
                        pattern,
                        kind,
                        default: 0.0,
                    });
                }
            }
        }
    }

    fn kind(
        &mut self,
        catalog: &Catalog<'_>,
        section: &Section,
        category: &Category,
        side: &str,
    ) -> SliderKind {
        if category.slots.is_none() {
            let stem = format!("{side}{}", category.name);
            let file = catalog.target(&section.name, &stem);
            let incr = Some(self.target(format!("{}/{stem}", section.name), file));
            return SliderKind::Detail {
                incr,
                decr: None,
                two_sided: false,
            };
        }
        let side = match side {
            "l-" => "left",
            "r-" => "right",
            _ => "unsided",
        };
        let mut slot = |sign: &str| {
            let key = format!("{sign}-{side}");
            // A slot without a name asks for a file without a stem.
            let found = category.slots.iter().flatten().find(|slot| slot.key == key);
            let stem = found.map_or("", |slot| slot.stem.as_str());
            let file = catalog.layer.file(&format!(
                "{}/{stem}.target.gz",
                catalog.folder(&section.name)
            ));
            Some(self.target(format!("{}/{stem}", section.name), file))
        };
        SliderKind::Detail {
            incr: slot("positive"),
            decr: slot("negative"),
            two_sided: true,
        }
    }

    /// Place of a target among the scene's.
    fn target(&mut self, name: String, file: Option<&FileFacts>) -> usize {
        let path = file.map_or_else(|| name.clone(), |file| file.path.clone());
        let scene = &mut self.scene;
        *self.by_path.entry(path.clone()).or_insert_with(|| {
            scene.targets.push(MorphTarget {
                name,
                path,
                ..MorphTarget::default()
            });
            scene.targets.len() - 1
        })
    }

    fn macros(&mut self, parts: Option<&Parts<'_>>) -> Result<MacroNames, String> {
        let parts = parts.ok_or_else(|| "macro.json is missing or cannot be used".to_owned())?;
        if parts.is_too_large {
            return Err(format!(
                "`{}` has too many combinations to evaluate",
                parts.file.path
            ));
        }
        if !parts.settings.is_whole() {
            return Err(format!(
                "`{}` lacks a setting, or a part of one cannot be used",
                parts.file.path
            ));
        }
        let settings = SETTINGS.iter().map(|name| (*name, DEFAULTS.0));
        for (name, default) in settings.chain(RACES.iter().map(|name| (*name, DEFAULTS.1))) {
            let place = self.scene.macro_defaults.len();
            self.scene.macro_defaults.push(default);
            let kind = SliderKind::Macro(place);
            self.scene.sliders.push(SceneSlider {
                pattern: name.to_owned(),
                kind,
                default,
            });
        }
        self.scene.products = dimensions(parts.settings);
        let names: Vec<Vec<String>> = parts.settings.settings.iter().map(names).collect();
        let numbered = parts.settings.settings.iter().zip(&names);
        let settings = numbered
            .map(|(setting, names)| eval_parts(setting, names))
            .collect();
        let loops = (0..LOOPS.len())
            .map(|number| self.target_loop(parts, &names, number))
            .collect();
        self.scene.macros = Some(Macros::Mpfb(MacroLoops {
            settings,
            races: RACES.len(),
            loops,
        }));
        Ok(MacroNames::Parts(names))
    }

    fn target_loop(
        &mut self,
        parts: &Parts<'_>,
        names: &[Vec<String>],
        number: usize,
    ) -> TargetLoop {
        let Some(own) = LOOPS.get(number) else {
            return TargetLoop::default();
        };
        let place = |setting: usize, name: &str| {
            let known = names
                .get(setting)
                .and_then(|names| names.iter().position(|own| own == name));
            known
                .and_then(|place| u32::try_from(place).ok())
                .unwrap_or(u32::MAX)
        };
        let lists = own.names(parts.settings);
        let source = |axis: &loops::Axis| match axis {
            loops::Axis::Race => Source::Races,
            loops::Axis::Setting(setting) => Source::Setting(*setting),
            loops::Axis::Only(setting, name) => Source::Only(*setting, place(*setting, name)),
        };
        let taken = |at: &usize| {
            let (axis, list) = (own.axes.get(*at)?, lists.get(*at)?);
            Some(Axis {
                of: source(axis),
                names: list.len(),
            })
        };
        let axes: Vec<Axis> = own.order.iter().filter_map(taken).collect();
        let mut targets = vec![None; lists.iter().map(Vec::len).product()];
        for request in parts
            .requests
            .iter()
            .filter(|request| request.number == number)
        {
            let names = own.order.iter().filter_map(|at| request.names.get(*at));
            let index = axes
                .iter()
                .zip(names)
                .fold(0, |index, (axis, name)| index * axis.names + name);
            if let Some(slot) = targets.get_mut(index) {
                *slot = u32::try_from(self.scene.macro_targets.len()).ok();
                let place = self.target(request.target.clone(), request.file);
                self.scene.macro_targets.push(place);
            }
        }
        TargetLoop { axes, targets }
    }
}

/// What the settings are looked at alone by: the ends of the ranges of their parts, and the races.
fn dimensions(settings: &MacroParts) -> Vec<Vec<Dimension>> {
    let of_setting = |(place, setting): (usize, &Setting)| {
        let ends = setting
            .parts
            .iter()
            .flat_map(|part| [part.lowest, part.highest]);
        let mut steps: Vec<f64> = ends
            .map(|end| end.clamp(0.0, 1.0))
            .chain([0.0, 1.0])
            .collect();
        steps.sort_by(f64::total_cmp);
        steps.dedup_by(|one, other| (*one - *other).abs() < APART);
        vec![Dimension::Steps {
            place,
            steps: steps.into(),
        }]
    };
    let first = settings.settings.len();
    let races = vec![Dimension::Corners((first..first + RACES.len()).collect())];
    settings
        .settings
        .iter()
        .enumerate()
        .map(of_setting)
        .chain([races])
        .collect()
}

/// Ends of ranges that are nearer are looked at once.
const APART: f64 = 0.01;

/// The names of a setting, numbered.
fn names(setting: &Setting) -> Vec<String> {
    loops::names(setting)
        .iter()
        .map(|name| name.text.to_owned())
        .collect()
}

fn eval_parts(setting: &Setting, names: &[String]) -> Vec<Part> {
    let number = |name: &Option<String>| {
        let place = names.iter().position(|own| Some(own) == name.as_ref())?;
        u32::try_from(place).ok()
    };
    let part = |part: &mhlint_formats::macro_parts::Part| Part {
        lowest: part.lowest,
        highest: part.highest,
        low: number(&part.low),
        high: number(&part.high),
    };
    setting.parts.iter().map(part).collect()
}
