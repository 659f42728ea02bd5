//! The shape keys of a character, by name, and their mix
//! (`docs/loaders/mpfb/targets.md#names-of-keys`, `docs/loaders/mpfb/targets.md#the-mix`).

use std::sync::Arc;

use serde_json::{Value, json};

use crate::outputs::rounded;
use crate::{Error, Evaluation};
use mhlint_eval::mpfb::mix::key_value;
use mhlint_eval::scene::{MorphTarget, Setting};
use mhlint_eval::vector::Point;
use mhlint_source::file_name;

/// Shape keys in the order in which they were made.
#[derive(Default)]
pub(super) struct Keys {
    keys: Vec<Key>,
}

struct Key {
    name: String,
    /// Place among the targets of the scene.
    target: usize,
    value: f64,
    is_macro: bool,
}

impl Keys {
    /// Sets the keys of the macros: those that are no longer needed go.
    pub(super) fn set_macros(&mut self, base: &Evaluation, setting: &Setting) -> Result<(), Error> {
        let factors = base.factors(&Setting {
            macros: Arc::clone(&setting.macros),
            details: [].into(),
        })?;
        self.keys.retain(|key| !key.is_macro);
        for (target, value) in factors {
            let path = base
                .scene
                .targets
                .get(target)
                .map_or("", |target| target.name.as_str());
            let name = format!("macrodetail-{}", file_name(path));
            self.keys.push(Key {
                name,
                target,
                value,
                is_macro: true,
            });
        }
        Ok(())
    }

    /// Adds a key for a target that is named by its file; a further one where there is one of its
    /// name.
    pub(super) fn add(&mut self, base: &mut Evaluation, file: &str, value: f64) {
        let name = file.strip_suffix(".gz").unwrap_or(file);
        let name = name.strip_suffix(".target").unwrap_or(name);
        let target = place(base, name, file);
        let stem = file_name(name);
        let numbered = (1..).map(|number| format!("{stem}.{number:03}"));
        let mut names = std::iter::once(stem.to_owned()).chain(numbered);
        let is_new = |name: &String| self.keys.iter().all(|key| key.name != *name);
        let name = names.find(is_new).unwrap_or_default();
        self.keys.push(Key {
            name,
            target,
            value: key_value(value),
            is_macro: false,
        });
    }

    /// The mesh with all of them, in Blender's axes.
    pub(super) fn mixed(&self, base: &mut Evaluation, scale: f32) -> Result<Vec<Point>, Error> {
        let keys: Vec<(usize, f64)> = self
            .keys
            .iter()
            .map(|key| (key.target, key.value))
            .collect();
        base.with_keys(&keys, scale)
    }

    pub(super) fn json(&self) -> Value {
        self.keys
            .iter()
            .map(|key| json!([key.name, rounded(key.value)]))
            .collect()
    }
}

/// Place of a target of the scene; one that no slider has is added.
fn place(base: &mut Evaluation, name: &str, file: &str) -> usize {
    let known = base
        .scene
        .targets
        .iter()
        .position(|target| target.name == name);
    known.unwrap_or_else(|| {
        let root = base
            .mesh_path
            .strip_suffix("3dobjs/base.obj")
            .unwrap_or_default();
        let path = format!("{root}targets/{file}");
        base.scene.targets.push(MorphTarget {
            name: name.to_owned(),
            path,
            ..MorphTarget::default()
        });
        base.scene.targets.len() - 1
    })
}
