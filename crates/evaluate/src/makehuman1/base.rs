//! The body of MakeHuman 1 made ready for settings: mesh, modifiers with their targets, base
//! skeleton with its weights.

use std::collections::{BTreeMap, BTreeSet};

use super::skeleton::skeleton_of;
use super::{OWN, weights};
use crate::data::SkeletonFile;
use crate::files::take_mesh;
use crate::gauge::{Composed, Rig};
use crate::opened::{MacroNames, NO_MESH};
use crate::rows::{Suspects, is_usable};
use crate::{Error, Evaluation, Rows};
use mhlint_diag::Application;
use mhlint_eval::macros::Macros;
use mhlint_eval::makehuman1::Modifiers as Formula;
use mhlint_eval::makehuman1::modifiers::{Factor, TargetGroup};
use mhlint_eval::makehuman1::variables::{FIRST_RACE, Human, SLIDERS, VARIABLES};
use mhlint_eval::measures::Received;
use mhlint_eval::scene::{MorphTarget, Scene, SceneSlider, SliderKind};
use mhlint_eval::settings::Dimension;
use mhlint_formats::modifiers::file::Part;
use mhlint_formats::obj::Mesh;
use mhlint_formats::target::name::TargetName;
use mhlint_repo::makehuman1::{KnownModifier, NamedTarget, View, mesh, shows};
use mhlint_repo::{FileFacts, Layers};
use mhlint_source::Limits;

/// The name of the body, if there is a mesh for it.
pub(crate) fn with_mesh(layers: Layers<'_>) -> BTreeSet<&str> {
    mesh(layers)
        .and_then(|(file, _)| file.base_in(OWN))
        .into_iter()
        .collect()
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
    let composed = compose(&view, &Rows::new()).ok_or_else(|| Error::file(&file.path, NO_MESH))?;
    let rig = view
        .base_rig()
        .and_then(|rig| Some((rig.file, rig.skeleton()?)));
    let no_rig = || "rigs/default.mhskel is missing or cannot be used".to_owned();
    let skeleton = rig.map(|(file, model)| SkeletonFile {
        path: file.path.clone(),
        model: model.clone(),
    });
    let macros = if composed.scene.macros.is_some() {
        Ok(MacroNames::Variables)
    } else {
        Err(NO_MODIFIERS.to_owned())
    };
    Ok(Evaluation {
        application: Application::Makehuman1,
        trees: Vec::new(),
        limits,
        base: name.to_owned(),
        size: mesh.size(),
        keys: Vec::new(),
        macros,
        mesh_path: file.path.clone(),
        skeleton: skeleton.ok_or_else(no_rig),
        weights_fault: None,
        archive: archive(&view),
        groups: Vec::new(),
        scene: composed.scene,
    })
}

/// The name of a target of the scene.
fn name_of(rel: &str) -> &str {
    rel.strip_prefix("targets/").unwrap_or(rel)
}

/// The archive that the program reads in place of texts, with the targets that it takes from it.
fn archive(view: &View<'_>) -> Option<(String, BTreeMap<String, String>)> {
    let (archive, targets) = view.targets.archived()?;
    let named = targets
        .iter()
        .map(|(target, _)| (name_of(&target.rel).to_owned(), target.member().to_owned()));
    Some((archive.file.path.clone(), named.collect()))
}

const NO_MODIFIERS: &str = "`modifiers/` is missing or cannot be used";

/// The scene, with the rows of its targets. `None` without a mesh.
pub(super) fn compose(view: &View<'_>, rows: &Rows) -> Option<Composed> {
    let (_, mesh) = view
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0)?;
    let mut composer = Composer::default();
    take_mesh(&mut composer.scene, mesh, shows);
    composer.modifiers(view);
    composer.custom(view);
    composer.take_rows(mesh, rows);
    let mut scene = composer.scene;
    let rig = view.base_rig();
    scene.skeleton = rig.and_then(|rig| skeleton_of(rig.skeleton()?, &scene).ok());
    let lists = rig.and_then(mhlint_repo::Rig::usable_weights);
    scene.weights = scene
        .skeleton
        .as_ref()
        .zip(lists)
        .and_then(|(bones, (_, own))| weights::bind(bones, own, &scene));
    // What other skeletons take of the weights is theirs to leave out: bones without any are usual
    // (`docs/loaders/makehuman1/weights.md#shipped-weights`).
    let rigs = view.rigs().iter().filter_map(|rig| {
        let skeleton = skeleton_of(rig.skeleton()?, &scene).ok()?;
        Some(Rig {
            path: rig.file.path.clone(),
            skeleton,
            received: Received::default(),
        })
    });
    let rigs = rigs.collect();
    Some(Composed {
        scene,
        rigs,
        is_cut: false,
    })
}

