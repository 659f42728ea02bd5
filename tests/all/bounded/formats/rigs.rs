//! Skeletons and weights of very many bones.

use super::{Files, SQUARE, base, file, joined};

fn skeleton(bones: &str, joints: &str) -> String {
    format!(
        r#"{{"name":"x","version":110,"weights_file":"w.mhw","bones":{{{bones}}},"joints":{{{joints}}}}}"#
    )
}

fn parent(bone: usize) -> String {
    bone.checked_sub(1)
        .map_or_else(|| "null".to_owned(), |parent| format!(r#""b{parent}""#))
}

/// A chain as pose skeleton, and one of other names that takes no weights of it.
pub(super) fn chains(count: usize) -> Files {
    let bones = |letter: &str| {
        let bone = |at| {
            format!(
                r#""{letter}{at}":{{"head":"a","tail":"c","parent":{}}}"#,
                parent(at)
            )
        };
        joined((0..count).map(bone), ",").replace("\"b", &format!("\"{letter}"))
    };
    let joints = r#""a":[0,3],"c":[1,2]"#;
    let weights = joined(
        (0..count).map(|at| format!(r#""b{at}":[[{},1]]"#, at % 4)),
        ",",
    );
    let more = [
        file("data/rigs/b/default.mhskel", skeleton(&bones("b"), joints)),
        file(
            "data/rigs/b/other.mhskel",
            skeleton(&bones("c"), joints).replace("\"x\"", "\"y\""),
        ),
        file(
            "data/rigs/b/w.mhw",
            format!(r#"{{"weights":{{{weights}}}}}"#),
        ),
    ];
    [base(SQUARE), more.to_vec()].concat()
}

pub(super) fn pairs(count: usize) -> Files {
    let side =
        |side: &str, at: usize| format!(r#""{at}.{side}":{{"head":"a","tail":"a","parent":"r"}}"#);
    let bones = joined(
        (0..count).flat_map(|at| [side("L", at), side("R", at)]),
        ",",
    );
    let mesh = joined(
        (0..count).flat_map(|at| [format!("v 1 {at} 0"), format!("v -1 {at} 0")]),
        "\n",
    );
    let joint = joined((0..count).map(|at| 2 * at), ",");
    let weights = joined(
        (0..count).map(|at| format!(r#""{at}.L":[[{},1]],"{at}.R":[[{},1]]"#, 2 * at + 1, 2 * at)),
        ",",
    );
    let root = format!(r#""r":{{"head":"a","tail":"a","parent":null}},{bones}"#);
    let more = [
        file(
            "data/rigs/b/default.mhskel",
            skeleton(&root, &format!(r#""a":[{joint}]"#)),
        ),
        file(
            "data/rigs/b/w.mhw",
            format!(r#"{{"weights":{{{weights}}}}}"#),
        ),
    ];
    [base(&format!("{mesh}\ng body\nf 1 2 3\n")), more.to_vec()].concat()
}

pub(super) fn references(count: usize) -> Files {
    let joints = r#""a":[0],"c":[1]"#;
    let bone = |at: usize| {
        format!(r#""c{at}":{{"head":"a","tail":"c","parent":null,"reference":["b","b"]}}"#)
    };
    let pairs = joined((0..count).map(|at| format!("[{at},1]")), ",");
    let own = r#""b":{"head":"a","tail":"c","parent":null}"#;
    let mesh = joined((0..count).map(|at| format!("v 1 {at} 0")), "\n");
    let more = [
        file("data/rigs/b/default.mhskel", skeleton(own, joints)),
        file("data/rigs/b/other.mhskel", {
            let more = joined((1..count).map(|at| bone(at).replace("null", "\"c0\"")), ",");
            skeleton(&format!("{},{more}", bone(0)), joints).replace("\"x\"", "\"y\"")
        }),
        file(
            "data/rigs/b/w.mhw",
            format!(r#"{{"weights":{{"b":[{pairs}]}}}}"#),
        ),
    ];
    [base(&format!("{mesh}\ng body\nf 1 2 3\n")), more.to_vec()].concat()
}

pub(super) fn joints(count: usize) -> Files {
    let bone = |at: usize| {
        format!(
            r#""b{at}":{{"head":"{at}","tail":"{}","parent":{}}}"#,
            at + 1,
            parent(at)
        )
    };
    let joints = joined((0..=count).map(|at| format!(r#""{at}":[{at}]"#)), ",");
    let mesh = joined((0..=count).map(|at| format!("v {} {at} 0", at % 7)), "\n");
    let faces = joined(
        (1..count)
            .map(|at| format!("f {at} {} {}", at + 1, at + 2))
            .filter(|_| count > 2),
        "\n",
    );
    let skeleton = skeleton(&joined((0..count).map(bone), ","), &joints);
    let mesh = format!("{mesh}\nv 0 0 1\ng body\n{faces}\n");
    [
        base(&mesh),
        vec![file("data/rigs/b/default.mhskel", skeleton)],
    ]
    .concat()
}

/// Skeletons of one bone, which takes nothing of as many weighted bones.
pub(super) fn takers(count: usize) -> Files {
    let joints = r#""a":[0,3],"c":[1,2]"#;
    let own = joined(
        (0..count).map(|at| {
            format!(
                r#""b{at}":{{"head":"a","tail":"c","parent":{}}}"#,
                parent(at)
            )
        }),
        ",",
    );
    let weights = joined(
        (0..count).map(|at| format!(r#""b{at}":[[{},1]]"#, at % 4)),
        ",",
    );
    let other = |at: usize| {
        let text = skeleton(r#""r":{"head":"a","tail":"c","parent":null}"#, joints);
        file(&format!("data/rigs/b/r{at}.mhskel"), text)
    };
    let more = [
        file("data/rigs/b/default.mhskel", skeleton(&own, joints)),
        file(
            "data/rigs/b/w.mhw",
            format!(r#"{{"weights":{{{weights}}}}}"#),
        ),
    ];
    [base(SQUARE), more.to_vec(), (0..count).map(other).collect()].concat()
}

/// Weights of one vertex each. Of the mesh only every other vertex is used, so that those without
/// weight are no run.
pub(super) fn small_weights(count: usize) -> Files {
    let mesh = "v 1 1 1\n".repeat(20 * count);
    let faces = joined(
        (0..3 * count)
            .map(|at| 6 * at + 1)
            .map(|at| format!("f {at} {} {}", at + 2, at + 4)),
        "\n",
    );
    let weights = |at: usize| {
        file(
            &format!("data/rigs/b/w{at}.mhw"),
            r#"{"weights":{"a":[[0,1]]}}"#,
        )
    };
    [
        base(&format!("{mesh}g body\n{faces}\n")),
        (0..count).map(weights).collect(),
    ]
    .concat()
}
