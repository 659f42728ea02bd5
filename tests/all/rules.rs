//! Every rule on its fixtures: the whole set of findings is compared. They run in memory, through
//! the library; those that need a disk (links, hidden files, a baseline) through the real binary,
//! and one of each family both ways.
//!
//! `fixtures/rules/<id>/<case>/` holds `case.toml` (edits over the example repository) and, where
//! something is found, `expected.txt`. In cases named `good…` the rule must be silent, those named
//! `bad…` must show it. `UPDATE=1 cargo test --test all rules::` rewrites the expectations; read the
//! diff before you commit.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::doubles::{Double, doubles, unlisted, unseen};
use crate::scratch::memory::{Asked, Memory, concise};
use crate::scratch::{Case, example_of, findings, folders, mhlint, project};
use mhlint::Tree;
use rayon::prelude::*;

/// A folder below `fixtures/rules`.
struct Fixture {
    rule: String,
    name: String,
    folder: PathBuf,
}

#[test]
fn every_case_gives_exactly_its_findings() {
    let only = std::env::var("CASE").unwrap_or_default();
    let all = fixtures();
    let chosen: Vec<&Fixture> = all
        .iter()
        .filter(|f| format!("{}/{}", f.rule, f.name).contains(&only))
        .collect();
    assert!(!chosen.is_empty(), "no case fits CASE={only}");
    let (faults, doubles): (Vec<Option<String>>, Vec<Vec<Double>>) =
        chosen.par_iter().map(|fixture| check(fixture)).unzip();
    let doubles = doubles.concat();
    let mut faults: Vec<String> = faults.into_iter().flatten().collect();
    faults.extend(unlisted(&doubles));
    if only.is_empty() {
        assert_eq!(unseen(&doubles), Vec::<[&str; 2]>::new());
    }
    assert!(
        faults.is_empty(),
        "\n{}\n{} of {} cases; if that is wanted: UPDATE=1 CASE=<id> cargo test --test all every_case",
        faults.join("\n"),
        faults.len(),
        chosen.len()
    );
}

#[test]
fn every_rule_has_cases_and_every_folder_a_rule() {
    let ids: BTreeSet<String> = mhlint::rule_infos()
        .into_iter()
        .map(|rule| rule.id.to_owned())
        .collect();
    let folders: BTreeSet<String> = fixtures().into_iter().map(|fixture| fixture.rule).collect();
    let strange: Vec<&String> = folders.symmetric_difference(&ids).collect();
    assert!(
        strange.is_empty(),
        "no rule, or no fixtures/rules/<id>/bad: {strange:?}"
    );
    for id in &ids {
        let names: Vec<String> = fixtures()
            .into_iter()
            .filter(|f| f.rule == *id)
            .map(|f| f.name)
            .collect();
        assert!(
            names.iter().any(|name| name == "bad"),
            "{id} has no case `bad`"
        );
        assert!(
            names.iter().any(|name| name.starts_with("good")),
            "{id} has no good case"
        );
    }
}

