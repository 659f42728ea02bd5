//! The example repositories in memory, damaged as a `case.toml` says, and the library on it: no
//! disk, no process.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, LazyLock};

use mhlint::report::{self, Format, View};
use mhlint::{Application, Config, Level, Outcome, Tree, lint_trees};

use super::{Case, content, project};

/// A repository in memory; the bytes are shared by all copies.
#[derive(Clone, Default)]
pub struct Memory {
    files: BTreeMap<String, Arc<[u8]>>,
    /// Every folder: one that loses its last file stays, as on disk.
    folders: BTreeSet<String>,
}

/// The example repositories, by application.
static EXAMPLES: LazyLock<BTreeMap<&str, Memory>> = LazyLock::new(|| {
    let read = |name| {
        let mut example = Memory::default();
        for (path, bytes) in content(&project("fixtures").join(name)) {
            example.put(&path.to_str().unwrap().replace('\\', "/"), bytes.into());
        }
        (name, example)
    };
    let names = Application::ALL.map(Application::word);
    names
        .into_iter()
        .filter(|name| project("fixtures").join(name).is_dir())
        .map(read)
        .collect()
});

/// What the arguments of a case ask for, where trees in memory can give it.
pub struct Asked {
    paths: Vec<String>,
    system: Option<String>,
    config: Config,
}

impl Asked {
    /// From `check PATH… --system FOLDER --only RULES --base NAME`; none where an argument or the
    /// case needs a disk.
    pub fn of(case: &Case) -> Option<Self> {
        let hidden = |path: &String| path.split('/').any(|part| part.starts_with('.'));
        if !case.link.is_empty()
            || !case.zip.is_empty()
            || !case.targets.is_empty()
            || !case.compiled.is_empty()
            || case.write.iter().any(|write| hidden(&write.file))
        {
            return None;
        }
        let settings = case.write.iter().find(|write| write.file == "mhlint.toml");
        let config = settings
            .map(|file| Config::parse(&file.text, "mhlint.toml", &mhlint::rule_infos()).unwrap());
        let named = |name: &String| {
            Application::ALL
                .into_iter()
                .find(|one| one.word() == name)
                .unwrap()
        };
        let mut asked = Self {
            paths: Vec::new(),
            system: None,
            config: config.unwrap_or_default(),
        };
        if let Some(application) = &case.application {
            asked.config.applications = vec![named(application)];
        }
        let mut args = case.args.iter().map(String::as_str);
        while let Some(arg) = args.next() {
            match arg {
                "check" => {}
                "." => asked.paths.push(String::new()),
                "data" | "user" => asked.paths.push(arg.to_owned()),
                "--system" => asked.system = Some(args.next()?.to_owned()),
                "--only" => asked.config.only.push(args.next()?.to_owned()),
                "--base" => asked.config.bases.push(args.next()?.to_owned()),
                _ => return None,
            }
        }
        if asked.paths.is_empty() {
            asked.paths.push(String::new());
        }
        Some(asked)
    }

    /// Everything, for all applications.
    pub fn of_all(config: Config) -> Self {
        Self {
            paths: vec![String::new()],
            system: None,
            config,
        }
    }

    /// Runs the library on a repository.
    pub fn lint(&self, repository: &Memory) -> Outcome {
        let (trees, system) = self.trees(repository);
        lint_trees(trees, system, &self.config).unwrap()
    }

    /// The same beside what the repository was before: what is new or worse.
    pub fn lint_beside(&self, now: &Memory, before: &Memory) -> Outcome {
        let [(now, system), (before, system_before)] =
            [now, before].map(|repository| self.trees(repository));
        mhlint::lint_trees_beside([now, before], [system, system_before], &self.config).unwrap()
    }

    fn trees(&self, repository: &Memory) -> (Vec<Tree>, Option<Tree>) {
        let trees = self
            .paths
            .iter()
            .map(|path| repository.tree(path))
            .collect();
        (
            trees,
            self.system.as_ref().map(|path| repository.tree(path)),
        )
    }
}

impl Memory {
    /// The example repository of a case, as it is before.
    pub fn example(case: &Case) -> Self {
        EXAMPLES[case.application.as_deref().unwrap_or("makehuman2")].clone()
    }

    /// An example repository by the name of its application.
    pub fn of(name: &str) -> Self {
        EXAMPLES[name].clone()
    }

    /// Puts another one into a folder, or over what is there.
    pub fn add(&mut self, other: &Self, folder: &str) {
        for (path, bytes) in &other.files {
            self.put(&format!("{folder}{path}"), Arc::clone(bytes));
        }
    }

    /// The paths of its files, in order.
    pub fn paths(&self) -> Vec<String> {
        self.files.keys().cloned().collect()
    }

    /// What is in a file.
    pub fn bytes(&self, path: &str) -> &[u8] {
        self.get(path)
    }

