//! Settings, formulas, texts in JSON.

use super::Input;
use super::macros::{base, listed, text};

pub(super) const INPUTS: &[Input] = &[
    Input {
        name: "glob of braces in braces, 126 levels",
        times: 126,
        files: nested,
        args: &[],
        exit: 2,
    },
    Input {
        name: "the same, 50,000 levels",
        times: 50_000,
        files: nested,
        args: &[],
        exit: 2,
    },
    Input {
        name: "mute of a glob of 10,000 levels",
        times: 10_000,
        files: nested_mute,
        args: &[],
        exit: 2,
    },
    Input {
        name: "settings of globs with wildcards",
        times: 90_000,
        files: wildcards,
        args: &[],
        exit: 2,
    },
    Input {
        name: "globs and files",
        times: 300,
        files: globs_and_files,
        args: &[],
        exit: 1,
    },
    Input {
        name: "settings of plain paths",
        times: 90_000,
        files: plain_paths,
        args: &[],
        exit: 1,
    },
    Input {
        name: "settings of rules that do not exist",
        times: 60_000,
        files: unknown_rules,
        args: &[],
        exit: 1,
    },
    Input {
        name: "settings of empty tables",
        times: 15_400,
        files: empty_tables,
        args: &[],
        exit: 2,
    },
    Input {
        name: "settings of unknown keys",
        times: 60_000,
        files: unknown_settings,
        args: &[],
        exit: 2,
    },
    Input {
        name: "weights of numbers in place of lists",
        times: 75_000,
        files: weights,
        args: &[],
        exit: 1,
    },
    Input {
        name: "sliders with a text for a number",
        times: 35_000,
        files: sliders,
        args: &[],
        exit: 1,
    },
    Input {
        name: "unknown keys",
        times: 70_000,
        files: unknown_keys,
        args: &[],
        exit: 1,
    },
    Input {
        name: "unknown keys where one is missing",
        times: 70_000,
        files: bones_at_the_top,
        args: &[],
        exit: 1,
    },
    Input {
        name: "formulas of line ends",
        times: 30_000,
        files: line_ends,
        args: &[],
        exit: 1,
    },
    Input {
        name: "random groups that do not exist",
        times: 20_000,
        files: groups,
        args: &[],
        exit: 1,
    },
];

const EXCLUDE: &str = "exclude = [";

fn settings(text: String) -> Vec<(String, Vec<u8>)> {
    let mut files = base("{}", None, None);
    files.push(("mhlint.toml".to_owned(), text.into_bytes()));
    files
}

fn nested(times: usize) -> Vec<(String, Vec<u8>)> {
    settings(format!(
        "{EXCLUDE}\"{}{}\"]\n",
        "{a,".repeat(times),
        "}".repeat(times)
    ))
}

fn nested_mute(times: usize) -> Vec<(String, Vec<u8>)> {
    let glob = "{a,".repeat(times) + &"}".repeat(times);
    settings(format!(
        "[[ignore]]\nrule = \"{glob}\"\npath = \"{glob}\"\nreason = \"none\"\n"
    ))
}

fn wildcards(times: usize) -> Vec<(String, Vec<u8>)> {
    settings(format!(
        "{EXCLUDE}{}]\n",
        listed(times, |number| format!("\"*{number:x}*\""))
    ))
}

fn globs_and_files(times: usize) -> Vec<(String, Vec<u8>)> {
    // More globs are refused.
    let globs = listed(times.min(450), |number| format!("\"**/*{number:x}x*\""));
    let mut files = settings(format!("{EXCLUDE}{globs}]\n"));
    let path = |number: usize| {
        format!(
            "data/target/figure/folder{}/target-{number}.target",
            number % 50
        )
    };
    files.extend((0..10 * times).map(|number| (path(number), b"0 1 0 0\n".to_vec())));
    files
}

fn plain_paths(times: usize) -> Vec<(String, Vec<u8>)> {
    settings(format!(
        "{EXCLUDE}{}]\n",
        listed(times, |number| format!("\"d{number}\""))
    ))
}

fn unknown_rules(times: usize) -> Vec<(String, Vec<u8>)> {
    settings(format!(
        "skip = [{}]\n",
        listed(times, |number| format!("\"rule-{number}\""))
    ))
}

fn empty_tables(times: usize) -> Vec<(String, Vec<u8>)> {
    settings("[[ignore]]\n".repeat(times))
}

fn unknown_settings(times: usize) -> Vec<(String, Vec<u8>)> {
    settings(
        (0..times)
            .map(|number| format!("key{number} = 1"))
            .collect::<Vec<_>>()
            .join("\n"),
    )
}

fn weights(times: usize) -> Vec<(String, Vec<u8>)> {
    let mut files = base("{}", None, None);
    let bones = listed(times, |number| format!("\"b{number}\":7"));
    files.push(text(
        "data/rigs/figure/a.mhw",
        format!("{{\"weights\":{{{bones}}}}}"),
    ));
    files
}

fn bones_at_the_top(times: usize) -> Vec<(String, Vec<u8>)> {
    let mut files = base("{}", None, None);
    files.push(text(
        "data/rigs/figure/a.mhskel",
        format!("{{{}}}", listed(times, |number| format!("\"q{number}\":7"))),
    ));
    files
}

fn sliders(times: usize) -> Vec<(String, Vec<u8>)> {
    let sliders = listed(times, |number| {
        format!("\"s{number}\":{{\"default\":\"x\"}}")
    });
    base("{}", Some(format!("{{{sliders}}}")), None)
}

fn unknown_keys(times: usize) -> Vec<(String, Vec<u8>)> {
    base(
        &format!(
            "{{{}}}",
            listed(times, |number| format!("\"key{number}\":0"))
        ),
        None,
        None,
    )
}

fn line_ends(times: usize) -> Vec<(String, Vec<u8>)> {
    let ends = "\\n".repeat(times);
    let rules = format!(r#"{{"random": {{"rules": {{"A": {{"A": "{ends}1{ends}+{ends}1"}}}}}}}}"#);
    let display = format!(r#"{{"slot": 1, "text": "", "formula": "{ends}1{ends}+ 1"}}"#);
    base(
        &rules,
        Some(format!(
            r#"{{"A": {{"group": "a|b", "macro": "m/A", "display": {display}}}}}"#
        )),
        None,
    )
}

fn groups(times: usize) -> Vec<(String, Vec<u8>)> {
    let groups = listed(times, |number| {
        format!("\"category{number}|group{number}\":true")
    });
    base(
        &format!("{{\"random\":{{\"groups\":{{{groups}}}}}}}"),
        Some(r#"{"A": {"group": "a|b", "macro": "m/A"}}"#.to_owned()),
        None,
    )
}
