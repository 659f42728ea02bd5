//! Macro systems.

use super::Input;

pub(super) const INPUTS: &[Input] = &[
    Input {
        name: "macrodefs of one component",
        times: 1_000,
        files: macrodefs,
        args: &[],
        exit: 1,
    },
    Input {
        name: "a macrodef of many components",
        times: 6_500,
        files: components,
        args: &[],
        exit: 1,
    },
    Input {
        name: "macrodefs with thousands of corners",
        times: 13,
        files: corners,
        args: &[],
        exit: 1,
    },
    Input {
        name: "macro sliders",
        times: 3_000,
        files: sliders,
        args: &[],
        exit: 1,
    },
    Input {
        name: "a component of many steps",
        times: 20_000,
        files: steps,
        args: &[],
        exit: 1,
    },
    Input {
        name: "a component of many steps, named as often",
        times: 8_000,
        files: named_steps,
        args: &[],
        exit: 1,
    },
    Input {
        name: "components with misspelt steps",
        times: 30_000,
        files: misspelt,
        args: &[],
        exit: 1,
    },
];

/// A file.
pub(super) fn text(path: &str, text: impl Into<String>) -> (String, Vec<u8>) {
    (path.to_owned(), text.into().into_bytes())
}

/// Elements with commas between them.
pub(super) fn listed(times: usize, element: impl Fn(usize) -> String) -> String {
    (0..times).map(element).collect::<Vec<_>>().join(",")
}

/// A base mesh of one face, with its sliders and macros.
pub(super) fn base(
    settings: &str,
    sliders: Option<String>,
    macros: Option<String>,
) -> Vec<(String, Vec<u8>)> {
    let mut files = vec![
        text("data/base/figure/base.json", settings),
        text(
            "data/base/figure/base.obj",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng body\nf 1 2 3 4\n",
        ),
    ];
    files.extend(sliders.map(|sliders| text("data/target/figure/modelling.json", sliders)));
    files.extend(macros.map(|macros| text("data/target/figure/macro.json", macros)));
    files
}

fn system(sliders: usize, components: &str, macrodefs: &str) -> Vec<(String, Vec<u8>)> {
    let slider =
        |number| format!(r#""S{number}":{{"group":"a|b","macro":"m/S{number}","default":0.5}}"#);
    let macros = format!(r#"{{"components":{{{components}}},"macrodef":[{macrodefs}]}}"#);
    base(
        r#"{"visible groups": ["body"]}"#,
        Some(format!("{{{}}}", listed(sliders, slider))),
        Some(macros),
    )
}

fn component(number: usize, slider: usize) -> String {
    format!(r#""c{number}":{{"values":["a","b"],"steps":[0,1],"pattern":"m/S{slider}"}}"#)
}

fn macrodef(components: &str) -> String {
    format!(r#"{{"comp":[{components}],"folder":"f","targets":[{{"name":"a","t":null}}]}}"#)
}

fn names(range: std::ops::Range<usize>) -> String {
    range
        .map(|number| format!("\"c{number}\""))
        .collect::<Vec<_>>()
        .join(",")
}

fn macrodefs(times: usize) -> Vec<(String, Vec<u8>)> {
    system(1, &component(0, 0), &listed(times, |_| macrodef("\"c0\"")))
}

fn components(times: usize) -> Vec<(String, Vec<u8>)> {
    system(
        1,
        &listed(times, |number| component(number, 0)),
        &macrodef(&names(0..times)),
    )
}

fn corners(times: usize) -> Vec<(String, Vec<u8>)> {
    let all = listed(12 * times, |number| component(number, number));
    system(
        12 * times,
        &all,
        &listed(times, |number| {
            macrodef(&names(12 * number..12 * number + 12))
        }),
    )
}

fn sliders(times: usize) -> Vec<(String, Vec<u8>)> {
    system(
        times,
        &listed(times, |number| component(number, number)),
        &listed(30, |n| macrodef(&names(n..n + 1))),
    )
}

fn steps(times: usize) -> Vec<(String, Vec<u8>)> {
    let (values, steps) = (
        listed(times, |n| format!("\"{n}\"")),
        listed(times, |n| (n as f64 / times as f64).to_string()),
    );
    let component = format!(r#""c0":{{"values":[{values}],"steps":[{steps}],"pattern":"m/S0"}}"#);
    system(1, &component, &macrodef("\"c0\""))
}

fn named_steps(times: usize) -> Vec<(String, Vec<u8>)> {
    let component = format!(
        r#""c0":{{"values":["x"],"steps":[{}],"pattern":"m/S0"}}"#,
        listed(times, |_| "0.5".into())
    );
    system(
        1,
        &component,
        &macrodef(&listed(times, |_| "\"c0\"".into())),
    )
}

fn misspelt(times: usize) -> Vec<(String, Vec<u8>)> {
    system(
        1,
        &listed(times, |number| format!(r#""c{number}":{{"step":0}}"#)),
        &macrodef("\"c0\""),
    )
}
