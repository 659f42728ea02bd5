//! Damage that no text file can describe: pipes, names that are no Unicode, links to the data
//! itself, bombs.

use std::fs;
use std::io::{Write, copy, repeat};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

use crate::scratch::{example, findings, mhlint, stderr};
use flate2::{Compression, write::GzEncoder};

fn check(root: &Path, args: &[&str]) -> Vec<String> {
    let output = mhlint(
        root,
        &[args, &["--report", "concise", "--only", "file-*"]].concat(),
    );
    assert!(
        matches!(output.status.code(), Some(0 | 1)),
        "{}",
        stderr(&output)
    );
    findings(&output)
}

#[test]
fn a_pipe_is_never_opened() {
    let root = example();
    let pipe = root.path().join("data/target/figure/head/pipe.target");
    assert!(
        Command::new("mkfifo")
            .arg(&pipe)
            .status()
            .unwrap()
            .success()
    );
    let expected = "data/target/figure/head/pipe.target: error[file-unreadable] cannot be read: it is not a regular file";
    assert_eq!(check(root.path(), &["."]), [expected]);
}

#[test]
fn a_name_that_is_no_unicode_is_named_and_its_file_is_read() {
    let root = example();
    let name = std::ffi::OsStr::from_bytes(b"J\xf6rg.target");
    fs::write(root.path().join("data/target/figure/head").join(name), "").unwrap();
    let path = "data/target/figure/head/J\u{fffd}rg.target";
    let expected = [
        format!("{path}: warning[file-empty] `J\u{fffd}rg.target` is empty (0 bytes)"),
        format!("{path}: warning[file-unportable-name] `J\u{fffd}rg.target` is not valid Unicode"),
    ];
    assert_eq!(check(root.path(), &["."]), expected);
}

#[test]
fn control_characters_of_names_do_not_reach_the_terminal() {
    let root = example();
    fs::write(
        root.path().join("data/target/figure/a\u{1b}[31mb\nc.txt"),
        "x",
    )
    .unwrap();
    let output = mhlint(root.path(), &[".", "--report", "concise"]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("file-unportable-name"), "{text}");
    assert!(
        text.lines().all(|line| !line.chars().any(char::is_control)),
        "{text:?}"
    );
}

#[test]
fn data_behind_a_link_is_checked_under_the_name_of_the_link() {
    let root = example();
    fs::write(
        root.path().join("data/target/figure/head/head-oval.target"),
        "",
    )
    .unwrap();
    symlink("data", root.path().join("linked")).unwrap();
    let expected = "linked/target/figure/head/head-oval.target: warning[file-empty] `head-oval.target` is empty (0 bytes)";
    assert_eq!(check(root.path(), &["linked"]), [expected]);
    assert_eq!(
        check(root.path(), &["user", "--system", "linked"]),
        Vec::<String>::new()
    );
}

#[test]
fn a_bomb_is_given_up_at_the_ratio() {
    let root = example();
    let file =
        fs::File::create(root.path().join("data/target/figure/head/zeros.target.gz")).unwrap();
    let mut encoder = GzEncoder::new(file, Compression::default());
    copy(&mut std::io::Read::take(repeat(0), 300 << 20), &mut encoder).unwrap();
    encoder.finish().unwrap().flush().unwrap();
    let packed = fs::metadata(root.path().join("data/target/figure/head/zeros.target.gz"))
        .unwrap()
        .len();
    let path = "data/target/figure/head/zeros.target.gz";
    let limit = packed * 200 + 1;
    let (kilobytes, megabytes) = (packed as f64 / 1e3, limit as f64 / 1e6);
    let sizes = format!("{kilobytes:.1} kB unpack to {megabytes:.1} MB or more");
    let expected = format!("{path}: info[file-decompression-bomb] {sizes}");
    assert_eq!(check(root.path(), &["."]), [expected.as_str()]);
    assert_eq!(
        check(root.path(), &[".", "--skip", "*"]),
        [expected.as_str()]
    );
}

#[test]
fn an_archive_is_checked_by_the_sizes_in_its_directory() {
    for path in [
        "data/hair/figure/curls/curls.mhbin",
        "data/base/figure/base.mhbin",
    ] {
        is_checked_by_its_directory(path);
    }
}

