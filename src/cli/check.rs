//! `mhlint check`: the run and its reports.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::args::{CheckArgs, Command};
use super::compare::compared;
use super::config::settings;
use super::exit::{Exit, Failure};
use super::fix;
use super::output::{Target, refuse_asset, refuse_unwritable, targets, write_file};
use super::panics::Panics;
use super::progress::Progress;
use super::step_summary;
use super::terminal::Terminal;
use super::workspace::placed;
use mhlint_config::Config;
use mhlint_diag::{Baseline, Outcome, TakenOver, Timed, Untouched, grouped, nearest};
use mhlint_engine::{Error, rule_infos};
use mhlint_report::{self as report, Format, View};

pub(super) fn run(
    args: &CheckArgs,
    terminal: Terminal,
    panics: &Panics,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Result<Exit, Failure> {
    let paths = &args.paths_or_here();
    let mut config = settings(args)?;
    let targets = targets(&args.reports, &config)?;
    refuse_without_human(args, &targets)?;
    config.compare = compared(args, paths, err)?;
    let new_baseline = new_baseline(&config)?;
    let progress = Progress::start("reading and evaluating");
    let checked = fix::check(paths, &config, args.fixes, &targets);
    drop(progress);
    let checked = checked.map_err(|error| explained(error, paths, args, &config))?;
    let outcome = &checked.outcome;
    refuse_asset(&targets, paths, &config, outcome)?;
    let exit = exit(outcome, &config, &panics.noted());
    if args.fixes.diff && exit != Exit::CannotWork && !is_empty(outcome) {
        let changes = fix::show(&checked.changes, terminal, out)?;
        out.flush()?;
        fix::tell(&checked, args, err)?;
        if args.timings {
            print_timings(outcome, err)?;
        }
        tell_nothing(outcome, err)?;
        return Ok(match exit {
            _ if changes => Exit::Findings,
            Exit::NothingToCheck => Exit::NothingToCheck,
            _ => Exit::Clean,
        });
    }
    fix::sweep(outcome, args, err)?;
    fix::write(&checked.changes)?;
    if let (Some(file), Some(baseline)) = (new_baseline, &outcome.baseline) {
        write_baseline(file, baseline, outcome.taken_over, exit, args, err)?;
    }
    write_reports(&targets, outcome, args, &config, exit, terminal, out)?;
    tell(outcome, args, &targets, err)?;
    tell_nothing(outcome, err)?;
    fix::tell(&checked, args, err)?;
    if !panics.noted().is_empty() || !outcome.is_whole() {
        writeln!(err, "mhlint: {}", own_fault(&panics.noted()))?;
    }
    if args.timings {
        print_timings(outcome, err)?;
    }
    Ok(exit)
}

/// The baseline to write; refuses before the run what could not be written after it.
fn new_baseline(config: &Config) -> Result<Option<&Path>, Failure> {
    if !config.write_baseline {
        return Ok(None);
    }
    let Some(file) = config.baseline.as_deref() else {
        let remedy = "add `--baseline FILE`, or `baseline = \"FILE\"` to mhlint.toml";
        return Err(Failure::Usage(format!(
            "`--write-baseline` needs a file to write to: {remedy}"
        )));
    };
    refuse_unwritable("the baseline", file)?;
    Ok(Some(file))
}

/// A run that misses findings or looked at nothing must not throw away what is known.
fn write_baseline(
    file: &Path,
    baseline: &Baseline,
    taken_over: Option<TakenOver>,
    exit: Exit,
    args: &CheckArgs,
    err: &mut dyn Write,
) -> Result<(), Failure> {
    if matches!(exit, Exit::CannotWork | Exit::NothingToCheck) {
        return Ok(());
    }
    write_file("the baseline", file, baseline.text().as_bytes())?;
    if !args.quiet {
        let shown = file.display();
        let known = report::count(baseline.entries.len(), "known finding");
        let difference = taken_over.map(difference).unwrap_or_default();
        writeln!(err, "mhlint: {known} written to `{shown}`{difference}")?;
    }
    Ok(())
}

/// `: 1 new (1 error), 11 removed`, and a word where the one may be why of the other.
fn difference(taken_over: TakenOver) -> String {
    let TakenOver { new, errors, gone } = taken_over;
    if (new, gone) == (0, 0) {
        return " (unchanged)".to_owned();
    }
    let of_them = if errors > 0 {
        format!(" ({})", report::count(errors, "error"))
    } else {
        String::new()
    };
    let hidden = if errors > 0 && gone > 0 {
        "; errors can hide findings: fix the new errors, then write the baseline again"
    } else {
        ""
    };
    format!(": {new} new{of_them}, {gone} removed{hidden}")
}

/// A bug of ours outweighs everything, since findings may be missing; then come findings, then what
/// was not checked.
fn exit(outcome: &Outcome, config: &Config, panics: &[String]) -> Exit {
    if !panics.is_empty() || !outcome.is_whole() {
        Exit::CannotWork
    } else if !config.passes(outcome) {
        Exit::Findings
    } else if !outcome.nothing_in.is_empty() {
        Exit::NothingToCheck
    } else {
        Exit::Clean
    }
}

/// Whether there was nothing to check at all: no report would say anything.
fn is_empty(outcome: &Outcome) -> bool {
    outcome.summary.files == 0 && outcome.findings.is_empty() && !outcome.nothing_in.is_empty()
}

/// Refuses what only the report for people can show where there is none.
fn refuse_without_human(args: &CheckArgs, targets: &[Target]) -> Result<(), Failure> {
    let options = [("--full", args.full), ("--statistics", args.statistics)];
    match options.into_iter().find(|(_, is_set)| *is_set) {
        Some((option, _)) if !targets.iter().any(|target| target.format == Format::Human) => {
            Err(Failure::Usage(format!(
                "`{option}` changes the human report, which is not written; add `--report human`, \
                    or leave it out"
            )))
        }
        _ => Ok(()),
    }
}

/// Files first: whoever reads standard output may go away at any time.
fn write_reports(
    targets: &[Target],
    outcome: &Outcome,
    args: &CheckArgs,
    config: &Config,
    exit: Exit,
    terminal: Terminal,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let rules = rule_infos();
    let view = |terminal: Terminal| View {
        pass: exit == Exit::Clean,
        fail_on: config.fail_on,
        max_warnings: config.max_warnings,
        color: terminal.color,
        unicode: terminal.unicode,
        width: terminal.width,
        quiet: args.quiet,
        full: args.full,
        statistics: args.statistics,
        rules: &rules,
    };
    let is_silent = |target: &&Target| is_empty(outcome) && target.format.shows_notes();
    let targets: Vec<&Target> = targets.iter().filter(|target| !is_silent(target)).collect();
    for (target, file) in targets
        .iter()
        .filter_map(|target| Some((target, target.file.as_ref()?)))
    {
        let mut bytes = Vec::new();
        report::write(
            target.format,
            &placed(outcome, target.format),
            &view(Terminal::PLAIN),
            &mut bytes,
        )?;
        write_file("the report", file, &bytes)?;
    }
    if let Some(file) =
        step_summary::file().filter(|_| targets.iter().any(|one| one.format == Format::Github))
    {
        step_summary::append(&file, outcome, &view(Terminal::PLAIN))?;
    }
    for target in targets.iter().filter(|target| target.file.is_none()) {
        let outcome = placed(outcome, target.format);
        let written =
            report::write(target.format, &outcome, &view(terminal), out).and_then(|()| out.flush());
        written.or_else(|error| {
            if error.kind() == ErrorKind::BrokenPipe {
                Ok(())
            } else {
                Err(error)
            }
        })?;
    }
    Ok(())
}

/// Says on standard error what no report on standard output says.
fn tell(
    outcome: &Outcome,
    args: &CheckArgs,
    targets: &[Target],
    err: &mut dyn Write,
) -> Result<(), Failure> {
    let mut lines: Vec<String> = Vec::new();
    if is_empty(outcome)
        || (!args.quiet
            && !targets
                .iter()
                .any(|target| target.file.is_none() && target.format.shows_notes()))
    {
        lines.extend(outcome.notes.iter().map(report::note));
    }
    if is_empty(outcome)
        || (!args.quiet && !targets.iter().any(|target| target.format.shows_unchecked()))
    {
        lines.extend(report::unchecked_line(outcome));
    }
    for line in lines {
        writeln!(err, "mhlint: {}", report::printable(&line))?;
    }
    Ok(())
}

/// Names the PATHs of which nothing was checked, and what could be given instead.
fn tell_nothing(outcome: &Outcome, err: &mut dyn Write) -> Result<(), Failure> {
    let untouched = outcome.nothing_in.iter();
    let by_reason = untouched
        .map(|Untouched { path, what }| (report::why_nothing(outcome, *what), format!("`{path}`")));
    for (why, paths) in grouped(by_reason) {
        let line = format!("nothing was checked in {}: {why}", paths.join(", "));
        writeln!(err, "mhlint: {}", report::printable(&line))?;
    }
    Ok(())
}

/// A path that cannot be read may stand in the configuration; one that looks like a command was
/// meant as one.
fn explained(error: Error, paths: &[PathBuf], args: &CheckArgs, config: &Config) -> Failure {
    if let (Error::Path { path, .. }, Some(file)) = (&error, &config.file)
        && args.systems.is_empty()
        && config
            .systems
            .iter()
            .any(|system| system.to_string_lossy() == path.as_str())
    {
        let line = file.line("system").unwrap_or(1);
        return Failure::Usage(format!("{error}; `system` is set in {}:{line}", file.path));
    }
    if let Error::Path { path, .. } = &error
        && paths
            .first()
            .is_some_and(|first| first.as_os_str() == path.as_str() && !first.exists())
        && let Some(word) = nearest(path, Command::WORDS)
    {
        return Failure::Usage(format!(
            "`{path}` does not exist; did you mean the command `{word}`?"
        ));
    }
    error.into()
}

/// What to say when mhlint itself failed.
pub(super) fn own_fault(panics: &[String]) -> String {
    let mut text =
        "this is a bug in mhlint; please report it with the files (findings may be missing)"
            .to_owned();
    for panic in panics {
        text.push_str("\n  ");
        text.push_str(&report::printable(panic));
    }
    text
}

/// The whole, the steps of the run, then the rules that took long.
fn print_timings(outcome: &Outcome, err: &mut dyn Write) -> Result<(), Failure> {
    const SHORT: Duration = Duration::from_millis(1);
    let mut steps: BTreeMap<&str, Duration> = BTreeMap::new();
    let mut rules: BTreeMap<&str, Duration> = BTreeMap::new();
    for timing in &outcome.timings {
        let (times, what) = match timing.what {
            Timed::Phase(phase) => (&mut steps, report::phase(phase)),
            Timed::Rule(rule) => (&mut rules, rule),
        };
        *times.entry(what).or_default() += timing.time;
    }
    let mut line =
        |what: &str, time: Duration| writeln!(err, "{:>9.3} ms  {what}", time.as_secs_f64() * 1e3);
    line("total", steps.values().sum())?;
    let (long, short): (Vec<_>, Vec<_>) = rules.into_iter().partition(|(_, time)| *time >= SHORT);
    for times in [steps.into_iter().collect(), long] {
        let mut times: Vec<(&str, Duration)> = times;
        times.sort_by_key(|(_, time)| Reverse(*time));
        times
            .into_iter()
            .try_for_each(|(what, time)| line(what, time))?;
    }
    if !short.is_empty() {
        writeln!(
            err,
            "{:>12}  {} below 1 ms",
            "",
            report::count(short.len(), "rule")
        )?;
    }
    Ok(())
}
