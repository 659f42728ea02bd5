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
    Key { name, shape, required: false, docs }
}

const fn required(name: &'static str, shape: Shape, docs: &'static str) -> Key {
    Key { name, shape, required: true, docs }
}

/// Keys of the file.
pub(super) static FILE: &[Key] = &[
    key("fail-on", Shape::FailOn, "The level from which on findings make the exit code 1; `error` unless set."),
    key("max-warnings", Shape::Count, "Makes the exit code 1 when there are more warnings than this."),
    key("select", Shape::Rules, "Run only these rules; all unless set."),
    key("skip", Shape::Rules, "Leave out these rules."),
    key("exclude", Shape::Globs, "Report nothing for these files and folders; they are still read to resolve names."),
    key("system", Shape::Path, "MakeHuman's own data: read to resolve references, not reported."),
    key("apps", Shape::Applications, "Judge only what these applications load; all unless set."),
    key("bases", Shape::Texts, "Report only these base meshes; all unless set."),
    key("baseline", Shape::Path, "File with the findings that are known and hidden."),
    key("level", Shape::Levels, "Another level for a rule; of several that fit the last one counts."),
    key("rule", Shape::Options, "Options of single rules; `mhlint explain RULE` lists them."),
    key("path", Shape::Tables(PATH), "Other rules and levels for a part of the repository."),
    key("ignore", Shape::Tables(IGNORE), "Mutes: known findings of a rule in some files, with the reason."),
    key("eval", Shape::Table(EVAL), "How much of the slider space is looked at."),
];

/// Keys of `[[path]]`.
static PATH: &[Key] = &[
    required("glob", Shape::Glob, "The files and folders that this is for."),
    key("skip", Shape::Rules, "Leave out these rules here."),
    key("level", Shape::Levels, "Another level for a rule here; it also turns on a rule that is left out elsewhere."),
];

/// Keys of `[[ignore]]`. Without a `reason` the ignore is a finding, so the reader does not insist on it.
static IGNORE: &[Key] = &[
    required("rule", Shape::Rule, "The rule to mute, or a glob of rules."),
    required("path", Shape::Glob, "The files and folders to mute it in."),
    key("reason", Shape::Text, "Why. A mute without a reason does not count."),
    key("until", Shape::Date, "Last day on which the mute counts, such as 2027-06-30."),
];

/// Keys of `[eval]`.
static EVAL: &[Key] = &[
    key(
        "samples",
        Shape::CountTo(MOST_SAMPLES),
        "Random slider settings to look at besides the deliberate ones, at most 100000.",
    ),
    key("exhaustive", Shape::Flag, "Look at every corner of the slider space."),
];
