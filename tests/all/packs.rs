//! Zips as PATH: what may come of them, and bad input of every kind. `fixtures/rules/pack-layout`
//! has the rest.

use std::fs;
use std::path::Path;

use crate::scratch::zipped::{Member, named, zip};
use crate::scratch::{assert_refused, edit, example, findings, mhlint, project, stderr, stdout};
use mhlint::{Application, Config, Limits, Outcome, Tree, lint_trees};
use proptest::prelude::*;

const SHIRT: &str = "fixtures/makehuman2/data/clothes/figure/shirt";

/// The shirt of the example as a pack, with the files of `more` in place of its own.
fn shirt(more: &[(&str, &str)]) -> Vec<u8> {
    let mut members: Vec<(Member, Vec<u8>)> = Vec::new();
    for file in [
        "shirt.mhclo",
        "shirt.mhmat",
        "shirt.obj",
        "shirt.png",
        "shirt.thumb",
        "shirt_folds.png",
    ] {
        members.push((
            named(&format!("clothes/shirt/{file}")),
            fs::read(project(SHIRT).join(file)).unwrap(),
        ));
    }
    for (name, text) in more {
        members.retain(|(member, _)| member.name != *name);
        members.push((named(name), text.as_bytes().to_vec()));
    }
    let members: Vec<(Member, &[u8])> = members
        .iter()
        .map(|(member, bytes)| (member.clone(), &bytes[..]))
        .collect();
    zip(&members)
}

/// A folder with a zip in it.
fn with(name: &str, bytes: &[u8]) -> tempfile::TempDir {
    let repository = example();
    fs::write(repository.path().join(name), bytes).unwrap();
    repository
}

fn check(root: &Path, args: &[&str]) -> (Option<i32>, Vec<String>) {
    let output = mhlint(root, &[args, &["--report", "concise"]].concat());
    (output.status.code(), findings(&output))
}

/// The library on a zip, with limits that a test reaches.
fn lint(bytes: Vec<u8>, limits: Limits) -> Outcome {
    let config = Config {
        limits,
        no_eval: true,
        ..Config::default()
    };
    let outcome = lint_trees(
        vec![Tree::packed("my.zip", bytes, &limits, |_, _, _| true)],
        None,
        &config,
    )
    .unwrap();
    assert!(
        outcome.is_whole(),
        "{:?} {:?}",
        outcome.failed_rules,
        outcome.failed_files
    );
    outcome
}

/// The same as MPFB takes it.
fn lint_for_mpfb(bytes: Vec<u8>) -> Outcome {
    let config = Config {
        no_eval: true,
        applications: vec![Application::Mpfb],
        ..Config::default()
    };
    let tree = Tree::packed("my.zip", bytes, &config.limits, |_, _, _| true);
    let outcome = lint_trees(vec![tree], None, &config).unwrap();
    assert!(
        outcome.is_whole(),
        "{:?} {:?}",
        outcome.failed_rules,
        outcome.failed_files
    );
    outcome
}

fn rules(outcome: &Outcome) -> Vec<&'static str> {
    let mut rules: Vec<&str> = outcome
        .findings
        .iter()
        .map(|finding| finding.rule)
        .collect();
    rules.dedup();
    rules
}

#[test]
fn a_pack_is_checked_in_capitals_as_well_and_for_the_applications_that_are_asked_for() {
    let repository = with(
        "MY.ZIP",
        &shirt(&[("clothes/shirt/shirt.mhmat", "diffuseColor 1 1\n")]),
    );
    let root = repository.path();
    let effects = |args: &[&str]| {
        let output = mhlint(root, &[&["MY.ZIP", "--report", "json"], args].concat());
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let roots: Vec<String> = report["roots"]
            .as_array()
            .unwrap()
            .iter()
            .map(|root| root["application"].as_str().unwrap().to_owned())
            .collect();
        (output.status.code(), roots)
    };
    assert_eq!(
        effects(&[]),
        (
            Some(1),
            vec!["makehuman2".to_owned(), "makehuman1".to_owned()]
        )
    );
    assert_eq!(
        effects(&["--app", "makehuman1"]),
        (Some(1), vec!["makehuman1".to_owned()])
    );
    assert_eq!(
        effects(&["--app", "makehuman2"]),
        (Some(1), vec!["makehuman2".to_owned()])
    );
    assert_eq!(
        effects(&["--system", "data"]),
        (Some(1), vec!["makehuman2".to_owned()])
    );
}

