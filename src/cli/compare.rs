//! `--since`, `--staged` and `--against`: what the data are compared with.

use std::io::Write;
use std::path::{Path, PathBuf};

use super::args::CheckArgs;
use super::exit::Failure;
use super::git::{Record, Refusal, Repository};
use super::recorded::Recorded;
use mhlint_config::{Before, Compare};
use mhlint_engine::is_pack;
use mhlint_report::printable;
use mhlint_source::{Contents, folder_of, resolved};

/// What to compare with, if anything. Says on standard error why there is nothing although it was
/// asked for.
pub(super) fn compared(
    args: &CheckArgs,
    paths: &[PathBuf],
    err: &mut dyn Write,
) -> Result<Option<Compare>, Failure> {
    if let Some(folder) = &args.against {
        return against(folder, paths).map(Some);
    }
    if let Some(revision) = &args.since {
        return since(revision, &around_all(paths, "--since")?).map(Some);
    }
    if !args.staged {
        return Ok(None);
    }
    let found = staged(&around_all(paths, "--staged")?)?;
    if let (Err(reason), false) = (&found, args.quiet) {
        writeln!(err, "mhlint: {}; reporting all findings", printable(reason))?;
    }
    Ok(found.ok())
}

fn against(folder: &Path, paths: &[PathBuf]) -> Result<Compare, Failure> {
    let shown = folder.display();
    if paths.len() > 1 {
        let text =
            format!("`--against` compares one PATH with `{shown}`; run mhlint once for each PATH");
        return Err(Failure::Usage(text));
    }
    if !folder.exists() {
        return Err(Failure::Usage(format!(
            "`--against`: `{shown}` does not exist; use an existing folder or zip"
        )));
    }
    Ok(Compare {
        with: folder.to_string_lossy().into_owned(),
        before: Before::Folder(folder.to_owned()),
        now: Contents::new(),
        missing: Vec::new(),
    })
}

/// The working tree beside the commit where it left `revision`.
fn since(revision: &str, repository: &Repository) -> Result<Compare, Failure> {
    if revision.starts_with('-') {
        return Err(unknown(repository, revision, ""));
    }
    let commit = format!("{revision}^{{commit}}");
    let known = repository.ask(&["rev-parse", "--verify", "--quiet", &commit]);
    known.map_err(|refusal| unknown(repository, revision, &refusal.words()))?;
    let start = repository.ask(&["merge-base", revision, "HEAD"]);
    let start = start.map_err(|refusal| unrelated(repository, revision, &refusal.words()))?;
    let start = String::from_utf8_lossy(&start).trim().to_owned();
    let before = Recorded::of(repository, Record::Commit(&start), false);
    let before = before.map_err(|refusal| failed(&format!("--since {revision}"), &refusal))?;
    let missing = before.missing.into_iter().collect();
    Ok(Compare {
        with: revision.to_owned(),
        before: Before::Contents(before.contents),
        now: Contents::new(),
        missing,
    })
}

/// The index beside the last commit; or why that makes no comparison.
fn staged(repository: &Repository) -> Result<Result<Compare, &'static str>, Failure> {
    let failed = |refusal: Refusal| failed("--staged", &refusal);
    let unmerged = repository
        .files(&["diff", "--name-only", "--diff-filter=U", "-z"])
        .map_err(failed)?;
    if let Some(first) = unmerged.first() {
        let shown = first.display();
        let text = format!(
            "`--staged`: `{shown}` has unresolved merge conflicts; resolve them and `git add` the \
                file"
        );
        return Err(Failure::Usage(text));
    }
    if repository
        .ask(&["rev-parse", "--verify", "--quiet", "HEAD^{commit}"])
        .is_err()
    {
        return Ok(Err("the repository has no commits yet"));
    }
    if repository
        .ask(&["diff", "--cached", "--name-only", "-z"])
        .map_err(failed)?
        .is_empty()
    {
        return Ok(Err("nothing is staged"));
    }
    let before = Recorded::of(repository, Record::Commit("HEAD"), true).map_err(failed)?;
    let now = Recorded::of(repository, Record::Index, true).map_err(failed)?;
    let missing = before.missing.union(&now.missing).cloned().collect();
    Ok(Ok(Compare {
        with: "HEAD".to_owned(),
        before: Before::Contents(before.contents),
        now: now.contents,
        missing,
    }))
}

/// The one repository that all PATHs lie in.
fn around_all(paths: &[PathBuf], option: &str) -> Result<Repository, Failure> {
    if let Some(pack) = paths.iter().find(|path| is_pack(path)) {
        let pack = pack.display();
        let text = format!(
            "`{option}` compares files that git knows, and `{pack}` is a zip; use `--against \
                OLD.zip`"
        );
        return Err(Failure::Usage(text));
    }
    let first = paths.first().map_or(Path::new("."), PathBuf::as_path);
    let repository = around(first, option)?;
    for path in paths.iter().skip(1) {
        if around(path, option)?.top() != repository.top() {
            let (first, path) = (first.display(), path.display());
            let text = format!(
                "`{option}`: `{path}` and `{first}` are in different repositories; run mhlint \
                    once for each"
            );
            return Err(Failure::Usage(text));
        }
    }
    Ok(repository)
}

/// The repository that a PATH lies in; of a submodule the one around it, unless the run begins
/// inside of it.
fn around(first: &Path, option: &str) -> Result<Repository, Failure> {
    let folder = if first.is_dir() {
        first
    } else {
        folder_of(first)
    };
    let here = resolved(Path::new("."));
    let outermost = |mut repository: Repository| {
        while let Some(outer) = repository
            .superproject()
            .filter(|_| !here.starts_with(resolved(repository.top())))
        {
            repository = outer;
        }
        repository
    };
    Repository::around(folder)
        .map(outermost)
        .map_err(|refusal| {
            let (words, shown) = (refusal.words(), folder.display());
            let remedy = "compare with a folder (`--against FOLDER`)";
            Failure::Usage(match refusal {
                Refusal::Said(_) => {
                    format!("`{option}`: `{shown}` is not in a git repository ({words}); {remedy}")
                }
                Refusal::NotStarted(_) | Refusal::NoFolder(_) => {
                    format!("`{option}`: {words}; install git, or {remedy}")
                }
            })
        })
}

fn failed(option: &str, refusal: &Refusal) -> Failure {
    Failure::Usage(format!("`{option}`: git failed: {}", refusal.words()))
}

fn unknown(repository: &Repository, revision: &str, said: &str) -> Failure {
    let advice = "use a commit, a tag or a branch (`git branch --all` lists branches; `git fetch` \
        downloads new ones)";
    let shallow = if repository.is_shallow() {
        format!("; this is a shallow clone, which may lack it: {FETCH}")
    } else {
        String::new()
    };
    Failure::Usage(format!(
        "`--since`: unknown revision `{revision}`{}; {advice}{shallow}",
        bracketed(said)
    ))
}

fn unrelated(repository: &Repository, revision: &str, said: &str) -> Failure {
    let advice = if repository.is_shallow() {
        format!("this is a shallow clone: {FETCH}")
    } else {
        "use a revision of the same history".to_owned()
    };
    let said = bracketed(said);
    Failure::Usage(format!(
        "`--since`: `{revision}` and `HEAD` have no commit in common{said}; {advice}"
    ))
}

const FETCH: &str =
    "fetch the full history (`git fetch --unshallow`, or `fetch-depth: 0` in a workflow)";

fn bracketed(said: &str) -> String {
    if said.is_empty() {
        String::new()
    } else {
        format!(" ({said})")
    }
}
