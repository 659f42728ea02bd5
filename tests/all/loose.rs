//! Assets in no data folder: each alone, over the system data of one application, and for both.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::Value;

use crate::scratch::{assert_refused, copy_folder, edit, mhlint, project, stderr, stdout};

/// The shirt of an example in a folder of its own.
fn shirt_of(application: &str, from: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(
        &project(&format!("fixtures/{application}/{from}")),
        &folder.path().join("my-shirt"),
    );
    folder
}

fn shirt() -> tempfile::TempDir {
    shirt_of("makehuman2", "data/clothes/figure/shirt")
}

fn system(application: &str) -> String {
    project(&format!("fixtures/{application}/data"))
        .to_str()
        .unwrap()
        .to_owned()
}

fn write(folder: &Path, path: &str, text: &str) {
    let path = folder.join(path);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

fn report(folder: &Path, args: &[&str]) -> Value {
    let output = mhlint(folder, &[args, &["--report", "json"]].concat());
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", stderr(&output)))
}

/// Rule, path, and the applications with the level in each.
fn found(report: &Value) -> Vec<String> {
    let row = |finding: &Value| {
        let breaks = finding["breaks"].as_array().unwrap().iter();
        let breaks: Vec<String> = breaks
            .map(|one| {
                format!(
                    "{} {}",
                    one["application"].as_str().unwrap(),
                    one["level"].as_str().unwrap()
                )
            })
            .collect();
        let [rule, path] = ["rule", "path"].map(|key| finding[key].as_str().unwrap());
        format!("{rule} {path}: {}", breaks.join(", "))
    };
    report["findings"]
        .as_array()
        .unwrap()
        .iter()
        .map(row)
        .collect()
}

/// The applications with their verdicts.
fn verdicts(report: &Value) -> Vec<String> {
    let word = |one: &Value, key: &str| one[key].as_str().unwrap().to_owned();
    let all = report["applications"].as_array().unwrap().iter();
    all.map(|one| format!("{} {}", word(one, "application"), word(one, "verdict")))
        .collect()
}

/// What was not checked, without what no rule is about.
fn unchecked(report: &Value) -> Vec<String> {
    let word = |one: &Value, key: &str| one[key].as_str().unwrap_or_default().to_owned();
    let all = report["not_checked"].as_array().unwrap().iter();
    let all = all.map(|one| format!("{} {}", word(one, "application"), word(one, "what")));
    all.filter(|one| !one.ends_with(" kind")).collect()
}

const BOTH: [&str; 2] = ["makehuman1 pass", "makehuman2 pass"];

fn sorted(mut all: Vec<String>) -> Vec<String> {
    all.sort();
    all
}

#[test]
fn a_sound_asset_is_silent_over_the_data_of_its_application() {
    for (application, from) in [
        ("makehuman2", "data/clothes/figure/shirt"),
        ("makehuman2", "data/clothes/figure/kilt"),
        ("makehuman2", "data/eyes/figure/beads"),
        ("makehuman2", "data/proxy/figure"),
        ("makehuman2", "data/rigs/figure"),
        ("makehuman2", "data/poses/figure"),
        ("makehuman2", "data/expressions/figure"),
        ("makehuman2", "data/skins/figure"),
        ("makehuman2", "data/models/figure"),
        ("makehuman1", "data/clothes/shirt"),
        ("makehuman1", "data/hair/curls"),
        ("makehuman1", "data/eyes/high-poly"),
        ("makehuman1", "user/data/clothes/kilt"),
        ("makehuman1", "user/data/skins/copper"),
        ("makehuman1", "user/data/poses"),
    ] {
        let folder = shirt_of(application, from);
        let found_over = report(
            folder.path(),
            &["my-shirt", "--system", &system(application)],
        );
        assert_eq!(found(&found_over), Vec::<String>::new(), "{from}");
        assert_eq!(unchecked(&found_over), Vec::<String>::new(), "{from}");
        assert_eq!(
            verdicts(&found_over),
            [format!("{application} pass")],
            "{from}"
        );
    }
}

#[test]
fn an_asset_alone_is_checked_for_both_and_what_needs_the_base_mesh_is_said_once() {
    let folder = shirt();
    let alone = report(
        folder.path(),
        &["my-shirt", "--only", "proxy-*", "--only", "mesh-*"],
    );
    assert_eq!(
        (found(&alone), sorted(verdicts(&alone))),
        (vec![], BOTH.map(str::to_owned).to_vec())
    );
    assert!(
        unchecked(&alone).contains(&"makehuman2 no-base-mesh".to_owned()),
        "{:?}",
        unchecked(&alone)
    );
    let output = mhlint(folder.path(), &["my-shirt"]);
    let text = stdout(&output).replace('\n', " ");
    assert_eq!(code(&output), Some(0), "{text}");
    assert_eq!(
        text.matches("vertex numbers in 1 .mhclo clothes file (no base mesh")
            .count(),
        1,
        "{text}"
    );
    assert!(
        !text.contains("clothes/hm08") && !text.contains("clothes/figure"),
        "a supposed place is named: {text}"
    );
}

#[test]
fn the_applications_are_those_asked_for_else_those_of_the_system() {
    let folder = shirt();
    let of = |args: &[&str]| verdicts(&report(folder.path(), args));
    assert_eq!(
        of(&["my-shirt", "--app", "makehuman1"]),
        ["makehuman1 pass"]
    );
    assert_eq!(
        of(&["my-shirt", "--system", &system("makehuman1")]),
        ["makehuman1 pass"]
    );
    assert_eq!(
        of(&["my-shirt", "--system", &system("makehuman2")]),
        ["makehuman2 pass"]
    );
    write(folder.path(), "mhlint.toml", "apps = [\"makehuman2\"]\n");
    assert_eq!(of(&["my-shirt"]), ["makehuman2 pass"]);
}

#[test]
fn what_is_made_for_another_application_is_not_held_against_one_that_nobody_named() {
    let folder = shirt();
    edit(
        folder.path(),
        "my-shirt/shirt.mhclo",
        "basemesh figure",
        "basemesh mh2bot",
    );
    let of = |args: &[&str]| verdicts(&report(folder.path(), args));
    assert_eq!(of(&["my-shirt"]), ["makehuman2 pass"]);
    assert_eq!(
        of(&["my-shirt", "--app", "makehuman1"]),
        ["makehuman1 pass"]
    );
    let nod = project("fixtures/makehuman2/data/poses/figure");
    copy_folder(&nod, &folder.path().join("nod"));
    assert_eq!(of(&["nod"]), ["makehuman2 pass"]);
    let over = mhlint(folder.path(), &["nod", "--system", &system("makehuman1")]);
    assert_eq!(code(&over), Some(1), "{}", stdout(&over));
    assert!(
        stdout(&over).contains("pose-unknown-bone"),
        "{}",
        stdout(&over)
    );
}

#[test]
fn a_fault_of_both_applications_is_one_finding() {
    let folder = shirt();
    edit(
        folder.path(),
        "my-shirt/shirt.mhmat",
        "shirt.png",
        "lost.png",
    );
    let alone = report(
        folder.path(),
        &["my-shirt", "--only", "material-missing-texture"],
    );
    let both =
        "material-missing-texture my-shirt/shirt.mhmat: makehuman2 warning, makehuman1 warning";
    assert_eq!(found(&alone), [both]);
    assert_eq!(
        code(&mhlint(folder.path(), &["my-shirt"])),
        Some(0),
        "a warning"
    );
    // A row that is no row.
    edit(
        folder.path(),
        "my-shirt/shirt.mhclo",
        "verts 0\n",
        "verts 0\n1 2 3\n",
    );
    let broken = report(folder.path(), &["my-shirt", "--only", "proxy-*"]);
    assert!(
        found(&broken)
            .iter()
            .any(|one| one.contains("makehuman2 error, makehuman1 error")),
        "{broken:#}"
    );
    assert_eq!(
        sorted(verdicts(&broken)),
        ["makehuman1 fail", "makehuman2 fail"]
    );
    assert_eq!(code(&mhlint(folder.path(), &["my-shirt"])), Some(1));
    let fingerprints: std::collections::BTreeSet<String> = broken["findings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["fingerprint"].to_string())
        .collect();
    assert_eq!(
        fingerprints.len(),
        broken["findings"].as_array().unwrap().len()
    );
}

#[test]
fn an_asset_is_measured_against_the_base_mesh_of_the_system() {
    let folder = shirt();
    edit(
        folder.path(),
        "my-shirt/shirt.mhclo",
        "verts 0\n",
        "verts 0\n99999\n",
    );
    let over = mhlint(
        folder.path(),
        &[
            "my-shirt",
            "--system",
            &system("makehuman2"),
            "--report",
            "concise",
        ],
    );
    assert_eq!(code(&over), Some(1), "{}", stdout(&over));
    assert!(
        stdout(&over).contains("error[proxy-vertex-out-of-range]"),
        "{}",
        stdout(&over)
    );
    let alone = mhlint(folder.path(), &["my-shirt", "--report", "concise"]);
    assert!(
        !stdout(&alone).contains("proxy-vertex-out-of-range"),
        "{}",
        stdout(&alone)
    );
    // The header says `figure`; who asks for another base gets that, and one that nobody has is
    // refused.
    edit(
        folder.path(),
        "my-shirt/shirt.mhclo",
        "basemesh figure",
        "basemesh nobody",
    );
    let other = report(
        folder.path(),
        &["my-shirt", "--system", &system("makehuman2")],
    );
    assert_eq!(unchecked(&other), ["makehuman2 base-not-in-system"]);
    let words = stdout(&mhlint(
        folder.path(),
        &["my-shirt", "--system", &system("makehuman2")],
    ))
    .replace('\n', " ");
    assert!(
        words.contains("1 .mhclo clothes file (its base mesh is not in the system data)"),
        "{words}"
    );
    assert_ne!(
        code(&mhlint(folder.path(), &["my-shirt", "--base", "nobody"])),
        Some(2),
        "it says what it is for"
    );
    let asked = [
        "my-shirt",
        "--system",
        &system("makehuman2"),
        "--base",
        "figure",
        "--report",
        "concise",
    ];
    assert!(stdout(&mhlint(folder.path(), &asked)).contains("proxy-vertex-out-of-range"));
    assert_refused(
        &mhlint(
            folder.path(),
            &[
                "my-shirt",
                "--system",
                &system("makehuman2"),
                "--base",
                "nobody",
            ],
        ),
        &["nobody"],
    );
}

#[test]
fn one_file_brings_what_belongs_to_it_and_nothing_else() {
    let folder = shirt();
    let shirt = folder.path().join("my-shirt");
    fs::create_dir(shirt.join("textures")).unwrap();
    fs::rename(shirt.join("shirt.png"), shirt.join("textures/shirt.png")).unwrap();
    edit(
        folder.path(),
        "my-shirt/shirt.mhmat",
        "shirt.png",
        "textures/shirt.png",
    );
    write(
        folder.path(),
        "my-shirt/other.mhclo",
        "name other\nobj_file lost.obj\n1 2 3\n",
    );
    let named = report(
        folder.path(),
        &["my-shirt/shirt.mhclo", "--system", &system("makehuman2")],
    );
    assert_eq!((found(&named), unchecked(&named)), (vec![], vec![]));
    assert!(
        named["summary"]["files"].as_u64().unwrap() >= 5,
        "{}",
        named["summary"]
    );
    edit(
        folder.path(),
        "my-shirt/shirt.mhmat",
        "textures/shirt.png",
        "textures/lost.png",
    );
    let named = report(
        folder.path(),
        &["my-shirt/shirt.mhclo", "--system", &system("makehuman2")],
    );
    assert_eq!(
        found(&named),
        ["material-missing-texture my-shirt/shirt.mhmat: makehuman2 warning"]
    );
    assert_eq!(
        code(&mhlint(folder.path(), &["my-shirt/other.mhclo"])),
        Some(1)
    );
}

#[test]
fn every_asset_of_a_folder_stands_alone() {
    let folder = shirt();
    // An equal copy of an asset is no matter of files in no library.
    copy_folder(
        &folder.path().join("my-shirt"),
        &folder.path().join("old/my-shirt"),
    );
    copy_folder(
        &project("fixtures/makehuman2/data/eyes/figure"),
        &folder.path().join("beads"),
    );
    let all = report(folder.path(), &[".", "--system", &system("makehuman2")]);
    assert_eq!((found(&all), unchecked(&all)), (vec![], vec![]));
    edit(
        folder.path(),
        "old/my-shirt/shirt.mhmat",
        "shirt.png",
        "lost.png",
    );
    let all = report(
        folder.path(),
        &[
            ".",
            "--system",
            &system("makehuman2"),
            "--skip",
            "library-*",
        ],
    );
    assert_eq!(
        found(&all),
        ["material-missing-texture old/my-shirt/shirt.mhmat: makehuman2 warning"]
    );
}

#[test]
fn names_lead_through_the_folder_that_was_given() {
    let folder = shirt();
    let shirt = folder.path().join("my-shirt");
    fs::create_dir_all(folder.path().join("shared/pictures")).unwrap();
    for (file, to) in [
        ("shirt.mhmat", "shared/shirt.mhmat"),
        ("shirt.png", "shared/pictures/shirt.png"),
    ] {
        fs::rename(shirt.join(file), folder.path().join(to)).unwrap();
    }
    edit(
        folder.path(),
        "my-shirt/shirt.mhclo",
        "material shirt.mhmat",
        "material ../shared/shirt.mhmat",
    );
    edit(
        folder.path(),
        "shared/shirt.mhmat",
        "shirt.png",
        "pictures/shirt.png",
    );
    edit(
        folder.path(),
        "shared/shirt.mhmat",
        "shirt_folds.png",
        "../my-shirt/shirt_folds.png",
    );
    let args = [
        "--system",
        &system("makehuman2"),
        "--skip",
        "material-unused-texture",
    ];
    let all = report(folder.path(), &[&["."], &args[..]].concat());
    assert_eq!(found(&all), Vec::<String>::new());
    fs::remove_file(folder.path().join("shared/pictures/shirt.png")).unwrap();
    let all = report(folder.path(), &[&["."], &args[..]].concat());
    assert_eq!(
        found(&all),
        ["material-missing-texture shared/shirt.mhmat: makehuman2 warning"]
    );
}

#[test]
fn poses_of_the_body_and_of_the_face_are_told_apart_by_their_units() {
    let folder = tempfile::tempdir().unwrap();
    for from in ["poses/figure/lean", "expressions/figure/puzzled"] {
        for extension in ["mhpose", "thumb"] {
            let file = project(&format!("fixtures/makehuman2/data/{from}.{extension}"));
            fs::copy(&file, folder.path().join(file.file_name().unwrap())).unwrap();
        }
    }
    let all = report(folder.path(), &[".", "--system", &system("makehuman2")]);
    assert_eq!((found(&all), unchecked(&all)), (vec![], vec![]));
}

#[test]
fn a_library_of_another_application_is_checked_where_that_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(
        &project("fixtures/makehuman2/data/clothes/figure/shirt"),
        &folder.path().join("clothes/shirt"),
    );
    let of = |args: &[&str]| verdicts(&report(folder.path(), args));
    assert_eq!(of(&["clothes/shirt"]), ["makehuman1 pass"], "by its layout");
    assert_eq!(
        of(&["clothes/shirt", "--app", "makehuman2"]),
        ["makehuman2 pass"]
    );
    assert_eq!(
        of(&[".", "--system", &system("makehuman2")]),
        ["makehuman2 pass"],
        "whose data are given"
    );
    assert_eq!(
        of(&[".", "--system", &system("makehuman1")]),
        ["makehuman1 pass"]
    );
}

#[test]
fn damaged_assets_are_findings_and_other_files_are_none() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "a/a.mhclo", "");
    write(
        folder.path(),
        "b/b.mhclo",
        "\u{0}\u{1}verts\nobj_file ../../../../../etc/passwd\nmaterial b.mhmat\n1 2\n",
    );
    write(
        folder.path(),
        "b/b.mhmat",
        "diffuseTexture ../../../x.png\n",
    );
    write(folder.path(), "walk.bvh", "HIERARCHY\n");
    write(folder.path(), "model.proxy", "a config\n");
    write(folder.path(), "package.json", "{ // broken\n");
    let all = report(folder.path(), &["."]);
    assert!(
        found(&all)
            .iter()
            .any(|one| one.starts_with("file-empty a/a.mhclo")),
        "{:?}",
        found(&all)
    );
    assert!(
        found(&all)
            .iter()
            .all(|one| one.contains(" a") || one.contains(" b/")),
        "{:?}",
        found(&all)
    );
    assert_eq!(
        code(&mhlint(folder.path(), &["walk.bvh"])),
        Some(1),
        "who names a file wants to hear of it"
    );
    assert_eq!(code(&mhlint(folder.path(), &["package.json"])), Some(3));
}

