//! A fault that grows is worse: for each rule with a measure, through the real binary.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use mhlint::diag::{Grows, Towards};
use serde_json::Value;

use crate::generated;
use crate::scratch::{Case, edit, example_of, folders, mhlint, project, stdout};

/// The rules whose findings have a measure of their own.
fn growing() -> impl Iterator<Item = (&'static str, Grows)> {
    mhlint::rule_infos()
        .into_iter()
        .filter_map(|rule| Some((rule.id, rule.grows?)))
}

#[test]
fn every_measure_is_in_the_table() {
    let mut table = "| rule | measure | worse when |\n|---|---|---|\n".to_owned();
    for (id, grows) in growing() {
        let family = id.split('-').next().unwrap();
        let of = serde_json::to_value(grows.of).unwrap();
        let worse = match grows.towards {
            Towards::More => "more",
            Towards::Less => "less",
            Towards::AwayFromOne => "farther from 1",
        };
        writeln!(
            table,
            "| [`{id}`](rules/{family}.md#{id}) | {} | {worse} |",
            of.as_str().unwrap()
        )
        .unwrap();
    }
    generated::check("docs/configuration.md", "measures", &table);
}

#[test]
fn what_grew_by_more_than_a_tenth_is_reported_with_both_figures() {
    for (id, grows) in growing() {
        if NO_FIGURE.contains(&id) {
            continue;
        }
        let cases = folders(&project(&format!("fixtures/rules/{id}")));
        let shown = cases.iter().filter(|case| {
            case.file_name()
                .unwrap()
                .to_string_lossy()
                .starts_with("bad")
        });
        let mut tried = shown.map(|case| grow(case, id, grows));
        assert!(
            tried.any(|is_measured| is_measured),
            "{id}: no case has a finding with a measure"
        );
    }
}

/// Rules whose cases move something to where is no number: that grows no more.
const NO_FIGURE: [&str; 1] = ["numeric-rest-skinning"];

/// A measure that is less bad: half as much, twice as much, half as far from one.
fn milder(grows: Grows, value: f64) -> f64 {
    match grows.towards {
        Towards::More => value / 2.0,
        Towards::Less => value.abs().max(1e-3) * 2.0,
        Towards::AwayFromOne => 1.0 + (value - 1.0) / 2.0,
    }
}

/// Shows of a case that its finding is hidden by what it was, and not by less; false where it has
/// no measure.
fn grow(folder: &Path, id: &str, grows: Grows) -> bool {
    let case = Case::read(folder);
    let repository = example_of(case.application.as_deref().unwrap_or("makehuman2"));
    let root = repository.path();
    case.apply(root);
    let own = || {
        let args: Vec<&str> = case.args.iter().map(String::as_str).collect();
        if args.is_empty() {
            vec!["check", "."]
        } else {
            args
        }
    };
    let check = |more: &[&str]| {
        mhlint(
            root,
            &[
                &own()[..],
                &["--only", id, "--baseline", "known.json"],
                more,
            ]
            .concat(),
        )
    };
    check(&["--write-baseline"]);
    let known: PathBuf = root.join("known.json");
    let mut baseline: Value = serde_json::from_slice(&fs::read(&known).unwrap()).unwrap();
    let hidden: Value = serde_json::from_str(&stdout(&check(&["--report", "json"]))).unwrap();
    assert_eq!(
        hidden["findings"].as_array().unwrap().len(),
        0,
        "{}",
        folder.display()
    );
    let entries = baseline["entries"].as_array_mut().unwrap();
    let Some(entry) = entries
        .iter_mut()
        .find(|entry| entry["rule"] == id && entry["measure"].is_f64())
    else {
        return false;
    };
    let value = entry["measure"].as_f64().unwrap();
    entry["measure"] = milder(grows, value).into();
    fs::write(&known, baseline.to_string()).unwrap();
    let shown: Value = serde_json::from_str(&stdout(&check(&["--report", "json"]))).unwrap();
    let figures = &shown["findings"][0]["grown"];
    let what = folder.display();
    assert_eq!(shown["findings"][0]["rule"], id, "{what}");
    assert_eq!(
        figures["of"],
        serde_json::to_value(grows.of).unwrap(),
        "{what}"
    );
    assert_eq!(
        [figures["from"].as_f64(), figures["to"].as_f64()],
        [Some(milder(grows, value)), Some(value)],
        "{what}"
    );
    true
}

/// Makes a gap between the parts of `age`.
fn gap(root: &Path, lowest: &str) {
    const MACROS: &str = "data/targets/macrodetails/macro.json";
    edit(
        root,
        MACROS,
        "\"highest\": 0.4999, \"low\": \"child\"",
        "\"highest\": 0.49, \"low\": \"child\"",
    );
    let wanted = format!("\"lowest\": {lowest}, \"highest\": 1.00001, \"low\": \"young\"");
    edit(
        root,
        MACROS,
        "\"lowest\": 0.4999, \"highest\": 1.00001, \"low\": \"young\"",
        &wanted,
    );
}

#[test]
fn a_gap_that_grows_is_worse_and_one_that_shrinks_is_counted() {
    let (old, new) = (example_of("mpfb"), example_of("mpfb"));
    gap(old.path(), "0.490001");
    gap(new.path(), "0.496");
    let against = |root: &Path, other: &Path| {
        let other = other.join("data");
        stdout(&mhlint(
            root,
            &["check", "data", "--against", other.to_str().unwrap()],
        ))
    };
    let worse = against(new.path(), old.path());
    let words = worse.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("parts-gap") && words.contains("| values); 201327 now, 34 before"),
        "{worse}"
    );
    let better = against(old.path(), new.path());
    let words = better.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        !words.contains("parts-gap") && words.contains("1 finding is smaller than before"),
        "{better}"
    );
}

const OVAL: &str = "data/target/figure/head/head-oval.target";
const WEIGHTS: &str = "data/rigs/figure/default_weights.mhw";

#[test]
fn what_is_left_when_the_worst_row_is_repaired_is_not_new() {
    let (old, new) = (example_of("makehuman2"), example_of("makehuman2"));
    for root in [old.path(), new.path()] {
        edit(root, OVAL, "337 .002 0 0\n", "337 0 70 .001\n");
    }
    edit(old.path(), OVAL, "339 0 .001 .001\n", "339 0 90 .001\n");
    let against = |root: &Path, other: &Path| {
        let other = other.join("data");
        stdout(&mhlint(
            root,
            &[
                "check",
                "data",
                "--against",
                other.to_str().unwrap(),
                "--report",
                "concise",
            ],
        ))
    };
    let left = against(new.path(), old.path());
    assert!(!left.contains("target-oversized-delta"), "{left}");
    let worse = against(old.path(), new.path());
    assert!(worse.contains("target-oversized-delta"), "{worse}");
}

#[test]
fn the_last_line_counts_what_is_smaller_than_in_the_baseline() {
    let repository = example_of("makehuman2");
    let root = repository.path();
    edit(root, WEIGHTS, "[190, 0.75]", "[190, -0.4]");
    mhlint(
        root,
        &[
            "check",
            "data",
            "--baseline",
            "known.json",
            "--write-baseline",
        ],
    );
    edit(root, WEIGHTS, "[190, -0.4]", "[190, -0.1]");
    let report = stdout(&mhlint(
        root,
        &["check", "data", "--baseline", "known.json"],
    ));
    let words = report.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("1 finding is smaller than before."),
        "{report}"
    );
}
