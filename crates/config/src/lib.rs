//! What a run is asked to do: the model and the loader of `mhlint.toml`.
//!
//! Gets the text of the file and the declared halves of the rules, gives a [`Config`] or all that
//! is wrong with the file, with spans. Knows no rule by name and looks for no asset.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod date;
mod fault;
mod find;
mod gate;
mod glob;
mod globs;
mod keys;
mod read;
mod schema;
mod template;
mod value;

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use mhlint_diag::{Application, Edition, Level, RuleInfo, UnknownRule, Version};
use mhlint_source::{Folder, Limits, Lines};

pub use date::Date;
pub use fault::{Error, Fault};
pub use find::{FILE_NAME, find};
pub use glob::{PathGlob, Selector};
pub use globs::Globs;
pub use schema::schema;
pub use template::{TEMPLATE, template_for};

/// Most random settings of the sliders that can be asked for: each takes time and memory.
pub const MOST_SAMPLES: usize = 100_000;

/// What a run is asked to do.
///
/// The fields are the values in effect for the whole run. What the configuration file says on
/// single rules and paths is kept apart in [`Config::file`], because the fields
/// [`only`](Config::only), [`skip`](Config::skip) and [`levels`](Config::levels) override it, as
/// the command line does.
///
/// ```
/// use mhlint_config::Config;
/// use mhlint_diag::Level;
///
/// let config = Config { skip: vec!["numeric-*".to_owned()], no_eval: true, ..Config::default() };
/// assert_eq!(config.fail_on, Some(Level::Error));
/// ```
#[derive(Debug, Clone)]
pub struct Config {
    /// Data of the applications themselves, one root for each, read and not reported.
    pub systems: Vec<PathBuf>,
    /// Check these applications only; empty for all.
    pub applications: Vec<Application>,
    /// The versions of them that are asked for; at most one counts for each.
    pub versions: Vec<Version>,
    /// Report these base meshes only; empty for all.
    pub bases: Vec<String>,
    /// Globs of rule ids to run, in place of what the file selects; empty to leave it to the file.
    pub only: Vec<String>,
    /// Globs of rule ids not to run, besides those of the file.
    pub skip: Vec<String>,
    /// Levels by rule id or glob, `None` for off; the last one that fits counts, and goes before
    /// the file.
    pub levels: Vec<(String, Option<Level>)>,
    /// Options of rules, by rule and name.
    pub rule_options: BTreeMap<(String, String), f64>,
    /// Leave out everything that needs evaluation.
    pub no_eval: bool,
    /// Random settings of the sliders to look at besides the deliberate ones, at most 100000;
    /// `None` for the default.
    pub samples: Option<usize>,
    /// Visit every corner of the slider space.
    pub exhaustive: bool,
    /// The level from which on a finding fails the run; `None` for never.
    pub fail_on: Option<Level>,
    /// More warnings than this fail the run.
    pub max_warnings: Option<usize>,
    /// File with known findings, which are hidden.
    pub baseline: Option<PathBuf>,
    /// Make a new baseline of what is found instead:
    /// [`Outcome::baseline`](mhlint_diag::Outcome::baseline).
    pub write_baseline: bool,
    /// What the configuration file says on rules and paths.
    pub file: Option<ConfigFile>,
    /// Bounds on what is read.
    pub limits: Limits,
    /// Report only what is new or worse than something else.
    pub compare: Option<Compare>,
}

/// What the data are compared with.
#[derive(Debug, Clone)]
pub struct Compare {
    /// What reports call it: a revision, a folder.
    pub with: String,
    /// The data as they were.
    pub before: Before,
    /// Contents that are checked in place of those that lie in the folders, by absolute path
    /// without links; `None` for no such file.
    pub now: BTreeMap<PathBuf, Option<Vec<u8>>>,
    /// Files that are not compared, because their contents are not at hand.
    pub missing: Vec<PathBuf>,
}

/// Data as they were.
#[derive(Debug, Clone)]
pub enum Before {
    /// They lie in another folder.
    Folder(PathBuf),
    /// They lie where they are checked, but for these contents, by absolute path without links;
    /// `None` for no such file.
    Contents(BTreeMap<PathBuf, Option<Vec<u8>>>),
}

/// What `mhlint.toml` says on rules and paths.
#[derive(Debug, Clone, Default)]
pub struct ConfigFile {
    /// Its path as printed.
    pub path: String,
    /// Its text.
    pub text: String,
    /// Its folder: what globs are relative to.
    pub folder: Folder,
    /// `select`; empty for all.
    pub select: Vec<Selector>,
    /// `skip`.
    pub skip: Vec<Selector>,
    /// `[level]`, in order of the file.
    pub levels: Vec<(Selector, Option<Level>)>,
    /// `exclude`.
    pub exclude: Globs,
    /// `[[path]]`.
    pub blocks: Vec<PathBlock>,
    /// `[[ignore]]`.
    pub ignores: Vec<Ignore>,
    /// Settings for rules that do not exist.
    pub unknown: Vec<UnknownRule>,
    /// Where each key stands whose value is in effect, by its full name (`eval.samples`).
    pub places: BTreeMap<String, Range<usize>>,
}

