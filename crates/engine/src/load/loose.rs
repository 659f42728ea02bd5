//! Files outside of data roots: which of them are ours, and which base mesh they are for.

use std::cell::{LazyCell, OnceCell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::super::error::Error;
use super::input::Input;
use super::narrow::Narrow;
use super::place::Place;
use super::unit_names::UnitNames;
use mhlint_config::Config;
use mhlint_diag::Application;
use mhlint_discover::{
    Binding, Known, Layout, Role, SAVED_CHARACTER, STORED_POSE, candidates, extension, is_of_macos,
    meant_extension,
};
use mhlint_formats::target::{has_broken_rows, recognise};
use mhlint_source::{
    Entry, Limits, Tree, canonical, folder_and_name, folders_above, lines, slashed,
};

/// Files of an input outside of its data roots, on their way to an application.
pub(super) struct Outside<'t, 'i> {
    pub(super) input: &'t Input,
    pub(super) roots: &'i BTreeMap<String, Vec<&'static Layout>>,
    /// Files, by their paths in the tree, that other applications check and this one is not asked
    /// for.
    pub(super) taken: &'i BTreeSet<String>,
    /// Base meshes of the system data.
    pub(super) bases: &'i BTreeSet<String>,
    /// Whether the application is asked for, by name or with its data.
    pub(super) is_meant: bool,
    pub(super) given: &'i Given<'i>,
    pub(super) seen: Seen,
}

/// What a run gives for all files outside of data roots.
pub(super) struct Given<'i> {
    /// Whether no application is named and the data of several are given: then models say which is
    /// meant.
    is_one_of_several: bool,
    units: UnitNames,
    pub(super) options: &'i Config,
}

impl<'i> Given<'i> {
    pub(super) fn of(systems: &[Place<'_>], options: &'i Config) -> Self {
        let given = Application::ALL
            .into_iter()
            .filter(|one| systems.iter().any(|system| system.is_of(*one)));
        let is_one_of_several = options.applications.is_empty() && given.count() > 1;
        Self {
            is_one_of_several,
            units: UnitNames::of(systems, &options.limits),
            options,
        }
    }
}

/// What was found out once for many files.
#[derive(Default)]
pub(super) struct Seen {
    /// The folders with targets that can be recognised.
    beside_target: OnceCell<BTreeSet<String>>,
    /// Of data roots whether what lies in them is no loose asset.
    kept: RefCell<BTreeMap<String, bool>>,
    /// Whether some data root is one of an application that is asked for.
    has_asked: OnceCell<bool>,
}

impl<'t> Outside<'t, '_> {
    /// The files, put where an application would look for them, with the parts that alone are asked
    /// for; `None` where there are none.
    pub(super) fn place(
        &self,
        layout: &'static Layout,
    ) -> Result<Option<(Place<'t>, Arc<Narrow>)>, Error> {
        let input = self.input;
        let is_asked = |entry: &Entry| self.is_asked(entry, layout);
        let bind = |entry: &Entry, above: &[&str]| self.bind(entry, above, layout);
        let names = |entry: &Entry| names(&input.tree, entry, &self.given.options.limits);
        let list = |entry: &Entry| {
            let limits = &self.given.options.limits;
            match meant_extension(&entry.path) {
                "mhpose" => self.given.units.list_of(&input.tree, entry, limits),
                extension => {
                    let text = LazyCell::new(|| input.tree.read(entry, limits).unwrap_or_default());
                    (layout.list_by_content)(extension, &|word| says(&text, word))
                }
            }
        };
        let top = top(&input.tree);
        let is_shallow = input.is_beside;
        let known = Known {
            top: &top,
            is_asked: &is_asked,
            is_shallow,
            bind: &bind,
            list: &list,
            names: &names,
        };
        let (place, narrow) = Place::loose(&input.tree, layout, &known, &input.narrow);
        let is_single = |path: &str| matches!(extension(path), "target" | "mhskel" | "mhw");
        let single = place.below.iter().find(|file| is_single(&file.entry.path));
        match (single, place.below.is_empty()) {
            (Some(first), _) if self.given.options.bases.len() > 1 => Err(Error::SeveralBases {
                file: input.tree.shown(&first.entry.path),
            }),
            (_, is_empty) => Ok((!is_empty).then(|| (place, Arc::new(narrow)))),
        }
    }