/// macOS, editors and Git leave such in a zip.
#[test]
fn what_is_hidden_in_a_zip_is_no_part_of_the_pack() {
    let hidden = [
        "._a.mhscene",
        ".clothes/shirt/shirt.mhclo",
        ".git/refs/heads/male_female",
        "clothes/.old/a.obj",
    ];
    let plain = with("my.zip", &shirt(&[]));
    let repository = with("my.zip", &shirt(&hidden.map(|name| (name, "x\n"))));
    assert_eq!(
        check(repository.path(), &["my.zip"]),
        check(plain.path(), &["my.zip"])
    );
}

#[test]
fn a_fault_for_both_applications_is_told_once() {
    let repository = with(
        "my.zip",
        &shirt(&[("clothes/shirt/shirt.mhmat", "diffuseColor 1 1\n")]),
    );
    let output = mhlint(repository.path(), &["my.zip", "--report", "json"]);
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let all = report["findings"].as_array().unwrap();
    let [arity] = all
        .iter()
        .filter(|one| one["rule"] == "material-arity")
        .collect::<Vec<_>>()[..]
    else {
        panic!("{all:#?}")
    };
    let told: Vec<&str> = arity["breaks"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["application"].as_str().unwrap())
        .collect();
    assert_eq!(told, ["makehuman2", "makehuman1"]);
    assert_eq!(report["summary"]["files"], 6);
}

/// A zip of MPFB with these names.
fn of_mpfb(names: &[&str]) -> tempfile::TempDir {
    let members: Vec<(Member, &[u8])> =
        names.iter().map(|name| (named(name), &b"{}"[..])).collect();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("my.zip"), zip(&members)).unwrap();
    folder
}

/// The findings of `pack-layout` on it, each as its application and its consequence.
fn consequences(names: &[&str], applications: &[&str]) -> Vec<Vec<(String, String)>> {
    let asked = applications
        .iter()
        .flat_map(|application| ["--app", application]);
    let args: Vec<&str> = ["my.zip", "--report", "json", "--only", "pack-layout"]
        .into_iter()
        .chain(asked)
        .collect();
    let output = mhlint(of_mpfb(names).path(), &args);
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let text = |one: &serde_json::Value, key: &str| one[key].as_str().unwrap().to_owned();
    let told = |finding: &serde_json::Value| {
        let breaks = finding["breaks"].as_array().unwrap().iter();
        breaks
            .map(|one| (text(one, "application"), text(one, "effect")))
            .collect()
    };
    report["findings"]
        .as_array()
        .unwrap()
        .iter()
        .map(told)
        .collect()
}

#[test]
fn a_zip_is_one_of_mpfb_where_it_is_asked_for_or_has_its_list_at_the_top() {
    let is_checked = |names: &[&str], args: &[&str]| {
        let output = mhlint(
            of_mpfb(names).path(),
            &[&["my.zip", "--report", "json"], args].concat(),
        );
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        report["roots"]
            .as_array()
            .unwrap()
            .iter()
            .any(|root| root["application"] == "mpfb")
    };
    let [with, around, without] = [
        &["packs/a.json", "clothes/a/a.mhclo"][..],
        &["x/packs/a.json", "x/clothes/a/a.mhclo"],
        &["clothes/a/a.mhclo"],
    ];
    assert_eq!(
        [with, around, without].map(|names| is_checked(names, &[])),
        [true, false, false]
    );
    assert_eq!(
        [with, around, without].map(|names| is_checked(names, &["--app", "mpfb"])),
        [true; 3]
    );
    assert_eq!(
        [with, around].map(|names| is_checked(names, &["--app", "makehuman2"])),
        [false; 2]
    );
    // A folder `packs` may be of anybody.
    assert!(!is_checked(&["packs/a.json", "clothes.txt"], &[]));
}

