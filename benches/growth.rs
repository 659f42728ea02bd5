//! How a run grows with what it reads: `cargo bench --bench growth`, or
//! `cargo bench --bench growth -- sliders` for one row.
//!
//! Repositories of one size and of four times that size are written to a folder and checked by the
//! program itself, as a user runs it. Four times as much may take at most [`BOUND`] times the
//! processor time; a row beyond it fails the run. What grows with the square takes 16 times as
//! long, so that it shows whatever the machine.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a benchmark prints, and stops where it fails"
)]

use std::fmt::Write as _;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Duration;

/// How many times as long four times as much may take.
const BOUND: f64 = 4.6;
/// Runs of each size; the one in the middle counts.
const RUNS: usize = 9;

/// Files of a repository: path and bytes.
type Files = Vec<(String, Vec<u8>)>;

/// A kind of repository that grows.
struct Shape {
    name: &'static str,
    /// How many there are in the small one.
    few: usize,
    make: fn(usize) -> Files,
    /// A rule that finds something, where the shape is about faults.
    finds: Option<&'static str>,
}

const SHAPES: [Shape; 16] = [
    Shape {
        name: "sliders",
        few: 2_000,
        make: sliders,
        finds: None,
    },
    Shape {
        name: "sliders without targets",
        few: 1_000,
        make: dead_sliders,
        finds: Some("modelling-missing-target"),
    },
    Shape {
        name: "unused pictures",
        few: 2_000,
        make: unused_pictures,
        finds: Some("file-unreferenced"),
    },
    Shape {
        name: "unused targets",
        few: 2_000,
        make: unused_targets,
        finds: Some("target-unreferenced"),
    },
    Shape {
        name: "bases",
        few: 50,
        make: bases,
        finds: None,
    },
    Shape {
        name: "faulty targets",
        few: 2_000,
        make: faulty_targets,
        finds: Some("target-syntax"),
    },
    Shape {
        name: "faulty texts",
        few: 1_000,
        make: faulty_texts,
        finds: Some("json-syntax"),
    },
    Shape {
        name: "faults in one JSON",
        few: 2_000,
        make: faults_in_one,
        finds: Some("json-schema"),
    },
    Shape {
        name: "faults in one list",
        few: 2_000,
        make: faults_in_list,
        finds: Some("json-schema"),
    },
    Shape {
        name: "lines of a model",
        few: 2_000,
        make: lines_of_model,
        finds: Some("model-unknown-asset"),
    },
    Shape {
        name: "assets of one folder",
        few: 1_000,
        make: assets_of_folder,
        finds: Some("proxy-missing-mesh"),
    },
    Shape {
        name: "ink layers",
        few: 1_000,
        make: ink_layers,
        finds: Some("ink-layer"),
    },
    Shape {
        name: "names in other capitals",
        few: 500,
        make: capitals,
        finds: Some("file-case-conflict"),
    },
    Shape {
        name: "uuids of a model",
        few: 700,
        make: uuids_of_model,
        finds: Some("model-unknown-asset"),
    },
    Shape {
        name: "groups of modifiers",
        few: 500,
        make: groups_of_modifiers,
        finds: Some("modifiers-no-target"),
    },
    Shape {
        name: "shaders of skins",
        few: 500,
        make: shaders_of_skins,
        finds: Some("material-missing-shader"),
    },
];

