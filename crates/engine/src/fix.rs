//! Fixes: check, change in memory, check again, until nothing is left that can be fixed; writing
//! comes after.

use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use super::error::Error;
use super::load::{Input, Side, sides};
use super::run::lint_sides;
use mhlint_config::Config;
use mhlint_diag::{Change, Edit, Finding, Fix, FixKind, Note, Outcome, Rewrite, Step, grouped};
use mhlint_fix::{FileChange, Patch, Plan, apply, is_packed, pack, unpack};
use mhlint_formats::{mhw, target};
use mhlint_json::{self as json, Finder};
use mhlint_source::{Limits, Tree, resolved};

/// Turns at most; what still asks for fixes then is left as it is and said.
const TURNS: usize = 20;

/// What fixing came to.
#[derive(Debug, Default)]
pub struct Fixed {
    /// What remains, checked after the last change.
    pub outcome: Outcome,
    /// What is fixed: rules in the order of the work, one entry for each finding.
    pub fixed: Vec<&'static str>,
    /// Findings that were not fixed, or not all of what they speak of, because files outside of the
    /// change ([`Config::compare`]) would have to be written.
    pub outside: usize,
    /// The same because of files for which the rule is ignored, or which the PATHs leave out.
    pub left_out: usize,
    /// Files that were not fixed because they lie in the folder otherwise than git has staged them.
    pub unstaged: Vec<String>,
    /// Files that differ from what is on disk, by path; nothing was written.
    pub changes: Vec<FileChange>,
}

/// Checks data roots found at `paths` and fixes in memory what can be: unsafe fixes too, if
/// `with_unsafe`. Only what would be reported is fixed, never a file of the system data, one for
/// which the rule is ignored or one that the PATHs leave out, and in a run that compares only files
/// that differ.
///
/// # Errors
/// As [`super::lint`], and when a path is a zip.
pub fn lint_and_fix(
    paths: &[PathBuf],
    options: &Config,
    with_unsafe: bool,
) -> Result<Fixed, Error> {
    let (mut now, before) = sides(paths, options)?;
    if let Some(pack) = now.inputs.iter().find(|input| input.tree.pack().is_some()) {
        return Err(Error::FixPack {
            path: pack.tree.label().to_owned(),
        });
    }
    now.inputs.iter_mut().for_each(|input| input.tree.watch());
    let mut work = Work::new(&now, before.as_ref(), options, with_unsafe);
    let mut all = Fixed::default();
    for turn in 0.. {
        all.outcome = lint_sides(&now, before.as_ref(), options)?;
        let (plan, fixed) = work.plan(&now, &all.outcome);
        if plan.is_empty() {
            break;
        }
        if turn == TURNS {
            all.outcome.notes.push(Note::Unfinished { turns: TURNS });
            break;
        }
        all.fixed.extend(fixed);
        for (path, patch) in plan.into_files() {
            work.change(&mut now, &path, &patch);
        }
    }
    (all.outside, all.left_out) = work.not_fixed(&all.outcome.findings);
    all.unstaged = work.unstaged(&all.outcome.findings);
    all.changes = work.changes(&now);
    Ok(all)
}

/// What is kept from turn to turn.
pub(super) struct Work {
    limits: Limits,
    with_unsafe: bool,
    systems: Vec<PathBuf>,
    /// The files that may be written, by printed path, if not all.
    changed: Option<BTreeSet<String>>,
    /// Files that git has staged otherwise than they lie in the folder, by printed path.
    unstaged: BTreeSet<String>,
    /// What was checked first of the files that change, by printed path.
    checked: BTreeMap<String, Checked>,
}

/// A file as it was checked first.
struct Checked {
    hash: u64,
    bytes: Vec<u8>,
    /// Place on disk and the folder it was found in.
    file: PathBuf,
    root: PathBuf,
}

impl Work {
    pub(super) fn new(
        now: &Side,
        before: Option<&Side>,
        options: &Config,
        with_unsafe: bool,
    ) -> Self {
        Self {
            limits: options.limits,
            with_unsafe,
            systems: options.systems.clone(),
            changed: before.map(|before| changed(now, before, &options.limits)),
            unstaged: options
                .compare
                .as_ref()
                .map(|compare| now.shown(compare.now.keys()))
                .unwrap_or_default(),
            checked: BTreeMap::new(),
        }
    }

    /// The fixes that can be done together, with the rules of their findings.
    fn plan(&self, now: &Side, outcome: &Outcome) -> (Plan, Vec<&'static str>) {
        let mut plan = Plan::default();
        let mut fixed = Vec::new();
        let mut texts = Texts::default();
        for finding in &outcome.findings {
            if let Some(fix) = finding.fix.as_ref().filter(|fix| self.may(fix))
                && let Some(patches) = self.patches(now, fix, &mut texts)
                && plan.accept(patches)
            {
                fixed.push(finding.rule);
            }
        }
        (plan, fixed)
    }