#[test]
fn what_mpfb_does_with_a_zip_that_it_rejects_depends_on_its_mode() {
    let strips = "The mode FIX leaves out the folder; INSTALL unpacks it to where no list shows it";
    let fails = "The mode FIX cannot repair it; INSTALL unpacks it";
    for (names, told) in [
        (
            &["x/packs/a.json", "x/clothes/a/a.mhclo", ".DS_Store"][..],
            strips,
        ),
        (&["x/packs/a.json", "README.txt"], strips),
        (
            &["x/packs/a.json", "__MACOSX/x/packs/._a.json"],
            "The mode FIX leaves out the folder, and `__MACOSX`",
        ),
        (
            &["x/packs/a.json", "y/b.txt"],
            "The mode INSTALL unpacks it",
        ),
        (&["x/y/packs/a.json"], fails),
        (&["Packs/a.json"], fails),
        (&["clothes/a/a.mhclo"], fails),
        (&[r"packs\a.json"], "The mode FIX cannot repair it"),
        (
            &["mine.zip"],
            "The mode FIX cannot repair it; INSTALL unpacks only another zip",
        ),
        (&[], "there is no folder `packs` in it"),
    ] {
        let found = consequences(names, &["mpfb"]);
        let [one] = found.as_slice() else {
            panic!("{names:?}: {found:?}")
        };
        assert!(
            matches!(one.as_slice(), [(mpfb, effect)] if mpfb == "mpfb" && effect.contains(told)),
            "{names:?}: {one:?}"
        );
        assert!(one[0].1.contains("rejects the zip"), "{names:?}: {one:?}");
    }
}

#[test]
fn a_folder_around_everything_is_one_fault_for_both_importers() {
    let names = [
        "x/packs/a.json",
        "x/clothes/a/a.mhclo",
        "x/clothes/a/a.png",
        "README.txt",
    ];
    let found = consequences(&names, &["makehuman2", "mpfb"]);
    let [one] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!(
        one.iter()
            .map(|(application, _)| application.as_str())
            .collect::<Vec<_>>(),
        ["makehuman2", "mpfb"]
    );
}

