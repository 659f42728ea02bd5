//! Repositories that hold data of several applications: each part is checked for its own, what they
//! share once, and every report says who loads what and how it fares there.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde_json::Value;

use crate::compare::commit_all;
use crate::scratch::{Case, assert_refused, copy_folder, edit, mhlint, project, stderr, stdout};

pub(crate) const APPLICATIONS: [&str; 3] = ["makehuman1", "makehuman2", "mpfb"];

/// The examples of these applications side by side, each with a user's folder where `users` says
/// so.
pub(crate) fn side_by_side(applications: &[&str], users: &[&str]) -> tempfile::TempDir {
    let repository = tempfile::tempdir().unwrap();
    for application in applications {
        let folders = ["data", "user"]
            .into_iter()
            .filter(|folder| *folder == "data" || users.contains(application));
        for folder in folders.map(|folder| format!("{application}/{folder}")) {
            copy_folder(
                &project(&format!("fixtures/{folder}")),
                &repository.path().join(folder),
            );
        }
    }
    repository
}

fn report(root: &Path, args: &[&str]) -> Value {
    let output = mhlint(root, &[&["--report", "json"], args].concat());
    serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", stderr(&output)))
}

/// How each file fares in each application that loads it.
fn matrix(report: &Value) -> BTreeMap<String, BTreeMap<String, String>> {
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    let cell = |one: &Value| (text(&one["application"]), text(&one["fares"]));
    let row = |one: &Value| {
        (
            text(&one["path"]),
            one["applications"]
                .as_array()
                .unwrap()
                .iter()
                .map(cell)
                .collect(),
        )
    };
    report["consumers"]
        .as_array()
        .unwrap()
        .iter()
        .map(row)
        .collect()
}

#[test]
fn each_part_is_checked_for_its_own_application() {
    let repository = side_by_side(&APPLICATIONS, &["makehuman2", "mpfb"]);
    let report = report(repository.path(), &["--fail-on", "warning"]);
    assert_eq!(
        (&report["verdict"], &report["findings"]),
        (&Value::from("pass"), &serde_json::json!([]))
    );
    let matrix = matrix(&report);
    for (path, consumers) in &matrix {
        let owner = path.split('/').next().unwrap();
        assert_eq!(consumers.keys().collect::<Vec<_>>(), [owner], "{path}");
    }
    let owners: BTreeSet<&str> = matrix
        .keys()
        .filter_map(|path| path.split('/').next())
        .collect();
    assert_eq!(owners.into_iter().collect::<Vec<_>>(), APPLICATIONS);
    assert!(matrix.len() > 300, "{}", matrix.len());
    let target = "makehuman1/data/targets/head/head-oval.target";
    let root = report["consumers"]
        .as_array()
        .unwrap()
        .iter()
        .find(|one| one["path"] == target)
        .unwrap();
    assert_eq!(root["applications"][0]["root"], "makehuman1/data");
}

/// The base meshes of the two examples differ: what is right for the one may be wrong for the
/// other.
#[test]
fn a_folder_of_two_applications_is_measured_against_the_base_mesh_of_each() {
    let repository = side_by_side(&["makehuman1", "mpfb"], &["makehuman1"]);
    let both = report(repository.path(), &[]);
    let target = "makehuman1/user/data/custom/paunch.target";
    let own = |name: &str, fares: &str| (name.to_owned(), fares.to_owned());
    let wanted: BTreeMap<String, String> =
        [own("makehuman1", "fine"), own("mpfb", "warning")].into();
    assert_eq!(matrix(&both)[target], wanted);
    let verdicts = serde_json::json!([
        { "application": "makehuman1", "verdict": "pass" },
        { "application": "mpfb", "verdict": "fail" },
    ]);
    assert_eq!(both["applications"], verdicts);
    let paths = both["consumers"].as_array().unwrap().len();
    assert!(
        both["summary"]["files"].as_u64().unwrap() <= paths as u64 + 5,
        "shared files are counted once"
    );
    let one = report(repository.path(), &["--app", "makehuman1"]);
    assert_eq!(
        (&one["verdict"], &one["findings"]),
        (&Value::from("pass"), &serde_json::json!([]))
    );
}

