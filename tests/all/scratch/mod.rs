//! Throw-away copies of the example repository, damaged as a `case.toml` says, and the real binary
//! on them.
#![allow(unreachable_pub, reason = "a program has no other crates")]

pub mod advice;
mod compiled;
pub mod exchanged;
pub mod memory;
pub mod pack;
mod pack_asset;
mod target_archive;
pub mod zipped;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde::Deserialize;

/// A case: edits over the example repository of an application. Paths are relative to it.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// One sentence: what the case shows.
    #[expect(dead_code, reason = "for readers of the case")]
    pub why: String,
    /// The application, if it is not MakeHuman 2. One that is not checked for users runs in memory
    /// only.
    #[serde(default)]
    pub application: Option<String>,
    /// Arguments in place of `check .`.
    #[serde(default)]
    pub args: Vec<String>,
    /// Replacements in text files.
    #[serde(default)]
    pub edit: Vec<Edit>,
    /// Files or folders to remove.
    #[serde(default)]
    pub remove: Vec<String>,
    /// Files or folders to move.
    #[serde(default)]
    pub rename: Vec<[String; 2]>,
    /// Files to copy.
    #[serde(default)]
    pub copy: Vec<[String; 2]>,
    /// Files to write.
    #[serde(default)]
    pub write: Vec<Write>,
    /// Meshes to pack as MakeHuman 2 does.
    #[serde(default)]
    pub pack: Vec<pack::Pack>,
    /// What is worn, and meshes, to pack as MakeHuman 1 does.
    #[serde(default)]
    pub compiled: Vec<compiled::Compiled>,
    /// Archives of targets to make as MakeHuman 1 does.
    #[serde(default)]
    pub targets: Vec<target_archive::TargetArchive>,
    /// Symbolic links: path, then what it points to.
    #[serde(default)]
    pub link: Vec<[String; 2]>,
    /// Folders to make.
    #[serde(default)]
    pub folder: Vec<String>,
    /// Zips to make when all else is done.
    #[serde(default)]
    pub zip: Vec<zipped::Zipped>,
}

/// A replacement; `find` must occur exactly once unless `all` is set.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Edit {
    pub file: String,
    pub find: String,
    pub replace: String,
    #[serde(default)]
    pub all: bool,
}

/// A file to write: as text, or as bytes in hexadecimal.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Write {
    pub file: String,
    #[serde(default)]
    pub text: String,
    #[serde(default)]
    pub hex: String,
    /// Put before the text: how often the text is repeated.
    #[serde(default)]
    pub times: Option<usize>,
    /// Pack the whole as gzip.
    #[serde(default)]
    pub gzip: bool,
}

impl Case {
    /// Reads `case.toml` of a fixture folder.
    pub fn read(folder: &Path) -> Self {
        let path = folder.join("case.toml");
        let text =
            fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    /// Applies the case to a copy of the example repository.
    pub fn apply(&self, root: &Path) {
        for [from, to] in &self.rename {
            make_parent(&root.join(to));
            fs::rename(root.join(from), root.join(to))
                .unwrap_or_else(|e| panic!("rename {from}: {e}"));
        }
        for [from, to] in &self.copy {
            make_parent(&root.join(to));
            fs::copy(root.join(from), root.join(to)).unwrap_or_else(|e| panic!("copy {from}: {e}"));
        }
        for path in &self.remove {
            remove(&root.join(path));
        }
        for write in &self.write {
            write.apply(root);
        }
        for pack in &self.pack {
            make_parent(&root.join(&pack.file));
            fs::write(root.join(&pack.file), pack.bytes()).unwrap();
        }
        for compiled in &self.compiled {
            compiled.apply(root);
        }
        for archive in &self.targets {
            archive.apply(root);
        }
        for edit in &self.edit {
            edit.apply(root);
        }
        for folder in &self.folder {
            fs::create_dir_all(root.join(folder)).unwrap();
        }
        for [path, target] in &self.link {
            make_parent(&root.join(path));
            std::os::unix::fs::symlink(target, root.join(path)).unwrap();
        }
        for zip in &self.zip {
            fs::write(root.join(&zip.file), zip.bytes(root)).unwrap();
        }
    }
}

impl Edit {
    fn apply(&self, root: &Path) {
        let path = root.join(&self.file);
        let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("edit {}: {e}", self.file));
        fs::write(&path, self.edited(&text)).unwrap();
    }

    /// The text with the replacement made.
    fn edited(&self, text: &str) -> String {
        let count = text.matches(&self.find).count();
        assert!(
            count == 1 || (self.all && count > 1),
            "{}: `{}` occurs {count} times",
            self.file,
            self.find
        );
        text.replace(&self.find, &self.replace)
    }
}

impl Write {
    fn apply(&self, root: &Path) {
        let path = root.join(&self.file);
        make_parent(&path);
        fs::write(path, self.bytes()).unwrap();
    }

