//! What a body wears, without end.

use super::Input;

const BASE: &str = r#"{"visible groups": ["body"], "equipment": ["clothes"]}"#;
const MESH: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\ng body\nf 1/1 2/2 3/3\n";

pub(super) const INPUTS: &[Input] = &[
    Input {
        name: "models that wear assets",
        times: 60,
        files: models,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "models that wear broken assets",
        times: 60,
        files: broken,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "assets of one identity",
        times: 500,
        files: copies,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "assets without a material in one folder",
        times: 500,
        files: bare,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "mesh of an asset: faces, one of them bad",
        times: 30_000,
        files: faces,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "asset: rows with faults",
        times: 10_000,
        files: rows,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "asset: lines of the head",
        times: 20_000,
        files: head,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "asset: ranges to hide",
        times: 20_000,
        files: ranges,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "filter: paths below paths",
        times: 5_000,
        files: filter,
        args: &["data"],
        exit: 1,
    },
    Input {
        name: "pose: units that do not exist",
        times: 10_000,
        files: pose,
        args: &["data"],
        exit: 1,
    },
];

type Files = Vec<(String, Vec<u8>)>;

fn lines(times: usize, line: impl Fn(usize) -> String) -> String {
    (0..times).map(line).collect()
}

/// A base and a file for it.
fn with(path: &str, text: String) -> Files {
    let mut files = base();
    files.push((format!("data/{path}"), text.into_bytes()));
    files
}

fn base() -> Files {
    vec![
        ("data/base/b/base.json".to_owned(), BASE.into()),
        ("data/base/b/base.obj".to_owned(), MESH.into()),
        // A fault for a verdict that does not depend on the rest.
        (
            "data/clothes/b/fault/fault.mhclo".to_owned(),
            "name fault\nobj_file no.obj\nverts\n0\n".into(),
        ),
    ]
}

fn asset(name: &str, mesh: &str) -> (String, Vec<u8>) {
    let text = format!("name {name}\nuuid {name}\nobj_file {mesh}\nverts 0\n0\n1\n2\n");
    (
        format!("data/clothes/b/{name}/{name}.mhclo"),
        text.into_bytes(),
    )
}

/// As many models as assets, and each wears all.
fn worn(times: usize, mesh: &str) -> Files {
    let mut files = base();
    let worn = lines(times, |at| format!("clothes asset{at} asset{at}\n"));
    for at in 0..times {
        let name = format!("asset{at}");
        files.push((format!("data/clothes/b/{name}/mesh.obj"), MESH.into()));
        files.push(asset(&name, mesh));
        files.push((
            format!("data/models/b/model{at}.mhm"),
            format!("name m{at}\n{worn}").into_bytes(),
        ));
    }
    files
}

fn models(times: usize) -> Files {
    worn(times, "mesh.obj")
}

fn broken(times: usize) -> Files {
    worn(times, "lost.obj")
}

fn copies(times: usize) -> Files {
    let mut files = base();
    for at in 0..times {
        let text = format!("name one\nuuid 1\nobj_file mesh.obj\n# {at}\nverts 0\n0\n1\n2\n");
        files.push((
            format!("data/clothes/b/copy{at}/copy.mhclo"),
            text.into_bytes(),
        ));
    }
    files
}

fn bare(times: usize) -> Files {
    let mut files = base();
    for at in 0..times {
        let text = format!(
            "name n{at}\nuuid {at}\nobj_file o{at}.obj\nmaterial m{at}.mhmat\nverts 0\n0\n1\n2\n"
        );
        files.push((format!("data/clothes/b/a{at}.mhclo"), text.into_bytes()));
        files.push((
            format!("data/clothes/b/other{at}.mhmat"),
            b"name x\n".to_vec(),
        ));
    }
    files
}

fn with_asset(path: &str, text: String) -> Files {
    let mut files = with(path, text);
    files.push(asset("one", "one.obj"));
    files
}

fn faces(times: usize) -> Files {
    with_asset(
        "clothes/b/one/one.obj",
        format!("{MESH}{}f 1/1 2/2 9/9\n", "f 1/1 2/2 3/3\n".repeat(times)),
    )
}

fn rows(times: usize) -> Files {
    let rows = "0 1 2 nan 2 9 1 1 1\n-1\n99 0 0 1 1 1 0 0 0\n1,5 2 3 4 5 6\n".repeat(times);
    with(
        "clothes/b/one/one.mhclo",
        format!("name one\nuuid 1\nobj_file one.obj\nverts 0\n{rows}"),
    )
}

fn head(times: usize) -> Files {
    let lines = lines(times, |at| {
        format!("tagg{at} a\ntag körper{at};b\n# author {at}\n")
    });
    with(
        "clothes/b/one/one.mhclo",
        format!("name one\nuuid 1\n{lines}obj_file one.obj\nverts 0\n0\n"),
    )
}

fn ranges(times: usize) -> Files {
    let lines = lines(times, |at| format!("{at} - {} -\n-{at}\n", at / 2));
    with(
        "clothes/b/one/one.mhclo",
        format!("name one\nuuid 1\nobj_file o.obj\nverts 0\n0\ndelete_verts\n{lines}"),
    )
}

fn filter(times: usize) -> Files {
    let leaves: Vec<String> = (0..times).map(|at| format!("\"l{at}\"")).collect();
    let tree = format!(
        "{}[{}]{}",
        "{\"abcdefghi\": ".repeat(90),
        leaves.join(","),
        "}".repeat(90)
    );
    let led: Vec<String> = (0..times)
        .map(|at| format!("\"t{at}\": \"lost:{at}\""))
        .collect();
    with(
        "clothes/b/selection_filter.json",
        format!("{{\"Slot\": {tree}, \"Translate\": {{{}}}}}", led.join(",")),
    )
}

fn pose(times: usize) -> Files {
    let values: Vec<String> = (0..times).map(|at| format!("\"Unit{at}\": 60")).collect();
    let mut files = with(
        "poses/b/p.mhpose",
        format!(
            "{{\"name\": \"p\", \"unit_poses\": {{{}}}}}",
            values.join(",")
        ),
    );
    files.push((
        "data/base/b/body-poses.json".to_owned(),
        b"{\"Units\": {\"group\": \"a\", \"bones\": {}}}".to_vec(),
    ));
    files
}
