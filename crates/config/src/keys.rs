//! The keys of `mhlint.toml`: one table for the reader, the JSON Schema and the documentation.

use super::MOST_SAMPLES;

/// A key.
#[derive(Debug, Clone, Copy)]
pub(super) struct Key {
    /// As written.
    pub name: &'static str,
    /// What may stand behind it.
    pub shape: Shape,
    /// Whether the table is worth nothing without it.
    pub required: bool,
    /// Meaning, in a sentence.
    pub docs: &'static str,
}

/// What may stand behind a key.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    /// `error`, `warning`, `info` or `never`.
    FailOn,
    /// A whole number, not negative.
    Count,
    /// The same, up to a highest one.
    CountTo(usize),
    /// `true` or `false`.
    Flag,
    /// Any text.
    Text,
    /// A path, relative to the folder of the file.
    Path,
    /// One or several.
    Paths,
    /// A glob of paths, relative to the folder of the file.
    Glob,
    /// Several.
    Globs,
    /// A rule or a glob of rules.
    Rule,
    /// Several.
    Rules,
    /// Words for applications.
    Applications,
    /// Any texts.
    Texts,
    /// A day.
    Date,
    /// A level for each rule or glob of rules.
    Levels,
    /// A table of options for each rule.
    Options,
    /// A table.
    Table(&'static [Key]),
    /// Any number of tables.
    Tables(&'static [Key]),
}

const fn key(name: &'static str, shape: Shape, docs: &'static str) -> Key {
    Key {
        name,
        shape,
        required: false,
        docs,
    }
}

const fn required(name: &'static str, shape: Shape, docs: &'static str) -> Key {
    Key {
        name,
        shape,
        required: true,
        docs,
    }
}

/// Keys of the file.
pub(super) static FILE: &[Key] = &[
    key(
        "fail-on",
        Shape::FailOn,
        "Lowest level of findings that makes the exit code 1; default: `error`.",
    ),
    key(
        "max-warnings",
        Shape::Count,
        "The exit code is 1 if there are more warnings than this.",
    ),
    key(
        "select",
        Shape::Rules,
        "Run only these rules; default: all.",
    ),
    key("skip", Shape::Rules, "Do not run these rules."),
    key(
        "exclude",
        Shape::Globs,
        "Report nothing for these files and folders; they are still read to resolve names.",
    ),
    key(
        "system",
        Shape::Paths,
        "Data of the applications themselves, one folder or a list: read to resolve references, \
            not reported.",
    ),
    key(
        "apps",
        Shape::Applications,
        "Check only what these applications load; default: all.",
    ),
    key(
        "bases",
        Shape::Texts,
        "Report only these base meshes; default: all.",
    ),
    key(
        "baseline",
        Shape::Path,
        "File of known findings, which are not reported.",
    ),
    key(
        "level",
        Shape::Levels,
        "Change the level of rules; the last entry that matches a rule counts.",
    ),
    key(
        "rule",
        Shape::Options,
        "Options of rules; `mhlint explain RULE` lists them.",
    ),
    key(
        "path",
        Shape::Tables(PATH),
        "Other rules and levels for a part of the repository.",
    ),
    key(
        "ignore",
        Shape::Tables(IGNORE),
        "Findings of a rule to ignore in some files, with a reason.",
    ),
    key(
        "eval",
        Shape::Table(EVAL),
        "How much of the slider space is evaluated.",
    ),
];

/// Keys of `[[path]]`.
static PATH: &[Key] = &[
    required(
        "glob",
        Shape::Glob,
        "The files and folders that the block applies to.",
    ),
    key("skip", Shape::Rules, "Do not run these rules here."),
    key(
        "level",
        Shape::Levels,
        "Change the level of rules here; this also turns on a rule that is skipped elsewhere.",
    ),
];

/// Keys of `[[ignore]]`. Without a `reason` the ignore is a finding, so the reader does not insist
/// on it.
static IGNORE: &[Key] = &[
    required(
        "rule",
        Shape::Rule,
        "The rule to ignore, or a glob of rules.",
    ),
    required(
        "path",
        Shape::Glob,
        "The files and folders to ignore it in.",
    ),
    key(
        "reason",
        Shape::Text,
        "Why; without a reason the `[[ignore]]` has no effect.",
    ),
    key(
        "until",
        Shape::Date,
        "Last day on which the `[[ignore]]` applies, such as 2027-06-30.",
    ),
];

/// Keys of `[eval]`.
static EVAL: &[Key] = &[
    key(
        "samples",
        Shape::CountTo(MOST_SAMPLES),
        "Number of random slider settings to evaluate besides the fixed ones, at most 100000.",
    ),
    key(
        "exhaustive",
        Shape::Flag,
        "Evaluate every corner of the slider space.",
    ),
];
