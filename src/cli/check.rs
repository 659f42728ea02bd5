//! `mhlint check`: the run and its reports.

use std::io::Write;
use std::path::PathBuf;

use super::args::CheckArgs;
use super::exit::{Exit, Failure};
use crate::engine::{Options, Outcome, lint};
use crate::report::{self, Format, View};

pub(super) fn run(args: &CheckArgs, out: &mut dyn Write, err: &mut dyn Write) -> Result<Exit, Failure> {
    let here = vec![PathBuf::from(".")];
    let paths = if args.paths.is_empty() { &here } else { &args.paths };
    let outcome = lint(paths, &options(args))?;
    for note in &outcome.notes {
        writeln!(err, "mhlint: {note}")?;
    }
    let failing = args.fail_on.level().is_some_and(|level| outcome.has_at_least(level));
    let view = View { pass: !failing, color: false, quiet: args.quiet, rules: &[] };
    let format = if args.reports.iter().any(|report| report == "json") { Format::Json } else { Format::Concise };
    report::write(format, &outcome, &view, out)?;
    if args.timings {
        print_timings(&outcome, err)?;
    }
    Ok(if !outcome.judged_anything() {
        Exit::NothingToCheck
    } else if failing {
        Exit::Findings
    } else {
        Exit::Clean
    })
}

fn options(args: &CheckArgs) -> Options {
    Options {
        system: args.system.clone(),
        applications: args.applications.clone(),
        bases: args.bases.clone(),
        only: args.only.clone(),
        skip: args.skip.clone(),
        levels: args.levels.clone(),
        ..Options::default()
    }
}

fn print_timings(outcome: &Outcome, err: &mut dyn Write) -> Result<(), Failure> {
    for timing in &outcome.timings {
        writeln!(err, "{:>9.3} ms  {}", timing.time.as_secs_f64() * 1e3, timing.what)?;
    }
    Ok(())
}
