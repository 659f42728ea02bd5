//! `fixtures/help/<family>.toml`: what the help of a finding advises, as edits of the case that
//! shows it.

use std::fs;

use serde::Deserialize;

use super::{Case, Edit, Write, compiled, pack, project, target_archive, zipped};

/// Rows of a family of rules.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Rows {
    row: Vec<Row>,
}

/// One help: edits of a case that do what it says and no more, or why there can be none.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// The rule of the finding.
    pub rule: String,
    /// The help, word for word.
    pub help: String,
    /// The case of the rule that shows it.
    #[serde(default)]
    pub case: String,
    /// Why no edit can do what the help says, in one sentence.
    #[serde(default)]
    pub cannot: String,
    /// Rules whose findings are new and only to be expected: they had nothing to say as long as the
    /// fault was there.
    #[serde(default)]
    pub shows: Vec<String>,
    /// Files or folders of the example repository that come back as they are there, before all
    /// edits.
    #[serde(default)]
    pub restore: Vec<String>,
    /// Arguments in place of those of the case, where the help names some.
    #[serde(default)]
    pub args: Option<Vec<String>>,
    // As in `case.toml`.
    #[serde(default)]
    edit: Vec<Edit>,
    #[serde(default)]
    remove: Vec<String>,
    #[serde(default)]
    rename: Vec<[String; 2]>,
    #[serde(default)]
    copy: Vec<[String; 2]>,
    #[serde(default)]
    write: Vec<Write>,
    #[serde(default)]
    pack: Vec<pack::Pack>,
    #[serde(default)]
    compiled: Vec<compiled::Compiled>,
    #[serde(default)]
    targets: Vec<target_archive::TargetArchive>,
    #[serde(default)]
    link: Vec<[String; 2]>,
    #[serde(default)]
    folder: Vec<String>,
    #[serde(default)]
    zip: Vec<zipped::Zipped>,
}

impl Row {
    /// All rows, with the name of their file.
    pub fn all() -> Vec<(String, Self)> {
        let mut all = Vec::new();
        let mut files: Vec<_> = fs::read_dir(project("fixtures/help"))
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .collect();
        files.sort();
        for path in files {
            let text = fs::read_to_string(&path).unwrap();
            let rows: Rows =
                toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            let family = path.file_stem().unwrap().to_str().unwrap();
            all.extend(rows.row.into_iter().map(|row| (family.to_owned(), row)));
        }
        all
    }

    /// The edits as a case of their own, to be applied on top of the one that they are for.
    pub fn into_edits(self) -> Case {
        let Self {
            edit,
            remove,
            rename,
            copy,
            write,
            pack,
            compiled,
            targets,
            link,
            folder,
            zip,
            ..
        } = self;
        Case {
            edit,
            remove,
            rename,
            copy,
            write,
            pack,
            compiled,
            targets,
            link,
            folder,
            zip,
            ..Case::default()
        }
    }
}
