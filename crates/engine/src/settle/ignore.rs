//! Ignores. They are applied to findings after the rules have run, so that ignores without effect
//! are known.

use std::collections::{BTreeMap, BTreeSet};

use super::answered::Answered;
use super::idle::{is_for_listed, reached};
use super::named::NamedRules;
use super::scope::Scope;
use super::select::{Selection, cannot_be_ignored};
use mhlint_config::{Config, Date, Globs, Ignore};
use mhlint_diag::{IgnoreState, IgnoreUse, Place, UnknownRule};
use mhlint_repo::FileFacts;
use mhlint_source::{Outer, Tree, file_name};

/// The ignores of a run, and which of them hid something so far.
pub(crate) struct Ignores<'c> {
    config: &'c Config,
    today: Date,
    /// The glob of each `[[ignore]]`.
    globs: Globs,
    /// Remembers whether an `[[ignore]]` hides a rule at a path.
    ignored: Answered<bool>,
    /// For each `[[ignore]]` whether it hid something.
    hits: Vec<bool>,
    /// The ignoring comments in the files that were reported on.
    inline: Vec<IgnoreUse>,
    /// File and line of the comments that hid something.
    used: BTreeSet<(String, u32)>,
    /// For each file with such comments its path below the data root.
    assets: BTreeMap<String, String>,
    named: NamedRules,
}

impl<'c> Ignores<'c> {
    pub(crate) fn new(config: &'c Config) -> Self {
        let ignores = config.file.iter().flat_map(|file| &file.ignores);
        let globs: Globs = ignores.map(|ignore| ignore.path.clone()).collect();
        Self {
            config,
            today: Date::today(),
            hits: vec![false; globs.iter().count()],
            globs,
            ignored: Answered::default(),
            inline: Vec::new(),
            used: BTreeSet::new(),
            assets: BTreeMap::new(),
            named: NamedRules::default(),
        }
    }

    /// Whether a rule is ignored for the file or folder at `path`; `file` has the facts on it. The
    /// ignores that hide the rule are marked as used.
    pub(crate) fn hides(
        &mut self,
        rule: &'static str,
        path: &str,
        file: Option<&FileFacts>,
    ) -> bool {
        let answered = std::mem::take(&mut self.ignored);
        let mut hidden =
            !self.globs.is_empty() && answered.of(path, rule, || self.is_ignored(rule, path));
        self.ignored = answered;
        let comments = file.into_iter().flat_map(|file| &file.ignores);
        for comment in comments.filter(|comment| !comment.reason.is_empty()) {
            if self.named.of(&comment.rule).contains(&rule) {
                self.used.insert((path.to_owned(), comment.line));
                hidden = true;
            }
        }
        hidden
    }

    fn is_ignored(&mut self, rule: &str, path: &str) -> bool {
        let Some(file) = &self.config.file else {
            return false;
        };
        let Some(rel) = file.relative(path) else {
            return false;
        };
        let mut hidden = false;
        for number in self.globs.fitting(&rel) {
            let (Some(ignore), Some(hit)) = (file.ignores.get(number), self.hits.get_mut(number))
            else {
                continue;
            };
            if counts(ignore, self.today) && ignore.rule.fits(rule) {
                *hit = true;
                hidden = true;
            }
        }
        hidden
    }

    /// Collects the ignoring comments of a file that is reported on.
    pub(crate) fn note(&mut self, file: &FileFacts, selection: &Selection<'_>, scope: &Scope<'_>) {
        for comment in &file.ignores {
            let state = match self.standing(&comment.rule) {
                _ if comment.rule.is_empty() => IgnoreState::Malformed {
                    words: comment.reason.clone(),
                },
                Some(state) => state,
                None if comment.reason.is_empty() => IgnoreState::NoReason,
                None if scope.is_whole() && !self.is_silenced(&comment.rule, selection) => {
                    IgnoreState::Unused
                }
                None => IgnoreState::NotChecked,
            };
            let (path, place) = (file.path.clone(), Place::Line(comment.line));
            self.inline.push(IgnoreUse {
                path,
                place,
                rule: comment.rule.clone(),
                covers: None,
                state,
            });
            self.assets.insert(file.path.clone(), file.rel.clone());
        }
    }

