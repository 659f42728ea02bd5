//! Many names that are nearly like many others: each is looked for among all of them.

use serde_json::{Map, Value, json};

use super::Input;
use crate::scratch::project;

pub(super) const INPUTS: &[Input] = &[
    Input {
        name: "parents of 199 letters that no bone has",
        times: 160,
        files: long_parents,
        args: &["check", "."],
        exit: 1,
    },
    Input {
        name: "unknown components in `comp`",
        times: 8000,
        files: unknown_components,
        args: &["check", "."],
        exit: 0,
    },
    Input {
        name: "start values of unknown sliders",
        times: 8000,
        files: unknown_presets,
        args: &["check", "."],
        exit: 1,
    },
    Input {
        name: "measures of unknown sliders",
        times: 8000,
        files: unknown_measures,
        args: &["check", "."],
        exit: 1,
    },
    Input {
        name: "groups that no category has",
        times: 6000,
        files: unknown_groups,
        args: &["check", "."],
        exit: 1,
    },
];

/// The example repository with other files in place of some of its own.
pub(super) fn example_with(changed: Vec<(&str, Value)>) -> Vec<(String, Vec<u8>)> {
    let root = project("fixtures/makehuman2/data");
    let listed = walkdir::WalkDir::new(&root).into_iter().map(Result::unwrap);
    let files = listed
        .filter(|entry| entry.file_type().is_file())
        .map(|entry| {
            let path = entry
                .path()
                .strip_prefix(&root)
                .unwrap()
                .to_str()
                .unwrap()
                .to_owned();
            (path, std::fs::read(entry.path()).unwrap())
        });
    let mut files: Vec<_> = files
        .filter(|(path, _)| changed.iter().all(|(other, _)| path != other))
        .collect();
    files.extend(
        changed
            .iter()
            .map(|(path, value)| ((*path).to_owned(), value.to_string().into_bytes())),
    );
    files
}

/// A JSON file of the example.
pub(super) fn of_example(path: &str) -> Value {
    serde_json::from_slice(&std::fs::read(project("fixtures/makehuman2/data").join(path)).unwrap())
        .unwrap()
}

fn long_parents(times: usize) -> Vec<(String, Vec<u8>)> {
    const SKELETON: &str = "rigs/figure/default.mhskel";
    let mut skeleton = of_example(SKELETON);
    for bone in 0..times {
        let name = format!("{}{bone:06}", "ab".repeat(96));
        let parent: String = name.chars().rev().collect();
        let bone = json!({"head": "pelvis____head", "tail": "pelvis____tail", "parent": format!("{parent}x"), "rotation_plane": "pelvis"});
        skeleton["bones"][name] = bone;
    }
    example_with(vec![(SKELETON, skeleton)])
}

fn unknown_components(times: usize) -> Vec<(String, Vec<u8>)> {
    const MACRO: &str = "target/figure/macro.json";
    let mut macros = of_example(MACRO);
    for number in 0..times / 2 {
        let component =
            json!({"values": ["a", "b"], "steps": [0, 1], "pattern": "macrodetails/Gender"});
        macros["components"][format!("component{number:05}")] = component;
    }
    let names: Vec<String> = (0..times / 2)
        .map(|number| format!("compnent{number:05}x"))
        .collect();
    macros["macrodef"][0]["comp"] = json!(names);
    example_with(vec![(MACRO, macros)])
}

/// Sliders with patterns that are nearly what is asked for.
fn sliders(times: usize, group: impl Fn(usize) -> String) -> Value {
    let mut sliders = of_example("target/figure/modelling.json");
    for number in 0..times {
        let slider = json!({"group": group(number), "incr": "head/head-oval"});
        sliders[format!("Slider {number:05}")] = slider;
    }
    sliders
}

fn unknown_presets(times: usize) -> Vec<(String, Vec<u8>)> {
    const BASE: &str = "base/figure/base.json";
    let mut base = of_example(BASE);
    let names = (0..times).map(|number| (format!("macrodetals/Slider{number:05}"), json!(0.5)));
    base["modifier-presets"] = Value::Object(names.collect::<Map<_, _>>());
    example_with(vec![
        (BASE, base),
        (
            "target/figure/modelling.json",
            sliders(times / 2, |_| "head|head".to_owned()),
        ),
    ])
}

fn unknown_measures(times: usize) -> Vec<(String, Vec<u8>)> {
    const BASE: &str = "base/figure/base.json";
    let mut base = of_example(BASE);
    let names = (0..times).map(|number| {
        (
            format!("size{number:05}"),
            json!(format!("measure/size-{number:05}")),
        )
    });
    base["measure"] = Value::Object(names.collect::<Map<_, _>>());
    example_with(vec![
        (BASE, base),
        (
            "target/figure/modelling.json",
            sliders(times / 2, |_| "head|head".to_owned()),
        ),
    ])
}

fn unknown_groups(times: usize) -> Vec<(String, Vec<u8>)> {
    const CATEGORIES: &str = "target/figure/target_cat.json";
    let mut categories = of_example(CATEGORIES);
    for number in 0..times {
        categories[format!("Category {number:05}")] = json!({"group": format!("categry{number:05}"), "items": [{"title": "A", "cat": format!("part{number:05}")}]});
    }
    let sliders = sliders(times, |number| {
        format!("category{number:05}|part{number:05}x")
    });
    example_with(vec![
        (CATEGORIES, categories),
        ("target/figure/modelling.json", sliders),
    ])
}
