//! `mhlint eval` through the real binary.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use crate::scratch::pack::packed;
use crate::scratch::{copy_folder, corpus, mhlint, project, stderr, stdout};
use serde_json::{Value, json};

const DATA: &str = "fixtures/makehuman2/data";

fn eval(args: &[&str]) -> Output {
    let all: Vec<&str> = ["eval"].iter().chain(args).copied().collect();
    mhlint(&project("."), &all)
}

fn json_of(output: &Output) -> Value {
    assert_eq!(output.status.code(), Some(0), "{}", stderr(output));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn error_of(args: &[&str]) -> String {
    let output = eval(args);
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(output.stdout.is_empty(), "{text}");
    text
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

const EXAMPLE: [&str; 6] = [
    "--set",
    "macrodetails/Gender=0.75",
    "--set",
    "macrodetails/Age=0.5",
    "--set",
    "macrodetails-universal/Muscle=0.25",
];

#[test]
fn worked_example_of_the_documentation() {
    let mut args = vec!["macros", DATA];
    args.extend(EXAMPLE);
    let report = json_of(&eval(&args));
    assert_eq!(
        (&report["format"], &report["kind"]),
        (&json!("mhlint-eval/1"), &json!("macros"))
    );
    let combinations = report["outputs"]["combinations"].as_array().unwrap();
    let found: Vec<Value> = combinations
        .iter()
        .filter(|combination| combination["macrodef"] == 1)
        .map(|c| json!([c["name"], c["factor"], c["fate"]]))
        .collect();
    let expected = json!([
        ["female-adult-minmuscle", 0.125, "applied"],
        ["female-adult-averagemuscle", 0.125, "null"],
        ["male-adult-minmuscle", 0.375, "applied"],
        ["male-adult-averagemuscle", 0.375, "applied"],
    ]);
    assert_eq!(Value::from(found), expected);
}

#[test]
fn keys_of_modelling_json_name_sliders_too() {
    let by_key = json_of(&eval(&[
        "macros",
        DATA,
        "--set",
        "Gender=0.75",
        "--set",
        "age=0.3",
    ]));
    let by_pattern = json_of(&eval(&[
        "macros",
        DATA,
        "--set",
        "macrodetails/Gender=0.75",
        "--set",
        "macrodetails/Age=0.3",
    ]));
    assert_eq!(by_key["outputs"], by_pattern["outputs"]);
}

#[test]
fn a_component_above_its_last_step_is_reported_with_its_reason() {
    let report = json_of(&eval(&["macros", DATA, "--set", "macrodetails/Age=1.5"]));
    let dropped = &report["outputs"]["dropped_components"];
    assert_eq!(dropped[0]["component"], "age");
    assert!(
        dropped[0]["reason"]
            .as_str()
            .unwrap()
            .contains("above the last step")
    );
}

#[test]
fn errors_name_the_nearest() {
    assert!(
        error_of(&["mesh", DATA, "--set", "head/head-size-decr|inc=1"])
            .contains("`head/head-size-decr|incr`?")
    );
    assert!(error_of(&["mesh", DATA, "--base", "figur"]).contains("did you mean `figure`?"));
    assert!(error_of(&["macros", DATA, "--set", "Gender"]).contains("NAME=VALUE"));
    assert!(error_of(&["macros", DATA, "--set", "Gender=much"]).contains("not a number"));
    assert!(
        error_of(&["mesh", "fixtures/rules"])
            .contains("contains no MakeHuman 2, MakeHuman 1 or MPFB data")
    );
    assert!(error_of(&["mesh", "nowhere"]).contains("nowhere"));
    assert!(
        error_of(&["mesh", DATA, "-o", "nowhere/out.obj"])
            .contains("folder `nowhere` does not exist")
    );
}

/// A copy of the example's data folder.
fn copy() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(&project(DATA), folder.path());
    folder
}

#[test]
fn a_target_that_is_missing_or_damaged_matters_only_when_it_is_used() {
    let folder = copy();
    let target = folder
        .path()
        .join("target/figure/head/head-size-incr.target");
    let root = text(folder.path());
    let moved = [
        "mesh",
        root,
        "--format",
        "json",
        "--set",
        "head/head-size-decr|incr=0.5",
    ];
    fs::write(&target, "0 0.1 zero 0\n").unwrap();
    let message = error_of(&moved);
    assert!(
        message.contains("head-size-incr.target")
            && message.contains("line 1: `zero` is not a number"),
        "{message}"
    );
    fs::remove_file(&target).unwrap();
    assert!(
        error_of(&moved)
            .contains("this setting needs target `head/head-size-incr`, which does not exist")
    );
    json_of(&eval(&[
        "mesh",
        root,
        "--format",
        "json",
        "--set",
        "head/head-size-decr|incr=-0.5",
    ]));
}

#[test]
fn a_written_mesh_reloads_to_the_same_coordinates() {
    let folder = copy();
    let root = text(folder.path());
    let mesh = folder.path().join("base/figure/base.obj");
    let before = fs::read_to_string(&mesh).unwrap();
    let set = [
        "--set",
        "head/head-size-decr|incr=-0.5",
        "--set",
        "macrodetails/Gender=0.9",
    ];
    let morphed = json_of(&eval(
        &[
            &["mesh", root, "--format", "json", "--vertices", "0,17,100"],
            &set[..],
        ]
        .concat(),
    ));
    assert_eq!(
        eval(&[&["mesh", root, "-o", text(&mesh)], &set[..]].concat())
            .status
            .code(),
        Some(0)
    );
    let after = fs::read_to_string(&mesh).unwrap();
    let others = |text: &str| {
        text.lines()
            .filter(|line| !line.starts_with("v "))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(others(&before), others(&after));
    assert_ne!(before, after);
    // Without macros and details the written mesh stands as it is.
    fs::remove_file(folder.path().join("target/figure/macro.json")).unwrap();
    let reloaded = json_of(&eval(&[
        "mesh",
        root,
        "--format",
        "json",
        "--vertices",
        "0,17,100",
    ]));
    assert_eq!(
        reloaded["outputs"]["vertices"],
        morphed["outputs"]["vertices"]
    );
    assert_eq!(reloaded["outputs"]["bbox"], morphed["outputs"]["bbox"]);
}

#[test]
fn a_packed_mesh_is_evaluated_in_place_of_the_obj() {
    let folder = copy();
    let root = text(folder.path());
    let [mesh, archive] =
        ["base.obj", "base.mhbin"].map(|name| folder.path().join("base/figure").join(name));
    let morphed = |more: &[&str]| {
        let set = [
            "mesh",
            root,
            "--set",
            "head/head-size-decr|incr=-0.5",
            "--set",
            "macrodetails/Gender=0.9",
        ];
        stdout(&eval(&[&set, more].concat()))
    };
    let json = ["--format", "json", "--vertices", "0,17,100"];
    let before = [morphed(&json), morphed(&[])];
    fs::write(&archive, packed(&fs::read(&mesh).unwrap())).unwrap();
    for broken in ["v 1 2 3\nv x\n", "v 1 2 3\nv 4 5 6\nv 7 8 9\nf 1 2 3\n"] {
        fs::write(&mesh, broken).unwrap();
        assert_eq!(morphed(&json), before[0]);
    }
    fs::remove_file(&mesh).unwrap();
    let vertices = |text: &str| {
        text.lines()
            .filter(|line| line.starts_with("v "))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(vertices(&morphed(&[])), vertices(&before[1]));
    fs::write(&archive, "not a zip\n").unwrap();
    assert!(error_of(&["mesh", root, "--base", "figure"]).contains("unknown base mesh `figure`"));
    fs::copy(project(DATA).join("base/figure/base.obj"), &mesh).unwrap();
    assert!(error_of(&["mesh", root, "--base", "figure"]).contains("base.mhbin"));
}

#[test]
fn written_weights_reload_to_the_same_weights() {
    let folder = tempfile::tempdir().unwrap();
    let (once, twice) = (folder.path().join("a.mhw"), folder.path().join("b.mhw"));
    let skeleton = format!("{DATA}/rigs/figure/default.mhskel");
    let file = format!("{DATA}/rigs/figure/default_weights.mhw");
    let first = json_of(&eval(&[
        "weights",
        &file,
        "--skeleton",
        &skeleton,
        "-o",
        text(&once),
    ]));
    let second = json_of(&eval(&[
        "weights",
        text(&once),
        "--skeleton",
        &skeleton,
        "-o",
        text(&twice),
    ]));
    assert!(!first["outputs"]["bones"].as_object().unwrap().is_empty());
    assert_eq!(first["outputs"]["bones"], second["outputs"]["bones"]);
    let weights =
        |path: &Path| -> Value { serde_json::from_slice(&fs::read(path).unwrap()).unwrap() };
    assert_eq!(weights(&once)["weights"], weights(&twice)["weights"]);
    let reduced = json_of(&eval(&[
        "weights",
        &file,
        "--skeleton",
        &skeleton,
        "--max-influences",
        "1",
    ]));
    assert_eq!(reduced["outputs"]["vertex_sum_range"], json!([1.0, 1.0]));
}

#[test]
fn the_rest_pose_gives_the_mesh_back() {
    let folder = tempfile::tempdir().unwrap();
    let pose = folder.path().join("pose.json");
    fs::write(&pose, "{}").unwrap();
    let chosen = ["--vertices", "0,50,100,150"];
    let rest = json_of(&eval(&[&["mesh", DATA], &chosen[..]].concat()));
    let skinned = json_of(&eval(
        &[&["skin", DATA, "--pose", text(&pose)], &chosen[..]].concat(),
    ));
    let numbers = |value: &Value| -> Vec<f64> {
        let points = value["outputs"]["vertices"].as_array().unwrap().iter();
        points
            .flat_map(|point| point.as_array().unwrap())
            .map(|x| x.as_f64().unwrap())
            .collect()
    };
    for (a, b) in numbers(&rest).iter().zip(numbers(&skinned)) {
        assert!((a - b).abs() < 1e-4, "{a} {b}");
    }
    fs::write(
        &pose,
        r#"{"neck": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "nek": []}"#,
    )
    .unwrap();
    assert!(error_of(&["skin", DATA, "--pose", text(&pose)]).contains("`nek` is not three rows"));
}

#[test]
fn an_exact_asset_lies_on_the_base_mesh() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("x.obj"),
        "v 9 9 9\nv 9 9 9\nv 9 9 9\nf 1 2 3\n",
    )
    .unwrap();
    let asset = folder.path().join("x.mhclo");
    fs::write(
        &asset,
        "name x\nobj_file x.obj\nverts 0\n3\n7\n3 7 9 0.5 0.5 0 0 1 0\n",
    )
    .unwrap();
    let mesh = json_of(&eval(&["mesh", DATA, "--vertices", "3,7"]));
    let vertices = |value: &Value| value["outputs"]["vertices"].clone();
    let fitted = json_of(&eval(&[
        "fit",
        text(&asset),
        "--base-mesh",
        DATA,
        "--vertices",
        "0,1",
    ]));
    assert_eq!(vertices(&fitted), vertices(&mesh));
    let plain = format!("{DATA}/base/figure/base.obj");
    assert!(
        error_of(&["fit", text(&asset), "--base-mesh", &plain, "--set", "a=1"])
            .contains("an OBJ file has no sliders")
    );
    let obj = eval(&["fit", text(&asset), "--base-mesh", &plain]);
    assert!(stdout(&obj).ends_with("\nf 1 2 3\n"));
    fs::write(&asset, "name x\nobj_file x.obj\nverts 0\n3 4\n").unwrap();
    assert!(error_of(&["fit", text(&asset), "--base-mesh", DATA]).contains("line 4"));
}

/// The worked formula of MakeHuman 1: `p = w0·H[v0] + w1·H[v1] + w2·H[v2] + M·d`.
#[test]
fn makehuman1_fits_by_its_own_scales_and_shears() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("base.obj", "v 0 0 0\nv 2 0 0\nv 0 4 0\nv 0 0 8\nf 1 2 3\n");
    write("x.obj", "v 9 9 9\nv 9 9 9\nv 9 9 9\nf 1 2 3\n");
    let (asset, base) = (
        folder.path().join("x.mhclo"),
        folder.path().join("base.obj"),
    );
    let fit = |lines: &str, rows: &str| {
        write(
            "x.mhclo",
            &format!("name x\nuuid 1\nobj_file x.obj\n{lines}verts 0\n{rows}\n"),
        );
        let args = [
            "fit",
            text(&asset),
            "--app",
            "makehuman1",
            "--base-mesh",
            text(&base),
        ]
        .map(str::to_owned);
        args.into_iter().collect::<Vec<String>>()
    };
    let numbers = |args: &[String], key: &str| {
        let args: Vec<&str> = args
            .iter()
            .map(String::as_str)
            .chain(["--vertices", "0,1,2"])
            .collect();
        json_of(&eval(&args))["outputs"][key].clone()
    };
    let rows = "1 2 3 0.5 0.25 0.25 0.1 0.2 0.3\n0\n3 2 1 1 0 0";
    let scaled = fit("x_scale 0 1 1\ny_scale 0 2 8\nz_scale 0 3 -4\n", rows);
    assert_eq!(
        numbers(&scaled, "scale"),
        serde_json::json!([2.0, 0.5, -2.0])
    );
    assert_eq!(
        numbers(&scaled, "vertices"),
        serde_json::json!([[1.2, 1.1, 1.4], [0.0, 0.0, 0.0], [0.0, 0.0, 8.0]])
    );
    let sheared = fit("shear_x 1 0 1 0\nshear_y 2 0 0 2\nshear_z 3 0 4 0\n", rows);
    assert_eq!(
        numbers(&sheared, "scale"),
        serde_json::json!([2.0, -2.0, 2.0])
    );
    let one = fit("", "3");
    assert_eq!(
        numbers(&one, "vertices"),
        serde_json::json!([[0.0, 0.0, 8.0], [0.0, 0.0, 8.0], [0.0, 0.0, 8.0]])
    );
    let error = |args: &[String]| error_of(&args.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(error(&fit("x_scale 0 1 1\n", rows)).contains("the scale of the y axis is missing"));
    assert!(error(&fit("", "0\n1")).contains("ValueError"));
    assert!(error(&fit("", "0\n1\n4")).contains("IndexError"));
    assert!(error(&fit("", "0\n1\n-2 1 2 1 0 0")).contains("x.mhclo"));
    let mut set = fit("", rows);
    set.extend(["--set".to_owned(), "a=1".to_owned()]);
    assert!(error(&set).contains("cannot be set yet"));
    let mut folder_only = fit("", rows);
    folder_only[5] = text(folder.path()).to_owned();
    assert!(error(&folder_only).contains("contains no `3dobjs/base.obj`"));
}

/// Cases over the example repository, with outputs as printed by mhlint itself.
fn own_cases(folder: &Path) -> (PathBuf, String) {
    let file = folder.join("cases.json");
    let cases = r#"{"kind": "mh2_macro_weights",
"inputs": {"modifiers": "a list"},
"cases": [
{"name": "defaults", "inputs": {"modifiers": []}, "outputs": {"sum": 0}},
{"name": "some", "inputs": {"modifiers": [["macrodetails/Gender", 0.3], ["macrodetails/Age", NaN]]}, "outputs": {}}
]
}
"#;
    fs::write(&file, cases).unwrap();
    let output = eval(&[
        "cases",
        text(&file),
        "--root",
        &format!("makehuman2={DATA}"),
    ]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let printed = stdout(&output);
    fs::write(&file, &printed).unwrap();
    (file, printed)
}

#[test]
fn printed_cases_agree_with_themselves_and_altered_ones_do_not() {
    let folder = tempfile::tempdir().unwrap();
    let (file, printed) = own_cases(folder.path());
    assert_eq!(printed.lines().count(), 7);
    let root = format!("makehuman2={}", "fixtures/makehuman2");
    let code = |root: &str| {
        eval(&["cases", text(&file), "--compare", "--root", root])
            .status
            .code()
    };
    assert_eq!(code(&root), Some(0));
    let altered = printed.replacen("\"sum\":", "\"sum\":1", 1);
    assert_ne!(altered, printed);
    fs::write(&file, altered).unwrap();
    assert_eq!(code(&root), Some(1));
}

#[test]
fn cases_that_cannot_be_computed_say_why() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("cases.json");
    let run = |content: &str, more: &[&str]| {
        fs::write(&file, content).unwrap();
        let output = eval(&[&["cases", text(&file)], more].concat());
        (output.status.code(), stderr(&output))
    };
    let (code, message) = run(r#"{"kind": "mpfb_hair", "cases": []}"#, &[]);
    assert!(
        code == Some(2) && message.contains("`mpfb_hair` are not supported"),
        "{message}"
    );
    let (code, message) = run(r#"{"kind": "mh2_fit", "cases": []}"#, &["--compare"]);
    assert!(
        code == Some(2) && message.contains("`cases` list is empty"),
        "{message}"
    );
    let no_fields =
        r#"{"kind": "mh2_fit", "cases": [{}, 7, {"name": "x", "inputs": {"modifiers": [[1]]}}]}"#;
    let (code, message) = run(no_fields, &[]);
    assert!(
        code == Some(2) && message.contains("`inputs.modifiers`"),
        "{message}"
    );
    let file_only = r#"{"kind": "mh2_weights", "cases": [{"name": "x", "inputs": {"file": "base/a.mhw", "root": "r", "vertex_count": 3}}]}"#;
    let (code, message) = run(file_only, &["--compare"]);
    assert_eq!(code, Some(2), "{message}");
    let (_, message) = run(file_only, &[]);
    assert!(message.contains("--root makehuman-assets=DIR"), "{message}");
    for broken in [
        "",
        "[]",
        "{}",
        r#"{"kind": "mh2_morph"}"#,
        r#"{"kind": "mh2_morph", "cases": 3}"#,
    ] {
        assert_eq!(run(broken, &[]).0, Some(2), "{broken}");
    }
}

#[test]
fn exceptions_of_the_application_are_outputs() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("cases.json");
    let wanted = [
        ("[]", "AttributeError"),
        (r#"{"a": [[0, 1], [9, 1]]}"#, "IndexError"),
        (r#"{"a": [[-1, 1]]}"#, "OverflowError"),
        (r#"{"a": [[0, 1, 2]]}"#, "ValueError"),
        (r#"{"a": [[0.5, 1]]}"#, "IndexError"),
    ];
    for (weights, error) in wanted {
        let inputs = format!(r#"{{"root": "root", "vertex_count": 2, "weights": {weights}}}"#);
        let cases =
            format!(r#"{{"kind": "mh2_weights", "cases": [{{"name": "x", "inputs": {inputs}}}]}}"#);
        fs::write(&file, cases).unwrap();
        let printed = json_of(&eval(&["cases", text(&file)]));
        assert_eq!(
            printed["cases"][0]["outputs"],
            json!({ "error": error }),
            "{weights}"
        );
    }
}

/// The whole of the reference files that are computed: `MHLINT_REFERENCE` names their folder.
#[test]
#[ignore = "needs the corpora and reference files: MHLINT_CORPORA=FOLDER MHLINT_REFERENCE=FOLDER cargo test -- --ignored"]
fn reference_files_agree_within_their_tolerances() {
    let reference = std::env::var_os("MHLINT_REFERENCE")
        .map_or_else(|| project("../shared/reference"), PathBuf::from);
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(&reference).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let is_computed = ["mh2_", "mh1_", "mpfb_"]
            .iter()
            .any(|kind| name.starts_with(kind));
        if is_computed && path.extension().is_some_and(|ending| ending == "json") {
            files.insert(name, path);
        }
    }
    assert!(
        !files.is_empty(),
        "no mh2_*.json, mh1_*.json or mpfb_*.json in {}",
        reference.display()
    );
    let root = |name: &str| format!("{name}={}", corpus(name).display());
    for (name, path) in files {
        let roots = ["makehuman2", "makehuman1", "makehuman-assets", "mpfb"].map(root);
        let given = roots.iter().flat_map(|root| ["--root", root]);
        let output = eval(
            &["cases", text(&path), "--compare"]
                .into_iter()
                .chain(given)
                .collect::<Vec<_>>(),
        );
        assert_eq!(output.status.code(), Some(0), "{name}\n{}", stdout(&output));
    }
}

const MAKEHUMAN1: &str = "fixtures/makehuman1/data";

/// Each of the races has a third, and the genders a half: six targets of the young, each with a
/// sixth.
#[test]
fn macros_of_makehuman1_are_products_of_variables() {
    let outputs = json_of(&eval(&["macros", MAKEHUMAN1]))["outputs"].clone();
    assert_eq!(outputs["variables"]["young"], json!(1.0));
    assert_eq!(outputs["targets"].as_object().unwrap().len(), 6);
    assert_eq!(
        outputs["targets"]["macrodetails/asian-female-young.target"],
        json!(0.166_666_7)
    );
    let set = [
        "--set",
        "macrodetails/Age=0",
        "--set",
        "macrodetails/African=9",
        "--set",
        "macrodetails/Asian=0",
    ];
    let outputs = json_of(&eval(&[&["macros", MAKEHUMAN1][..], &set].concat()))["outputs"].clone();
    // The third that was not set counts with a third of its own.
    assert_eq!(outputs["variables"]["african"], json!(0.75));
    assert_eq!(
        outputs["targets"]["macrodetails/african-male-baby.target"],
        json!(0.375)
    );
}

/// The archive was made before the text was changed, and after it was removed.
#[test]
fn targets_of_makehuman1_are_those_of_its_archive() {
    let repository = crate::scratch::example_of("makehuman1");
    let data = text(&repository.path().join("data")).to_owned();
    let width = |of: &str| {
        let args = [
            "mesh",
            of,
            "--set",
            "head/head-oval=1",
            "--vertices",
            "337",
            "--format",
            "json",
        ];
        json_of(&eval(&args))["outputs"]["vertices"][0][0]
            .as_f64()
            .unwrap()
    };
    let sound = width(&data);
    crate::scratch::Case::read(&project(
        "fixtures/rules/target-stale-binary/bad-makehuman1",
    ))
    .apply(repository.path());
    assert!((width(&data) - sound).abs() < 1e-6, "the archive counts");
    let target = repository.path().join("data/targets/head/head-oval.target");
    fs::rename(&target, repository.path().join("kept")).unwrap();
    assert!(
        (width(&data) - sound).abs() < 1e-6,
        "without a text as well"
    );
    fs::rename(repository.path().join("kept"), &target).unwrap();
    fs::remove_file(repository.path().join("data/targets.npz")).unwrap();
    assert!(
        (width(&data) - sound - 0.001).abs() < 1e-6,
        "the text counts without an archive"
    );
}

/// As in releases, which have no texts.
#[test]
fn a_packed_mesh_of_makehuman1_is_evaluated_where_there_is_no_obj() {
    let repository = crate::scratch::example_of("makehuman1");
    let data = text(&repository.path().join("data")).to_owned();
    let outputs = |command: &[&str]| {
        let args = [
            "--set",
            "head/head-oval=1",
            "--set",
            "macrodetails/Gender=0.9",
        ];
        json_of(&eval(&[command, &[&data], &args].concat()))["outputs"].clone()
    };
    let all = || {
        [
            outputs(&["mesh", "--format", "json", "--vertices", "0,17,337,665"]),
            outputs(&["skeleton"]),
        ]
    };
    let of_text = all();
    let packed = project("fixtures/rules/program-missing-file/good-makehuman1-base-packed");
    crate::scratch::Case::read(&packed).apply(repository.path());
    assert!(!repository.path().join("data/3dobjs/base.obj").exists());
    assert_eq!(all(), of_text);
}

#[test]
fn sliders_of_makehuman1_end_at_their_range() {
    let at = |value: &str| {
        let set = format!("head/head-size-decr|incr={value}");
        json_of(&eval(&[
            "mesh", MAKEHUMAN1, "--set", &set, "--format", "json",
        ]))["outputs"]["bbox"]
            .clone()
    };
    assert_eq!(at("1"), at("5"));
    assert_ne!(at("1"), at("-1"));
    assert_ne!(at("0"), at("-1"));
    let unknown = error_of(&["mesh", MAKEHUMAN1, "--set", "head/head-size-incr=1"]);
    assert!(
        unknown.contains("did you mean `head/head-size-decr|incr`?"),
        "{unknown}"
    );
    assert!(
        json_of(&eval(&["skeleton", MAKEHUMAN1]))["outputs"]["bones"]["head"]["length"].as_f64()
            > Some(0.1)
    );
}

/// Such cases stand as lists.
#[test]
fn groups_of_targets_are_compared_and_filled_in() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("cases.json");
    let run = |case: &str, how: &[&str]| {
        fs::write(
            &file,
            format!(r#"{{"kind": "mh1_target_groups", "cases": [{case}]}}"#),
        )
        .unwrap();
        let output = eval(&[&["cases", text(&file)][..], how].concat());
        (output.status.code(), stdout(&output))
    };
    let right = r#"["head/head-old_incr.target", ["head", "head", "incr"], {"age": "old"}]"#;
    assert_eq!(run(right, &["--compare"]).0, Some(0));
    assert_eq!(
        run(&right.replace("\"incr\"", "\"decr\""), &["--compare"]).0,
        Some(1)
    );
    let filled = run(r#"["head/head-old_incr.target", [], {}]"#, &[]).1;
    assert!(
        filled.contains(r#"["head/head-old_incr.target", ["head","head","incr"], {"age":"old"}]"#),
        "{filled}"
    );
}

const MPFB: &str = "fixtures/mpfb/data";

#[test]
fn macros_of_mpfb_are_shares_of_names_and_their_products() {
    let outputs = json_of(&eval(&[
        "macros", MPFB, "--set", "age=0.2", "--set", "gender=1",
    ]))["outputs"]
        .clone();
    assert_eq!(
        outputs["components"]["gender"],
        json!([["female", 0.0], ["male", 1.0]])
    );
    assert_eq!(
        outputs["components"]["age"],
        json!([["child", 0.5999], ["young", 0.4001]])
    );
    assert_eq!(outputs["components"]["height"], json!([]));
    let targets = outputs["targets"].as_array().unwrap();
    assert!(targets.contains(&json!([
        "macrodetails/universal-male-child-averagemuscle-averageweight",
        0.149_975
    ])));
    // A part with one name at both ends has the share of the end alone: of two for one name the
    // last counts.
    // The breast is that of a woman, whatever the gender.
    assert!(targets.contains(&json!([
        "breast/female-child-averagemuscle-averageweight-maxcup-averagefirmness",
        0.037_493_75
    ])));
    assert_eq!(outputs["targets_without_file"], json!([]));
    assert!(error_of(&["macros", MPFB, "--set", "agee=1"]).contains("did you mean `age`?"));
}

/// The vertex 0 of the cube, which the slider and all macro targets move.
fn corner(root: &str, set: &[&str]) -> Vec<f64> {
    let mut args = vec!["mesh", root, "--format", "json", "--vertices", "0"];
    // No age, no gender: no macro target.
    for setting in ["age=2", "gender=2"].iter().chain(set) {
        args.extend(["--set", setting]);
    }
    let vertex = json_of(&eval(&args))["outputs"]["vertices"][0].clone();
    serde_json::from_value(vertex).unwrap()
}

#[test]
fn sliders_of_mpfb_end_at_the_whole_target() {
    assert_eq!(corner(MPFB, &[]), [-1.0, -1.0, -1.0]);
    let up = corner(MPFB, &["nose/nose-hump-decr-incr=1"]);
    assert_ne!(up, corner(MPFB, &[]));
    assert_eq!(up, corner(MPFB, &["nose_nose_hump_decr_incr=3"]));
    assert_ne!(up, corner(MPFB, &["nose/nose-hump-decr-incr=-1"]));
}

#[test]
fn targets_of_mpfb_are_read_as_it_reads_them() {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(&project(MPFB), folder.path());
    let root = text(folder.path());
    let target = folder.path().join("targets/chin/chin-triangle.target");
    fs::remove_file(target.with_extension("target.gz")).unwrap();
    // Rows of one vertex add up, and what the mesh lacks is passed over.
    fs::write(&target, "0 0.5 0 0\n0 0.25 0 0.5\n99 1 1 1\n").unwrap();
    assert_eq!(corner(root, &["chin/chin-triangle=1"]), [-0.25, -1.0, -0.5]);
    fs::write(&target, "0 0.5 0\n").unwrap();
    let moved = ["mesh", root, "--set", "chin/chin-triangle=1"];
    assert!(error_of(&moved).contains("line 1: 3 fields"));
    fs::remove_file(&target).unwrap();
    assert!(
        error_of(&moved).contains("`chin/chin-triangle`, which does not exist; MPFB would crash")
    );
    let packed = folder.path().join("targets/chin/chin-triangle.target.gz");
    fs::write(&packed, "").unwrap();
    assert_eq!(corner(root, &["chin/chin-triangle=1"]), corner(root, &[]));
    fs::write(&packed, "no gzip").unwrap();
    assert!(error_of(&moved).contains("cannot be unpacked"));
    let macros = folder.path().join("targets/macrodetails/macro.json");
    fs::write(&macros, "{}").unwrap();
    assert!(error_of(&["macros", root]).contains("lacks a setting"));
    fs::remove_file(&macros).unwrap();
    assert!(error_of(&["macros", root]).contains("macro.json is missing or cannot be used"));
    assert!(error_of(&["skeleton", root]).contains("--rig FILE"));
}

/// Cases of MPFB have the axes and the unit of Blender.
#[test]
fn cases_of_mpfb_are_computed_in_blender() {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(&project(MPFB), &folder.path().join("data"));
    let root = format!("mpfb={}", text(folder.path()));
    let file = folder.path().join("cases.json");
    let inputs = r#"{"macro": null, "scale_factor": 0.5, "feet_on_ground": true, "vertex_ids": [6],
        "targets": [["chin/chin-triangle.target.gz", 3], ["chin/chin-triangle.target.gz", -1]]}"#;
    let cases = |inputs: &str| {
        fs::write(
            &file,
            format!(r#"{{"kind": "mpfb_morph", "cases": [{{"name": "x", "inputs": {inputs}}}]}}"#),
        )
        .unwrap();
        eval(&["cases", text(&file), "--root", &root])
    };
    let outputs = json_of(&cases(inputs))["cases"][0]["outputs"].clone();
    assert_eq!(
        outputs["shape_keys"],
        json!([["chin-triangle", 1.0], ["chin-triangle.001", 0.0]])
    );
    let plain = json_of(&cases(&inputs.replace(
        "\"chin/chin-triangle.target.gz\", 3",
        "\"chin/chin-triangle.target.gz\", 0",
    )));
    assert_eq!(
        plain["cases"][0]["outputs"]["vertices"],
        json!([[0.5, -0.5, 1.0]])
    );
    assert_eq!(plain["cases"][0]["outputs"]["lowest_point"], json!(0.0));
    for wrong in [
        r#"{"targets": [3]}"#,
        r#"{"macro": {"age": "x"}}"#,
        r#"{"macro": {"agee": 1}}"#,
        r#"{"targets": [["no/such.target.gz", 1]]}"#,
    ] {
        assert_eq!(cases(wrong).status.code(), Some(2), "{wrong}");
    }
}

const CUBE: &str = "fixtures/mpfb/data/rigs/standard/rig.cube.json";

fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one.as_f64().unwrap())
        .collect()
}

/// Bones lie where joints and vertices are, with all sliders of the macros at their defaults.
#[test]
fn bones_of_mpfb_lie_on_the_figure() {
    let rig = |more: &[&str]| {
        json_of(&eval(&[&["rig", MPFB, "--rig", CUBE][..], more].concat()))["outputs"].clone()
    };
    let outputs = rig(&[]);
    let bones = &outputs["bones"];
    assert_eq!(
        (&bones["top"]["parent"], &bones["top"]["use_connect"]),
        (&json!("root"), &json!(true))
    );
    assert_eq!(
        (&outputs["identified"], &outputs["default_position_used"]),
        (&json!("unknown"), &json!([]))
    );
    // The axis of a bone is its second column; left and right mirror each other.
    let [left, right] = ["ear.L", "ear.R"].map(|bone| numbers(&bones[bone]["tail"]));
    assert!((left[0] + right[0]).abs() < 1e-6 && (left[2] - right[2]).abs() < 1e-6);
    let large = rig(&["--scale", "1"]);
    let [small, large] = [&outputs, &large].map(|one| numbers(&one["bones"]["ear.L"]["tail"]));
    assert!(
        small
            .iter()
            .zip(&large)
            .all(|(small, large)| (small * 10.0 - large).abs() < 1e-5)
    );
    // A slider moves the joints.
    let moved = rig(&["--set", "chin/chin-triangle=1"]);
    assert_ne!(moved["bones"], *bones);
    for wrong in [&["--scale", "0"][..], &["--scale", "nan"]] {
        assert!(error_of(&[&["rig", MPFB, "--rig", CUBE][..], wrong].concat()).contains("--scale"));
    }
    assert!(error_of(&["rig", MPFB]).contains("--rig FILE"));
}

/// Weights go to the bones of a rig, and what leads to none is dropped.
#[test]
fn weights_of_mpfb_become_groups_of_bones() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("weights.json");
    let text_of = r#"{"weights": {"DEF-top": [[0, 0.5], [0, 0.75]], "no": [[1, 1]], "mhmask-x": [[2, -1], [9, 1]]}}"#;
    fs::write(&file, text_of).unwrap();
    let outputs = json_of(&eval(&[
        "weights",
        text(&file),
        "--rig",
        CUBE,
        "--vertices",
        "8",
    ]))["outputs"]
        .clone();
    assert_eq!(
        outputs["groups"],
        json!({"top": [1, 1.0], "mhmask-x": [1, 0.0]})
    );
    assert_eq!(outputs["weighted_vertices"], json!(2));
    fs::write(&file, r#"{"weights": {"top": [[0.5, 1]]}}"#).unwrap();
    assert!(error_of(&["weights", text(&file), "--rig", CUBE]).contains("TypeError"));
    assert!(
        error_of(&[
            "weights",
            text(&file),
            "--rig",
            CUBE,
            "--max-influences",
            "4"
        ])
        .contains("--rig")
    );
}

/// A pose turns what hangs on a bone, and a pose without anything leaves the figure as it is.
#[test]
fn poses_of_mpfb_move_the_figure() {
    let folder = tempfile::tempdir().unwrap();
    let (file, weights) = (
        folder.path().join("pose.json"),
        "fixtures/mpfb/data/rigs/standard/weights.cube.json",
    );
    let skin = |pose: &str| {
        fs::write(&file, pose).unwrap();
        let args = [
            "skin",
            MPFB,
            "--rig",
            CUBE,
            "--weights",
            weights,
            "--pose",
            text(&file),
            "--vertices",
            "6,7",
        ];
        eval(&args)
    };
    let pose = |bones: &str| {
        format!(
            r#"{{"skeleton_type": "cube", "bone_rotations": {{{bones}}}, "bone_translations": {{}}}}"#
        )
    };
    let plain = json_of(&skin(&pose("")))["outputs"].clone();
    let turned = json_of(&skin(&pose(
        r#""root": [0, 0, 3.14159265358979], "none": [1, 1, 1]"#,
    )))["outputs"]
        .clone();
    // The root points up: the figure turns about it.
    let [before, after] = [&plain, &turned].map(|one| numbers(&one["vertices"][0]));
    assert!(
        (before[0] + after[0]).abs() < 1e-5 || (before[2] - after[2]).abs() > 0.1,
        "{before:?} {after:?}"
    );
    assert_ne!(plain["vertices"], turned["vertices"]);
    for (wrong, why) in [
        ("{}", "KeyError"),
        (
            r#"{"skeleton_type": "default", "bone_rotations": {}, "bone_translations": {}}"#,
            "AttributeError",
        ),
        (
            r#"{"skeleton_type": "x", "bone_rotations": {"top": [1, 2]}, "bone_translations": {}}"#,
            "ValueError",
        ),
    ] {
        let output = skin(wrong);
        assert!(
            output.status.code() == Some(2) && stderr(&output).contains(why),
            "{wrong}: {}",
            stderr(&output)
        );
    }
}

/// What is fitted has the axes and units of its OBJ when it is written, and those of Blender as
/// numbers.
#[test]
fn assets_of_mpfb_are_fitted() {
    let folder = tempfile::tempdir().unwrap();
    let asset = folder.path().join("hat.mhclo");
    fs::write(
        &asset,
        "obj_file hat.obj\nverts 0\n6\n7\n3\n\ndelete_verts\n0 - 7\n",
    )
    .unwrap();
    fs::write(
        folder.path().join("hat.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n",
    )
    .unwrap();
    let fit = |more: &[&str]| {
        eval(
            &[
                &["fit", text(&asset), "--app", "mpfb", "--base-mesh", MPFB][..],
                more,
            ]
            .concat(),
        )
    };
    let outputs = json_of(&fit(&["--vertices", "0"]))["outputs"].clone();
    assert_eq!(
        (
            &outputs["vertex_count"],
            &outputs["delete_lines"],
            &outputs["delete_verts"]
        ),
        (&json!(3), &json!(9), &json!(8))
    );
    let written = folder.path().join("out.obj");
    assert_eq!(fit(&["-o", text(&written)]).status.code(), Some(0));
    let mesh = mhlint::evaluate::read_positions(&written).unwrap();
    let place = numbers(&outputs["vertices"][0]);
    assert!(
        (f64::from(mesh[0][1]) * 0.1 - place[2]).abs() < 1e-5
            && (f64::from(mesh[0][2]) * 0.1 + place[1]).abs() < 1e-5
    );
    assert!(mesh[3].iter().all(|one| (one - 9.0).abs() < 1e-6));
    // Too few rows, and ranges above them that are counted as rows.
    for rows in ["verts 0\n6\n", "delete_verts\n0 - 7\n\nverts 0\n6\n7\n3\n"] {
        fs::write(&asset, format!("obj_file hat.obj\n{rows}")).unwrap();
        let output = fit(&[]);
        assert!(
            output.status.code() == Some(2) && stderr(&output).contains("KeyError"),
            "{}",
            stderr(&output)
        );
    }
}

#[test]
fn modifiers_of_makehuman1_share_out_their_values() {
    let set = [
        "--set",
        "head/head-size-decr|incr=-0.5",
        "--set",
        "macrodetails/Gender=1",
        "--set",
        "head/head-oval=7",
    ];
    let outputs =
        json_of(&eval(&[&["modifiers", MAKEHUMAN1][..], &set].concat()))["outputs"].clone();
    let of = |name: &str| outputs["modifiers"][name].clone();
    let size = of("head/head-size-decr|incr");
    assert_eq!(
        size["weights"],
        serde_json::json!({ "head/head-size-decr.target": 0.5 })
    );
    assert_eq!(
        (&size["clamped"], &size["value_read_back"]),
        (&(-0.5).into(), &(-0.5).into())
    );
    assert_eq!(of("head/head-oval")["clamped"], 1.0);
    let gender = of("macrodetails/Gender");
    let names = gender["weights"].as_object().unwrap();
    assert!(
        !names.is_empty() && names.keys().all(|name| name.contains("-male-")),
        "{names:?}"
    );
    assert_eq!(outputs["targets"]["head/head-size-decr.target"], 0.5);
    assert_eq!(outputs["variables"]["male"], 1.0);
    let reason = error_of(&["modifiers", "fixtures/makehuman2", "--base", "figure"]);
    assert!(
        reason.contains("for MakeHuman 2 use `mhlint eval macros`"),
        "{reason}"
    );
    assert!(
        error_of(&["modifiers", MAKEHUMAN1, "--set", "head/head-ovall=1"])
            .contains("head/head-oval")
    );
}

#[test]
fn weights_of_makehuman1_go_to_other_skeletons_by_their_references() {
    let file = |name: &str| format!("{MAKEHUMAN1}/rigs/{name}");
    let (weights, base, stick) = (
        file("default_weights.mhw"),
        file("default.mhskel"),
        file("stick.mhskel"),
    );
    let usual = [
        "weights",
        &weights,
        "--app",
        "makehuman1",
        "--skeleton",
        &base,
        "--remap-to",
        &stick,
    ];
    let outputs = json_of(&eval(&usual))["outputs"].clone();
    let bones = outputs["bones"].as_object().unwrap();
    let taken = outputs["weight_references"].as_object().unwrap();
    assert!(
        taken.len() > 1 && bones.keys().all(|bone| taken.contains_key(bone)),
        "{bones:?} {taken:?}"
    );
    let one = |value: &Value| (value.as_f64().unwrap() - 1.0).abs() < 1e-3;
    assert!(
        outputs["vertex_sum_range"]
            .as_array()
            .unwrap()
            .iter()
            .all(one),
        "{outputs}"
    );
    let reduced =
        json_of(&eval(&[&usual[..], &["--max-influences", "1"]].concat()))["outputs"].clone();
    assert_eq!(reduced["reduction"]["max_influences"], 1);
    assert!(
        reduced["vertex_sum_range"]
            .as_array()
            .unwrap()
            .iter()
            .all(one),
        "{reduced}"
    );
    let reason = error_of(&[&usual[..], &["--max-influences", "7"]].concat());
    assert!(reason.contains("only of 1 to 6 and of 13"), "{reason}");
}
