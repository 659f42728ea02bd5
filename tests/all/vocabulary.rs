//! The words of mhlint: what a user reads holds none of the phrases that the vocabulary replaces.
//!
//! Read are every message, consequence and help text of the fixtures, the help of every command,
//! what the rules and the schemas say of themselves, and the documents. Names in back quotes are
//! names, not words.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::listing;
use crate::scratch::{mhlint, project, stdout};

/// What is not said, and what is said instead. `*` is any word, `A` a word that begins with a
/// capital.
const PHRASES: [(&str, &[&str]); 17] = [
    (
        "check",
        &[
            "judge",
            "judges",
            "judged",
            "judging",
            "judgement",
            "looks after",
            "looked after",
        ],
    ),
    (
        "fix",
        &["mend", "mends", "mended", "mending", "remedy", "remedies"],
    ),
    (
        "report, print, hide",
        &[
            "tell of",
            "tells of",
            "told",
            "speaks for",
            "speak for",
            "mhlint says",
            "is said",
        ],
    ),
    ("ignore", &["mute", "mutes", "muted", "muting", "spared"]),
    ("is not valid JSON", &["no json"]),
    ("is not a …", &["is no *", "are no *"]),
    (
        "does not exist, is missing",
        &["is not there", "are not there", "absent"],
    ),
    ("no longer occurs", &["found no more"]),
    ("matches no …", &["fits no *", "fit no *"]),
    ("could not run", &["could not work"]),
    (
        "crashes with `…`",
        &[
            "stops with a *",
            "stops with an *",
            "stop with a *",
            "stop with an *",
        ],
    ),
    (
        "ignores, drops, never loads",
        &["gives to nobody", "given to nobody"],
    ),
    ("several, more than one", &["of several together"]),
    (
        "left/right counterpart",
        &["the other side", "opposite of its side"],
    ),
    (
        "UV-seam duplicate",
        &["double of a seam", "doubles of a seam"],
    ),
    (
        "no effect in …; …",
        &["2: nothing", "1: nothing", "mpfb: nothing"],
    ),
    (
        "an order of words that English has",
        &["at the end stands", "anew"],
    ),
];

/// Where such words have another sense: the words, and which.
const ALLOWED: [(&str, &str); 4] = [
    ("is no longer", "of time"),
    ("there is no", "of something that is missing as a whole"),
    ("there are no", "the same of several"),
    ("told apart", "to tell one from another"),
];

#[test]
fn nothing_that_users_read_has_the_words_of_before() {
    let mut found = BTreeSet::new();
    for (place, text) in texts() {
        for line in text.lines() {
            found.extend(
                wrong(line)
                    .map(|(not, say)| format!("{place}: `{not}`, say {say}: {}", line.trim())),
            );
        }
    }
    let all: Vec<String> = found.into_iter().collect();
    assert!(all.is_empty(), "{}\n{} lines", all.join("\n"), all.len());
}

#[test]
fn phrases_are_found_as_words() {
    let not = |line: &str| wrong(line).map(|(not, _)| not).collect::<Vec<_>>();
    assert_eq!(not("the file is no number"), ["is no *"]);
    assert_eq!(not("it is no longer read, and `muted` is a name"), [""; 0]);
    assert_eq!(not("Judged: mended."), ["judged", "mended"]);
    assert_eq!(not("a commuted mutex"), [""; 0]);
}

fn wrong(line: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let words = words(
        &ALLOWED
            .iter()
            .fold(line.to_lowercase(), |line, (allowed, _)| {
                line.replace(allowed, "")
            }),
    );
    let all = PHRASES
        .iter()
        .flat_map(|(say, phrases)| phrases.iter().map(|not| (*not, *say)));
    all.filter(move |(not, _)| holds(&words, not))
}

fn holds(words: &[String], phrase: &str) -> bool {
    let phrase: Vec<&str> = phrase.split(' ').collect();
    let is_it = |word: &str, wanted: &str| {
        wanted == "*" || word == wanted || word.trim_end_matches(':') == wanted
    };
    let is_there = |run: &[String]| {
        run.iter()
            .zip(&phrase)
            .all(|(word, wanted)| is_it(word, wanted))
    };
    words.windows(phrase.len()).any(is_there)
}

/// The words outside of back quotes. A colon stays with its word.
fn words(line: &str) -> Vec<String> {
    let outside: Vec<&str> = line.split('`').step_by(2).collect();
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, ':' | '\'' | '-');
    let all = outside.join(" x ");
    all.split(|c| !is_part(c))
        .filter(|word| !word.is_empty())
        .map(str::to_owned)
        .collect()
}

/// Everything, with where it stands.
fn texts() -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = listing::MESSAGES
        .iter()
        .map(|text| ("messages".to_owned(), text.clone()))
        .collect();
    for rule in mhlint::rule_infos() {
        let effects = rule
            .breaks
            .iter()
            .map(|(application, effect)| format!("{application}: {effect}\n"));
        let options = rule
            .options
            .iter()
            .map(|option| format!("{}\n", option.docs));
        let text: String = effects.chain(options).collect();
        all.push((
            rule.id.to_owned(),
            format!("{}\n{}\n{text}", rule.summary, rule.documentation()),
        ));
    }
    for command in [
        "",
        "check",
        "config",
        "eval",
        "explain",
        "init",
        "rules",
        "schema",
        "completions",
        "man",
    ] {
        let args: Vec<&str> = [command, "--help"]
            .into_iter()
            .filter(|word| !word.is_empty())
            .collect();
        all.push((
            format!("mhlint {command} --help"),
            stdout(&mhlint(&project("fixtures"), &args)),
        ));
    }
    for file in [project("README.md"), project("CHANGELOG.md")]
        .into_iter()
        .chain(files_of(&project("docs")))
        .chain(files_of(&project("schemas")))
    {
        let name = file
            .strip_prefix(project(""))
            .unwrap_or(&file)
            .display()
            .to_string();
        all.push((name, fs::read_to_string(&file).unwrap()));
    }
    all
}

/// The documents and schemas directly in a folder.
fn files_of(folder: &Path) -> Vec<std::path::PathBuf> {
    let entries = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    entries
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "md" || extension == "json")
        })
        .collect()
}
