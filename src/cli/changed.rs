//! `--staged`, `--since` and `--changed-files`: which files a change touches.

use std::collections::BTreeSet;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

use super::exit::Failure;
use super::git::{Refusal, Repository};
use crate::config::{Config, FILE_NAME};
use crate::source::{canonical, folder_of, holds, link_targets, own_place, resolved};

/// Paths from a list: a line each, or separated by NUL as `git diff -z` writes them; `-` is standard input.
/// Lines that git has put in quotes, as it does where a name is not ASCII, are read as git means them.
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
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        let shown = file.display();
        return Err(Failure::Usage(format!(
            "--changed-files: `{shown}` is UTF-16; write it as UTF-8, in PowerShell with `Out-File -Encoding utf8`"
        )));
    }
    Ok(split(bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&bytes)).map(PathBuf::from).collect())
}

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

fn split(bytes: &[u8]) -> impl Iterator<Item = String> {
    let separator = if bytes.contains(&0) { 0 } else { b'\n' };
    let lines = bytes.split(move |byte| *byte == separator);
    let trimmed = lines.map(move |line| {
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        let name = if separator == 0 { None } else { unquoted(line) };
        String::from_utf8_lossy(name.as_deref().unwrap_or(line)).into_owned()
    });
    trimmed.filter(|line| !line.is_empty())
}

/// What git writes as `"gr\303\274n"`; none if it is not written that way.
fn unquoted(line: &[u8]) -> Option<Vec<u8>> {
    let mut rest = line.strip_prefix(b"\"")?.strip_suffix(b"\"")?;
    let mut name = Vec::new();
    while let Some((byte, after)) = rest.split_first() {
        rest = after;
        if *byte == b'"' {
            return None;
        }
        if *byte != b'\\' {
            name.push(*byte);
            continue;
        }
        let (escaped, after) = rest.split_first()?;
        rest = after;
        name.push(match escaped {
            b'a' => 7,
            b'b' => 8,
            b't' => b'\t',
            b'n' => b'\n',
            b'v' => 11,
            b'f' => 12,
            b'r' => b'\r',
            b'"' | b'\\' => *escaped,
            b'0'..=b'3' => {
                let (low, after) = rest.split_at_checked(2)?;
                rest = after;
                let digits = [*escaped, *low.first()?, *low.last()?];
                u8::from_str_radix(std::str::from_utf8(&digits).ok()?, 8).ok()?
            }
            _ => return None,
        });
    }
    Some(name)
}

/// Why a list of changed files cannot be meant for the folder where mhlint runs, if so. A gate must not pass for a list
/// that its maker did not get: git lists from the top of the repository wherever it runs, and nothing at all when it failed.
pub(super) fn astray(files: &[PathBuf]) -> Option<String> {
    let Some(first) = files.first() else { return Some("--changed-files lists no file".to_owned()) };
    let lost: Vec<&PathBuf> = files.iter().filter(|file| !leads_somewhere(file)).collect();
    let remedy = "list paths relative to where mhlint runs, as `git diff --relative` does, or use --since";
    let above = lost.iter().find_map(|file| Some((file, folder_above_with(file)?)));
    if let Some((file, above)) = above {
        let (file, above) = (file.display(), above.display());
        return Some(format!("--changed-files: `{file}` is not here, but in `{above}`; {remedy}"));
    }
    (lost.len() == files.len()).then(|| {
        let others = match files.len() {
            1 => String::new(),
            number => format!(", nor is any other of the {number} listed files"),
        };
        format!("--changed-files: `{}` is not here{others}; {remedy}", first.display())
    })
}

/// Whether there is something at a path, or was: of a deleted file a folder is left, at least the outermost.
fn leads_somewhere(file: &Path) -> bool {
    let outermost = |file: &Path| {
        let is_name = |part: &Component<'_>| matches!(part, Component::Normal(_));
        let ups: PathBuf = file.components().take_while(|part| !is_name(part)).collect();
        file.is_relative() && file.components().find(is_name).is_some_and(|name| ups.join(name).is_dir())
    };
    file.exists() || file.is_symlink() || folder_of(file).is_dir() || outermost(file)
}

/// The folder above the working directory, not above its repository, from which a path would lead to something.
fn folder_above_with(file: &Path) -> Option<PathBuf> {
    let here = canonical(Path::new("."))?;
    let levels = here.ancestors().position(|folder| holds(folder, ".git")).unwrap_or(usize::MAX);
    let found = here.ancestors().skip(1).take(levels).position(|above| leads_somewhere(&above.join(file)))?;
    file.is_relative().then(|| vec![".."; found + 1].join("/").into())
}

/// Files that differ between HEAD, or nothing before the first commit, and what is staged; deleted and renamed ones
/// included.
pub(super) fn staged(first: &Path) -> Result<Vec<PathBuf>, Failure> {
    let repository = around(first, "--staged")?;
    let listed = repository.files(&["diff", "--cached", "--name-only", "--no-renames", "-z", "--"]);
    listed.map_err(|refusal| Failure::Usage(format!("--staged: git failed: {}", refusal.words())))
}

/// Files that differ between the working tree and the point where it left `revision`, deleted, renamed and
/// not yet added ones included. Of data in a submodule the commit that the repository around it names counts as well.
pub(super) fn since(revision: &str, first: &Path) -> Result<Vec<PathBuf>, Failure> {
    let repository = around(first, "--since")?;
    let mut all = differing(&repository, revision)?;
    let mut inner = repository;
    while let Some(outer) = inner.superproject() {
        // A revision that only the submodule has says nothing of what is around it.
        all.extend(differing(&outer, revision).unwrap_or_default());
        inner = outer;
    }
    Ok(all.into_iter().collect())
}