#[test]
fn a_change_that_breaks_one_application_says_which() {
    let repository = side_by_side(&APPLICATIONS, &[]);
    commit_all(repository.path());
    edit(repository.path(), "mpfb/data/targets/target.json", "{", "");
    let text = |format: &str| {
        stdout(&mhlint(
            repository.path(),
            &[".", "--since", "HEAD", "--report", format],
        ))
    };
    let sentence =
        "MPFB would crash, reject a file or lose data. MakeHuman 2 and MakeHuman 1 pass.";
    for format in ["human", "github", "junit", "markdown", "html"] {
        let text = text(format).replace('\n', " ");
        assert!(text.contains(sentence), "{format}: {text}");
    }
    let human = text("human");
    let verdict = human
        .lines()
        .find(|line| line.starts_with("verdict"))
        .unwrap();
    assert_eq!(
        verdict.split_whitespace().collect::<Vec<_>>(),
        ["verdict", "passed", "passed", "failed"],
        "{human}"
    );
    let sliders = human
        .lines()
        .find(|line| line.starts_with("sliders"))
        .unwrap();
    assert!(sliders.ends_with("error in 1 of 2"), "{human}");
    assert!(text("concise").contains("; MakeHuman 2: pass, MakeHuman 1: pass, MPFB: fail"));
    let sarif: Value = serde_json::from_str(&text("sarif")).unwrap();
    let rows = sarif["runs"][0]["properties"]["consumers"]
        .as_array()
        .unwrap();
    let broken: Vec<&Value> = rows.iter().filter(|row| row["error"] != 0).collect();
    assert_eq!(
        broken
            .iter()
            .map(|row| &row["application"])
            .collect::<Vec<_>>(),
        ["mpfb"],
        "{broken:?}"
    );
}

#[test]
fn one_application_needs_no_matrix() {
    let repository = side_by_side(&["mpfb"], &[]);
    let text = |format: &str| stdout(&mhlint(repository.path(), &[".", "--report", format]));
    for format in ["human", "markdown", "github", "junit"] {
        assert!(!text(format).contains("loaded by"), "{format}");
    }
    assert!(!text("html").contains("class=\"matrix\""));
    assert!(!text("concise").contains("MPFB"));
}

#[test]
fn an_archive_that_stands_for_a_text_is_named() {
    let repository = tempfile::tempdir().unwrap();
    let archived = Case::read(&project(
        "fixtures/rules/target-stale-binary/bad-makehuman1",
    ));
    copy_folder(&project("fixtures/makehuman1"), repository.path());
    archived.apply(repository.path());
    let report = report(repository.path(), &[]);
    let rows = report["consumers"].as_array().unwrap();
    let at = |path: &str| rows.iter().find(|row| row["path"] == path).unwrap();
    let target = &at("data/targets/head/head-oval.target")["applications"][0];
    assert_eq!(
        (&target["application"], &target["archive"]),
        (&"makehuman1".into(), &"data/targets.npz".into())
    );
    assert_eq!(
        at("data/clothes/shirt/shirt.mhclo")["applications"][0]["archive"],
        Value::Null
    );
}

/// A pack over the data of two applications.
fn pack_over(systems: &[&str]) -> std::process::Output {
    let repository = side_by_side(&["makehuman1", "mpfb"], &[]);
    let hat = "mpfb/user/data/clothes/hat";
    copy_folder(
        &project("fixtures").join(hat),
        &repository.path().join("pack/clothes/hat"),
    );
    let systems = systems.iter().flat_map(|system| ["--system", system]);
    mhlint(
        repository.path(),
        &["pack", "--report", "json"]
            .into_iter()
            .chain(systems)
            .collect::<Vec<_>>(),
    )
}

