//! `macro.json` of `figure` and the macro targets.
//!
//! Two macrodefs: `phenotype-gender` (barycentric × 2 steps) and `gender-age-muscle` (2 × 4 × 3
//! steps), both complete. The base mesh is the neutral state of both, so one name of each is
//! `null`. Names that differ only in gender share a file for all ages but `adult`, and all names of
//! `child` share one.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use crate::fields::{belly, bulk, head_size, shoulders, size, stoop, sum};
use crate::json_text;
use crate::mesh::{Mesh, Point};
use crate::morph::{Side, target_text};
use crate::tree::Tree;

/// Amounts of the fields that a macro target adds up.
#[derive(Clone, Copy)]
struct Shape {
    size: f64,
    bulk: f64,
    shoulders: f64,
    head: f64,
    stoop: f64,
    belly: f64,
}

const ORIGIN: Shape = Shape {
    size: 0.0,
    bulk: 0.0,
    shoulders: 0.0,
    head: 0.0,
    stoop: 0.0,
    belly: 0.0,
};

const PHENOTYPES: [(&str, Shape); 3] = [
    ("coastal", ORIGIN),
    (
        "highland",
        Shape {
            size: -0.02,
            bulk: 0.04,
            head: 0.03,
            ..ORIGIN
        },
    ),
    (
        "woodland",
        Shape {
            size: 0.02,
            bulk: -0.03,
            head: -0.02,
            ..ORIGIN
        },
    ),
];
const GENDERS: [(&str, Shape); 2] = [
    ("female", ORIGIN),
    (
        "male",
        Shape {
            size: 0.015,
            shoulders: 0.08,
            ..ORIGIN
        },
    ),
];
const AGES: [(&str, Shape); 4] = [
    (
        "child",
        Shape {
            size: -0.06,
            head: 0.06,
            ..ORIGIN
        },
    ),
    (
        "teen",
        Shape {
            size: -0.025,
            bulk: -0.02,
            ..ORIGIN
        },
    ),
    ("adult", ORIGIN),
    (
        "old",
        Shape {
            size: -0.015,
            stoop: 0.25,
            belly: 0.03,
            ..ORIGIN
        },
    ),
];
const MUSCLES: [(&str, Shape); 3] = [
    (
        "minmuscle",
        Shape {
            bulk: -0.06,
            shoulders: -0.03,
            ..ORIGIN
        },
    ),
    ("averagemuscle", ORIGIN),
    (
        "maxmuscle",
        Shape {
            bulk: 0.08,
            shoulders: 0.05,
            ..ORIGIN
        },
    ),
];
/// Being male shows less in the second macrodef, which is added to the first.
const MALE_BUILD: Shape = Shape {
    bulk: 0.02,
    belly: 0.01,
    ..ORIGIN
};

pub(crate) fn add(tree: &mut Tree, mesh: &Mesh) {
    let mut phenotypes = Vec::new();
    for (phenotype, first) in PHENOTYPES {
        for (gender, second) in GENDERS {
            let name = format!("{phenotype}-{gender}");
            let neutral = name == "coastal-female";
            phenotypes.push(entry(&name, (!neutral).then_some(name.as_str())));
            if !neutral {
                add_target(
                    tree,
                    mesh,
                    &format!("macro_phenotype/{name}"),
                    &[first, second],
                );
            }
        }
    }
    let builds = add_builds(tree, mesh);
    let macros = json!({
        "components": components(),
        "macrodef": [
            { "name": "phenotype-gender", "comp": ["phenotype", "gender"], "folder": "macro_phenotype", "targets": phenotypes },
            { "name": "gender-age-muscle", "comp": ["gender", "age", "muscle"], "folder": "macro_build", "targets": builds },
        ],
    });
    tree.add("data/target/figure/macro.json", json_text::by_hand(&macros));
}

fn add_builds(tree: &mut Tree, mesh: &Mesh) -> Vec<Value> {
    let mut entries = Vec::new();
    let mut written = BTreeSet::new();
    for (gender, _) in GENDERS {
        let build = if gender == "male" { MALE_BUILD } else { ORIGIN };
        for (age, first) in AGES {
            for (muscle, second) in MUSCLES {
                let name = format!("{gender}-{age}-{muscle}");
                let (file, shapes) = match age {
                    "child" => (age.to_owned(), vec![first]),
                    "adult" => (name.clone(), vec![second, build]),
                    _ => (format!("{age}-{muscle}"), vec![first, second]),
                };
                let neutral = name == "female-adult-averagemuscle";
                entries.push(entry(&name, (!neutral).then_some(file.as_str())));
                if !neutral && written.insert(file.clone()) {
                    add_target(tree, mesh, &format!("macro_build/{file}"), &shapes);
                }
            }
        }
    }
    entries
}

fn components() -> Value {
    json!({
        "phenotype": {
            "values": names(&PHENOTYPES),
            "pattern": "macrodetails/",
            "sum": ["Coastal", "Highland", "Woodland"],
        },
        "gender": { "values": names(&GENDERS), "steps": [0.0, 1.0], "pattern": "macrodetails/Gender" },
        "age": { "values": names(&AGES), "steps": [0.0, 0.25, 0.5, 1.0], "pattern": "macrodetails/Age" },
        "muscle": { "values": names(&MUSCLES), "steps": [0.0, 0.5, 1.0], "pattern": "macrodetails-universal/Muscle" },
    })
}

fn names(list: &[(&'static str, Shape)]) -> Vec<&'static str> {
    list.iter().map(|(name, _)| *name).collect()
}

fn entry(name: &str, file: Option<&str>) -> Value {
    json!({ "name": name, "t": file })
}

fn add_target(tree: &mut Tree, mesh: &Mesh, path: &str, shapes: &[Shape]) {
    let field = |point: Point| {
        shapes
            .iter()
            .fold([0.0; 3], |total, shape| sum(total, shape.at(point)))
    };
    let text = target_text(mesh, "figure", Side::Both, &field);
    tree.add(format!("data/target/figure/{path}.target"), text);
}

impl Shape {
    fn at(self, point: Point) -> Point {
        let parts = [
            size(point, self.size),
            bulk(point, self.bulk),
            shoulders(point, self.shoulders),
            head_size(point, self.head),
            stoop(point, self.stoop),
            belly(point, self.belly),
        ];
        parts.into_iter().fold([0.0; 3], sum)
    }
}
