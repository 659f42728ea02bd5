//! The command line: arguments, streams, exit codes. No logic that a library user would miss.

#![expect(
    clippy::disallowed_methods,
    reason = "a command has files of its own, streams, and surroundings"
)]

mod args;
mod check;
mod compare;
mod config;
mod eval;
mod exit;
mod explain;
mod fix;
mod git;
mod harmless;
mod init;
mod list;
mod one_of;
mod output;
mod panics;
mod patch;
mod progress;
mod recorded;
mod schema;
mod shell;
mod step_summary;
mod terminal;
mod watch;
mod workspace;

use std::io::{self, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::Parser;

use args::{Args, Command};
use exit::{Exit, Failure};
use harmless::Harmless;
use mhlint_report::Paint;
use panics::Panics;
use terminal::Terminal;

/// Runs the command and gives the exit code.
pub fn main() -> ExitCode {
    let args = Args::try_parse().unwrap_or_else(|error| args::refuse(error));
    let panics = Panics::watch();
    let mut err = Harmless::stderr();
    let ended = catch_unwind(AssertUnwindSafe(|| run(&args, &panics, &mut err)));
    let result = match ended {
        Ok(Ok(exit)) => Ok(exit),
        Ok(Err(failure)) if failure.is_closed_pipe() => Ok(Exit::Clean),
        Ok(Err(failure)) => Err(failure.to_string()),
        Err(_) => Err(check::own_fault(&panics.noted())),
    };
    result
        .unwrap_or_else(|text| {
            // Nothing is left to do when standard error is closed as well.
            let _ = writeln!(err, "mhlint: {text}");
            Exit::CannotWork
        })
        .code()
}

fn run(args: &Args, panics: &Panics, err: &mut dyn Write) -> Result<Exit, Failure> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    let terminal = Terminal::of_stdout(args.color);
    let paint = Paint {
        color: terminal.color,
    };
    let exit = match &args.command {
        None => check::run(&args.check, terminal, panics, &mut out, err)?,
        Some(Command::Check(check)) => check::run(check, terminal, panics, &mut out, err)?,
        Some(Command::Config(check)) => config::run(check, &mut out)?,
        Some(Command::Eval(command)) => eval::run(command, &mut out, err)?,
        Some(Command::Explain { rule, format }) => explain::run(
            rule,
            *format,
            explain::Page {
                paint,
                width: terminal.width,
            },
            &mut out,
        )?,
        Some(Command::Init { folder }) => init::run(folder.as_deref(), &mut out, err)?,
        Some(Command::Rules { format }) => list::run(*format, paint, &mut out)?,
        Some(Command::Schema { name }) => schema::run(name.as_deref(), &mut out)?,
        Some(Command::Completions { shell }) => shell::write_completions(*shell, &mut out)?,
        Some(Command::Man { words }) => shell::write_man_page(words, &mut out)?,
    };
    match out.flush() {
        // Who stopped reading has seen enough, and the exit code still tells.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(exit),
    }
}
