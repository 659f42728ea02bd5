//! Whole repositories of the applications, where `MHLINT_CORPORA` names the folder that holds them.
//!
//! They are not part of the project, so that the tests are ignored unless asked for
//! (`-- --ignored`).

use crate::scratch::{corpus, mhlint};
use mhlint::eval::skin::{pose_bones, skin};
use mhlint::eval::vector::distance;

/// The JSON report on a folder of a corpus.
fn report(corpus: &std::path::Path, args: &[&str]) -> serde_json::Value {
    let output = mhlint(corpus, &[args, &["--report", "json"]].concat());
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)))
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn makehuman2_ends_with_a_verdict_that_its_counts_bear_out() {
    let corpus = corpus("makehuman2");
    let report = report(&corpus, &["data"]);
    let summary = &report["summary"];
    assert_eq!(
        report["roots"][0]["bases"],
        serde_json::json!(["hm08", "mh2bot"])
    );
    assert!(summary["files"].as_u64().unwrap() > 1_000, "{summary}");
    let errors = summary["error"].as_u64().unwrap();
    assert_eq!(
        report["verdict"],
        if errors == 0 { "pass" } else { "fail" },
        "{summary}"
    );
    let listed = report["findings"].as_array().unwrap().iter();
    assert_eq!(
        listed.filter(|finding| finding["level"] == "error").count() as u64,
        errors
    );
}

/// `rule message` of the findings about a file below `data/`, without what evaluation says.
fn said<'r>(report: &'r serde_json::Value, rule: &str, path: &str) -> Vec<&'r str> {
    let of_file = report["findings"].as_array().unwrap().iter();
    let of_rule = of_file.filter(|finding| {
        finding["rule"] == rule && finding["path"] == format!("data/{path}").as_str()
    });
    of_rule
        .map(|finding| finding["message"].as_str().unwrap())
        .collect()
}

