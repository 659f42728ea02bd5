//! `mhlint check`: the run and its reports.

use std::io::{ErrorKind, Write};
use std::path::PathBuf;

use super::args::{CheckArgs, Command};
use super::changed::{listed, since};
use super::exit::{Exit, Failure};
use super::output::{Target, targets, write_file};
use super::panics::Panics;
use super::progress::Progress;
use super::step_summary;
use super::terminal::Terminal;
use crate::diag::nearest;
use crate::engine::{Error, Options, Outcome, lint, rule_infos};
use crate::report::{self, Format, View};

pub(super) fn run(
    args: &CheckArgs,
    terminal: Terminal,
    panics: &Panics,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Result<Exit, Failure> {
    let targets = targets(&args.reports)?;
    let here = vec![PathBuf::from(".")];
    let paths = if args.paths.is_empty() { &here } else { &args.paths };
    let mut options = options(args);
    options.changed = changed(args, paths)?;
    let progress = Progress::start("reading and evaluating");
    let outcome = lint(paths, &options);
    drop(progress);
    let outcome = outcome.map_err(|error| mistaken_command(error, paths))?;
    let exit = exit(&outcome, args, &panics.noted());
    write_reports(&targets, &outcome, args, exit, terminal, out)?;
    tell(&outcome, args, exit, &targets, err)?;
    if !panics.noted().is_empty() || !outcome.failed_rules.is_empty() {
        writeln!(err, "mhlint: {}", own_fault(&panics.noted()))?;
    }
    if args.timings {
        print_timings(&outcome, err)?;
    }
    Ok(exit)
}

fn changed(args: &CheckArgs, paths: &[PathBuf]) -> Result<Option<Vec<PathBuf>>, Failure> {
    match (&args.changed_files, &args.since, paths.first()) {
        (Some(file), ..) => listed(file).map(Some),
        (None, Some(revision), Some(first)) => since(revision, first).map(Some),
        _ => Ok(None),
    }
}

fn options(args: &CheckArgs) -> Options {
    Options {
        system: args.system.clone(),
        applications: args.applications.clone(),
        bases: args.bases.clone(),
        only: args.only.clone(),
        skip: args.skip.clone(),
        levels: args.levels.clone(),
        no_eval: args.no_eval,
        samples: args.samples,
        exhaustive: args.exhaustive,
        ..Options::default()
    }
}

/// A bug of ours outweighs everything, since findings may be missing; then comes an empty run.
fn exit(outcome: &Outcome, args: &CheckArgs, panics: &[String]) -> Exit {
    let graded = args.fail_on.level().is_some_and(|level| outcome.has_at_least(level));
    let too_many = args.max_warnings.is_some_and(|limit| outcome.summary.warning > limit);
    if !panics.is_empty() || !outcome.failed_rules.is_empty() {
        Exit::CannotWork
    } else if !outcome.judged_anything() {
        Exit::NothingToCheck
    } else if graded || too_many {
        Exit::Findings
    } else {
        Exit::Clean
    }
}

/// Files first: whoever reads standard output may go away at any time.
fn write_reports(
    targets: &[Target],
    outcome: &Outcome,
    args: &CheckArgs,
    exit: Exit,
    terminal: Terminal,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let rules = rule_infos();
    let view = |terminal: Terminal| View {
        pass: exit == Exit::Clean,
        fail_on: args.fail_on.level(),
        max_warnings: args.max_warnings,
        color: terminal.color,
        unicode: terminal.unicode,
        width: terminal.width,
        quiet: args.quiet,
        rules: &rules,
    };
    let is_silent = |target: &&Target| exit == Exit::NothingToCheck && target.format.shows_notes();
    let targets: Vec<&Target> = targets.iter().filter(|target| !is_silent(target)).collect();
    for (target, file) in targets.iter().filter_map(|target| Some((target, target.file.as_ref()?))) {
        let mut bytes = Vec::new();
        report::write(target.format, outcome, &view(Terminal::PLAIN), &mut bytes)?;
        write_file(file, &bytes)?;
    }
    if let Some(file) = step_summary::file().filter(|_| targets.iter().any(|one| one.format == Format::Github)) {
        step_summary::append(&file, outcome, &view(Terminal::PLAIN))?;
    }
    for target in targets.iter().filter(|target| target.file.is_none()) {
        let written = report::write(target.format, outcome, &view(terminal), out).and_then(|()| out.flush());
        written.or_else(|error| if error.kind() == ErrorKind::BrokenPipe { Ok(()) } else { Err(error) })?;
    }
    Ok(())
}

/// Says on standard error what no report on standard output says.
fn tell(
    outcome: &Outcome,
    args: &CheckArgs,
    exit: Exit,
    targets: &[Target],
    err: &mut dyn Write,
) -> Result<(), Failure> {
    let reported = |target: &Target| target.format.shows_notes() && target.file.is_none();
    let nothing = exit == Exit::NothingToCheck;
    if nothing || (!args.quiet && !targets.iter().any(reported)) {
        for note in &outcome.notes {
            writeln!(err, "mhlint: {}", report::printable(note))?;
        }
    }
    if nothing {
        let remedy = "give the folder that holds `base/`, `target/`, `contarget/` or `rigs/`";
        writeln!(err, "mhlint: nothing to check: no data of MakeHuman 2 were found; {remedy}")?;
    }
    Ok(())
}

/// A path that does not exist and looks like a command was meant as one.
fn mistaken_command(error: Error, paths: &[PathBuf]) -> Failure {
    if let Error::Path { path, .. } = &error
        && paths.first().is_some_and(|first| first.as_os_str() == path.as_str() && !first.exists())
        && let Some(word) = nearest(path, Command::WORDS)
    {
        return Failure::Usage(format!("there is no file or folder `{path}`; did you mean the command `{word}`?"));
    }
    Failure::Run(error)
}

/// What to say when mhlint itself failed.
pub(super) fn own_fault(panics: &[String]) -> String {
    let mut text = "this is a bug of mhlint, please report it with the files; findings may be missing".to_owned();
    for panic in panics {
        text.push_str("\n  ");
        text.push_str(&report::printable(panic));
    }
    text
}

fn print_timings(outcome: &Outcome, err: &mut dyn Write) -> Result<(), Failure> {
    for timing in &outcome.timings {
        writeln!(err, "{:>9.3} ms  {}", timing.time.as_secs_f64() * 1e3, timing.what)?;
    }
    Ok(())
}
