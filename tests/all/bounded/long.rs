//! One long name that much refers to, and many things that are told of one another.

use super::Input;

type Files = Vec<(String, Vec<u8>)>;

pub(super) const INPUTS: &[Input] = &[
    input("long: an object with repeated keys", 1000, repeated_keys),
    input("long: a list with numbers for texts", 1000, wrong_values),
    input("long: an object with unknown keys", 1000, unknown_keys),
    input("long: a bone with negative weights", 3000, |times| {
        bone(times, |number| format!("[{number},-{number}]"))
    }),
    input("long: a bone with malformed pairs", 3000, |times| {
        bone(times, |number| format!("[{number}]"))
    }),
    input("long: a group that reopened ones land in", 3000, reopened),
    input("long: a folder with heirs", 3000, heirs),
    input("materials of a picture that is not there", 3000, materials),
    input("pictures of one material", 3000, pictures),
    input("faults of one material", 30_000, faults),
    input("macrodefs that list the same name", 250, pairs),
    input("targets that differ in capitals", 600, alike),
    Input {
        args: &["check", ".", "--diff"],
        exit: 0,
        ..input("diff: references in other capitals", 600, capitals)
    },
];

const fn input(name: &'static str, times: usize, files: fn(usize) -> Files) -> Input {
    Input {
        name,
        times,
        files,
        args: &["check", "."],
        exit: 1,
    }
}

const LONG: usize = 200_000;
const MESH: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng body\nf 1 2 3\n";
const MODELLING: &str = "target/b/modelling.json";
const MACRO: &str = "target/b/macro.json";

fn base(mesh: &str, more: Vec<(&str, String)>) -> Files {
    let settings = r#"{"visible groups": ["body"], "pose-skeleton": "default.mhskel"}"#.to_owned();
    let files = [
        ("base/b/base.json", settings),
        ("base/b/base.obj", mesh.to_owned()),
    ]
    .into_iter()
    .chain(more);
    files
        .map(|(path, text)| (path.to_owned(), text.into_bytes()))
        .collect()
}

fn listed(times: usize, part: impl Fn(usize) -> String) -> String {
    (0..times).map(part).collect::<Vec<_>>().join(",")
}

fn slider(members: &str) -> Files {
    base(
        MESH,
        vec![(
            MODELLING,
            format!("{{\"{}\":{{{members}}}}}", "k".repeat(LONG)),
        )],
    )
}

fn repeated_keys(times: usize) -> Files {
    slider(&listed(times, |number| {
        format!("\"a{0}\":1,\"a{0}\":1", number / 2)
    }))
}

fn wrong_values(times: usize) -> Files {
    slider(&format!(
        "\"barycentric\":[{}]",
        listed(times, |_| "1".to_owned())
    ))
}

fn unknown_keys(times: usize) -> Files {
    slider(&listed(times, |number| format!("\"q{number}\":1")))
}

fn bone(times: usize, pair: fn(usize) -> String) -> Files {
    let weights = format!(
        "{{\"weights\":{{\"{}\":[{}]}}}}",
        "b".repeat(LONG),
        listed(times, pair)
    );
    let skeleton = r#"{"name": "d", "joints": {"a": [0], "b": [1]}, "bones": {"r": {"head": "a", "tail": "b", "parent": null}}}"#;
    base(
        MESH,
        vec![
            ("rigs/b/default.mhskel", skeleton.to_owned()),
            ("rigs/b/default_weights.mhw", weights),
        ],
    )
}

fn reopened(times: usize) -> Files {
    let groups = (0..times)
        .map(|number| format!("g g{number}\n"))
        .collect::<Vec<_>>()
        .concat();
    base(
        &format!("{MESH}{groups}g {}\nf 1 2 3\n{groups}", "L".repeat(LONG)),
        Vec::new(),
    )
}

fn heirs(times: usize) -> Files {
    let heirs = listed(times, |_| "{}".to_owned());
    let macros = format!(
        "{{\"components\":{{}},\"macrodef\":[{{\"folder\":\"{}\"}},{heirs}]}}",
        "x".repeat(LONG)
    );
    base(MESH, vec![(MACRO, macros), (MODELLING, "{}".to_owned())])
}

fn materials(times: usize) -> Files {
    let material = |number| {
        (
            format!("skins/b/m{number}.mhmat"),
            format!("diffuseTexture t{number}.png\n").into_bytes(),
        )
    };
    base(MESH, Vec::new())
        .into_iter()
        .chain((0..times).map(material))
        .collect()
}

fn pictures(times: usize) -> Files {
    let lines = (0..times)
        .map(|number| format!("diffuseTexture t{number}.png\n"))
        .collect::<Vec<_>>()
        .concat();
    base(MESH, vec![("skins/b/a.mhmat", lines)])
}

fn faults(times: usize) -> Files {
    let line = |number| {
        format!(
            "roughnessFactor x\nshaderParam p{number} {number}\nword{number} 1\ntransparent maybe\n"
        )
    };
    base(
        MESH,
        vec![(
            "skins/b/a.mhmat",
            (0..times).map(line).collect::<Vec<_>>().concat(),
        )],
    )
}

fn pairs(times: usize) -> Files {
    let one = |number| {
        format!(
            r#"{{"name":"d{number}","comp":["a"],"folder":"f","targets":[{{"name":"x","t":"t"}}]}}"#
        )
    };
    let components = r#"{"a":{"values":["x","y"],"steps":[0,1],"pattern":"m"}}"#;
    let macros = format!(
        "{{\"components\":{components},\"macrodef\":[{}]}}",
        listed(times, one)
    );
    base(
        MESH,
        vec![
            (MACRO, macros),
            (MODELLING, r#"{"A":{"macro":"m"}}"#.to_owned()),
        ],
    )
}

/// Fourteen letters of which the number says which are capitals.
fn name(number: usize) -> String {
    let letter = |(at, letter): (usize, char)| {
        if number >> at & 1 == 1 {
            letter.to_ascii_uppercase()
        } else {
            letter
        }
    };
    "abcdefghijklmn".chars().enumerate().map(letter).collect()
}

fn alike(times: usize) -> Files {
    let target = |number| {
        (
            format!("target/b/{}.target", name(number)),
            b"0 0 0 1\n".to_vec(),
        )
    };
    let sliders = listed(times, |number| {
        format!("\"s{number}\":{{\"incr\":\"{}\"}}", name(number + 8000))
    });
    base(MESH, vec![(MODELLING, format!("{{{sliders}}}"))])
        .into_iter()
        .chain((0..times).map(target))
        .collect()
}

fn capitals(times: usize) -> Files {
    let target = |number| (format!("target/b/a{number}.target"), b"0 0 0 1\n".to_vec());
    let sliders = listed(times, |number| {
        format!("\"s{number}\":{{\"incr\":\"A{number}\"}}")
    });
    base(MESH, vec![(MODELLING, format!("{{{sliders}}}"))])
        .into_iter()
        .chain((0..times).map(target))
        .collect()
}