/// Vertices whose weights the loader cuts down are drawn towards the origin by what they lack, in
/// the application as well; the others must not move at all.
#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn skinning_the_rest_pose_gives_the_meshes_back() {
    let corpus = corpus("makehuman2");
    for base in ["hm08", "mh2bot"] {
        let mut evaluation = mhlint::open_base(&corpus.join("data"), None, Some(base)).unwrap();
        let defaults = evaluation.scene().defaults();
        let mesh = evaluation.morphed(&defaults).unwrap();
        let scene = evaluation.scene();
        let skeleton = scene.skeleton.as_ref().unwrap();
        let joints = skeleton.joint_positions(&mesh).unwrap();
        let rest = skeleton.rest_bones(&joints).unwrap();
        let posed = pose_bones(&skeleton.bones, &rest, &vec![None; skeleton.bones.len()]).unwrap();
        let moved: Vec<_> = posed.iter().map(|bone| bone.moved).collect();
        let weights = scene.weights.as_ref().unwrap();
        let skinned = skin(&mesh, &weights.bones, &moved).unwrap();
        let farthest = mesh
            .iter()
            .zip(&skinned)
            .map(|(at, skinned)| distance(*skinned, *at))
            .fold(0.0, f64::max);
        assert!(farthest < 1e-4, "{base}: a vertex is off by {farthest}");
    }
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn makehuman2_shows_its_known_defects() {
    let corpus = corpus("makehuman2");
    let report = report(&corpus, &["data", "--no-eval"]);
    let expected = [
        (
            "macro-missing-combination",
            "target/hm08/macro.json",
            &["108 of 216", "72 of 216", "432 of 648"][..],
        ),
        (
            "macro-alias-suspect",
            "target/hm08/macro.json",
            &["averagecup-maxfirmness", "averagecup-minfirmness"],
        ),
        (
            "base-unknown-preset",
            "base/hm08/base.json",
            &["`shapes|fale hormonal`"],
        ),
        (
            "base-vertex-count",
            "base/mh2bot/base.json",
            &["`numverts` is 7267, but base.obj has 7259"],
        ),
        (
            "mesh-reopened-group",
            "base/hm08/base.obj",
            &["5 groups appear more than once: 93 faces"],
        ),
        (
            "base-geometry-range",
            "base/hm08/geometry.json",
            &["l-upper.leg"],
        ),
        (
            "target-zero-delta",
            "target/hm08/macro_prop/female-old-averagemuscle-maxweight-ideal.target",
            &["163 zero rows"],
        ),
        (
            "weights-not-normalized",
            "rigs/hm08/default_weights.mhw",
            &["5799 of 19158"],
        ),
        (
            "weights-not-normalized",
            "rigs/mh2bot/default_weights.mhw",
            &["4 of 7259"],
        ),
        (
            "pose-matrix",
            "base/hm08/body-poses.json",
            &["`shoulder01.L` in the reverse of unit `LeftUpperArmRotHorizontal`"],
        ),
        (
            "file-unreferenced",
            "target/hm08/icons/bodyshapes-elvs-man-diamond.png",
            &["is not used"],
        ),
    ];
    for (rule, path, texts) in expected {
        let said = said(&report, rule, path);
        let fits = said.len() == texts.len()
            && said
                .iter()
                .zip(texts)
                .all(|(said, text)| said.contains(text));
        assert!(fits, "{rule} {path}: {said:?}");
    }
    // The two files that nothing uses are those that the suspect entries should name: one cause.
    for side in ["maxfirmness", "minfirmness"] {
        let path = format!(
            "target/hm08/macro_fembreast/child-minmuscle-averageweight-averagecup-{side}.target"
        );
        assert_eq!(
            said(&report, "macro-unreferenced-target", &path),
            Vec::<&str>::new(),
            "{path}"
        );
    }
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn nothing_else_in_makehuman2_is_an_error_or_a_warning() {
    let corpus = corpus("makehuman2");
    let report = report(&corpus, &["data", "--no-eval"]);
    let loud = report["findings"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|finding| finding["level"] != "info");
    let mut rules: Vec<&str> = loud
        .map(|finding| finding["rule"].as_str().unwrap())
        .collect();
    rules.sort_unstable();
    let known = [
        "base-unknown-preset",
        "base-vertex-count",
        "filter-dead-entry",
        "filter-dead-entry",
        "filter-dead-entry",
        "filter-dead-entry",
        "filter-dead-entry",
        "macro-alias-suspect",
        "macro-alias-suspect",
        "mesh-reopened-group",
        "modelling-measure",
        "modelling-measure",
        "modelling-measure",
        "pose-matrix",
        // `url_mhcommunity` (`docs/loaders/makehuman2/program.md#version-and-settings`).
        "program-file-content",
    ];
    assert_eq!(rules, known);
    assert_eq!(
        mhlint(&corpus, &["data", "--no-eval"]).status.code(),
        Some(0),
        "no error"
    );
    let systematic = said(
        &report,
        "macro-missing-combination",
        "target/hm08/macro.json",
    );
    assert!(
        systematic
            .iter()
            .all(|message| message.contains("systematically")),
        "{systematic:?}"
    );
}

/// What no modifier moves is told once a folder; all names of modifiers, sliders and descriptions
/// lead somewhere.
#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn makehuman1_has_neither_errors_nor_warnings() {
    let corpus = corpus("makehuman1");
    let report = report(&corpus, &["data", "--app", "makehuman1"]);
    let summary = &report["summary"];
    assert_eq!(
        (summary["error"].as_u64(), summary["warning"].as_u64()),
        (Some(0), Some(0)),
        "{summary}"
    );
    assert!(summary["files"].as_u64() > Some(1_500), "{summary}");
    let findings = report["findings"].as_array().unwrap();
    let of = |rule: &str| -> Vec<&serde_json::Value> {
        findings
            .iter()
            .filter(|finding| finding["rule"].as_str().unwrap().starts_with(rule))
            .collect()
    };
    let unused: Vec<u64> = of("target-unreferenced")
        .iter()
        .map(|finding| finding["evidence"]["count"].as_u64().unwrap())
        .collect();
    assert_eq!(unused, [20, 62, 1, 102]);
    assert_eq!(of("modifiers-").len() + of("skeleton-").len(), 0);
    assert_eq!(
        of("target-macro-token").len() + of("target-missing-combination").len(),
        0
    );
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn rigs_of_the_assets_fit_the_base_skeleton_of_makehuman1() {
    let data = corpus("makehuman1").join("data");
    let report = report(
        &corpus("makehuman-assets"),
        &[
            ".",
            "--app",
            "makehuman1",
            "--system",
            data.to_str().unwrap(),
        ],
    );
    let findings = report["findings"].as_array().unwrap().iter();
    let of_rigs =
        findings.filter(|finding| finding["rule"].as_str().unwrap().starts_with("skeleton-"));
    let said: Vec<(&str, &str)> = of_rigs
        .map(|finding| {
            (
                finding["level"].as_str().unwrap(),
                finding["rule"].as_str().unwrap(),
            )
        })
        .collect();
    // `toe1-3` is in all of them and in no base skeleton; nothing is lost by it.
    assert_eq!(said, [("info", "skeleton-unknown-reference"); 3]);
}
