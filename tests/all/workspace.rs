//! Paths for code hosts: relative to what a CI system says is the top of the repository.

use std::fs;
use std::path::Path;

use crate::scratch::{broken, command, copy_folder};
use serde_json::Value;

fn run(folder: &Path, args: &[&str]) -> String {
    String::from_utf8(command(folder, args).output().unwrap().stdout).unwrap()
}

/// The first annotation, the first path of SARIF and of the code quality report, with a variable of
/// a CI system set.
fn places(folder: &Path, args: &[&str], variable: (&str, &Path)) -> [String; 3] {
    let text = |format: &str| {
        let mut command = command(
            folder,
            &[args, &["--only", "macro-steps-length", "--report", format]].concat(),
        );
        String::from_utf8(command.env(variable.0, variable.1).output().unwrap().stdout).unwrap()
    };
    let json = |format: &str| serde_json::from_str::<Value>(&text(format)).unwrap();
    let annotation = text("github");
    let file = annotation
        .strip_prefix("::error file=")
        .unwrap()
        .split(',')
        .next()
        .unwrap();
    let sarif = json("sarif")["runs"][0]["results"][0]["locations"][0]["physicalLocation"].take();
    let uri = sarif["artifactLocation"]["uri"].as_str().unwrap();
    [
        file,
        uri,
        json("gitlab")[0]["location"]["path"].as_str().unwrap(),
    ]
    .map(str::to_owned)
}

#[test]
fn code_hosts_get_paths_from_the_top_of_the_repository() {
    let repository = broken();
    let (top, below) = (repository.path(), repository.path().join("data"));
    let [whole, short] = ["data/target/figure/macro.json", "target/figure/macro.json"];
    let github = ("GITHUB_WORKSPACE", top);
    assert_eq!(places(&below, &[], github), [whole, whole, short]);
    assert_eq!(
        places(&below, &[], ("CI_PROJECT_DIR", top)),
        [short, whole, whole]
    );
    assert_eq!(places(&below, &["../data"], github)[0], whole);
    assert_eq!(places(top, &[], github), [whole; 3]);
    assert_eq!(
        places(top, &["data"], ("GITHUB_WORKSPACE", Path::new(""))),
        [whole; 3]
    );
    let given = top.join("data");
    assert_eq!(
        places(Path::new("/"), &[given.to_str().unwrap()], github)[..2],
        [whole, whole]
    );
}

#[test]
fn a_checkout_in_a_folder_of_the_workspace_is_the_top() {
    let workspace = tempfile::tempdir().unwrap();
    let checkout = workspace.path().join("checkout");
    copy_folder(broken().path(), &checkout);
    fs::create_dir(checkout.join(".git")).unwrap();
    let github = ("GITHUB_WORKSPACE", workspace.path());
    assert_eq!(
        places(&checkout.join("data"), &[], github)[..2],
        ["data/target/figure/macro.json"; 2]
    );
}

#[test]
fn paths_outside_of_the_workspace_stay() {
    let (repository, elsewhere) = (broken(), tempfile::tempdir().unwrap());
    let short = "target/figure/macro.json";
    for top in [
        elsewhere.path(),
        &repository.path().join("user"),
        Path::new("/no/such/folder"),
    ] {
        assert_eq!(
            places(
                &repository.path().join("data"),
                &[],
                ("GITHUB_WORKSPACE", top)
            ),
            [short; 3]
        );
    }
}

#[test]
fn the_workspace_changes_no_fingerprint_and_no_other_report() {
    let repository = broken();
    let folder = repository.path().join("data");
    let with = |format: &str| {
        let mut command = command(&folder, &["--report", format]);
        command
            .env("GITHUB_WORKSPACE", repository.path())
            .env("CI_PROJECT_DIR", repository.path());
        String::from_utf8(command.output().unwrap().stdout).unwrap()
    };
    for format in ["human", "concise", "json", "junit", "markdown", "html"] {
        assert_eq!(
            with(format),
            run(&folder, &["--report", format]),
            "{format}"
        );
    }
    let prints = |text: &str| -> Vec<Value> {
        let issues: Vec<Value> = serde_json::from_str(text).unwrap();
        issues
            .into_iter()
            .map(|mut issue| issue["fingerprint"].take())
            .collect()
    };
    assert_eq!(
        prints(&with("gitlab")),
        prints(&run(&folder, &["--report", "gitlab"]))
    );
}
