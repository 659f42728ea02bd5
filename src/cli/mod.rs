//! The command line: arguments, streams, exit codes. No logic that a library user would miss.

mod args;
mod check;
mod eval;
mod exit;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

use args::{Args, Command};
use exit::Exit;

/// Runs the command and gives the exit code.
pub fn main() -> ExitCode {
    let args = Args::parse();
    let mut out = io::BufWriter::new(io::stdout().lock());
    let mut err = io::stderr().lock();
    let result = match &args.command {
        Some(Command::Check(check)) => check::run(check, &mut out, &mut err),
        Some(Command::Eval(command)) => eval::run(command, &mut out, &mut err),
        None => check::run(&args.check, &mut out, &mut err),
    };
    let exit = result.and_then(|exit| out.flush().map(|()| exit).map_err(exit::Failure::from));
    match exit {
        Ok(exit) => exit.code(),
        Err(failure) if failure.is_closed_pipe() => Exit::Clean.code(),
        Err(failure) => {
            // Nothing is left to do when standard error is closed as well.
            let _ = writeln!(err, "mhlint: {failure}");
            Exit::CannotWork.code()
        }
    }
}