/// Whoever has a zip with nothing but an asset in it puts the asset to the others of its kind:
/// MakeHuman 1 imports nothing.
#[test]
fn a_zip_of_one_asset_is_checked_for_makehuman_1_like_a_loose_one() {
    let asset = |prefix: &str, material: &str| {
        let clothes =
            "name vest\nobj_file vest.obj\nmaterial vest.mhmat\nuuid 1\nverts 0\n0\n1\n2\n";
        let files = [
            ("vest.mhclo", clothes),
            ("vest.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
            ("vest.mhmat", material),
        ];
        zip(&files.map(|(name, text)| (named(&format!("{prefix}{name}")), text.as_bytes())))
    };
    for prefix in ["vest/", ""] {
        for (material, findings) in [
            ("name vest\n", 0),
            ("name vest\ndiffuseTexture gone.png\n", 1),
        ] {
            let folder = tempfile::tempdir().unwrap();
            fs::write(folder.path().join("vest.zip"), asset(prefix, material)).unwrap();
            let args = [
                "vest.zip",
                "--app",
                "makehuman1",
                "--report",
                "json",
                "--only",
                "material-missing-texture",
            ];
            let output = mhlint(folder.path(), &args);
            let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
            let paths: Vec<&str> = report["findings"]
                .as_array()
                .unwrap()
                .iter()
                .filter_map(|one| one["path"].as_str())
                .collect();
            let expected = vec![format!("vest.zip/{prefix}vest.mhmat"); findings];
            assert_eq!(paths, expected, "{prefix} {material}");
        }
    }
}

#[test]
fn a_zip_is_not_fixed() {
    let repository = with("my.zip", &shirt(&[]));
    for option in ["--fix", "--diff"] {
        let output = mhlint(repository.path(), &["my.zip", option]);
        assert_refused(
            &output,
            &[
                "`my.zip` is a zip",
                "unpack it, fix the folder, and pack it again",
            ],
        );
        let output = mhlint(repository.path(), &["data", "my.zip", option]);
        assert_refused(&output, &["`my.zip` is a zip"]);
    }
}

#[test]
fn git_knows_nothing_of_what_is_in_a_zip() {
    let repository = with("my.zip", &shirt(&[]));
    for option in [&["--since", "HEAD"][..], &["--staged"]] {
        let output = mhlint(repository.path(), &[&["my.zip"], option].concat());
        assert_refused(&output, &["`my.zip` is a zip", "`--against OLD.zip`"]);
    }
}

#[test]
fn a_zip_is_compared_with_a_zip_or_a_folder() {
    let old = [("clothes/shirt/shirt.mhmat", "diffuseTexture absent.png\n")];
    let new = [
        old[0],
        ("clothes/shirt/other.mhmat", "diffuseTexture gone.png\n"),
    ];
    let repository = with("old.zip", &shirt(&old));
    let root = repository.path();
    fs::write(root.join("new.zip"), shirt(&new)).unwrap();
    let args = |path: &'static str, against: &'static str| {
        [path, "--system", "data", "--against", against]
    };
    let (code, found) = check(root, &args("new.zip", "old.zip"));
    assert_eq!(code, Some(0), "a warning");
    assert!(
        found.iter().any(|line| line.contains("gone.png")),
        "{found:?}"
    );
    assert!(
        !found.iter().any(|line| line.contains("absent.png")),
        "{found:?}"
    );
    assert!(
        found.iter().all(|line| line.starts_with("new.zip/")),
        "{found:?}"
    );
    assert_eq!(
        check(root, &args("old.zip", "new.zip")),
        (Some(0), Vec::new())
    );
    // The folder that it was packed from.
    fs::create_dir_all(root.join("my/clothes/shirt")).unwrap();
    for file in [
        "shirt.mhclo",
        "shirt.obj",
        "shirt.png",
        "shirt.thumb",
        "shirt_folds.png",
    ] {
        fs::copy(
            project(SHIRT).join(file),
            root.join("my/clothes/shirt").join(file),
        )
        .unwrap();
    }
    fs::write(root.join("my/clothes/shirt/shirt.mhmat"), old[0].1).unwrap();
    let (code, found) = check(root, &["new.zip", "--app", "makehuman1", "--against", "my"]);
    assert_eq!(code, Some(0));
    let missing: Vec<&String> = found
        .iter()
        .filter(|line| line.contains("material-missing-texture"))
        .collect();
    assert!(
        matches!(missing.as_slice(), [one] if one.contains("gone.png")),
        "{found:?}"
    );
    let output = mhlint(root, &args("new.zip", "absent.zip"));
    assert_refused(&output, &["`absent.zip` does not exist"]);
}

#[test]
fn a_zip_in_a_data_folder_is_not_opened() {
    let repository = example();
    let path = repository.path().join("data/clothes/figure/shirt/old.zip");
    fs::write(path, shirt(&[("../x", "x")])).unwrap();
    assert_eq!(check(repository.path(), &["data"]), (Some(0), Vec::new()));
}

#[test]
fn a_report_does_not_take_the_place_of_the_zip() {
    let bytes = shirt(&[]);
    let repository = with("my.zip", &bytes);
    let output = mhlint(repository.path(), &["my.zip", "--report", "json=my.zip"]);
    assert_refused(&output, &["it is an asset and would be overwritten"]);
    assert_eq!(fs::read(repository.path().join("my.zip")).unwrap(), bytes);
}

#[test]
fn a_zip_without_assets_is_not_checked() {
    let repository = with(
        "photos.zip",
        &zip(&[
            (named("holiday/beach.png"), b"x"),
            (named("README.md"), b""),
        ]),
    );
    let output = mhlint(repository.path(), &["photos.zip"]);
    assert_eq!(output.status.code(), Some(3));
    assert!(
        stderr(&output).contains("`photos.zip`: nothing in it can be read as an asset"),
        "{}",
        stderr(&output)
    );
    assert!(
        stdout(&output).is_empty() || !stdout(&output).contains("error"),
        "{}",
        stdout(&output)
    );
}

#[test]
fn a_zip_of_which_nothing_is_imported_is_checked_all_the_same() {
    let repository = with("my.zip", &zip(&[(named("litspheres/shiny.png"), b"x")]));
    let (code, found) = check(repository.path(), &["my.zip"]);
    assert_eq!(code, Some(0), "a warning");
    assert!(
        matches!(found.as_slice(), [one] if one.contains("warning[pack-layout]")),
        "{found:?}"
    );
}

#[test]
fn what_is_no_zip_is_a_finding() {
    for bytes in [&b""[..], b"hello", b"PK\x05\x06"] {
        let repository = with("my.zip", bytes);
        let (code, found) = check(repository.path(), &["my.zip"]);
        assert_eq!((code, found.len()), (Some(1), 1), "{found:?}");
        assert!(
            found[0].starts_with("my.zip: error[archive-malformed] not a zip archive"),
            "{found:?}"
        );
    }
    let output = mhlint(example().path(), &["absent.zip"]);
    assert_refused(&output, &["absent.zip"]);
}

#[test]
fn what_is_wrong_with_a_zip_is_one_matter_for_all_applications() {
    let outcome = lint(shirt(&[("/etc/hello", "x")]), Limits::default());
    let escapes: Vec<_> = outcome
        .findings
        .iter()
        .filter(|finding| finding.rule == "archive-path-escape")
        .collect();
    let [escape] = escapes.as_slice() else {
        panic!("{escapes:?}")
    };
    let applications: Vec<Application> = escape.breaks.iter().map(|one| one.application).collect();
    assert_eq!(
        applications,
        [Application::Makehuman2, Application::Makehuman1]
    );
}

#[test]
fn what_is_unsafe_cannot_be_ignored() {
    let repository = with("my.zip", &shirt(&[("../hello", "x")]));
    fs::write(
        repository.path().join("mhlint.toml"),
        "exclude = [\"my.zip\", \"my.zip/**\"]\n",
    )
    .unwrap();
    let (code, found) = check(repository.path(), &["my.zip"]);
    assert_eq!(code, Some(1), "{found:?}");
    assert!(
        found
            .iter()
            .any(|line| line.contains("archive-path-escape")),
        "{found:?}"
    );
}

#[test]
fn a_zip_cut_anywhere_is_a_finding() {
    let whole = shirt(&[]);
    for cut in (0..whole.len())
        .step_by(whole.len() / 60)
        .chain([whole.len() - 1])
    {
        let outcome = lint(whole[..cut].to_vec(), Limits::default());
        assert_eq!(
            rules(&outcome),
            ["archive-malformed"],
            "cut at {cut} of {}",
            whole.len()
        );
    }
}

#[test]
fn a_zip_that_mpfb_cannot_read_has_one_finding() {
    let whole = shirt(&[]);
    for cut in [0, 1, whole.len() / 2, whole.len() - 1] {
        assert_eq!(
            rules(&lint_for_mpfb(whole[..cut].to_vec())),
            ["archive-malformed"],
            "cut at {cut}"
        );
    }
    assert!(rules(&lint_for_mpfb(whole)).contains(&"pack-layout"));
}

#[test]
fn bombs_are_refused_by_ratio_and_by_size() {
    let zeros = |name: &str| Member {
        times: 2,
        ..named(name)
    };
    let content = vec![b'0'; 20 << 20];
    let bomb = zip(&[(zeros("clothes/a/a.obj"), &content)]);
    assert_eq!(
        rules(&lint(bomb, Limits::default())),
        ["file-decompression-bomb"]
    );
    let many: Vec<(Member, &[u8])> = (0..9)
        .map(|number| (zeros(&format!("clothes/a/{number}.obj")), &content[..100]))
        .collect();
    let limits = Limits {
        unpacked_bytes: 899,
        ..Limits::default()
    };
    assert_eq!(
        rules(&lint(zip(&many), limits)),
        ["file-decompression-bomb"]
    );
}

#[test]
fn a_member_that_unpacks_to_more_than_it_says_is_damaged() {
    let mut lying = zip(&[(
        Member {
            times: 2,
            ..named("clothes/a/a.obj")
        },
        &vec![b'0'; 1 << 20],
    )]);
    let list = lying
        .windows(4)
        .position(|four| four == b"PK\x01\x02")
        .unwrap();
    lying[list + 24..list + 28].copy_from_slice(&9_u32.to_le_bytes());
    assert_eq!(
        rules(&lint(lying, Limits::default())),
        ["archive-malformed"]
    );
}

#[test]
fn more_members_than_anybody_has_are_refused() {
    let members: Vec<(Member, &[u8])> = (0..100_001)
        .map(|number| (named(&format!("a/{number}")), &b""[..]))
        .collect();
    assert_eq!(
        rules(&lint(zip(&members), Limits::default())),
        ["archive-malformed"]
    );
}

#[test]
fn folders_without_end_are_bounded() {
    let deep = "a/".repeat(2000);
    let members: Vec<(Member, &[u8])> = (0..40)
        .map(|number| {
            (
                named(&format!("clothes/{number}/{deep}x.mhclo")),
                &b"name x\n"[..],
            )
        })
        .collect();
    lint(zip(&members), Limits::default());
    let long = named(&format!("clothes/{}", "a/".repeat(30_000)));
    assert!(
        rules(&lint(
            zip(&[(
                Member {
                    name: format!("{}x", long.name),
                    ..long
                },
                b""
            )]),
            Limits::default()
        ))
        .contains(&"archive-malformed")
    );
}

#[test]
fn two_capitals_of_one_folder_are_a_conflict() {
    let outcome = lint(
        shirt(&[("clothes/Shirt/notes.txt", "x")]),
        Limits::default(),
    );
    assert!(
        rules(&outcome).contains(&"file-case-conflict"),
        "{:?}",
        rules(&outcome)
    );
}

#[test]
fn the_base_mesh_is_the_one_that_is_asked_for() {
    let repository = with("my.zip", &shirt(&[]));
    let bases = |args: &[&str]| {
        let output = mhlint(
            repository.path(),
            &[&["my.zip", "--app", "makehuman2", "--report", "json"], args].concat(),
        );
        let report: serde_json::Value = serde_json::from_slice(&output.stdout)
            .unwrap_or_else(|_| panic!("{}", stderr(&output)));
        report["roots"][0]["bases"].clone()
    };
    assert_eq!(bases(&[]), serde_json::json!(["hm08"]));
    assert_eq!(bases(&["--base", "imp"]), serde_json::json!(["imp"]));
    assert_eq!(bases(&["--system", "data"]), serde_json::json!(["figure"]));
    let output = mhlint(
        repository.path(),
        &["my.zip", "--base", "imp", "--base", "figure"],
    );
    assert_refused(&output, &["`my.zip`"]);
}

#[test]
fn findings_in_a_zip_have_their_lines() {
    let repository = with(
        "my.zip",
        &shirt(&[(
            "clothes/shirt/shirt.mhmat",
            "# note\n\ndiffuseTexture absent.png\n",
        )]),
    );
    let (_, found) = check(repository.path(), &["my.zip", "--system", "data"]);
    assert!(
        found
            .iter()
            .any(|line| line.starts_with("my.zip/clothes/shirt/shirt.mhmat:3:16: ")),
        "{found:?}"
    );
    edit(
        repository.path(),
        "data/clothes/figure/shirt/shirt.mhmat",
        "shirt.png",
        "absent.png",
    );
    let all = check(
        repository.path(),
        &["my.zip", "data", "--app", "makehuman2"],
    )
    .1;
    assert!(
        all.iter().any(|line| line.starts_with("data/clothes")),
        "{all:?}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    #[test]
    fn a_changed_zip_never_panics(at in 0_usize..2000, to in any::<u8>(), from_end in any::<bool>()) {
        let mut bytes = shirt(&[]);
        let at = if from_end { bytes.len() - 1 - at.min(bytes.len() - 1) } else { at.min(bytes.len() - 1) };
        bytes[at] = to;
        lint(bytes.clone(), Limits::default());
        lint_for_mpfb(bytes);
    }

    #[test]
    fn noise_never_panics(noise in proptest::collection::vec(any::<u8>(), 0..400)) {
        let mut bytes = noise;
        bytes.extend(shirt(&[]).split_off(200));
        lint(bytes.clone(), Limits::default());
        lint_for_mpfb(bytes);
    }
}
