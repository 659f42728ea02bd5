//! What git says about the folder that is checked. The only place that starts another program.

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use mhlint_source::resolved;

/// By these git hands its own repository and the index of the commit to a hook. They are relative
/// to where the hook runs, and the folder to check may lie in another repository.
const HANDED_DOWN: [&str; 6] = [
    "GIT_DIR",
    "GIT_WORK_TREE",
    "GIT_IMPLICIT_WORK_TREE",
    "GIT_COMMON_DIR",
    "GIT_INDEX_FILE",
    "GIT_PREFIX",
];

/// Contents that are not at hand stay away: a gate waits for no network.
const NO_DOWNLOADS: [(&str, &str); 3] = [
    ("GIT_LFS_SKIP_SMUDGE", "1"),
    ("GIT_NO_LAZY_FETCH", "1"),
    ("GIT_TERMINAL_PROMPT", "0"),
];

/// A working tree of git.
pub(super) struct Repository {
    top: PathBuf,
    /// `top` behind all links.
    place: PathBuf,
    folder: PathBuf,
    /// The index of the commit at hand: `git commit -a` and `git commit PATH` write one of their
    /// own. Relative to `top`.
    index: Option<OsString>,
}

/// Where git keeps contents.
#[derive(Clone, Copy)]
pub(super) enum Record<'r> {
    /// In a commit.
    Commit(&'r str),
    /// In the index: what is about to be committed.
    Index,
}

impl<'r> Record<'r> {
    pub(super) const fn commit(self) -> Option<&'r str> {
        if let Self::Commit(commit) = self {
            Some(commit)
        } else {
            None
        }
    }
}

/// Why git gives no answer.
#[derive(Debug)]
pub(super) enum Refusal {
    /// It is not there.
    NotStarted(io::Error),
    /// It ended with an error and these words.
    Said(String),
    /// There is no folder for what it writes.
    NoFolder(io::Error),
}

impl Repository {
    /// The one that `folder` lies in.
    pub(super) fn around(folder: &Path) -> Result<Self, Refusal> {
        let here = || locate(&|| Command::new("git"));
        let index = std::env::var_os("GIT_INDEX_FILE");
        let own = locate(&|| {
            let mut git = undirected();
            git.arg("-C").arg(folder);
            git
        });
        match own {
            Ok((top, git_folder)) => {
                let is_same = || here().is_ok_and(|(_, other)| other == git_folder);
                let index = index.filter(|_| is_same());
                Ok(Self::at(top, git_folder, index))
            }
            Err(Refusal::Said(said)) => {
                // A working tree without `.git` in it: only the variables tell where its repository
                // is.
                let (top, git_folder) = here().map_err(|_| Refusal::Said(said.clone()))?;
                let is_inside = real(folder).starts_with(real(&top));
                if is_inside {
                    Ok(Self::at(top, git_folder, index))
                } else {
                    Err(Refusal::Said(said))
                }
            }
            Err(refusal) => Err(refusal),
        }
    }

    fn at(top: PathBuf, folder: PathBuf, index: Option<OsString>) -> Self {
        let place = resolved(&top);
        Self {
            top,
            place,
            folder,
            index,
        }
    }

    /// What git prints. It runs at the top of the tree, so that paths mean the same whatever folder
    /// was asked about.
    pub(super) fn ask(&self, arguments: &[&str]) -> Result<Vec<u8>, Refusal> {
        output(self.command().args(arguments))
    }

    fn command(&self) -> Command {
        let mut git = undirected();
        git.arg("-C")
            .arg(&self.top)
            .env("GIT_DIR", &self.folder)
            .env("GIT_WORK_TREE", &self.top);
        if let Some(index) = &self.index {
            git.env("GIT_INDEX_FILE", index);
        }
        git
    }

    /// The top of the working tree.
    pub(super) fn top(&self) -> &Path {
        &self.top
    }

    /// Where a file of the working tree lies, by the name that git has for it.
    pub(super) fn place(&self, name: &[u8]) -> PathBuf {
        self.place.join(path(name))
    }