fn is_checked_by_its_directory(path: &str) {
    let root = example();
    fs::create_dir_all(root.path().join(path).parent().unwrap()).unwrap();
    let mut zip = zip::ZipWriter::new(fs::File::create(root.path().join(path)).unwrap());
    zip.start_file("coord.npy", zip::write::SimpleFileOptions::default())
        .unwrap();
    zip.write_all(&vec![0; 17 << 20]).unwrap();
    zip.finish().unwrap();
    let packed = fs::metadata(root.path().join(path)).unwrap().len() as f64 / 1e3;
    let expected =
        format!("{path}: error[file-decompression-bomb] {packed:.1} kB unpack to 17.8 MB or more");
    assert_eq!(check(root.path(), &["."]), [expected]);
}

#[test]
fn an_endless_file_is_read_up_to_the_limit_only() {
    let root = example();
    let file = fs::File::create(root.path().join("data/target/figure/head/huge.target")).unwrap();
    file.set_len(2 << 30).unwrap();
    let path = "data/target/figure/head/huge.target";
    let expected = format!("{path}: warning[file-too-large] target too large to check: 2147.5 MB");
    assert_eq!(check(root.path(), &["."]), [expected]);
}

#[test]
fn help_says_what_to_write_in_the_words_of_the_file() {
    let help = |file: &str, find: &str, replace: &str| {
        let root = example();
        let file = root.path().join(file);
        let text = fs::read_to_string(&file).unwrap();
        assert!(text.contains(find), "{find}");
        fs::write(&file, text.replacen(find, replace, 1)).unwrap();
        let output = mhlint(root.path(), &["--report", "json", "--no-eval"]);
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let findings = report["findings"].as_array().unwrap();
        assert_eq!(findings.len(), 1, "{findings:#?}");
        findings[0]["help"].as_str().unwrap().to_owned()
    };
    let [modelling, macros] = [
        "data/target/figure/modelling.json",
        "data/target/figure/macro.json",
    ];
    let [clothes, material] =
        ["mhclo", "mhmat"].map(|suffix| format!("data/clothes/figure/shirt/shirt.{suffix}"));
    let [clothes, material] = [clothes.as_str(), &material];
    let cases = [
        (
            modelling,
            "\"torso/chest-depth-decr\"",
            "\"torso/chest-dpeth-decr\"",
            "did you mean `torso/chest-depth-decr`?",
        ),
        (
            modelling,
            "\"head/head-oval\"",
            "\"head/Head-oval\"",
            "write `head/head-oval`, or rename the file",
        ),
        (
            macros,
            "\"folder\": \"macro_build\"",
            "\"folder\": \"Macro_build\"",
            "write `macro_build`, or rename the folder",
        ),
        (
            macros,
            "\"highland-female\", \"t\"",
            "\"\", \"t\"",
            "did you mean `highland-female`?",
        ),
        (
            clothes,
            "4b7f-8e1d",
            "4b7f -8e1d",
            "write `uuid 38a1d6f4-50c2-4b7f-8e1d-6c09f2b4d702`, without spaces",
        ),
        (
            clothes,
            "d702",
            "d702 old",
            "write `uuid 38a1d6f4-50c2-4b7f-8e1d-6c09f2b4d702`, without spaces",
        ),
        (
            material,
            "shirt_folds.png",
            "shirt folds.png",
            "write `shirt_folds.png`: a name ends at the first space",
        ),
    ];
    for (file, find, replace, expected) in cases {
        assert_eq!(help(file, find, replace), expected);
    }
}

#[test]
fn help_names_a_picture_as_the_material_has_to_write_it() {
    let otherwise = "correct the name, add the picture, or remove the line";
    for (picture, expected) in [
        (
            "plain/maps/skin.png",
            "write `maps/skin.png`: the picture is there",
        ),
        (
            "other/skin.png",
            "write `other/skin.png`: the picture is there",
        ),
        // The first part of such a name is left out.
        ("skins/skin.png", otherwise),
        ("plain/my maps/skin.png", otherwise),
    ] {
        let root = example();
        let skins = root.path().join("data/skins/figure");
        for (file, text) in [
            ("plain/plain.mhmat", "diffuseTexture skin.png"),
            (picture, "a picture"),
        ] {
            fs::create_dir_all(skins.join(file).parent().unwrap()).unwrap();
            fs::write(skins.join(file), text).unwrap();
        }
        let output = mhlint(
            root.path(),
            &["--report", "json", "--no-eval", "--only", "material-*"],
        );
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(report["findings"][0]["help"], expected, "{picture}");
    }
}