#[test]
fn a_pack_is_checked_over_the_data_of_each_application() {
    let hat = "pack/clothes/hat/hat.mhclo";
    for (systems, applications) in [
        (&["makehuman1/data"][..], &["makehuman1"][..]),
        (&["mpfb/data"], &["mpfb"]),
        (&["mpfb/data", "makehuman1/data"], &["makehuman1", "mpfb"]),
    ] {
        let report: Value = serde_json::from_slice(&pack_over(systems).stdout).unwrap();
        let own = matrix(&report)[hat].clone();
        assert_eq!(own.keys().collect::<Vec<_>>(), applications, "{report}");
        if let Some(fares) = own.get("mpfb") {
            assert_eq!(fares, "fine", "{report}");
        }
        assert!(
            report["not_checked"]
                .as_array()
                .unwrap()
                .iter()
                .all(|one| one["what"] == "kind"),
            "{report}"
        );
    }
}

#[test]
fn two_systems_of_one_application_are_refused() {
    let output = pack_over(&["mpfb/data", "mpfb/data/../data", "makehuman1/data"]);
    let words = "`mpfb/data/../data` and `mpfb/data` are both given with `--system` as data of MPFB; name one of them";
    assert_refused(&output, &[words]);
}

/// Data of one application inside those of another one are checked for their own alone.
#[test]
fn data_inside_those_of_another_application_are_their_own() {
    let around = |outer: &str, inner: &[(&str, &str)]| {
        let repository = tempfile::tempdir().unwrap();
        copy_folder(&project("fixtures").join(outer), repository.path());
        for (from, to) in inner {
            copy_folder(&project("fixtures").join(from), &repository.path().join(to));
        }
        repository
    };
    for (outer, inner, application, below) in [
        (
            "makehuman2/user",
            &[("makehuman1/data", "other/mh1")][..],
            "makehuman1",
            "other/mh1/",
        ),
        (
            "makehuman2/data",
            &[("mpfb/data", "extra/data"), ("mpfb/user", "extra/user")],
            "mpfb",
            "extra/",
        ),
        (
            "mpfb/data",
            &[
                ("makehuman2/data", "extra/data"),
                ("makehuman2/user", "extra/user"),
            ],
            "makehuman2",
            "extra/",
        ),
        (
            "mpfb/data",
            &[("makehuman1/data", "extra/data")],
            "makehuman1",
            "extra/",
        ),
    ] {
        let repository = around(outer, inner);
        let report = report(repository.path(), &["--fail-on", "warning"]);
        let messages = report["findings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|one| one["message"].to_string());
        assert_eq!(
            report["verdict"],
            "pass",
            "{outer}: {:?}",
            messages.collect::<Vec<_>>()
        );
        let inside = matrix(&report)
            .into_iter()
            .filter(|(path, _)| path.starts_with(below));
        let mut count = 0;
        for (path, consumers) in inside {
            assert_eq!(
                consumers.keys().collect::<Vec<_>>(),
                [application],
                "{path}"
            );
            count += 1;
        }
        assert!(count > 50, "{outer}: {count}");
    }
}

#[test]
fn the_paths_of_a_repository_are_checked_as_the_whole() {
    let repository = side_by_side(&APPLICATIONS, &["makehuman1"]);
    let whole = matrix(&report(repository.path(), &["."]));
    let parts = matrix(&report(repository.path(), &APPLICATIONS));
    assert_eq!(whole, parts);
    assert!(whole["makehuman1/user/data/custom/paunch.target"].contains_key("mpfb"));
}

#[test]
fn an_application_that_is_asked_for_gets_no_data_of_others() {
    let repository = side_by_side(&APPLICATIONS, &["mpfb"]);
    let one = report(
        repository.path(),
        &["--app", "makehuman2", "--fail-on", "info"],
    );
    assert_eq!(
        (&one["verdict"], &one["findings"]),
        (&Value::from("pass"), &serde_json::json!([]))
    );
    assert!(
        matrix(&one)
            .keys()
            .all(|path| path.starts_with("makehuman2/"))
    );
    let alone = side_by_side(&["makehuman2"], &[]);
    let text = stdout(&mhlint(
        alone.path(),
        &[".", "--app", "makehuman2", "--app", "mpfb"],
    ));
    assert!(text.contains("nothing was checked for MPFB"), "{text}");
}

#[test]
fn what_may_run_code_is_checked_wherever_it_lies() {
    for (case, file, rule) in [
        (
            "scene-unsafe-pickle/bad",
            "data/scenes/dusk.mhscene",
            "scene-unsafe-pickle",
        ),
        (
            "scene-unsafe-pickle/bad-cache",
            "user/cache/hair.mhc",
            "scene-unsafe-pickle",
        ),
    ] {
        let repository = side_by_side(&["makehuman2"], &[]);
        Case::read(&project(&format!("fixtures/rules/{case}"))).apply(repository.path());
        let name = file.rsplit('/').next().unwrap();
        let bytes = std::fs::read(repository.path().join(file)).unwrap();
        std::fs::remove_file(repository.path().join(file)).unwrap();
        copy_folder(
            &project("fixtures/makehuman1/data"),
            &repository.path().join("all/data"),
        );
        copy_folder(
            &project("fixtures/makehuman2/data"),
            &repository.path().join("all/data/makehuman2"),
        );
        // In no data folder, in that of an application that opens no such file, at the top of one
        // that does, and in one that lies inside of that.
        for folder in [
            "wip",
            "makehuman2/data/scenes",
            "all/data",
            "all/data/makehuman2",
        ] {
            let place = format!("{folder}/{name}");
            std::fs::create_dir_all(repository.path().join(folder)).unwrap();
            std::fs::write(repository.path().join(&place), &bytes).unwrap();
            for path in [place.as_str(), "."] {
                let output = mhlint(repository.path(), &[path, "--report", "concise"]);
                assert_eq!(output.status.code(), Some(1), "{path}: {}", stdout(&output));
                assert!(
                    stdout(&output).contains(&format!("{place}: error[{rule}]")),
                    "{}",
                    stdout(&output)
                );
            }
            std::fs::remove_file(repository.path().join(&place)).unwrap();
        }
    }
}

#[test]
fn an_archive_of_something_worn_is_checked_wherever_it_lies() {
    let repository = tempfile::tempdir().unwrap();
    std::fs::write(repository.path().join("kilt.mhpxy"), "no archive").unwrap();
    let output = mhlint(repository.path(), &["kilt.mhpxy", "--report", "concise"]);
    assert!(
        stdout(&output).starts_with("kilt.mhpxy: error[archive-malformed]"),
        "{}",
        stdout(&output)
    );
}

/// What is downloaded of a release is a folder of archives, which lies in no library.
#[test]
fn an_archive_of_something_worn_leads_to_what_lies_beside_it() {
    let repository = side_by_side(&["makehuman1"], &[]);
    let data = repository.path().join("makehuman1/data");
    let case = "why = ''\n\
        [[compiled]]\nalone = true\nfile = 'hair/curls/curls.mhpxy'\nfrom = 'hair/curls/curls.mhclo'\n\
        [[compiled]]\nalone = true\nfile = 'hair/curls/curls.npz'\nfrom = 'hair/curls/curls.obj'\n";
    toml::from_str::<Case>(case).unwrap().apply(&data);
    let loose = tempfile::tempdir().unwrap();
    copy_folder(&data.join("hair/curls"), &loose.path().join("curls"));
    let found = |from: &Path, arguments: &[&str]| {
        let output = mhlint(
            from,
            &[arguments, &["--report", "concise", "--fail-on", "never"]].concat(),
        );
        let text = stdout(&output);
        text.lines()
            .filter(|line| line.contains('['))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    let system = data.to_string_lossy().into_owned();
    let folder = loose.path().join("curls");
    for arguments in [
        vec!["."],
        vec!["curls.mhpxy"],
        vec!["curls.mhpxy", "--app", "makehuman1"],
    ] {
        assert_eq!(found(&folder, &arguments), [""; 0], "{arguments:?}");
        assert_eq!(
            found(&folder, &[&arguments[..], &["--system", &system]].concat()),
            [""; 0],
            "{arguments:?}"
        );
    }
    std::fs::remove_file(folder.join("curls.mhw")).unwrap();
    std::fs::remove_file(folder.join("curls.mhmat")).unwrap();
    for (from, path) in [
        (folder.as_path(), "curls.mhpxy"),
        (folder.as_path(), "."),
        (loose.path(), "."),
    ] {
        let told = found(from, &[path]);
        let has = |rule: &str| {
            told.iter()
                .any(|line| line.contains(rule) && line.contains("curls.mhpxy"))
        };
        assert!(
            has("error[proxy-missing-weights]") && has("warning[proxy-missing-material]"),
            "{path}: {told:?}"
        );
        assert_eq!(told.len(), 2, "{path}: {told:?}");
    }
    std::fs::remove_file(folder.join("curls.npz")).unwrap();
    let told = found(&folder, &["curls.mhpxy"]);
    assert!(
        told.len() == 1 && told[0].contains("error[proxy-missing-mesh]"),
        "{told:?}"
    );
}

/// Git and other programs have such folders in the data, and no checkout of a fixture would.
#[test]
fn the_names_of_hidden_folders_count_for_the_targets_of_makehuman_1() {
    let repository = side_by_side(&["makehuman1"], &[]);
    let data = repository.path().join("makehuman1/data");
    for folder in [
        ".git/refs/heads/male_female",
        "clothes/.old/young-old",
        ".git/refs/heads/male",
    ] {
        std::fs::create_dir_all(data.join(folder)).unwrap();
    }
    for (from, path) in [
        (repository.path(), "."),
        (repository.path(), "makehuman1/data"),
        (data.as_path(), "."),
    ] {
        let text = stdout(&mhlint(from, &[path, "--report", "concise"]));
        let found =
            |folder: &str| text.contains(&format!("{folder}/: error[target-token-conflict]"));
        assert!(
            found(".git/refs/heads/male_female") && found("clothes/.old/young-old"),
            "{path}: {text}"
        );
        assert_eq!(
            text.matches("error").count(),
            3,
            "{path}: two findings and the sum: {text}"
        );
    }
}

#[test]
fn a_users_folder_is_of_mpfb_if_only_mpfb_has_what_is_in_it() {
    let alone = |files: &[(&str, &str)]| {
        let user = tempfile::tempdir().unwrap();
        for (path, text) in files {
            let path = user.path().join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        user
    };
    let applications = |user: &Path, path: &str| -> Vec<String> {
        let report = report(user, &[path]);
        let roots = report["roots"].as_array().unwrap().iter();
        roots
            .map(|root| root["application"].as_str().unwrap().to_owned())
            .collect()
    };
    let target = ("u/data/targets/custom/x.target", "1 0 0 .1\n");
    let user = alone(&[target]);
    for path in [
        ".",
        "u/data",
        "u/data/targets",
        "u/data/targets/custom",
        "u/data/targets/custom/x.target",
    ] {
        assert_eq!(applications(user.path(), path), ["mpfb"], "{path}");
    }
    let hat = ("u/data/clothes/hat/hat.mhclo", "obj_file hat.obj\n");
    let user = alone(&[hat, ("u/data/packs/hats.json", "{\"hat\": {}}")]);
    assert_eq!(applications(user.path(), "."), ["makehuman1", "mpfb"]);
}

#[test]
fn paths_of_one_folder_are_one_however_they_are_written() {
    let repository = side_by_side(&["makehuman1"], &["makehuman1"]);
    let absolute = |path: &str| {
        repository
            .path()
            .canonicalize()
            .unwrap()
            .join(path)
            .to_str()
            .unwrap()
            .to_owned()
    };
    let (data, models) = ("makehuman1/user/data", "makehuman1/user/models");
    let (target, pose) = (
        "makehuman1/user/data/custom/paunch.target",
        "makehuman1/user/data/poses/step.bvh",
    );
    let pairs = [
        [absolute(data), models.to_owned()],
        [models.to_owned(), absolute(data)],
        [data.to_owned(), absolute(models)],
        [absolute(target), pose.to_owned()],
        [target.to_owned(), absolute(pose)],
    ];
    for pair in pairs {
        let args = [
            pair[0].as_str(),
            pair[1].as_str(),
            "--system",
            "makehuman1/data",
        ];
        let output = mhlint(repository.path(), &args);
        assert_eq!(
            output.status.code(),
            Some(0),
            "{pair:?}: {}{}",
            stdout(&output),
            stderr(&output)
        );
    }
}