    fn is_asked(&self, entry: &Entry, layout: &Layout) -> bool {
        let around =
            || folders_above(&entry.path).filter_map(|above| self.roots.get_key_value(above));
        let is_own = |layouts: &[&Layout]| {
            layouts
                .iter()
                .any(|one| one.application == layout.application)
        };
        // In the data of another application what is dangerous is looked at all the same.
        let is_left_out =
            || (layout.is_dangerous)(&entry.path) && !around().any(|(_, layouts)| is_own(layouts));
        let keeps = |(root, layouts): (&String, &Vec<&'static Layout>)| {
            let known = self.seen.kept.borrow().get(root).copied();
            known.unwrap_or_else(|| {
                let keeps = self.keeps(root, layouts);
                self.seen.kept.borrow_mut().insert(root.clone(), keeps);
                keeps
            })
        };
        let is_in_root = || around().any(keeps) && !is_left_out();
        !self.taken.contains(entry.path.as_str()) && !is_of_macos(&entry.path) && !is_in_root()
    }

    /// Whether what lies in a data root is no loose asset. A user's data of an application that is
    /// not asked for may be installed in that of another one.
    fn keeps(&self, root: &str, layouts: &[&'static Layout]) -> bool {
        let has_asked = || {
            let mut all = self.roots.values().flatten();
            all.any(|layout| self.given.options.asks_for(layout.application))
        };
        if *self.seen.has_asked.get_or_init(has_asked) {
            return true;
        }
        let is_users = |layout: &Layout| {
            (layout.role)(&candidates(&self.input.tree, root, &[layout])) == Role::User
        };
        layouts
            .iter()
            .any(|layout| self.given.options.asks_for(layout.application) || !is_users(layout))
    }

    /// The base mesh that a file is for: as it is asked for, as the file says or a folder above it,
    /// or the only one there is.
    fn bind(&self, entry: &Entry, above: &[&str], layout: &Layout) -> Binding {
        let Self {
            input,
            bases,
            given: Given { options, .. },
            ..
        } = self;
        let asked = match options.bases.as_slice() {
            [asked] if bases.is_empty() || bases.contains(asked) => Some(asked),
            _ => None,
        };
        let folders = || {
            self.seen
                .beside_target
                .get_or_init(|| self.folders_of_targets())
        };
        let is_beside_target = || folders().contains(folder_and_name(&entry.path).0);
        let header = recognised(input, entry, options, self.is_meant, &is_beside_target)?;
        let is_target = meant_extension(&entry.path) == "target";
        // What was made for another one is not held against an application that nobody named.
        let is_of_others = || {
            header
                .as_deref()
                .is_some_and(|base| layout.is_base_of_others(base))
                || is_target
                    && header
                        .as_deref()
                        .is_some_and(|base| is_for_another(base, layout))
                || layout.joint.is_some_and(|joint| self.lacks(entry, joint))
                || self.is_written_for_others(entry, layout)
        };
        let is_excluded = layout
            .only_base
            .is_some_and(|only| !options.asks_for_base(only));
        let is_others = if self.is_meant {
            self.given.is_one_of_several
                && meant_extension(&entry.path) == "mhm"
                && self.is_written_for_others(entry, layout)
        } else {
            is_of_others()
        };
        if is_excluded || is_others {
            return None;
        }
        let only = bases.first().filter(|_| bases.len() == 1);
        let folder = above
            .iter()
            .find(|name| !is_target && bases.contains(**name))
            .map(|name| (*name).to_owned());
        let asked = layout
            .only_base
            .map(str::to_owned)
            .or_else(|| asked.cloned());
        let named = asked.or(header).or(folder).or_else(|| only.cloned());
        // Of several bases it is the usual one for what most are made for, and looks alike on any.
        let is_usual = match meant_extension(&entry.path) {
            "target" => false,
            "mhclo" | "proxy" | "mhmat" => bases.is_empty() || bases.contains(Layout::USUAL_BASE),
            _ => bases.is_empty(),
        };
        Some(named.or_else(|| is_usual.then(|| Layout::USUAL_BASE.to_owned())))
    }

    /// The folders outside of data roots with files that can be recognised as targets.
    fn folders_of_targets(&self) -> BTreeSet<String> {
        let is_in = |path: &str| folders_above(path).any(|above| self.roots.contains_key(above));
        let is_outside = |path: &str| !is_in(path);
        let Input { tree, .. } = self.input;
        let files = tree
            .entries()
            .iter()
            .filter(|entry| meant_extension(&entry.path) == "target");
        let is_target = |entry: &&Entry| {
            is_outside(&entry.path)
                && tree
                    .read(entry, &self.given.options.limits)
                    .is_ok_and(|text| recognise(&text).is_some())
        };
        files
            .filter(is_target)
            .map(|entry| folder_and_name(&entry.path).0.to_owned())
            .collect()
    }

    /// Whether a file is for other applications where nobody asks, as it says itself, or by its
    /// kind.
    fn is_written_for_others(&self, entry: &Entry, layout: &Layout) -> bool {
        let text = self
            .input
            .tree
            .read(entry, &self.given.options.limits)
            .unwrap_or_default();
        (layout.is_of_others)(meant_extension(&entry.path), &|word| says(&text, word))
    }

    /// Whether a file is a motion without this joint.
    fn lacks(&self, entry: &Entry, joint: &str) -> bool {
        let text = || {
            self.input
                .tree
                .read(entry, &self.given.options.limits)
                .unwrap_or_default()
        };
        meant_extension(&entry.path) == "bvh" && !has_joint(&text(), joint)
    }
}

/// The base mesh in the header of a file that is ours: it is named as PATH, or its content says so.
/// Only assets that share their extension with files of other programs are in doubt.
fn recognised(
    input: &Input,
    entry: &Entry,
    options: &Config,
    is_meant: bool,
    is_beside_target: &dyn Fn() -> bool,
) -> Binding {
    let is_named = || input.named.contains(&input.tree.shown(&entry.path));
    let read = || input.tree.read(entry, &options.limits).unwrap_or_default();
    match meant_extension(&entry.path) {
        "target" => {
            let text = read();
            let target = recognise(&text);
            // Who names a base mesh or gives data means the targets that there are, also those of
            // which no row can be read.
            let is_asked = || (is_meant || !options.bases.is_empty()) && has_broken_rows(&text);
            // One of several that are some is broken, unless it says that it is for another
            // program.
            let is_broken =
                || is_beside_target() && !FOREIGN_TARGETS.iter().any(|word| says(&text, word));
            let is_ours = target.is_some() || is_named() || is_asked() || is_broken();
            is_ours.then(|| {
                target
                    .and_then(|target| target.basemesh)
                    .filter(|name| is_folder_name(name))
            })
        }
        "mhclo" => Some(base_of(&read())),
        // Only MPFB has rigs in such files, and weights and presets under names that say so.
        "json" => (is_meant && (is_named() || is_named_as_of_rig(&entry.path))
            || says_it_is_of_mpfb(&entry.path, &read()))
        .then_some(None),
        "gz" => Some(None),
        "proxy" => {
            let text = read();
            (is_named() || first_words(&text).any(|(word, _)| word == "obj_file"))
                .then(|| base_of(&text))
        }
        "bvh" => (is_named() || is_of_makehuman(input, entry, &read())).then_some(None),
        _ => Some(None),
    }
}

/// What targets of systemd and Eclipse say.
const FOREIGN_TARGETS: [&str; 3] = ["[Unit]", "[Install]", "<target"];

/// Whether the base mesh in the header of a target is not the only one that there is, nor that of
/// an older version.
fn is_for_another(base: &str, layout: &Layout) -> bool {
    layout.only_base.is_some_and(|only| only != base) && !base.starts_with("alpha")
}

/// Whether a JSON says by its content that it is a rig, a pose or a saved character of MPFB.
fn says_it_is_of_mpfb(path: &str, text: &[u8]) -> bool {
    says(text, "\"identifying_bones\"")
        || STORED_POSE.iter().all(|word| says(text, word))
        || is_named_as_preset(path) && is_saved_character(text)
}

/// Whether a file has a name as rigs and their weights have it among those of the add-on.
fn is_named_as_of_rig(path: &str) -> bool {
    let (_, name) = folder_and_name(path);
    name.starts_with("rig.") || name.starts_with("weights.")
}

/// Whether a file has a name as saved characters have it.
fn is_named_as_preset(path: &str) -> bool {
    folder_and_name(path).1.starts_with("human.")
}

fn is_saved_character(text: &[u8]) -> bool {
    SAVED_CHARACTER
        .iter()
        .all(|words| words.iter().any(|word| says(text, word)))
}

fn says(text: &[u8], word: &str) -> bool {
    text.windows(word.len()).any(|part| part == word.as_bytes())
}

/// A motion with a preview or a description as the applications have them, or for their skeleton.
fn is_of_makehuman(input: &Input, entry: &Entry, text: &[u8]) -> bool {
    let beside = |extension| {
        input
            .tree
            .entry(&format!(
                "{}.{extension}",
                entry.path.trim_end_matches(".bvh")
            ))
            .is_some()
    };
    let mut joints = Application::ALL
        .into_iter()
        .filter_map(|application| Layout::of(application).joint);
    beside("meta") || beside("thumb") || joints.any(|joint| has_joint(text, joint))
}

fn has_joint(text: &[u8], joint: &str) -> bool {
    first_words(text).any(|(word, rest)| matches!(&*word, "JOINT" | "ROOT") && rest == [joint])
}

/// The base mesh in the header of an asset.
fn base_of(text: &[u8]) -> Option<String> {
    let mut lines = first_words(text).filter(|(word, _)| word.trim_end_matches(':') == "basemesh");
    lines
        .find_map(|(_, rest)| rest.into_iter().next())
        .filter(|name| is_folder_name(name))
}

/// A name that is no folder leads elsewhere.
fn is_folder_name(name: &str) -> bool {
    !name.contains(['/', '\\']) && !name.starts_with('.')
}

/// The lines that begin with a word, and what stands behind it.
fn first_words(text: &[u8]) -> impl Iterator<Item = (String, Vec<String>)> {
    let begins_with_word = |line: &&[u8]| {
        line.trim_ascii_start()
            .first()
            .is_some_and(u8::is_ascii_alphabetic)
    };
    lines(text)
        .map(|(_, line)| line)
        .filter(begins_with_word)
        .filter_map(|line| {
            let line = String::from_utf8_lossy(line);
            let mut words = line.split_whitespace().map(str::to_owned);
            Some((words.next()?, words.collect()))
        })
}

/// Names that a text is searched for; more of them no asset has.
const NAMES: usize = 1000;

/// The words of a text that may be names of files.
fn names(tree: &Tree, entry: &Entry, limits: &Limits) -> Vec<String> {
    let text = tree.read(entry, limits).unwrap_or_default();
    let words = first_words(&text).flat_map(|(_, rest)| rest);
    words
        .filter(|word| word.contains('.') && word.parse::<f64>().is_err())
        .take(NAMES)
        .collect()
}

/// The folder at the top of a tree, with those above it.
fn top(tree: &Tree) -> String {
    tree.root()
        .and_then(canonical)
        .map_or_else(|| tree.label().to_owned(), |folder| slashed(&folder))
}
