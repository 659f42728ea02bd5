//! Contents that git has recorded, in a commit or in the index, where the working tree has others.
//!
//! They come through git's own filters, so that line ends are those of the working tree; nothing is
//! downloaded.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::git::{Record, Refusal, Repository, path};
use mhlint_source::{Contents, Encoding, Limits, canonical, folder_of, resolved};

/// What git has in place of what lies in a working tree.
#[derive(Default)]
pub(super) struct Recorded {
    /// By absolute path.
    pub(super) contents: Contents<PathBuf>,
    /// Files and submodules whose contents are not at hand.
    pub(super) missing: BTreeSet<PathBuf>,
    /// Links, and what they lead to.
    links: Vec<(PathBuf, PathBuf)>,
    with_ignored: bool,
}

/// Files that git has not recorded, and those that it is not to record.
const NEW: &[&str] = &["ls-files", "--others", "--exclude-standard", "-z"];
const NEW_AND_IGNORED: &[&str] = &["ls-files", "--others", "-z"];

/// A file that differs: what is recorded in its place.
struct Difference {
    /// From the top of the working tree, as git names it.
    name: Vec<u8>,
    kind: Kind,
    object: String,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Nothing,
    File,
    Link,
    Submodule,
}

impl Recorded {
    /// Everything in which a record differs from the working tree. Files that git ignores are in
    /// both, unless these count as well.
    pub(super) fn of(
        repository: &Repository,
        record: Record<'_>,
        with_ignored: bool,
    ) -> Result<Self, Refusal> {
        let mut recorded = Self {
            with_ignored,
            ..Self::default()
        };
        recorded.add(repository, record)?;
        for (link, target) in std::mem::take(&mut recorded.links) {
            match recorded.behind(repository, &target) {
                Some(bytes) => drop(recorded.contents.insert(link, Some(bytes))),
                None => drop(recorded.missing.insert(link)),
            }
        }
        Ok(recorded)
    }

    fn add(&mut self, repository: &Repository, record: Record<'_>) -> Result<(), Refusal> {
        let mut written = Vec::new();
        for one in differences(repository, record)? {
            let place = repository.place(&one.name);
            match one.kind {
                Kind::Nothing if place.is_dir() => self.add_submodule(&place, None),
                Kind::Nothing => drop(self.contents.insert(place, None)),
                Kind::Submodule => self.add_submodule(&place, Some(&one.object)),
                Kind::File | Kind::Link => written.push((one, place)),
            }
        }
        let new = repository.files(if self.with_ignored {
            NEW_AND_IGNORED
        } else {
            NEW
        })?;
        self.contents
            .extend(new.into_iter().map(|file| (file, None)));
        let folder =
            repository.check_out(record, written.iter().map(|(one, _)| one.name.as_slice()))?;
        for (one, place) in written {
            let copy = folder.path().join(path(&one.name));
            if let (Kind::Link, Ok(target)) = (one.kind, fs::read_link(&copy)) {
                self.links
                    .push((place.clone(), folder_of(&place).join(target)));
                continue;
            }
            let bytes = content(&copy);
            let is_at_hand = |bytes: &[u8]| {
                !is_pointer(bytes) || fs::read(&place).is_ok_and(|now| is_pointer(&now))
            };
            let found = bytes
                .clone()
                .filter(|bytes| is_at_hand(bytes))
                .or_else(|| object(bytes.as_ref()?, repository));
            if found.is_none() {
                self.missing.insert(place.clone());
            }
            // That there was a file is known all the same.
            if let Some(bytes) = found.or(bytes) {
                self.contents.insert(place, Some(bytes));
            }
        }
        Ok(())
    }

    /// The files of a submodule as they were at a commit of its own; at none there was no
    /// submodule.
    fn add_submodule(&mut self, place: &Path, commit: Option<&str>) {
        let inner = Repository::around(place)
            .ok()
            .filter(|inner| canonical(inner.top()) == canonical(place));
        let added = inner.and_then(|inner| {
            if let Some(commit) = commit {
                return self.add(&inner, Record::Commit(commit)).ok();
            }
            let files = inner
                .files(&["ls-files", "--cached", "--others", "-z"])
                .ok()?;
            self.contents
                .extend(files.into_iter().map(|file| (file, None)));
            Some(())
        });
        if added.is_none() {
            self.missing.insert(place.to_owned());
        }
    }

    /// The content of the file that a link leads to, if that is one of the working tree.
    fn behind(&self, repository: &Repository, target: &Path) -> Option<Vec<u8>> {
        let target = resolved(target);
        match self.contents.get(&target) {
            Some(recorded) => recorded.clone(),
            None if target.starts_with(canonical(repository.top())?) => fs::read(target).ok(),
            None => None,
        }
    }
}

/// How a record differs from the working tree, but for files that git has never seen.
fn differences(repository: &Repository, record: Record<'_>) -> Result<Vec<Difference>, Refusal> {
    let mut arguments = vec![
        "diff",
        "--raw",
        "-z",
        "--no-renames",
        "--no-abbrev",
        "--no-ext-diff",
    ];
    arguments.push("--ignore-submodules=none");
    arguments.extend(record.commit());
    arguments.push("--");
    let told = repository.ask(&arguments)?;
    let mut fields = told.split(|byte| *byte == 0);
    let mut differences = Vec::new();
    while let (Some(what), Some(name)) = (fields.next(), fields.next()) {
        // `:100644 100644 8e27be7 0000000 M`
        let what = String::from_utf8_lossy(what);
        let mut words = what.trim_start_matches(':').split(' ');
        let (mode, object, status) = (words.next(), words.nth(1), words.nth(1));
        let kind = match mode {
            // Told again, with what is recorded.
            _ if status == Some("U") => continue,
            Some("120000") => Kind::Link,
            Some("160000") => Kind::Submodule,
            Some("000000") | None => Kind::Nothing,
            Some(_) => Kind::File,
        };
        differences.push(Difference {
            name: name.to_owned(),
            kind,
            object: object.unwrap_or_default().to_owned(),
        });
    }
    Ok(differences)
}

/// What git has written to `copy`.
fn content(copy: &Path) -> Option<Vec<u8>> {
    let size = fs::metadata(copy).ok()?.len();
    if size > Limits::default().file_bytes {
        None
    } else {
        fs::read(copy).ok()
    }
}

fn is_pointer(bytes: &[u8]) -> bool {
    Encoding::of(bytes).lfs_pointer
}

/// The object that a pointer of Git LFS stands for, if it was fetched.
fn object(pointer: &[u8], repository: &Repository) -> Option<Vec<u8>> {
    let text = String::from_utf8_lossy(pointer);
    let object = text
        .lines()
        .find_map(|line| line.strip_prefix("oid sha256:"))?
        .trim();
    let folders = [object.get(..2)?, object.get(2..4)?, object];
    fs::read(repository.lfs_objects()?.join(folders.join("/"))).ok()
}
