//! Bad input in modifiers, rigs, expressions and targets of MakeHuman 1: each value as something
//! else, a hundred thousand targets, words in other scripts, macros that depend on each other. No
//! rule fails, and what is lost is reported.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::Arc;

use crate::scratch::exchanged::exchanged;
use crate::scratch::{content, project};
use mhlint::{Config, Outcome, Tree, lint_trees};
use rayon::prelude::*;
use serde_json::{Value, json};

type Files = BTreeMap<String, Arc<[u8]>>;

fn example() -> Files {
    let listed = content(&project("fixtures/makehuman1")).into_iter();
    listed
        .map(|(path, bytes)| (path.to_str().unwrap().replace('\\', "/"), bytes.into()))
        .collect()
}

/// The example with other files, checked; nothing may fail.
fn run(files: &Files, others: Vec<(String, Vec<u8>)>, evaluates: bool) -> Outcome {
    let mut changed = files.clone();
    changed.extend(others.into_iter().map(|(path, bytes)| (path, bytes.into())));
    let options = Config {
        no_eval: !evaluates,
        ..Config::default()
    };
    let outcome = lint_trees(vec![Tree::in_memory("", changed)], None, &options).unwrap();
    assert!(
        outcome.is_whole(),
        "{:?} {:?}",
        outcome.failed_rules,
        outcome.failed_files
    );
    assert!(
        outcome
            .findings
            .iter()
            .all(|finding| !finding.path.is_empty())
    );
    outcome
}

/// The findings of a rule, with the path of each.
fn of_rule<'o>(outcome: &'o Outcome, rule: &str) -> Vec<&'o str> {
    outcome
        .findings
        .iter()
        .filter(|one| one.rule == rule)
        .map(|one| one.path.as_str())
        .collect()
}

const DOCUMENTS: [&str; 6] = [
    "data/modifiers/bodyshapes_modifiers.json",
    "data/modifiers/bodyshapes_sliders.json",
    "data/modifiers/bodyshapes_modifiers_desc.json",
    "data/rigs/stick.mhskel",
    "data/expressions/puzzled.mhpose",
    "data/poseunits/face-poseunits.json",
];

#[test]
fn every_value_of_modifiers_rigs_and_expressions_may_be_anything() {
    let files = example();
    let others = [
        json!(null),
        json!("1"),
        json!(-1),
        json!(1e300),
        json!([]),
        json!({}),
        json!([1, 2]),
        json!([[]]),
    ];
    for path in DOCUMENTS {
        let whole: Value = serde_json::from_slice(&files[path]).unwrap();
        let damages = exchanged(&whole, &others);
        let told = damages.par_iter().filter(|(_, copy)| {
            let bytes = serde_json::to_vec(copy).unwrap();
            !run(&files, vec![(path.to_owned(), bytes)], false)
                .findings
                .is_empty()
        });
        let (told, all) = (told.count(), damages.len());
        // What the program never reads, such as a name of the units, may be anything.
        assert!(
            told * 3 > all,
            "{path}: {told} of {all} damages are reported"
        );
    }
}

#[test]
fn a_hundred_thousand_targets_are_one_finding() {
    let target = |at: usize| {
        (
            format!("data/targets/many/many-{at}.target"),
            b"# one\n0 0 .1 0\n".to_vec(),
        )
    };
    let outcome = run(&example(), (0..100_000).map(target).collect(), false);
    assert_eq!(
        of_rule(&outcome, "target-unreferenced"),
        ["data/targets/many/many-0.target"]
    );
    assert_eq!(
        outcome.findings.len(),
        1,
        "{:?}",
        outcome
            .findings
            .iter()
            .map(|one| &one.message)
            .collect::<Vec<_>>()
    );
}

#[test]
fn words_of_paths_may_be_of_any_script() {
    let row = b"# one\n0 0 .1 0\n".to_vec();
    let names = [
        "größe-男性.target",
        "мужчина_молодой.target",
        "رجل.target",
        "-..target",
        "Male-FEMALE.target",
        "e\u{301}.target",
    ];
    let shipped = names
        .iter()
        .map(|name| (format!("data/targets/données/{name}"), row.clone()));
    let own = names
        .iter()
        .map(|name| (format!("user/data/custom/{name}"), row.clone()));
    let outcome = run(&example(), shipped.chain(own).collect(), true);
    // None of them is a word of a macro; that no modifier moves them is told once for their folder.
    assert_eq!(of_rule(&outcome, "target-unreferenced").len(), 1);
    let accented = [
        "data/targets/données/e\u{301}.target",
        "user/data/custom/e\u{301}.target",
    ];
    assert_eq!(of_rule(&outcome, "file-unportable-name"), accented);
    assert_eq!(
        outcome.findings.len(),
        3,
        "{:?}",
        outcome
            .findings
            .iter()
            .map(|one| one.rule)
            .collect::<Vec<_>>()
    );
}

/// The targets of each of two macros depend on the variable of the other one.
#[test]
fn macros_that_depend_on_each_other_end_with_a_verdict() {
    let group = |group: &str, variable: &str| json!({ "group": group, "modifiers": [{ "macrovar": variable }] });
    let groups = json!([
        group("ring-one", "Muscle"),
        group("ring-two", "Weight"),
        group("ring-three", "BreastSize")
    ]);
    let mut targets: Vec<(String, Vec<u8>)> = Vec::new();
    for (name, variables) in [
        (
            "ring-one",
            [["minmuscle", "maxmuscle"], ["minweight", "maxweight"]],
        ),
        (
            "ring-two",
            [["minweight", "maxweight"], ["mincup", "maxcup"]],
        ),
        (
            "ring-three",
            [["mincup", "maxcup"], ["minmuscle", "maxmuscle"]],
        ),
    ] {
        for (first, second) in variables[0]
            .iter()
            .flat_map(|first| variables[1].iter().map(move |second| (first, second)))
        {
            let mut text = "# ring\n".to_owned();
            (0..20).for_each(|vertex| writeln!(text, "{vertex} 0 .1 0").unwrap());
            targets.push((
                format!("data/targets/{name}-{first}-{second}.target"),
                text.into_bytes(),
            ));
        }
    }
    let names = [
        "ring-one/Muscle",
        "ring-two/Weight",
        "ring-three/BreastSize",
    ];
    let sliders: Vec<Value> = names.iter().map(|name| json!({ "mod": name })).collect();
    let texts: serde_json::Map<String, Value> = names
        .iter()
        .map(|name| ((*name).to_owned(), json!("")))
        .collect();
    let files = [
        ("bodyshapes_modifiers.json", groups),
        ("bodyshapes_modifiers_desc.json", Value::Object(texts)),
        (
            "bodyshapes_sliders.json",
            json!({ "Rings": { "modifiers": { "ring": sliders } } }),
        ),
    ];
    targets.extend(files.iter().map(|(name, json)| {
        (
            format!("data/modifiers/{name}"),
            serde_json::to_vec(json).unwrap(),
        )
    }));
    let outcome = run(&example(), targets, true);
    assert!(of_rule(&outcome, "modifiers-no-target").is_empty());
    assert!(
        outcome
            .findings
            .iter()
            .all(|one| !one.path.contains("ring-") || !one.rule.starts_with("numeric-"))
    );
}