#[test]
fn memory_and_binary_find_the_same() {
    let mut families = BTreeSet::new();
    let mut faults = Vec::new();
    for fixture in fixtures()
        .into_iter()
        .filter(|fixture| fixture.name == "bad")
    {
        let case = Case::read(&fixture.folder);
        let family = fixture.rule.split('-').next().unwrap().to_owned();
        if case.application.is_none() && Asked::of(&case).is_some() && families.insert(family) {
            let (ours, binary) = (by_library(&case).unwrap().0, by_binary(&case).unwrap());
            let differs = || format!("{}: {ours:#?} {binary:#?}", fixture.rule);
            faults.extend((ours != binary).then(differs));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(families.len() > 10, "{families:?}");
}

#[test]
fn the_example_repositories_are_silent() {
    for example in ["makehuman2", "makehuman1", "mpfb"] {
        let output = mhlint(&project("fixtures"), &[example, "--report", "concise"]);
        assert_eq!(findings(&output), Vec::<String>::new());
        assert_eq!(output.status.code(), Some(0));
    }
}

/// Those of what is worn: the weights of its rigs are not checked yet.
#[test]
fn weights_are_checked_as_makehuman_1_reads_them() {
    let weights = |pair: &str| {
        format!(r#"{{"name": "w", "version": 1, "license": "CC0", "weights": {{{pair}}}}}"#)
    };
    let negative = weights(r#""root": [[0, 1], [1, 1.25], [2, 1]], "tip": [[1, -0.25]]"#);
    let skeleton = |file: &str| {
        let bone = r#"{"head": "a", "tail": "b", "parent": null}"#;
        format!(
            r#"{{"name": "rig", "weights_file": "{file}", "bones": {{"root": {bone}}}, "joints": {{"a": [0], "b": [1]}}}}"#
        )
    };
    let files = [
        ("modifiers/modeling_modifiers.json", "[]".to_owned()),
        ("3dobjs/base.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng body\nf 1 2 3\n".to_owned()),
        ("rigs/default.mhskel", skeleton("default_weights.mhw")),
        ("rigs/other.mhskel", skeleton("data/rigs/sub/other.mhw")),
        ("rigs/default_weights.mhw", negative.clone()),
        ("rigs/sub/other.mhw", weights(r#""root": [[0, 1], [1, 1], [2, 1]]"#)),
        ("rigs/old.mhw", negative.clone()),
        (
            "clothes/hat/hat.mhclo",
            "name hat\nobj_file hat.obj\nvertexboneweights_file: old.mhw\nvertexboneweights_file hat.mhw\n".to_owned(),
        ),
        ("clothes/hat/hat.mhw", negative.clone()),
        ("clothes/hat/old.mhw", negative),
    ];
    let tree = Tree::in_memory(
        "",
        files.map(|(path, text)| (path.to_owned(), text.into_bytes())),
    );
    let config = mhlint::Config {
        only: vec!["weights".to_owned()],
        applications: vec![mhlint::Application::Makehuman1],
        ..mhlint::Config::default()
    };
    let outcome = mhlint::lint_trees(vec![tree], None, &config).unwrap();
    let expected = [
        "clothes/hat/hat.mhw:1:104: warning[weights-negative] bone `tip` has the negative weight -0.25 for vertex 1",
        "rigs/default_weights.mhw:1:96: warning[weights-unknown-bone] bone `tip` does not exist in the skeleton",
        "rigs/default_weights.mhw:1:104: warning[weights-negative] bone `tip` has the negative weight -0.25 for vertex 1 \
         (`body`, near `root`)",
        "rigs/old.mhw: warning[weights-unbound] no skeleton of base `hm08` uses these weights",
    ];
    assert_eq!(concise(&outcome), expected);
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn the_data_of_mpfb_have_their_known_defects() {
    let tree = Tree::on_disk(
        "",
        crate::scratch::corpus("mpfb").join("data"),
        |_, _, _| false,
    );
    let config = mhlint::Config {
        applications: vec![mhlint::Application::Mpfb],
        ..mhlint::Config::default()
    };
    let outcome = mhlint::lint_trees(vec![tree], None, &config).unwrap();
    assert!(outcome.is_whole());
    assert_eq!(
        outcome
            .roots
            .iter()
            .map(|root| root.bases.clone())
            .collect::<Vec<_>>(),
        [["hm08"]]
    );
    let gap = |line: u32, text: &str| {
        format!("targets/macrodetails/macro.json:{line}:31: warning[parts-gap] no part of {text}")
    };
    let found = concise(&outcome);
    let expected = [
        "`age` covers 0.1874998 to 0.1874999 (7 slider values)",
        "`age` covers 0.49998 to 0.49999 (336 slider values)",
        "`muscle` covers 0.49998 to 0.49999 (336 slider values)",
        "`weight` covers 0.49998 to 0.49999 (336 slider values)",
        "`cupsize` covers 0.49998 to 0.49999 (336 slider values)",
        "`firmness` covers 0.4998 to 0.4999 (3355 slider values)",
    ];
    let gaps: Vec<String> = [26, 32, 50, 68, 122, 140]
        .into_iter()
        .zip(expected)
        .map(|(line, text)| gap(line, text))
        .collect();
    let (others, found): (Vec<String>, Vec<String>) = found
        .into_iter()
        .partition(|line| !line.contains("[parts-gap]"));
    assert_eq!(found, gaps);
    // What else is known of them, and what the copy lacks: rule, and what the finding says.
    let known = [
        (
            "catalog-duplicate-target",
            "34 targets exist in several folders",
        ),
        ("catalog-empty-section", "section `measure` is empty"),
        ("catalog-unlisted-target", "62 targets in `targets/asym`"),
        (
            "catalog-unlisted-target",
            "34 targets in `targets/expression/units/african`",
        ),
        (
            "catalog-unlisted-target",
            "34 targets in `targets/expression/units/asian`",
        ),
        (
            "catalog-unlisted-target",
            "34 targets in `targets/expression/units/caucasian`",
        ),
        (
            "file-duplicate-content",
            "`targets/legs/measure-lowerleg-height-decr.target.gz`",
        ),
        (
            "file-duplicate-content",
            "`targets/legs/measure-lowerleg-height-incr.target.gz`",
        ),
        (
            "file-duplicate-content",
            "`targets/legs/upperlegs-height-incr.target.gz`",
        ),
        (
            "metadata-table",
            "`helper-l-eyelashes` is not a vertex group (5 such names)",
        ),
        ("parts-end-share", "16 of 16 ends"),
        ("program-missing-file", "folder `targets/_images`"),
        ("program-missing-file", "folder `textures`"),
        ("rig-asymmetric", "`mixamorig:LeftHand`"),
        ("rig-default-position-drift", "rig.game_engine.json"),
        (
            "rig-default-position-drift",
            "rig.game_engine_with_breast.json",
        ),
        ("rig-default-position-drift", "rig.mixamo.json"),
        (
            "rig-missing-weights",
            "`weights.human.json` does not exist, which rig `human` needs",
        ),
        (
            "rig-missing-weights",
            "`weights.default.json` does not exist, which rigs `default` and `default_no_toes` need",
        ),
        ("target-asymmetric", "32 of 810 targets"),
        ("target-asymmetric", "203 vertices"),
        ("target-asymmetric-pair", "`r-foot-trans-backward`"),
        ("target-asymmetric-pair", "`r-foot-trans-forward`"),
        ("target-zero-delta", "35326 zero rows in 635 targets"),
        (
            "weights-not-normalized",
            "weights.game_engine_with_breast.json",
        ),
        ("weights-not-normalized", "weights.mixamo.json"),
    ];
    for (rule, text) in known {
        let told = others
            .iter()
            .filter(|line| line.contains(&format!("[{rule}]")) && line.contains(text))
            .count();
        assert_eq!(told, 1, "{rule}: {text}: {others:#?}");
    }
    assert_eq!(others.len(), known.len(), "{others:#?}");
}

fn fixtures() -> Vec<Fixture> {
    let mut all = Vec::new();
    for rule in folders(&project("fixtures/rules")) {
        for folder in folders(&rule) {
            let name = |path: &Path| path.file_name().unwrap().to_str().unwrap().to_owned();
            all.push(Fixture {
                rule: name(&rule),
                name: name(&folder),
                folder,
            });
        }
    }
    all
}

/// What is wrong with a case, and the findings of it that stand at one place.
fn check(fixture: &Fixture) -> (Option<String>, Vec<Double>) {
    let case = Case::read(&fixture.folder);
    let title = format!("{}/{}", fixture.rule, fixture.name);
    let (found, doubles) = match by_library(&case) {
        Ok(found) => found,
        Err(fault) => return (Some(format!("{title}: {fault}")), Vec::new()),
    };
    (fault(fixture, &title, &found), doubles)
}

fn fault(fixture: &Fixture, title: &str, found: &[String]) -> Option<String> {
    let shows_rule = found
        .iter()
        .any(|line| line.contains(&format!("[{}]", fixture.rule)));
    if fixture.name.starts_with("bad") != shows_rule {
        return Some(format!(
            "{title}: `bad` means that the rule fires, `good` that it does not\n  {}",
            found.join("\n  ")
        ));
    }
    compare(title, &fixture.folder.join("expected.txt"), found)
}

/// The findings of a case by the library, or by the binary where it needs a disk.
fn by_library(case: &Case) -> Result<(Vec<String>, Vec<Double>), String> {
    let Some(asked) = Asked::of(case) else {
        return by_binary(case).map(|found| (found, Vec::new()));
    };
    let mut repository = Memory::example(case);
    repository.apply(case);
    let outcome = asked.lint(&repository);
    if outcome.is_whole() && outcome.checked_anything() {
        Ok((concise(&outcome), doubles(&outcome.findings)))
    } else {
        Err(format!(
            "failed {:?} {:?}",
            outcome.failed_rules, outcome.failed_files
        ))
    }
}

/// The same by the binary.
fn by_binary(case: &Case) -> Result<Vec<String>, String> {
    let repository = example_of(case.application.as_deref().unwrap_or("makehuman2"));
    case.apply(repository.path());
    let mut args: Vec<&str> = case.args.iter().map(String::as_str).collect();
    if args.is_empty() {
        args.extend(["check", "."]);
    }
    args.extend(["--report", "concise"]);
    let output = mhlint(repository.path(), &args);
    match output.status.code() {
        Some(0 | 1) => Ok(findings(&output)),
        _ => Err(format!(
            "{:?} {}",
            output.status,
            String::from_utf8_lossy(&output.stderr)
        )),
    }
}

fn compare(title: &str, path: &Path, found: &[String]) -> Option<String> {
    let mut text = found.join("\n");
    text.push_str(if found.is_empty() { "" } else { "\n" });
    let expected = fs::read_to_string(path).unwrap_or_default();
    if text == expected {
        return None;
    }
    if std::env::var_os("UPDATE").is_some() {
        if text.is_empty() {
            fs::remove_file(path)
        } else {
            fs::write(path, &text)
        }
        .unwrap();
        return None;
    }
    Some(format!(
        "{title}:\n--- expected\n{expected}--- found\n{text}"
    ))
}

/// Two applications have one data root: each is told of what it reads itself, and at its own level.
#[test]
fn a_file_is_a_matter_of_the_applications_that_read_it() {
    use mhlint::Application::{Makehuman2, Mpfb};
    let broken = b"\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03".as_slice();
    let files = [
        ("base/cube/base.json", b"{}".as_slice()),
        ("target/cube/head/a.target.gz", broken),
        (
            "targets/target.json",
            b"{\"nose\": {\"label\": \"nose\", \"categories\": []}}",
        ),
        ("targets/nose/b.target.gz", broken),
    ];
    let tree = Tree::in_memory(
        "",
        files.map(|(path, bytes)| (path.to_owned(), bytes.to_vec())),
    );
    let config = mhlint::Config {
        only: vec!["file-gzip-corrupt".to_owned()],
        applications: vec![Makehuman2, Mpfb],
        ..mhlint::Config::default()
    };
    let outcome = mhlint::lint_trees(vec![tree], None, &config).unwrap();
    let told = |finding: &mhlint::Finding| {
        let breaks: Vec<_> = finding
            .breaks
            .iter()
            .map(|one| (one.application, one.level))
            .collect();
        (finding.path.clone(), finding.level, breaks)
    };
    let expected = [
        (
            "target/cube/head/a.target.gz",
            mhlint::Level::Info,
            Makehuman2,
        ),
        ("targets/nose/b.target.gz", mhlint::Level::Error, Mpfb),
    ];
    let expected = expected.map(|(path, level, of)| (path.to_owned(), level, vec![(of, level)]));
    assert_eq!(
        outcome.findings.iter().map(told).collect::<Vec<_>>(),
        expected
    );
    let verdicts: Vec<_> = outcome
        .applications
        .iter()
        .map(|one| (one.application, one.verdict))
        .collect();
    assert_eq!(
        verdicts,
        [
            (Makehuman2, mhlint::diag::Verdict::Pass),
            (Mpfb, mhlint::diag::Verdict::Fail)
        ]
    );
}
