//! Archives, skeletons, meshes, weights, slider settings.

mod archives;
mod rigs;

use super::Input;

type Files = Vec<(String, Vec<u8>)>;

const CHECK: &[&str] = &["check", "."];

pub(super) const INPUTS: &[Input] = &[
    input(
        "archive: members of four bytes a row",
        45,
        archives::dense_archive,
    ),
    input(
        "archive: one member of many names",
        1200,
        archives::overlapping_archive,
    ),
    input(
        "archive: packed mesh of single bytes",
        45,
        archives::dense_mesh,
    ),
    input(
        "skeletons: a chain of weighted bones, none claimed",
        6000,
        rigs::chains,
    ),
    input(
        "skeletons: pairs of bones on one large joint",
        4000,
        rigs::pairs,
    ),
    input(
        "skeletons: references to one bone of many weights",
        4000,
        rigs::references,
    ),
    input("skeletons: as many joints as vertices", 5000, rigs::joints),
    input(
        "skeletons: beside a default one of many bones",
        1_000,
        rigs::takers,
    ),
    input(
        "weights: small files beside a large mesh",
        800,
        rigs::small_weights,
    ),
    input("mesh: all vertices in one place", 60_000, one_place),
    input("mesh: places of two vertices, one hub", 20_000, hub),
    input(
        "sliders: half of details, half of macros",
        15_000,
        |count| sliders(count, "0", true),
    ),
    input("sliders: all set after a reset", 15_000, |count| {
        sliders(count, "0.5", false)
    }),
    input("folders: 1,900 levels", 1, |_| deep()),
    Input {
        args: &["eval", "weights", "w.mhw"],
        exit: 2,
        ..input("eval weights: vertex 16,777,215", 1, far_vertex)
    },
    Input {
        args: &[
            "eval",
            "cases",
            "cases.json",
            "--root",
            "makehuman2=.",
            "-o",
            "out.json",
        ],
        exit: 2,
        ..input("eval cases: vertices times cases", 2000, cases)
    },
    Input {
        args: &["check", ".", "--diff", "--unsafe-fixes"],
        ..input("diff: every other row goes", 40_000, zero_rows)
    },
];

const fn input(name: &'static str, times: usize, files: fn(usize) -> Files) -> Input {
    Input {
        name,
        times,
        files,
        args: CHECK,
        exit: 1,
    }
}

fn file(path: &str, text: impl Into<Vec<u8>>) -> (String, Vec<u8>) {
    (path.to_owned(), text.into())
}

/// A base with this mesh.
fn base(mesh: &str) -> Files {
    let settings = r#"{"visible groups": ["body"], "pose-skeleton": "default.mhskel"}"#;
    vec![
        file("data/base/b/base.json", settings),
        file("data/base/b/base.obj", mesh),
    ]
}

fn joined<T: std::fmt::Display>(parts: impl Iterator<Item = T>, between: &str) -> String {
    parts
        .map(|part| part.to_string())
        .collect::<Vec<_>>()
        .join(between)
}

const SQUARE: &str = "v -1 0 0\nv 1 0 0\nv 1 1 0\nv -1 1 0\ng body\nf 1 2 3 4\n";

fn one_place(count: usize) -> Files {
    base(&format!("{}g body\nf 1 2 3\n", "v 1 1 1\n".repeat(count)))
}

fn hub(count: usize) -> Files {
    let mesh = joined(
        (0..count).map(|at| {
            format!(
                "v {} {} 0",
                if at.is_multiple_of(2) { 1 } else { -1 },
                at / 4
            )
        }),
        "\n",
    );
    let faces = joined((2..count).map(|at| format!("f 1 {at} {}", at + 1)), "\n");
    base(&format!("{mesh}\ng body\n{faces}\n"))
}

fn sliders(count: usize, default: &str, with_macros: bool) -> Files {
    let slider = |at: usize| {
        if with_macros && at % 2 == 1 {
            format!(r#""s{at}":{{"macro":"m/{at}"}}"#)
        } else {
            format!(r#""s{at}":{{"incr":"t/a","decr":"t/b","default":{default}}}"#)
        }
    };
    let more = [
        file("data/target/b/t/a.target", "0 .1 0 0\n"),
        file("data/target/b/t/b.target", "0 -.1 0 0\n"),
        file(
            "data/target/b/modelling.json",
            format!("{{{}}}", joined((0..count).map(slider), ",")),
        ),
    ];
    [base(SQUARE), more.to_vec()].concat()
}

/// As deep as a path may be long.
fn deep() -> Files {
    [
        base(SQUARE),
        vec![file(
            &format!("data/{}x.target", "a/".repeat(1900)),
            "0 .1 0 0\n",
        )],
    ]
    .concat()
}

fn far_vertex(_: usize) -> Files {
    vec![file("w.mhw", r#"{"weights":{"a":[[16777215,0.5]]}}"#)]
}

fn cases(count: usize) -> Files {
    let case = r#"{"inputs":{"base":"b","modifiers":null}}"#;
    let ids = joined((0..20 * count).map(|_| 1), ",");
    let cases = joined((0..count).map(|_| case), ",");
    let text =
        format!(r#"{{"kind":"mh2_morph","inputs":{{"vertex_ids":[{ids}]}},"cases":[{cases}]}}"#);
    [base(SQUARE), vec![file("cases.json", text)]].concat()
}

fn zero_rows(count: usize) -> Files {
    let rows = joined(
        (0..count).map(|at| format!("{} 0 0 0\n{} .1 0 0\n", at % 4, at % 4)),
        "",
    );
    let more = [
        file("data/target/b/t/a.target", rows),
        file("data/target/b/modelling.json", r#"{"s": {"incr": "t/a"}}"#),
    ];
    [base(SQUARE), more.to_vec()].concat()
}