fn differing(repository: &Repository, revision: &str) -> Result<BTreeSet<PathBuf>, Failure> {
    if revision.starts_with('-') {
        return Err(unknown(repository, revision, ""));
    }
    let commit = format!("{revision}^{{commit}}");
    let known = repository.ask(&["rev-parse", "--verify", "--quiet", &commit]);
    known.map_err(|refusal| unknown(repository, revision, &refusal.words()))?;
    let start = repository.ask(&["merge-base", revision, "HEAD"]);
    let start = start.map_err(|refusal| unrelated(repository, revision, &refusal.words()))?;
    let start = String::from_utf8_lossy(&start).trim().to_owned();
    let failed = |refusal: Refusal| Failure::Usage(format!("--since {revision}: git failed: {}", refusal.words()));
    let differing = repository.files(&["diff", "--name-only", "--no-renames", "-z", &start, "--"]).map_err(failed)?;
    let new = repository.files(&["ls-files", "--others", "--exclude-standard", "-z"]).map_err(failed)?;
    Ok(differing.into_iter().chain(new).collect())
}

/// What among the changed files can raise or hide any finding: the configuration or the baseline in use, or, where the
/// configuration is looked for from a PATH upwards, one that is or was on this way.
pub(super) fn setting_among(files: &[PathBuf], config: &Config, from: Option<&Path>) -> Option<String> {
    let in_use = |setting: &Path| {
        let places = places_of(setting);
        files.iter().any(|file| places.contains(&own_place(file)))
    };
    let file = config.file.as_ref().map(|file| Path::new(&file.path)).filter(|file| in_use(file));
    if let Some(file) = file {
        return Some(format!("the configuration `{}`", file.display()));
    }
    if let Some(baseline) = config.baseline.as_deref().filter(|file| in_use(file)) {
        return Some(format!("the baseline `{}`", baseline.display()));
    }
    let from = canonical(from?)?;
    let on_the_way = |file: &&PathBuf| {
        file.file_name().is_some_and(|name| name == FILE_NAME) && from.starts_with(resolved(folder_of(file)))
    };
    files.iter().find(on_the_way).map(|file| format!("the configuration `{}`", file.display()))
}

/// Where a file is, link by link, with the folders on the way: a submodule or a link is listed by its own name alone.
fn places_of(file: &Path) -> BTreeSet<PathBuf> {
    let mut places = BTreeSet::new();
    let mut open = vec![std::path::absolute(file).unwrap_or_else(|_| file.to_owned())];
    while let Some(path) = open.pop() {
        for step in path.ancestors() {
            if places.insert(own_place(step)) {
                open.extend(link_targets(step));
            }
        }
    }
    places
}

/// The repository that the first PATH lies in.
fn around(first: &Path, option: &str) -> Result<Repository, Failure> {
    let folder = if first.is_dir() { first } else { folder_of(first) };
    Repository::around(folder).map_err(|refusal| {
        let words = refusal.words();
        Failure::Usage(match refusal {
            Refusal::NotStarted(_) => {
                format!("{option}: {words}; install git, or give the changed files with --changed-files FILE")
            }
            Refusal::Said(_) => {
                let folder = folder.display();
                format!(
                    "{option}: `{folder}` is in no git repository ({words}); \
                     give the changed files with --changed-files FILE"
                )
            }
        })
    })
}

fn unknown(repository: &Repository, revision: &str, said: &str) -> Failure {
    let advice = "name a commit, a tag or a branch (`git branch --all` lists those; `git fetch` brings what is new)";
    let shallow = if repository.is_shallow() {
        format!("; if it is one, it lies beyond what this shallow clone holds: {FETCH}")
    } else {
        String::new()
    };
    Failure::Usage(format!("--since: git knows no revision `{revision}`{}; {advice}{shallow}", bracketed(said)))
}

fn unrelated(repository: &Repository, revision: &str, said: &str) -> Failure {
    let advice = if repository.is_shallow() {
        format!("this is a shallow clone: {FETCH}")
    } else {
        "name a revision of the same history".to_owned()
    };
    let said = bracketed(said);
    Failure::Usage(format!("--since: `{revision}` and HEAD have no commit in common{said}; {advice}"))
}

const FETCH: &str = "fetch its history (`git fetch --unshallow`, `fetch-depth: 0` in a workflow)";

fn bracketed(said: &str) -> String {
    if said.is_empty() { String::new() } else { format!(" ({said})") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_lines_or_separated_by_nul() {
        assert_eq!(split(b"a b\r\nc\n\n").collect::<Vec<_>>(), ["a b", "c"]);
        assert_eq!(split(b"a\nb\0c\0").collect::<Vec<_>>(), ["a\nb", "c"]);
    }

    #[test]
    fn quoted_lines_of_git_are_read_as_meant() {
        let names = |text: &[u8]| split(text).collect::<Vec<_>>();
        assert_eq!(names(b"\"d/gr\\303\\274n.target\"\r\nplain\n"), ["d/gr\u{fc}n.target", "plain"]);
        assert_eq!(names(br#""a \"b\" \\ \t""#), ["a \"b\" \\ \t"]);
        assert_eq!(names(br#""a"b""#), [r#""a"b""#]);
        assert_eq!(names(br#""a\9""#), [r#""a\9""#]);
        assert_eq!(names(br#""a\30""#), [r#""a\30""#]);
        assert_eq!(names(b"\"\n"), ["\""]);
        assert_eq!(names(b"\"gr\\303\\274n\"\0"), ["\"gr\\303\\274n\""]);
    }
}