    fn may(&self, fix: &Fix) -> bool {
        fix.kind == FixKind::Safe || self.with_unsafe
    }

    /// What one fix alone does to each file; nothing if it cannot be done.
    pub(super) fn alone(
        &self,
        now: &Side,
        fix: &Fix,
        texts: &mut Texts,
    ) -> BTreeMap<String, Patch> {
        let mut plan = Plan::default();
        if let Some(patches) = self.patches(now, fix, texts) {
            plan.accept(patches);
        }
        plan.into_files()
    }

    /// The steps in files that may be written. Operations on whole files stand each for itself,
    /// others belong together.
    pub(super) fn steps<'f>(&self, fix: &'f Fix) -> Vec<&'f Step> {
        let (inside, outside): (Vec<&Step>, Vec<&Step>) = fix
            .steps
            .iter()
            .partition(|step| self.is_changed(&step.path) && !fix.left_out.contains(&step.path));
        let are_apart = fix
            .steps
            .iter()
            .all(|step| matches!(step.change, Change::Rewrite(_)));
        if outside.is_empty() || are_apart {
            inside
        } else {
            Vec::new()
        }
    }

    fn is_changed(&self, path: &str) -> bool {
        self.changed
            .as_ref()
            .is_none_or(|changed| changed.contains(path))
            && !self.unstaged.contains(path)
    }

    /// Files that would be fixed if they lay in the folder as git has staged them.
    fn unstaged(&self, findings: &[Finding]) -> Vec<String> {
        let fixes = findings
            .iter()
            .filter_map(|finding| finding.fix.as_ref())
            .filter(|fix| self.may(fix));
        let steps = fixes.flat_map(|fix| &fix.steps);
        let named: BTreeSet<&String> = steps
            .map(|step| &step.path)
            .filter(|path| self.unstaged.contains(*path))
            .collect();
        named.into_iter().cloned().collect()
    }

    /// How many findings could be fixed by writing files outside of the change, and how many of the
    /// others by writing files that are left out.
    fn not_fixed(&self, findings: &[Finding]) -> (usize, usize) {
        let fixes = findings
            .iter()
            .filter_map(|finding| finding.fix.as_ref())
            .filter(|fix| self.may(fix));
        let (inside, outside): (Vec<&Fix>, Vec<&Fix>) =
            fixes.partition(|fix| fix.steps.iter().all(|step| self.is_changed(&step.path)));
        (
            outside.len(),
            inside.iter().filter(|fix| !fix.left_out.is_empty()).count(),
        )
    }

    /// Byte edits of all steps; nothing if one of them cannot be done.
    fn patches(&self, now: &Side, fix: &Fix, texts: &mut Texts) -> Option<Vec<(String, Patch)>> {
        let changes = grouped(
            self.steps(fix)
                .into_iter()
                .map(|step| (step.path.as_str(), &step.change)),
        );
        let patch = |(path, changes): (&str, Vec<&Change>)| {
            let (tree, rel) = now
                .find(path)
                .filter(|(tree, rel)| !self.is_system(tree, rel))?;
            if changes
                .iter()
                .any(|change| matches!(change, Change::Remove))
            {
                return Some((path.to_owned(), Patch::Remove));
            }
            let text = texts.of(path, || {
                let stored = tree.read(tree.entry(rel)?, &self.limits).ok()?;
                unpack(&stored, &self.limits).ok()
            })?;
            Some((path.to_owned(), Patch::Edits(edits(text, &changes)?)))
        };
        changes.into_iter().map(patch).collect()
    }

    /// Whether a file belongs to the system data, unless the folder that is checked lies inside of
    /// them.
    fn is_system(&self, tree: &Tree, rel: &str) -> bool {
        let Some(root) = tree.root().map(resolved) else {
            return false;
        };
        let systems = self.systems.iter().map(|system| resolved(system));
        let mut systems = systems.filter(|system| root == *system || !root.starts_with(system));
        systems.any(|system| {
            disk_path(tree, rel).is_some_and(|file| resolved(&file).starts_with(system))
        })
    }

    fn change(&mut self, now: &mut Side, path: &str, by: &Patch) {
        let Some((tree, rel)) = now.find(path) else {
            return;
        };
        let Some(stored) = tree
            .entry(rel)
            .and_then(|entry| tree.read(entry, &self.limits).ok())
        else {
            return;
        };
        let after = match by {
            Patch::Remove => None,
            Patch::Edits(edits) => {
                let Ok(text) = unpack(&stored, &self.limits) else {
                    return;
                };
                let text = apply(&text, edits);
                let Ok(stored) = (if is_packed(&stored) {
                    pack(&text)
                } else {
                    Ok(text)
                }) else {
                    return;
                };
                Some(stored)
            }
        };
        if let (Some(hash), Some(file), Some(root)) =
            (tree.seen(rel), disk_path(tree, rel), tree.root())
        {
            let checked = || Checked {
                hash,
                bytes: stored,
                file,
                root: root.to_owned(),
            };
            self.checked.entry(path.to_owned()).or_insert_with(checked);
        }
        for input in &mut now.inputs {
            if let Some(rel) = input.tree.below(path).map(str::to_owned) {
                input.tree.change(&rel, after.clone());
            }
        }
    }

    /// The files that differ in the end. A file that links lead to from two places changes once.
    fn changes(self, now: &Side) -> Vec<FileChange> {
        let mut changes: Vec<FileChange> = Vec::new();
        let mut known = BTreeSet::new();
        for (path, checked) in self.checked {
            let after = now
                .find(&path)
                .and_then(|(tree, rel)| tree.read(tree.entry(rel)?, &self.limits).ok());
            if after.as_ref() == Some(&checked.bytes) || !known.insert(resolved(&checked.file)) {
                continue;
            }
            let Checked {
                hash,
                bytes,
                file,
                root,
            } = checked;
            changes.push(FileChange {
                path,
                file,
                root,
                checked: hash,
                before: bytes,
                after,
            });
        }
        changes
    }
}