#[derive(Default)]
struct Composer<'a> {
    scene: Scene,
    formula: Formula,
    /// The targets of the scene with their files, and their places by path below the data.
    files: Vec<&'a FileFacts>,
    by_path: BTreeMap<&'a str, usize>,
    /// Numbers of macro targets by place.
    numbers: BTreeMap<usize, u32>,
    /// Names that have a slider already.
    known: BTreeSet<&'a str>,
}

impl<'a> Composer<'a> {
    /// The macro sliders, then all others in the order of the files.
    fn modifiers(&mut self, view: &'a View<'a>) {
        self.scene.most_factor = Some(1.0);
        let human = Human::default();
        self.scene.macro_defaults = (0..SLIDERS.len())
            .map(|slider| human.value(slider))
            .collect();
        let mut groups = BTreeSet::new();
        for one in &view.modifiers.all {
            // A name that is there already stops its file.
            if !self.known.insert(one.name.as_str()) {
                continue;
            }
            match &one.modifier.variable {
                Some(variable) => {
                    let Some(place) = SLIDERS
                        .iter()
                        .position(|own| own.eq_ignore_ascii_case(&variable.name))
                    else {
                        continue;
                    };
                    let default = self
                        .scene
                        .macro_defaults
                        .get(place)
                        .copied()
                        .unwrap_or_default();
                    self.slider(&one.name, SliderKind::Macro(place), default);
                    if groups.insert(one.modifier.group.as_str()) {
                        self.macro_group(view, one);
                    }
                }
                None => self.detail(view, one),
            }
        }
        if view.modifiers.is_there {
            self.scene.macros = Some(Macros::Makehuman1(std::mem::take(&mut self.formula)));
        }
    }

    fn slider(&mut self, name: &str, kind: SliderKind, default: f64) {
        self.scene.sliders.push(SceneSlider {
            pattern: name.to_owned(),
            kind,
            default,
        });
    }

    fn macro_group(&mut self, view: &'a View<'a>, one: &'a KnownModifier<'a>) {
        let targets: Vec<&'a NamedTarget<'a>> = targets(view, one, Part::Macro);
        self.scene.products.push(dimensions(&targets));
        self.group(Factor::One, &targets);
    }

    fn group(&mut self, factor: Factor, targets: &[&'a NamedTarget<'a>]) {
        let targets = targets.iter().map(|target| {
            (
                self.number(target.file, &target.rel),
                variables(&target.name),
            )
        });
        let targets = targets.collect();
        self.formula.groups.push(TargetGroup { factor, targets });
    }

