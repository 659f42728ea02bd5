//! `--fix` and `--diff`: what can be fixed is fixed on disk, or shown.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};

use super::args::CheckArgs;
use super::exit::Failure;
use super::output::Target;
use super::patch::{Names, names};
use super::terminal::Terminal;
use super::watch::Watch;
use mhlint_config::Config;
use mhlint_diag::Outcome;
use mhlint_engine::{self as engine, Fixed, fixable};
use mhlint_fix::{FileChange, Left, Pending, unified, unpack, write_all};
use mhlint_report::{Paint, count, printable};
use mhlint_source::{Limits, depth};

/// Options of `check` that fix.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub(super) struct FixArgs {
    /// Apply the safe fixes, then report the remaining findings.
    #[arg(long, group = "fixing", help_heading = "Fixes")]
    fix: bool,
    /// Show what --fix would change as a diff, and write nothing.
    ///
    /// The exit code is 1 if anything would change.
    #[arg(
        long,
        group = "fixing",
        conflicts_with = "reports",
        help_heading = "Fixes"
    )]
    pub(super) diff: bool,
    /// Include unsafe fixes in --fix or --diff.
    ///
    /// An unsafe fix may change more than the fault. Check the result with --diff first.
    #[arg(long, requires = "fixing", help_heading = "Fixes")]
    unsafe_fixes: bool,
}

/// Checks, and fixes if that was asked for; with `--diff` in memory only. Some reports say what
/// fixes replace.
pub(super) fn check(
    paths: &[PathBuf],
    options: &Config,
    args: FixArgs,
    targets: &[Target],
) -> Result<Fixed, engine::Error> {
    if args.fix || args.diff {
        return engine::lint_and_fix(paths, options, args.unsafe_fixes);
    }
    let with_replacements = targets
        .iter()
        .any(|target| target.format.shows_replacements());
    let lint = if with_replacements {
        engine::lint_with_replacements
    } else {
        engine::lint
    };
    Ok(Fixed {
        outcome: lint(paths, options)?,
        ..Fixed::default()
    })
}

/// Brings the changes to disk. Who ends the run meanwhile finds nothing of it beside the data.
pub(super) fn write(changes: &[FileChange]) -> Result<(), Failure> {
    if changes.is_empty() {
        return Ok(());
    }
    let pending = Pending::default();
    let _watch = Watch::over(&pending);
    write_all(changes, &pending).map_err(|error| Failure::Usage(printable(&error.to_string())))
}

/// Says what runs left beside the data that were ended while they fixed; one that fixes removes it.
pub(super) fn sweep(
    outcome: &Outcome,
    asked: &CheckArgs,
    err: &mut dyn Write,
) -> Result<(), Failure> {
    for left in outcome
        .journals
        .iter()
        .filter_map(|journal| Left::by(journal))
    {
        let files = count(left.count(), "hidden file");
        let folder = left.folder().display();
        let told = match asked.fixes.fix.then(|| left.remove()) {
            Some(Err(error)) => {
                format!(
                    "a `--fix` that was interrupted left {files} in `{folder}`, which cannot be \
                        removed: {error}"
                )
            }
            _ if asked.quiet => continue,
            Some(Ok(())) => {
                format!("{files} of a `--fix` that was interrupted removed from `{folder}`")
            }
            None => format!(
                "a `--fix` that was interrupted left {files} in `{folder}`; the next `--fix` \
                    removes them"
            ),
        };
        writeln!(err, "mhlint: {}", printable(&told))?;
    }
    Ok(())
}

/// Shows the changes. Gives whether there are any.
pub(super) fn show(
    changes: &[FileChange],
    terminal: Terminal,
    out: &mut dyn Write,
) -> Result<bool, Failure> {
    let names = names_of(changes).names;
    let (empty, others): (Vec<_>, Vec<_>) = changes
        .iter()
        .zip(names)
        .partition(|(change, _)| change.before.is_empty());
    // In a patch, empty files that go come last.
    for (change, name) in others.into_iter().chain(empty) {
        let text = |stored: &[u8]| unpack(stored, &Limits::default()).unwrap_or_default();
        let after = change.after.as_deref().map(text);
        let diff = unified(
            &exact(&name, &change.file),
            &text(&change.before),
            after.as_deref(),
        );
        if std::io::stdout().is_terminal() {
            write_painted(
                &diff,
                Paint {
                    color: terminal.color,
                },
                out,
            )?;
        } else {
            out.write_all(&diff)?;
        }
    }
    Ok(!changes.is_empty())
}

