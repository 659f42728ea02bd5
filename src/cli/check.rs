//! `mhlint check`: the run and its reports.

use std::io::Write;
use std::path::PathBuf;

use super::args::{CheckArgs, Command};
use super::exit::{Exit, Failure};
use super::fix;
use super::output::{Target, targets, write_file};
use super::panics::Panics;
use super::progress::Progress;
use super::terminal::Terminal;
use crate::diag::nearest;
use crate::engine::{Error, Options, Outcome, rule_infos};
use crate::report::{self, View};

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
    let progress = Progress::start("reading and evaluating");
    let checked = fix::check(paths, &options(args), args.fixes);
    drop(progress);
    let checked = checked.map_err(|error| mistaken_command(error, paths))?;
    let outcome = &checked.outcome;
    let exit = exit(outcome, args, &panics.noted());
    if args.fixes.diff && !matches!(exit, Exit::CannotWork | Exit::NothingToCheck) {
        let changes = checked.show(terminal, out)?;
        out.flush()?;
        checked.tell(args.fixes, err)?;
        return Ok(if changes { Exit::Findings } else { Exit::Clean });
    }
    checked.write()?;
    for target in &targets {
        write_report(target, outcome, args, exit, terminal, out)?;
    }
    out.flush()?;
    tell(outcome, args, exit, &targets, err)?;
    checked.tell(args.fixes, err)?;
    if !panics.noted().is_empty() || !outcome.failed_rules.is_empty() {
        writeln!(err, "mhlint: {}", own_fault(&panics.noted()))?;
    }
    if args.timings {
        print_timings(outcome, err)?;
    }
    Ok(exit)
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

fn write_report(
    target: &Target,
    outcome: &Outcome,
    args: &CheckArgs,
    exit: Exit,
    terminal: Terminal,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    if exit == Exit::NothingToCheck && target.format.shows_notes() {
        return Ok(());
    }
    let terminal = if target.file.is_some() { Terminal::PLAIN } else { terminal };
    let rules = rule_infos();
    let view = View {
        pass: exit == Exit::Clean,
        fail_on: args.fail_on.level(),
        max_warnings: args.max_warnings,
        color: terminal.color,
        unicode: terminal.unicode,
        width: terminal.width,
        quiet: args.quiet,
        rules: &rules,
    };
    match &target.file {
        None => Ok(report::write(target.format, outcome, &view, out)?),
        Some(file) => {
            let mut bytes = Vec::new();
            report::write(target.format, outcome, &view, &mut bytes)?;
            write_file(file, &bytes)
        }
    }
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