    /// Writes a file.
    pub fn write(&mut self, path: &str, bytes: Vec<u8>) {
        self.put(path, bytes.into());
    }

    /// Gives a file another name.
    pub fn move_away(&mut self, path: &str, to: &str) {
        for (below, bytes) in self.take(path) {
            self.put_or_make(&format!("{to}{below}"), bytes);
        }
    }

    /// Applies a case without links, in the order of [`Case::apply`].
    pub fn apply(&mut self, case: &Case) {
        for [from, to] in &case.rename {
            let taken = self.take(from);
            assert!(!taken.is_empty(), "rename {from}");
            for (below, bytes) in taken {
                self.put_or_make(&format!("{to}{below}"), bytes);
            }
        }
        for [from, to] in &case.copy {
            self.put(to, Arc::clone(self.get(from)));
        }
        for path in &case.remove {
            assert!(!self.take(path).is_empty(), "remove {path}");
        }
        for write in &case.write {
            self.put(&write.file, write.bytes().into());
        }
        for pack in &case.pack {
            self.put(&pack.file, pack.bytes().into());
        }
        for edit in &case.edit {
            let text = std::str::from_utf8(self.get(&edit.file)).unwrap();
            let edited = edit.edited(text);
            self.put(&edit.file, edited.into_bytes().into());
        }
        case.folder.iter().for_each(|folder| self.make(folder));
    }

    /// Brings back a file, or a folder with everything in it, as it is in another repository.
    pub fn restore(&mut self, path: &str, whole: &Self) {
        for (below, bytes) in whole.clone().take(path) {
            self.put_or_make(&format!("{path}{below}"), bytes);
        }
    }

    /// Whether there is a file at a path.
    pub fn has(&self, path: &str) -> bool {
        self.files.contains_key(path)
    }

    fn get(&self, path: &str) -> &Arc<[u8]> {
        self.files
            .get(path)
            .unwrap_or_else(|| panic!("there is no `{path}`"))
    }

    fn put(&mut self, path: &str, bytes: Arc<[u8]>) {
        if let Some((folder, _)) = path.rsplit_once('/') {
            self.make(folder);
        }
        self.files.insert(path.to_owned(), bytes);
    }

    fn put_or_make(&mut self, path: &str, bytes: Option<Arc<[u8]>>) {
        match bytes {
            Some(bytes) => self.put(path, bytes),
            None => self.make(path),
        }
    }

    /// Makes a folder and those above it.
    fn make(&mut self, folder: &str) {
        let above = folder.match_indices('/').map(|(at, _)| &folder[..at]);
        self.folders
            .extend(above.chain([folder]).map(str::to_owned));
    }

    /// Takes a file, or a folder with everything in it: what is behind `path`, with bytes for a
    /// file.
    fn take(&mut self, path: &str) -> Vec<(String, Option<Arc<[u8]>>)> {
        let below = |found: &str| {
            found
                .strip_prefix(path)
                .filter(|rest| rest.is_empty() || rest.starts_with('/'))
                .map(str::to_owned)
        };
        let files = self
            .files
            .extract_if(.., |found, _| below(found).is_some())
            .map(|(found, bytes)| (found, Some(bytes)));
        let mut taken: Vec<_> = files.collect();
        taken.extend(
            self.folders
                .extract_if(.., |found| below(found).is_some())
                .map(|found| (found, None)),
        );
        taken
            .into_iter()
            .filter_map(|(found, bytes)| Some((below(&found)?, bytes)))
            .collect()
    }

    /// What lies below a folder, as a tree that is labelled with it; empty for everything.
    fn tree(&self, label: &str) -> Tree {
        let below = |path: &str| match label {
            "" => Some(path.to_owned()),
            _ => path
                .strip_prefix(label)?
                .strip_prefix('/')
                .map(str::to_owned),
        };
        let folders = self
            .folders
            .iter()
            .filter_map(|path| Some((below(path)? + "/", Arc::default())));
        let files = self
            .files
            .iter()
            .filter_map(|(path, bytes)| Some((below(path)?, Arc::clone(bytes))));
        Tree::in_memory(label, folders.chain(files))
    }
}

/// Lines of the concise report.
pub fn concise(outcome: &Outcome) -> Vec<String> {
    let rules = mhlint::rule_infos();
    let view = View {
        pass: false,
        fail_on: Some(Level::Error),
        max_warnings: None,
        color: false,
        unicode: false,
        width: 80,
        quiet: true,
        full: false,
        statistics: false,
        rules: &rules,
    };
    let mut text = Vec::new();
    report::write(Format::Concise, outcome, &view, &mut text).unwrap();
    String::from_utf8(text)
        .unwrap()
        .lines()
        .map(str::to_owned)
        .collect()
}