/// A name in a patch to the byte: those of reports are Unicode, those of files need not be.
fn exact(name: &str, file: &Path) -> Vec<u8> {
    let parts: Vec<&OsStr> = file.iter().rev().take(depth(name)).collect();
    let path: PathBuf = parts.into_iter().rev().collect();
    if path.to_string_lossy() == name {
        path.into_os_string().into_encoded_bytes()
    } else {
        name.as_bytes().to_vec()
    }
}

/// What the changed files are called in a patch.
fn names_of(changes: &[FileChange]) -> Names {
    names(
        &changes
            .iter()
            .map(|change| change.path.as_str())
            .collect::<Vec<_>>(),
    )
}

/// What was fixed and what else could be, for standard error.
pub(super) fn tell(all: &Fixed, asked: &CheckArgs, err: &mut dyn Write) -> Result<(), Failure> {
    let args = asked.fixes;
    if asked.quiet || !args.fix && !args.diff {
        return Ok(());
    }
    if let Some(above) = names_of(&all.changes).above.filter(|_| args.diff) {
        writeln!(
            err,
            "mhlint: the patch is for the folder `{above}`; run `git apply` or `patch -p1` there"
        )?;
    }
    let files = count(all.changes.len(), "file");
    let done = if args.fix { "fixed" } else { "would be fixed" };
    match all.fixed.len() {
        0 => writeln!(err, "mhlint: nothing {done}")?,
        number => writeln!(
            err,
            "mhlint: {number} {done} in {files}: {}",
            by_rule(&all.fixed)
        )?,
    }
    if all.outside > 0 {
        let more = count(all.outside, "fixable finding");
        let whole = asked.comparing().map_or_else(String::new, |option| {
            format!("; to fix all, run without `{option}`")
        });
        writeln!(
            err,
            "mhlint: {more} not fixed: the fix is for files that have not changed{whole}"
        )?;
    }
    if !all.unstaged.is_empty() {
        let files = printable(&all.unstaged.join("`, `"));
        writeln!(
            err,
            "mhlint: not fixed, because the files differ from their staged versions: `{files}`"
        )?;
    }
    if all.left_out > 0 {
        let more = count(all.left_out, "fixable finding");
        writeln!(
            err,
            "mhlint: {more} not fixed: the fix is for files that are ignored or outside the PATHs"
        )?;
    }
    let (_, risky) = fixable(&all.outcome.findings);
    if risky > 0 && !args.unsafe_fixes {
        writeln!(
            err,
            "mhlint: {risky} more can be fixed with `--unsafe-fixes`; check `--diff \
                --unsafe-fixes` first"
        )?;
    }
    Ok(())
}

/// `target-zero-delta (1), weights-not-normalized (2)`.
fn by_rule(fixed: &[&'static str]) -> String {
    let mut rules: BTreeMap<&str, usize> = BTreeMap::new();
    fixed
        .iter()
        .for_each(|rule| *rules.entry(rule).or_default() += 1);
    rules
        .iter()
        .map(|(rule, number)| format!("{rule} ({number})"))
        .collect::<Vec<_>>()
        .join(", ")
}

/// A diff for a person: in colour, and with nothing in it that could steer the terminal.
fn write_painted(diff: &[u8], paint: Paint, out: &mut dyn Write) -> Result<(), Failure> {
    for line in String::from_utf8_lossy(diff).lines() {
        let line = printable(&line.replace('\t', "    "));
        let painted = match line.as_bytes().first() {
            Some(b'-') => paint.bad(&line),
            Some(b'+') => paint.good(&line),
            Some(b'@') => paint.hint(&line),
            _ => line,
        };
        writeln!(out, "{painted}")?;
    }
    Ok(())
}