/// A `[[path]]`.
#[derive(Debug, Clone)]
pub struct PathBlock {
    /// The files that it is for.
    pub glob: PathGlob,
    /// `skip`.
    pub skip: Vec<Selector>,
    /// `level`, in order of the file.
    pub levels: Vec<(Selector, Option<Level>)>,
    /// Where it stands.
    pub span: Range<usize>,
}

/// An `[[ignore]]`.
#[derive(Debug, Clone)]
pub struct Ignore {
    /// `rule`.
    pub rule: Selector,
    /// `path`.
    pub path: PathGlob,
    /// `reason`, if there is one that says something.
    pub reason: Option<String>,
    /// `until`.
    pub until: Option<Date>,
    /// Where it stands.
    pub span: Range<usize>,
    /// Where `until` stands.
    pub until_span: Range<usize>,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            systems: Vec::new(),
            applications: Vec::new(),
            versions: Vec::new(),
            bases: Vec::new(),
            only: Vec::new(),
            skip: Vec::new(),
            levels: Vec::new(),
            rule_options: BTreeMap::new(),
            no_eval: false,
            samples: None,
            exhaustive: false,
            fail_on: Some(Level::Error),
            max_warnings: None,
            baseline: None,
            write_baseline: false,
            file: None,
            limits: Limits::default(),
            compare: None,
        }
    }
}

impl Config {
    /// Reads a configuration file. `rules` are those that there are: `rule_infos` of the engine.
    ///
    /// # Errors
    /// When the file cannot be read, is no TOML, or holds keys or values that do not exist.
    pub fn load(path: &Path, rules: &[&'static RuleInfo]) -> Result<Self, Error> {
        find::load(path, rules)
    }

    /// The same for a text; `path` is what messages call it. Globs and paths in it are relative to
    /// the trees of `lint_trees`.
    ///
    /// ```
    /// use mhlint_config::Config;
    ///
    /// let error = Config::parse("selct = ['macro-*']", "mhlint.toml", &[]).unwrap_err();
    /// assert!(error.to_string().contains("did you mean `select`?"));
    /// ```
    ///
    /// # Errors
    /// As [`Config::load`].
    pub fn parse(text: &str, path: &str, rules: &[&'static RuleInfo]) -> Result<Self, Error> {
        read::read(text, path, Path::new(""), Folder::default(), rules)
    }

    /// Sets which applications are to be checked, and in which versions.
    pub fn check_for(&mut self, editions: &[Edition]) {
        self.applications = editions.iter().map(|one| one.application).collect();
        self.versions = editions.iter().filter_map(|one| one.version).collect();
    }

    /// The applications that are asked for by name.
    pub fn editions(&self) -> impl Iterator<Item = Edition> {
        let version = |application| {
            self.versions
                .iter()
                .find(move |one| one.application() == application)
                .copied()
        };
        self.applications.iter().map(move |one| Edition {
            application: *one,
            version: version(*one),
        })
    }

    /// Whether data of an application are to be checked.
    pub fn asks_for(&self, application: Application) -> bool {
        self.applications.is_empty() || self.applications.contains(&application)
    }

    /// Whether a base mesh is to be checked.
    pub fn asks_for_base(&self, name: &str) -> bool {
        self.bases.is_empty() || self.bases.iter().any(|base| base == name)
    }

    /// Whether the file excludes anything.
    pub fn has_exclude(&self) -> bool {
        self.file
            .as_ref()
            .is_some_and(|file| !file.exclude.is_empty())
    }

    /// Whether nothing is to be reported for a printed path.
    pub fn excludes(&self, path: &str) -> bool {
        let Some(file) = self.file.as_ref().filter(|_| self.has_exclude()) else {
            return false;
        };
        let Some(rel) = file.folder.relative(path) else {
            return false;
        };
        file.exclude.fits(&rel)
    }
}

impl ConfigFile {
    /// Line of a key that is set, counted from 1.
    pub fn line(&self, key: &str) -> Option<u32> {
        self.places.get(key).map(|span| self.line_at(span))
    }

    /// Line of a span, counted from 1.
    pub fn line_at(&self, span: &Range<usize>) -> u32 {
        Lines::of(self.text.as_bytes()).position(span.start).line
    }

    /// Path of a printed path relative to the folder of the file; none if it lies elsewhere.
    pub fn relative(&self, path: &str) -> Option<String> {
        self.folder.relative(path)
    }
}