    /// Recorded files in a folder of their own, as git writes them to the working tree. What git
    /// cannot write there without a download is missing.
    pub(super) fn check_out<'n>(
        &self,
        record: Record<'_>,
        names: impl Iterator<Item = &'n [u8]>,
    ) -> Result<tempfile::TempDir, Refusal> {
        let folder = tempfile::tempdir().map_err(Refusal::NoFolder)?;
        let mut names = names.peekable();
        if names.peek().is_none() {
            return Ok(folder);
        }
        let mut git = self.command();
        if let Record::Commit(commit) = record {
            let index = folder.path().join(".git-index");
            output(
                self.command()
                    .env("GIT_INDEX_FILE", &index)
                    .args(["read-tree", commit]),
            )?;
            git.env("GIT_INDEX_FILE", index);
        }
        let mut prefix = OsString::from("--prefix=");
        prefix.push(folder.path());
        prefix.push("/");
        git.args(["checkout-index", "-z", "--stdin", "--quiet"])
            .arg(prefix);
        git.stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        let mut running = git.spawn().map_err(Refusal::NotStarted)?;
        if let Some(mut list) = running.stdin.take() {
            names
                .try_for_each(|name| list.write_all(name).and_then(|()| list.write_all(&[0])))
                .map_err(Refusal::NotStarted)?;
        }
        // Which files it could not write shows by their absence.
        running.wait().map_err(Refusal::NotStarted)?;
        Ok(folder)
    }

    /// Where Git LFS keeps what it has fetched.
    pub(super) fn lfs_objects(&self) -> Option<PathBuf> {
        let common = self.ask(&["rev-parse", "--git-common-dir"]).ok()?;
        Some(
            self.top
                .join(path(common.strip_suffix(b"\n")?))
                .join("lfs/objects"),
        )
    }

    /// The files that git lists, separated by NUL.
    pub(super) fn files(&self, arguments: &[&str]) -> Result<Vec<PathBuf>, Refusal> {
        let listed = self.ask(arguments)?;
        let names = listed
            .split(|byte| *byte == 0)
            .filter(|name| !name.is_empty());
        Ok(names.map(|name| self.place(name)).collect())
    }

    /// The one that holds this one as a submodule.
    pub(super) fn superproject(&self) -> Option<Self> {
        let top = self
            .ask(&["rev-parse", "--show-superproject-working-tree"])
            .ok()?;
        let top = top.strip_suffix(b"\n").filter(|top| !top.is_empty())?;
        Self::around(&path(top)).ok()
    }

    /// Whether a part of the history was not fetched.
    pub(super) fn is_shallow(&self) -> bool {
        self.ask(&["rev-parse", "--is-shallow-repository"])
            .is_ok_and(|said| said.starts_with(b"true"))
    }
}

impl Refusal {
    /// What git complained about; may be empty.
    pub(super) fn words(&self) -> String {
        match self {
            Self::NotStarted(error) => format!("cannot start git: {error}"),
            Self::Said(said) => said.clone(),
            Self::NoFolder(error) => format!("cannot create a temporary folder for git: {error}"),
        }
    }
}

/// A git that has to find its repository itself.
fn undirected() -> Command {
    let mut git = Command::new("git");
    for name in HANDED_DOWN {
        git.env_remove(name);
    }
    git.envs(NO_DOWNLOADS);
    git
}

/// The top of the working tree and the folder of the repository.
fn locate(git: &dyn Fn() -> Command) -> Result<(PathBuf, PathBuf), Refusal> {
    let ask = |what| {
        output(git().args(["rev-parse", what]))
            .map(|line| path(line.strip_suffix(b"\n").unwrap_or(&line)))
    };
    Ok((ask("--show-toplevel")?, ask("--absolute-git-dir")?))
}

fn output(git: &mut Command) -> Result<Vec<u8>, Refusal> {
    let output = git.output().map_err(Refusal::NotStarted)?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    Err(Refusal::Said(
        String::from_utf8_lossy(&output.stderr).trim().to_owned(),
    ))
}

fn real(path: &Path) -> PathBuf {
    std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
}

#[cfg(unix)]
pub(super) fn path(bytes: &[u8]) -> PathBuf {
    use std::os::unix::ffi::OsStrExt;
    PathBuf::from(std::ffi::OsStr::from_bytes(bytes))
}

#[cfg(not(unix))]
pub(super) fn path(bytes: &[u8]) -> PathBuf {
    PathBuf::from(String::from_utf8_lossy(bytes).into_owned())
}