    /// A modifier whose sides have a plain target each, or one with a setting of its own.
    fn detail(&mut self, view: &'a View<'a>, one: &'a KnownModifier<'a>) {
        let of = |part: Part| targets(view, one, part);
        let (left, centre, right, only) = (
            of(Part::Left),
            of(Part::Centre),
            of(Part::Right),
            of(Part::Only),
        );
        let two_sided = one.modifier.tails.sides().is_some();
        let is_plain = |targets: &Vec<&NamedTarget<'a>>| {
            targets.len() < 2 && targets.iter().all(|target| !target.name.is_macro())
        };
        let default = one.modifier.default.unwrap_or(0.0);
        if centre.is_empty() && [&left, &right, &only].into_iter().all(is_plain) {
            let mut first = |targets: &[&'a NamedTarget<'a>]| {
                targets
                    .first()
                    .map(|target| self.target(target.file, &target.rel))
            };
            let decr = first(&left);
            let incr = first(&right).or_else(|| first(&only));
            return self.slider(
                &one.name,
                SliderKind::Detail {
                    incr,
                    decr,
                    two_sided,
                },
                default,
            );
        }
        let place = self.scene.macro_defaults.len();
        self.scene.macro_defaults.push(default);
        self.slider(&one.name, SliderKind::Macro(place), default);
        let sides = [
            Factor::Left(place),
            Factor::Centre(place),
            Factor::Right(place),
            Factor::Only(place),
        ];
        for (factor, targets) in sides.into_iter().zip([left, centre, right, only]) {
            if !targets.is_empty() {
                self.group(factor, &targets);
            }
        }
        let steps: [f64; 3] = [if two_sided { -1.0 } else { 0.0 }, 0.0, 1.0];
        let steps = if two_sided { &steps[..] } else { &steps[1..] };
        self.scene.products.push(vec![Dimension::Steps {
            place,
            steps: steps.into(),
        }]);
    }

    fn custom(&mut self, view: &'a View<'a>) {
        for one in &view.targets.custom {
            if self.known.insert(one.name.as_str()) {
                let incr = Some(self.target(one.file, &one.file.rel));
                self.slider(
                    &one.name,
                    SliderKind::Detail {
                        incr,
                        decr: None,
                        two_sided: false,
                    },
                    0.0,
                );
            }
        }
    }

    /// Place of a target among the scene's. One without a text has the archive for a file.
    fn target(&mut self, file: &'a FileFacts, rel: &'a str) -> usize {
        if let Some(place) = self.by_path.get(rel) {
            return *place;
        }
        let name = name_of(rel).to_owned();
        let place = self.scene.targets.len();
        self.scene.targets.push(MorphTarget {
            name,
            path: file.path.clone(),
            ..MorphTarget::default()
        });
        self.files.push(file);
        self.by_path.insert(rel, place);
        place
    }

    /// Number of a target among those of the formula.
    fn number(&mut self, file: &'a FileFacts, rel: &'a str) -> u32 {
        let place = self.target(file, rel);
        let next = u32::try_from(self.numbers.len()).unwrap_or(u32::MAX);
        let macro_targets = &mut self.scene.macro_targets;
        *self.numbers.entry(place).or_insert_with(|| {
            macro_targets.push(place);
            next
        })
    }

    fn take_rows(&mut self, mesh: &Mesh, rows: &Rows) {
        let (vertices, suspects) = (mesh.positions.len(), Suspects::new(mesh));
        for (target, file) in self.scene.targets.iter_mut().zip(&self.files) {
            let is_whole = file.target().is_some_and(is_usable);
            let own = rows
                .get(&target.path)
                .cloned()
                .filter(|own| own.iter().all(|row| (row.0 as usize) < vertices));
            target.rows = own.filter(|_| is_whole);
            target.suspect = suspects.has(file);
        }
    }
}

/// The targets that a modifier has for a side.
fn targets<'a>(
    view: &'a View<'a>,
    one: &KnownModifier<'_>,
    part: Part,
) -> Vec<&'a NamedTarget<'a>> {
    let places = one
        .parts
        .iter()
        .filter(|own| own.part == part)
        .flat_map(|own| own.targets.iter());
    places.filter_map(|place| view.targets.at(*place)).collect()
}

/// Places of the variables that a target depends on.
pub(super) fn variables(name: &TargetName) -> Vec<u8> {
    let place = |value: &str| {
        VARIABLES
            .iter()
            .position(|own| *own == value)
            .and_then(|place| u8::try_from(place).ok())
    };
    name.categories()
        .filter_map(|(_, value)| place(value))
        .collect()
}

/// The sliders that targets depend on, with their steps.
fn dimensions(targets: &[&NamedTarget<'_>]) -> Vec<Dimension> {
    let categories: BTreeSet<&str> = targets
        .iter()
        .flat_map(|target| target.name.categories())
        .map(|(category, _)| category)
        .collect();
    let of = |category: &&str| {
        if *category == "race" {
            return Some(Dimension::Corners((FIRST_RACE..SLIDERS.len()).collect()));
        }
        let place = SLIDERS
            .iter()
            .position(|own| own.eq_ignore_ascii_case(category))?;
        let steps: &[f64] = match *category {
            "gender" => &[0.0, 1.0],
            "age" => &[0.0, 0.1875, 0.5, 1.0],
            _ => &[0.0, 0.5, 1.0],
        };
        Some(Dimension::Steps {
            place,
            steps: steps.into(),
        })
    };
    categories.iter().filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_formats::target::name::CATEGORIES;

    /// Formulas and names of files have lists of their own.
    #[test]
    fn every_word_of_a_path_has_a_formula() {
        let words: BTreeSet<&str> = CATEGORIES
            .iter()
            .flat_map(|(_, words)| *words)
            .copied()
            .collect();
        assert_eq!(words, VARIABLES.into_iter().collect());
    }
}