fn main() -> ExitCode {
    let wanted = std::env::args()
        .skip(1)
        .find(|arg| !arg.starts_with('-'))
        .unwrap_or_default();
    println!(
        "{:<26}{:>8}{:>12}{:>12}{:>8}",
        "", "few", "few", "4 x few", "factor"
    );
    let mut steep = 0;
    for shape in SHAPES.iter().filter(|shape| shape.name.contains(&wanted)) {
        let [small, large] = time(shape);
        let factor = large.as_secs_f64() / small.as_secs_f64();
        let shown = |time: Duration| format!("{:.1} ms", time.as_secs_f64() * 1e3);
        let word = if factor > BOUND { "  too steep" } else { "" };
        println!(
            "{:<26}{:>8}{:>12}{:>12}{factor:>8.2}{word}",
            shape.name,
            shape.few,
            shown(small),
            shown(large)
        );
        steep += usize::from(factor > BOUND);
    }
    if steep == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// The middle of some runs on few and on four times as many, in turn: what else the machine does
/// concerns both.
fn time(shape: &Shape) -> [Duration; 2] {
    let repositories = [1, 4].map(|times| written(&(shape.make)(shape.few * times)));
    for repository in &repositories {
        assert_shown(shape, repository.path());
    }
    let mut times = [const { Vec::new() }; 2];
    for _ in 0..RUNS {
        for (times, repository) in times.iter_mut().zip(&repositories) {
            let start = clock();
            mhlint(repository.path());
            times.push(clock().saturating_sub(start));
        }
    }
    times.map(|mut times| {
        times.sort_unstable();
        times[RUNS / 2]
    })
}

fn written(files: &Files) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, bytes) in files {
        let path = folder.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
    folder
}

/// The JSON report on a repository.
fn mhlint(repository: &Path) -> Vec<u8> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mhlint"));
    command
        .args(["--report", "json"])
        .arg(repository)
        .output()
        .unwrap()
        .stdout
}

/// Processor time of the programs that were run.
#[cfg(unix)]
fn clock() -> Duration {
    use nix::sys::{
        resource::{UsageWho, getrusage},
        time::TimeValLike as _,
    };
    let usage = getrusage(UsageWho::RUSAGE_CHILDREN).unwrap();
    let microseconds =
        usage.user_time().num_microseconds() + usage.system_time().num_microseconds();
    Duration::from_micros(u64::try_from(microseconds).unwrap())
}

#[cfg(not(unix))]
fn clock() -> Duration {
    static START: std::sync::LazyLock<std::time::Instant> =
        std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed()
}

/// A repository that is not what it is taken for measures nothing.
fn assert_shown(shape: &Shape, repository: &Path) {
    let report: serde_json::Value = serde_json::from_slice(&mhlint(repository)).unwrap();
    assert_ne!(report["summary"]["files"], 0, "{}", shape.name);
    let rules: Vec<&str> = report["findings"]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|it| it["rule"].as_str())
        .collect();
    assert!(
        shape.finds.is_none_or(|rule| rules.contains(&rule)),
        "{}: {rules:?}",
        shape.name
    );
}

const BASE: &str =
    r#"{"visible groups": ["body"], "numverts": 8, "target-opposites": {"decr": "incr"}}"#;

/// A cube with a base mesh's settings around it.
fn base(name: &str) -> Files {
    let mut mesh = String::new();
    for vertex in 0..8 {
        writeln!(mesh, "v {} {} {}", vertex & 1, vertex >> 1 & 1, vertex >> 2).unwrap();
    }
    mesh.push_str("g body\n");
    for face in [
        "1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4",
    ] {
        writeln!(mesh, "f {face}").unwrap();
    }
    vec![
        (format!("base/{name}/base.json"), BASE.as_bytes().to_vec()),
        (format!("base/{name}/base.obj"), mesh.into_bytes()),
        (
            format!("target/{name}/target_cat.json"),
            br#"{"Body": {"group": "body", "items": []}}"#.to_vec(),
        ),
    ]
}

/// Sliders of a base, each with what `members` says.
fn modelling(name: &str, count: usize, members: impl Fn(usize) -> String) -> (String, Vec<u8>) {
    let rows: Vec<String> = (0..count)
        .map(|number| format!("\"S{number}\": {{{}}}", members(number)))
        .collect();
    (
        format!("target/{name}/modelling.json"),
        format!("{{\n{}\n}}\n", rows.join(",\n")).into_bytes(),
    )
}

/// A target of one row.
fn target(name: &str, number: usize) -> (String, Vec<u8>) {
    let row = format!("{} 0.{:04} 0.1 0\n", number % 8, number % 9_999 + 1);
    (
        format!("target/{name}/body/t{number}.target"),
        row.into_bytes(),
    )
}