    /// What is to be in the file.
    fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.text.repeat(self.times.unwrap_or(1)).into_bytes();
        let digits: Vec<u8> = self
            .hex
            .bytes()
            .filter(|byte| !byte.is_ascii_whitespace())
            .collect();
        for pair in digits.chunks(2) {
            let text = std::str::from_utf8(pair).unwrap();
            bytes.push(u8::from_str_radix(text, 16).unwrap_or_else(|e| panic!("hex {text}: {e}")));
        }
        if self.gzip { gzip(&bytes) } else { bytes }
    }
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    std::io::Write::write_all(&mut encoder, bytes).unwrap();
    encoder.finish().unwrap()
}

fn make_parent(path: &Path) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
}

/// Removes a file, or a folder with everything in it.
pub fn remove(path: &Path) {
    if path.is_dir() {
        fs::remove_dir_all(path).unwrap();
    } else {
        fs::remove_file(path).unwrap_or_else(|e| panic!("remove {}: {e}", path.display()));
    }
}

/// A folder of the project.
pub fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// A folder of the corpora, which are not part of the project: tests that need them are ignored
/// unless asked for.
pub fn corpus(name: &str) -> PathBuf {
    let corpora = std::env::var_os("MHLINT_CORPORA")
        .expect("MHLINT_CORPORA names the folder that holds the corpora");
    let path = PathBuf::from(corpora).join(name);
    assert!(path.is_dir(), "{} is missing", path.display());
    path
}

/// Copies a folder with everything in it.
pub fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy_folder(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// Every file below a folder, with its bytes.
pub fn content(root: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut all = BTreeMap::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.is_file() {
                all.insert(
                    path.strip_prefix(root).unwrap().to_owned(),
                    fs::read(&path).unwrap(),
                );
            }
        }
    }
    all
}

/// A copy of the example repository in a folder that goes away.
pub fn example() -> tempfile::TempDir {
    example_of("makehuman2")
}

/// A copy of the example repository of an application.
pub fn example_of(application: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(&project("fixtures").join(application), folder.path());
    folder
}

/// Puts `replace` in the place of the first `find` of a file below `root`.
#[track_caller]
pub fn edit(root: &Path, file: &str, find: &str, replace: &str) {
    let path = root.join(file);
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains(find), "`{find}` is not in {file}");
    fs::write(path, text.replacen(find, replace, 1)).unwrap();
}

/// Makes one error in a copy of the example repository: a component with fewer steps than values.
pub fn lose_a_step(root: &Path) {
    let [four, three] = [
        "\"steps\": [0.0, 0.25, 0.5, 1.0]",
        "\"steps\": [0.0, 0.25, 0.5, 0.75, 1.0]",
    ];
    edit(root, "data/target/figure/macro.json", four, three);
}

/// A copy with that error.
pub fn broken() -> tempfile::TempDir {
    let repository = example();
    lose_a_step(repository.path());
    repository
}

/// The folders in a folder, sorted.
pub fn folders(path: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(path)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut folders: Vec<PathBuf> = entries.filter(|path| path.is_dir()).collect();
    folders.sort();
    folders
}

/// Variables by which terminals and CI systems speak to programs.
const SURROUNDINGS: [&str; 9] = [
    "CI",
    "NO_COLOR",
    "CLICOLOR_FORCE",
    "COLUMNS",
    "GITHUB_ACTIONS",
    "GITHUB_STEP_SUMMARY",
    "GITHUB_WORKSPACE",
    "CI_PROJECT_DIR",
    "TERM",
];

/// The real binary in `folder`, with an environment that says nothing about terminals or CI.
pub fn mhlint(folder: &Path, args: &[&str]) -> Output {
    command(folder, args).output().unwrap()
}

/// What [`mhlint`] starts.
pub fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mhlint"));
    for name in SURROUNDINGS {
        command.env_remove(name);
    }
    command.current_dir(folder).args(args);
    command
}

/// What was written to standard output.
pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// What was written to standard error.
pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// The run is refused: exit 2, nothing on standard output, `words` on standard error.
#[track_caller]
pub fn assert_refused(output: &Output, words: &[&str]) {
    assert_eq!(
        (output.status.code(), stdout(output).as_str()),
        (Some(2), ""),
        "{}",
        stderr(output)
    );
    for word in words {
        assert!(
            stderr(output).contains(word),
            "no `{word}` in: {}",
            stderr(output)
        );
    }
}

/// Lines of a concise report without its last line of counts.
pub fn findings(output: &Output) -> Vec<String> {
    let text = stdout(output);
    let lines = text.lines().map(str::to_owned);
    lines
        .filter(|line| !line.starts_with("pass: ") && !line.starts_with("fail: "))
        .collect()
}
