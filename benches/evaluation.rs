//! The pure evaluation: `cargo bench --bench evaluation`.
//!
//! On the figure of the example repository; with `MHLINT_CORPORA` set, on hm08 of MakeHuman 2 as
//! well. Each beside its floor: a copy of the vertices it works on.
#![allow(clippy::unwrap_used, reason = "a benchmark may stop where it fails")]

use std::path::PathBuf;
use std::sync::LazyLock;

use divan::Bencher;
use mhlint::eval::macros::MacroWork;
use mhlint::eval::scene::Scene;
use mhlint::eval::skin::{pose_bones, skin};

fn main() {
    divan::main();
}

struct Loaded {
    name: &'static str,
    scene: Scene,
}

/// Scenes with the rows of the targets that the default character needs.
static SCENES: LazyLock<Vec<Loaded>> = LazyLock::new(|| {
    let example = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fixtures/makehuman2/data");
    let mut places = vec![("figure", example)];
    if let Some(corpora) = std::env::var_os("MHLINT_CORPORA") {
        places.push(("hm08", PathBuf::from(corpora).join("makehuman2/data")));
    }
    let load = |(name, root): (&'static str, PathBuf)| {
        let mut evaluation = mhlint::open_base(&root, None, Some(name)).unwrap();
        let defaults = evaluation.scene().defaults();
        evaluation.morphed(&defaults).unwrap();
        Loaded {
            name,
            scene: evaluation.scene().clone(),
        }
    };
    places.into_iter().map(load).collect()
});

fn names() -> Vec<&'static str> {
    SCENES.iter().map(|loaded| loaded.name).collect()
}

fn scene(name: &str) -> &'static Scene {
    &SCENES
        .iter()
        .find(|loaded| loaded.name == name)
        .unwrap()
        .scene
}

#[divan::bench(args = names())]
fn macro_setting(bencher: Bencher<'_, '_>, name: &str) {
    let scene = scene(name);
    let macros = scene.macros.as_ref().unwrap();
    let mut work = MacroWork::default();
    bencher.bench_local(|| macros.factors(&scene.macro_defaults, &mut work).is_ok());
}

#[divan::bench(args = names())]
fn morph_defaults(bencher: Bencher<'_, '_>, name: &str) {
    let scene = scene(name);
    bencher.bench_local(|| scene.morphed(&scene.defaults()).unwrap());
}

#[divan::bench(args = names())]
fn skin_rest(bencher: Bencher<'_, '_>, name: &str) {
    let scene = scene(name);
    let skeleton = scene.skeleton.as_ref().unwrap();
    let joints = skeleton.joint_positions(&scene.positions).unwrap();
    let rest = skeleton.rest_bones(&joints).unwrap();
    let posed = pose_bones(&skeleton.bones, &rest, &vec![None; skeleton.bones.len()]).unwrap();
    let moved: Vec<_> = posed.iter().map(|bone| bone.moved).collect();
    let weights = &scene.weights.as_ref().unwrap().bones;
    bencher.bench_local(|| skin(&scene.positions, weights, &moved).unwrap());
}

#[divan::bench(args = names())]
fn copy_of_vertices(bencher: Bencher<'_, '_>, name: &str) {
    let scene = scene(name);
    bencher.bench_local(|| scene.positions.clone());
}