/// The files that differ, by printed path.
fn changed(now: &Side, before: &Side, limits: &Limits) -> BTreeSet<String> {
    let files = now
        .inputs
        .iter()
        .flat_map(|Input { tree, .. }| tree.entries().iter().map(|one| tree.shown(&one.path)));
    files
        .filter(|path| !now.shares(path, before, limits))
        .collect()
}

fn disk_path(tree: &Tree, rel: &str) -> Option<PathBuf> {
    Some(tree.root()?.join(&tree.entry(rel)?.native))
}

/// The text of the file that was changed last: mostly the next fix is one in the same file.
#[derive(Default)]
pub(super) struct Texts {
    last: Option<(String, Text)>,
}

/// A text, and its tree if one was asked for.
struct Text {
    bytes: Vec<u8>,
    finder: OnceCell<Option<Finder>>,
}

impl Texts {
    fn of(&mut self, path: &str, read: impl FnOnce() -> Option<Vec<u8>>) -> Option<&mut Text> {
        if self.last.as_ref().is_none_or(|(known, _)| known != path) {
            self.last = Some((
                path.to_owned(),
                Text {
                    bytes: read()?,
                    finder: OnceCell::new(),
                },
            ));
        }
        self.last.as_mut().map(|(_, text)| text)
    }
}

/// Descriptions to bytes. Nothing if one of them does not fit the text.
fn edits(text: &mut Text, changes: &[&Change]) -> Option<Vec<Edit>> {
    let mut edits = Vec::new();
    let mut elements = Vec::new();
    let Text { bytes, finder } = text;
    let mut finder = if changes.iter().any(|change| {
        matches!(
            change,
            Change::Value { .. } | Change::Key { .. } | Change::Element(_)
        )
    }) {
        finder.get_or_init(|| json::parse(bytes).ok().map(Finder::new));
        finder.get_mut().and_then(Option::as_mut)
    } else {
        None
    };
    for change in changes {
        match change {
            Change::Value { pointer, text } => {
                edits.push(json::set_value(finder.as_mut()?, pointer, text.as_deref())?);
            }
            Change::Key { pointer, key } => {
                edits.push(json::set_key(finder.as_mut()?, pointer, key)?);
            }
            Change::Element(pointer) => elements.push(pointer.as_str()),
            Change::Rewrite(rewrite) => edits.extend(rewritten(*rewrite, bytes)),
            Change::Remove => return None,
        }
    }
    if let Some(finder) = finder.filter(|_| !elements.is_empty()) {
        edits.extend(json::remove_elements(bytes, finder, &elements));
    }
    Some(edits)
}

fn rewritten(rewrite: Rewrite, text: &[u8]) -> Vec<Edit> {
    match rewrite {
        Rewrite::DropByteOrderMark if text.starts_with(b"\xef\xbb\xbf") => {
            vec![Edit::removal(0..3)]
        }
        Rewrite::DropByteOrderMark => Vec::new(),
        Rewrite::DropZeroRows => target::edit::drop_zero_rows(text),
        Rewrite::KeepLastRows => target::edit::keep_last_rows(text),
        Rewrite::DropSmallWeights => mhw::edit::drop_small_weights(text),
        Rewrite::MergeWeights => mhw::edit::merge_weights(text),
        Rewrite::NormalizeWeights => mhw::edit::normalize_weights(text),
    }
}

/// How many findings `--fix` alone could fix, and how many need `--unsafe-fixes`.
pub fn fixable(findings: &[Finding]) -> (usize, usize) {
    let of = |kind| {
        findings
            .iter()
            .filter(|one| one.fix.as_ref().is_some_and(|fix| fix.kind == kind))
            .count()
    };
    (of(FixKind::Safe), of(FixKind::Unsafe))
}