/// A file of each kind in no data folder, with what is wrong in it: over the data of its
/// application, asked for by name or not, it is checked for that one, and with neither for those
/// that may be meant.
#[test]
fn a_loose_file_of_any_kind_is_checked_for_who_is_meant() {
    let skeleton = r#"{"name": "x", "bones": {"root": {"head": "a", "tail": "b", "parent": null}}, "joints": {"a": [99999], "b": [1]}}"#;
    let weights = r#"{"name": "x", "version": 1, "weights": {"root": [[0, 1.0], [99999, 1.0]]}}"#;
    for (application, file, text, rule, alone) in [
        (
            "makehuman1",
            "far.target",
            "0 0.1 0 0\n99999 0.1 0 0\n",
            "target-vertex-out-of-range",
            2,
        ),
        (
            "makehuman1",
            "rig.mhskel",
            skeleton,
            "skeleton-joint-out-of-range",
            2,
        ),
        (
            "makehuman1",
            "ann.mhm",
            "version v1.3.0\nmodifier head/head-oval abc\n",
            "model-modifier",
            1,
        ),
        (
            "makehuman1",
            "rig.mhw",
            weights,
            "weights-vertex-out-of-range",
            2,
        ),
        (
            "makehuman1",
            "step.bvh",
            "HIERARCHY\nROOT upperleg02.L\n{\n",
            "bvh-syntax",
            2,
        ),
        (
            "makehuman1",
            "smile.mhpose",
            "{\"name\": \"smile\", \"unit_poses\": {\"nobody\": 0.5}}",
            "pose-unknown-unit",
            1,
        ),
        (
            "mpfb",
            "far.target",
            "0 0.1 0 0\n99999 0.1 0 0\n",
            "target-vertex-out-of-range",
            2,
        ),
        (
            "mpfb",
            "ue5.json",
            "{\"identifying_bones\": [], \"bones\": 5}",
            "",
            1,
        ),
        (
            "mpfb",
            "ann.mhm",
            "name ann\nmodifier head/head-oval abc\n",
            "model-modifier",
            2,
        ),
        (
            "makehuman2",
            "far.target",
            "# basemesh figure\n99999 0.1 0 0\n",
            "target-vertex-out-of-range",
            1,
        ),
        (
            "makehuman2",
            "rig.mhskel",
            skeleton,
            "skeleton-joint-out-of-range",
            2,
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        write(folder.path(), file, text);
        let system = system(application);
        for args in [
            &[file, "--system", &system][..],
            &[file, "--app", application, "--system", &system],
            &[".", "--app", application, "--system", &system],
            &[file, "--app", application],
        ] {
            let report = report(folder.path(), args);
            let own: Vec<String> = verdicts(&report)
                .iter()
                .map(|one| one.split(' ').next().unwrap().to_owned())
                .collect();
            let is_found = found(&report).iter().any(|one| one.starts_with(rule));
            assert!(own == [application], "{args:?}: {own:?}");
            assert!(
                is_found || !args.contains(&"--system"),
                "{args:?}: {:?}",
                found(&report)
            );
        }
        let verdicts = verdicts(&report(folder.path(), &[file]));
        assert_eq!(verdicts.len(), alone, "{application} {file}: {verdicts:?}");
    }
}

#[test]
fn init_beside_assets_proposes_settings_that_fit() {
    let folder = shirt();
    let output = mhlint(&folder.path().join("my-shirt"), &["init"]);
    assert!(
        stdout(&output).contains("MakeHuman 2 and MakeHuman 1, without system data"),
        "{}",
        stdout(&output)
    );
    let text = fs::read_to_string(folder.path().join("my-shirt/mhlint.toml")).unwrap();
    assert!(
        text.contains("\napps = [\"makehuman2\", \"makehuman1\"]\n"),
        "{text}"
    );
    assert!(text.contains("\n#system = "), "{text}");
    fs::remove_file(folder.path().join("my-shirt/mhlint.toml")).unwrap();
    copy_folder(
        &project("fixtures/makehuman2/data"),
        &folder.path().join("MakeHuman data/data"),
    );
    assert_eq!(code(&mhlint(folder.path(), &["init", "my-shirt"])), Some(0));
    let text = fs::read_to_string(folder.path().join("my-shirt/mhlint.toml")).unwrap();
    assert!(text.contains("\napps = [\"makehuman2\"]\n"), "{text}");
    assert!(
        text.contains("\nsystem = \"../MakeHuman data/data\"\n"),
        "{text}"
    );
    let settled = report(&folder.path().join("my-shirt"), &["."]);
    assert_eq!((found(&settled), unchecked(&settled)), (vec![], vec![]));
    // In data folders it is as it was.
    let output = mhlint(&folder.path().join("MakeHuman data/data"), &["init"]);
    assert!(
        stdout(&output).contains("all settings, explained and commented out"),
        "{}",
        stdout(&output)
    );
}

/// Weights and meshes are checked as parts of an asset: "no rules yet" would be wrong of them.
#[test]
fn parts_of_no_asset_are_said_to_be_such() {
    let folder = shirt_of("makehuman1", "data/hair/curls");
    let part = folder.path().join("my-shirt/curls.mhw");
    fs::remove_file(folder.path().join("my-shirt/curls.mhclo")).unwrap();
    assert!(part.exists());
    let output = mhlint(folder.path(), &["my-shirt", "--app", "makehuman1"]);
    let text = stdout(&output);
    assert!(
        text.contains("1 .mhw, 1 .obj (part of nothing that was checked)"),
        "{text}"
    );
    let output = mhlint(
        folder.path(),
        &["my-shirt/curls.mhw", "--app", "makehuman1"],
    );
    assert!(
        stderr(&output).contains("these files are parts of assets"),
        "{}",
        stderr(&output)
    );
}