fn sliders(count: usize) -> Files {
    let mut files = base("cube");
    files.push(modelling("cube", count, |number| {
        format!(r#""group": "body", "incr": "body/t{number}""#)
    }));
    files.extend((0..count).map(|number| target("cube", number)));
    files
}

fn dead_sliders(count: usize) -> Files {
    let mut files = base("cube");
    files.push(modelling("cube", count, |number| {
        format!(r#""group": "body", "incr": "body/t{number}""#)
    }));
    files.extend((0..count).map(|number| target("cube", number + 10 * count)));
    files
}

fn unused_pictures(count: usize) -> Files {
    let mut files = sliders(1);
    // All of one size, as thumbnails are.
    let bytes = |number: usize| format!("\u{89}PNG {number:08}").into_bytes();
    files.extend(
        (0..count).map(|number| (format!("target/cube/icons/i{number}.png"), bytes(number))),
    );
    files
}

fn unused_targets(count: usize) -> Files {
    let mut files = sliders(1);
    files.extend((1..count).map(|number| target("cube", number)));
    files
}

fn bases(count: usize) -> Files {
    let mut files = Files::new();
    for name in (0..count).map(|number| format!("b{number}")) {
        files.extend(base(&name));
        files.push(modelling(&name, 10, |number| {
            format!(r#""group": "body", "incr": "body/t{number}""#)
        }));
        files.extend((0..10).map(|number| target(&name, number)));
    }
    files
}

fn faulty_targets(count: usize) -> Files {
    let mut files = sliders(count);
    for (_, bytes) in files
        .iter_mut()
        .filter(|(path, _)| path.ends_with(".target"))
    {
        bytes.extend_from_slice(b"3 0.1 one 0\n");
    }
    files
}

fn faulty_texts(count: usize) -> Files {
    let mut files = sliders(1);
    files.extend((0..count).map(|number| {
        (
            format!("rigs/cube/r{number}.mhskel"),
            b"{\"bones\": [,]}".to_vec(),
        )
    }));
    files
}

fn faults_in_one(count: usize) -> Files {
    let mut files = base("cube");
    files.push(modelling("cube", count, |_| {
        r#""group": "body", "incr": 7, "default": "half", "tipp": "x""#.to_owned()
    }));
    files
}

fn faults_in_list(count: usize) -> Files {
    let mut files = sliders(1);
    let items: Vec<String> = (0..count)
        .map(|number| format!(r#"{{"title": {number}, "catt": "x"}}"#))
        .collect();
    let text = format!(
        r#"{{"Body": {{"group": "body", "items": [{}]}}}}"#,
        items.join(",\n")
    );
    files.retain(|(path, _)| !path.ends_with("target_cat.json"));
    files.push(("target/cube/target_cat.json".to_owned(), text.into_bytes()));
    files
}

/// What MakeHuman 1 needs to be taken for more than a part of it.
fn makehuman1() -> Files {
    let named = |path: &str, text: &str| (format!("data/{path}"), text.as_bytes().to_vec());
    vec![
        named(
            "3dobjs/base.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\ng body\nf 1 2 3\n",
        ),
        named("modifiers/modeling_modifiers.json", "[]"),
        named("targets/macrodetails/a.target", "0 0 0 .1\n"),
        named("rigs/default.mhskel", "{}"),
        named("poseunits/face-poseunits.json", "{}"),
        named("shaders/glsl/own_fragment_shader.txt", "void main() {}\n"),
        named("eyes/high-poly/high-poly.mhclo", "name eyes\n"),
        named("skins/default.mhmat", "name default\n"),
        (
            "user/data/custom/x.target".to_owned(),
            b"0 0 0 .1\n".to_vec(),
        ),
    ]
}

/// A character of MakeHuman 1 whose lines have the names of assets, and other uuids.
fn uuids_of_model(count: usize) -> Files {
    let mut lines = "version v1.3.0\nname a\n".to_owned();
    (0..count).for_each(|number| writeln!(lines, "clothes c{number} other{number}").unwrap());
    let asset = |number: usize| {
        let text = format!("name c{number}\nuuid {number}\nverts 0\n0\n1\n2\n");
        (
            format!("user/data/clothes/c{number}/c{number}.mhclo"),
            text.into_bytes(),
        )
    };
    let model = ("user/models/a.mhm".to_owned(), lines.into_bytes());
    makehuman1()
        .into_iter()
        .chain((0..count).map(asset))
        .chain([model])
        .collect()
}

/// Modifiers of MakeHuman 1, each in a group of its own without targets.
fn groups_of_modifiers(count: usize) -> Files {
    let group = |number: usize| {
        format!(r#"{{"group": "g{number}", "modifiers": [{{"target": "a"}}, {{"target": "b"}}]}}"#)
    };
    let text = format!(
        "[{}]",
        (0..count).map(group).collect::<Vec<_>>().join(",\n")
    );
    let mut files = makehuman1();
    files.retain(|(path, _)| !path.ends_with("_modifiers.json"));
    files.push((
        "data/modifiers/modeling_modifiers.json".to_owned(),
        text.into_bytes(),
    ));
    files.extend((0..count).map(|number| {
        (
            format!("data/targets/h{number}/a.target"),
            b"0 0 0 .1\n".to_vec(),
        )
    }));
    files
}

/// Skins of MakeHuman 1 with shaders that nobody has, beside others.
fn shaders_of_skins(count: usize) -> Files {
    let skin = |number: usize| {
        let text = format!("name s{number}\nshader shaders/glsl/none{number}\n");
        (
            format!("user/data/skins/s{number}/s{number}.mhmat"),
            text.into_bytes(),
        )
    };
    let shader = |number: usize| {
        (
            format!("data/shaders/glsl/s{number}_fragment_shader.txt"),
            b"void main() {}\n".to_vec(),
        )
    };
    makehuman1()
        .into_iter()
        .chain((0..count).map(skin))
        .chain((0..count).map(shader))
        .collect()
}

/// A character of MakeHuman 1 with lines for assets and materials that nobody has.
fn lines_of_model(count: usize) -> Files {
    let mut lines = "version v1.3.0\nname a\n".to_owned();
    (0..count).for_each(|number| {
        writeln!(
            lines,
            "clothes c{number} {number}\nmaterial c{number} {number} a.mhmat"
        )
        .unwrap();
    });
    makehuman1()
        .into_iter()
        .chain([("user/models/a.mhm".to_owned(), lines.into_bytes())])
        .collect()
}

/// Assets in the folder of one, all without their mesh.
fn assets_of_folder(count: usize) -> Files {
    let asset = |number: usize| {
        let text = format!("name a{number}\nuuid {number}\nobj_file m{number}.obj\nverts 0\n5\n");
        (format!("clothes/b/a/a{number}.mhclo"), text.into_bytes())
    };
    base("b").into_iter().chain((0..count).map(asset)).collect()
}

/// Ink layers of MPFB without their pictures.
fn ink_layers(count: usize) -> Files {
    let layer = |number: usize| {
        let text = format!("{{\"focus\": \"\", \"image_name\": \"p{number}.png\"}}");
        (format!("data/ink_layers/x{number}.json"), text.into_bytes())
    };
    let mut files: Files = (0..count).map(layer).collect();
    files.push((
        "config/human.a.json".to_owned(),
        b"{\"phenotype\": {}}".to_vec(),
    ));
    files
}

/// Pictures whose names differ in nothing but capitals.
fn capitals(count: usize) -> Files {
    let name = |number: usize| -> String {
        let letters = "abcdefghijklmn".chars().enumerate();
        letters
            .map(|(bit, letter)| {
                if number >> bit & 1 == 1 {
                    letter.to_ascii_uppercase()
                } else {
                    letter
                }
            })
            .collect()
    };
    let pictures =
        (0..count).map(|number| (format!("clothes/b/a/{}.png", name(number)), b"x".to_vec()));
    base("b").into_iter().chain(pictures).collect()
}