    /// All ignores, each with its state: used, unused, expired and so on.
    pub(crate) fn uses<'t>(
        &self,
        selection: &Selection<'_>,
        scope: &Scope<'_>,
        trees: impl Iterator<Item = &'t Tree> + Clone,
    ) -> Vec<IgnoreUse> {
        let file = self.config.file.iter();
        let listed = Outer::of(trees.clone().map(Tree::label));
        let reached = self
            .config
            .file
            .as_ref()
            .map(|file| reached(file, &self.globs, trees))
            .unwrap_or_default();
        let ignores = file.flat_map(|file| {
            file.ignores
                .iter()
                .zip(&self.hits)
                .map(move |each| (file, each))
        });
        let mut uses: Vec<IgnoreUse> = (0..)
            .zip(ignores)
            .map(|(number, (file, (ignore, hit)))| {
                let state = match self.standing(&ignore.rule.text) {
                    _ if *hit => IgnoreState::Used,
                    Some(state) => state,
                    None if ignore.reason.is_none() => IgnoreState::NoReason,
                    None => match ignore.until.filter(|until| *until < self.today) {
                        Some(until) => IgnoreState::Expired {
                            until: until.to_string(),
                        },
                        None if self.is_silenced(&ignore.rule.text, selection) => {
                            IgnoreState::NotChecked
                        }
                        None if is_for_listed(file, &ignore.path, &listed)
                            && !reached.contains(&number) =>
                        {
                            IgnoreState::Unused
                        }
                        None if !scope.covers(&file.folder, ignore.path.folder()) => {
                            IgnoreState::NotChecked
                        }
                        None => IgnoreState::Unused,
                    },
                };
                let span = if let IgnoreState::Expired { .. } = state {
                    &ignore.until_span
                } else {
                    &ignore.rule.span
                };
                IgnoreUse {
                    path: file.path.clone(),
                    place: Place::Span(span.clone()),
                    rule: ignore.rule.text.clone(),
                    covers: Some(ignore.path.text.clone()),
                    state,
                }
            })
            .collect();
        uses.extend(self.inline.iter().map(|comment| {
            let is_used = match comment.place {
                Place::Line(line) => self.used.contains(&(comment.path.clone(), line)),
                _ => false,
            };
            let state = if is_used {
                IgnoreState::Used
            } else {
                comment.state.clone()
            };
            IgnoreUse {
                state,
                ..comment.clone()
            }
        }));
        uses
    }

    /// Settings in the configuration file for rules that do not exist.
    pub(crate) fn unknown(&self) -> Vec<UnknownRule> {
        self.config
            .file
            .as_ref()
            .map(|file| file.unknown.clone())
            .unwrap_or_default()
    }

    /// The state of an ignore, if it follows from its rule alone.
    fn standing(&self, rule: &str) -> Option<IgnoreState> {
        if cannot_be_ignored(rule) {
            return Some(IgnoreState::CannotBeIgnored);
        }
        self.named
            .of(rule)
            .is_empty()
            .then(|| IgnoreState::UnknownRule {
                nearest: self.named.nearest(rule),
            })
    }

    /// Whether the command line turned off a rule that the ignore is for, or the ignore names no
    /// rule.
    fn is_silenced(&self, rule: &str, selection: &Selection<'_>) -> bool {
        let named = self.named.of(rule);
        named.is_empty() || named.iter().any(|rule| selection.is_silenced(rule))
    }

    /// The path for the fingerprint of a finding on an ignore: the path below the data root, or
    /// else the name of the file. It does not depend on where the data lie.
    pub(crate) fn asset(&self, path: &str) -> String {
        let name = || file_name(path).to_owned();
        self.assets.get(path).cloned().unwrap_or_else(name)
    }
}

/// Whether an ignore has a reason and has not ended.
fn counts(ignore: &Ignore, today: Date) -> bool {
    ignore.reason.is_some() && ignore.until.is_none_or(|until| today <= until)
}
