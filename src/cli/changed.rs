//! `--changed-files` and `--since`: which files a change touches. The only place that starts another program.

use std::collections::BTreeSet;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::exit::Failure;

/// Paths from a list: a line each, or separated by NUL as `git diff -z` writes them; `-` is standard input.
pub(super) fn listed(file: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut bytes = Vec::new();
    let read = if file == Path::new("-") {
        std::io::stdin().read_to_end(&mut bytes).map(|_| ())
    } else {
        std::fs::read(file).map(|content| bytes = content)
    };
    read.map_err(|error| {
        let shown = file.display();
        Failure::Usage(format!(
            "--changed-files: cannot read `{shown}`: {error}; give a file with a path a line, or `-`"
        ))
    })?;
    Ok(split(&bytes).map(PathBuf::from).collect())
}

fn split(bytes: &[u8]) -> impl Iterator<Item = String> {
    let separator = if bytes.contains(&0) { 0 } else { b'\n' };
    let lines = bytes.split(move |byte| *byte == separator);
    let trimmed = lines.map(|line| String::from_utf8_lossy(line.strip_suffix(b"\r").unwrap_or(line)).into_owned());
    trimmed.filter(|line| !line.is_empty())
}

/// Files that differ between the working tree and the point where it left `revision`, deleted, renamed and
/// not yet added ones included.
pub(super) fn since(revision: &str, first: &Path) -> Result<Vec<PathBuf>, Failure> {
    let folder = if first.is_dir() { first } else { first.parent().unwrap_or(first) };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let git = Git { folder, revision };
    let top = git.ask(&["rev-parse", "--show-toplevel"]).map_err(|said| git.outside(&said))?;
    let top = PathBuf::from(String::from_utf8_lossy(&top).trim_end());
    if revision.starts_with('-') {
        return Err(git.unknown(""));
    }
    let commit = format!("{revision}^{{commit}}");
    git.ask(&["rev-parse", "--verify", "--quiet", &commit]).map_err(|said| git.unknown(&said))?;
    let start = git.ask(&["merge-base", revision, "HEAD"]).map_err(|said| git.unrelated(&said))?;
    let start = String::from_utf8_lossy(&start).trim().to_owned();
    let failed = |said: String| Failure::Usage(format!("--since {revision}: git failed: {said}"));
    // From the top of the tree, so that paths mean the same whatever folder was asked about.
    let whole = Git { folder: &top, revision };
    let differing = whole.ask(&["diff", "--name-only", "--no-renames", "-z", &start, "--"]).map_err(failed)?;
    let new = whole.ask(&["ls-files", "--others", "--exclude-standard", "-z"]).map_err(failed)?;
    let names: BTreeSet<String> = nul_separated(&differing).chain(nul_separated(&new)).collect();
    Ok(names.into_iter().map(|name| top.join(name)).collect())
}

fn nul_separated(bytes: &[u8]) -> impl Iterator<Item = String> {
    let names = bytes.split(|byte| *byte == 0).filter(|name| !name.is_empty());
    names.map(|name| String::from_utf8_lossy(name).into_owned())
}

struct Git<'a> {
    folder: &'a Path,
    revision: &'a str,
}

impl Git<'_> {
    /// What git prints, or what it complains about.
    fn ask(&self, arguments: &[&str]) -> Result<Vec<u8>, String> {
        let output = Command::new("git").arg("-C").arg(self.folder).args(arguments).output();
        let output = output.map_err(|error| format!("git cannot be started: {error}"))?;
        if output.status.success() {
            return Ok(output.stdout);
        }
        Err(String::from_utf8_lossy(&output.stderr).trim().to_owned())
    }

    fn outside(&self, said: &str) -> Failure {
        let folder = self.folder.display();
        Failure::Usage(format!(
            "--since: `{folder}` is in no git repository ({said}); give the changed files with --changed-files FILE"
        ))
    }

    fn unknown(&self, said: &str) -> Failure {
        let reason = if said.is_empty() { String::new() } else { format!(" ({said})") };
        Failure::Usage(format!(
            "--since: git knows no revision `{}`{reason}; {}",
            self.revision,
            self.advice("name a commit, a tag or a branch, `origin/main` say")
        ))
    }

    fn unrelated(&self, said: &str) -> Failure {
        let reason = if said.is_empty() { String::new() } else { format!(" ({said})") };
        Failure::Usage(format!(
            "--since: `{}` and HEAD have no commit in common{reason}; {}",
            self.revision,
            self.advice("name a revision of the same history")
        ))
    }

    /// In a shallow clone the history is what is missing.
    fn advice(&self, otherwise: &str) -> String {
        let shallow = self.ask(&["rev-parse", "--is-shallow-repository"]);
        if shallow.is_ok_and(|said| said.starts_with(b"true")) {
            "this is a shallow clone: fetch its history (`git fetch --unshallow`, `fetch-depth: 0` in a workflow)"
                .to_owned()
        } else {
            otherwise.to_owned()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_lines_or_separated_by_nul() {
        assert_eq!(split(b"a b\r\nc\n\n").collect::<Vec<_>>(), ["a b", "c"]);
        assert_eq!(split(b"a\nb\0c\0").collect::<Vec<_>>(), ["a\nb", "c"]);
    }
}
