//! The arguments.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};

use super::eval::EvalCommand;
use crate::diag::{Application, Level};

/// Judges asset repositories of the MakeHuman family before an application meets them.
#[derive(Debug, Parser)]
#[command(name = "mhlint", version, args_conflicts_with_subcommands = true)]
pub(super) struct Args {
    #[command(subcommand)]
    pub(super) command: Option<Command>,
    #[command(flatten)]
    pub(super) check: CheckArgs,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Judge data roots (the default).
    Check(CheckArgs),
    /// Compute what the application would show.
    #[command(subcommand)]
    Eval(EvalCommand),
}

/// Arguments of `check`.
#[derive(Debug, clap::Args)]
pub(super) struct CheckArgs {
    /// Folders or files; the current directory if none is given.
    #[arg(value_name = "PATH")]
    pub(super) paths: Vec<PathBuf>,
    /// MakeHuman's own data: read to resolve references, not reported.
    #[arg(long, value_name = "DIR")]
    pub(super) system: Option<PathBuf>,
    /// Judge only what this application loads; repeatable.
    #[arg(long = "app", value_name = "APPLICATION", value_parser = application)]
    pub(super) applications: Vec<Application>,
    /// Report only this base mesh; repeatable.
    #[arg(long = "base", value_name = "NAME")]
    pub(super) bases: Vec<String>,
    /// Run only rules that fit the glob; repeatable.
    #[arg(long, value_name = "GLOB")]
    pub(super) only: Vec<String>,
    /// Leave out rules that fit the glob; repeatable.
    #[arg(long, value_name = "GLOB")]
    pub(super) skip: Vec<String>,
    /// Report a rule (or glob) at another level: error, warning, info or off; repeatable.
    #[arg(long = "level", value_name = "RULE=LEVEL", value_parser = level_setting)]
    pub(super) levels: Vec<(String, Option<Level>)>,
    /// The level from which on findings make the exit code 1.
    #[arg(long, value_name = "LEVEL", default_value = "error")]
    pub(super) fail_on: FailOn,
    /// Format of the report, and a file to write it to instead of standard output; repeatable.
    #[arg(long = "report", value_name = "FORMAT[=FILE]")]
    pub(super) reports: Vec<String>,
    /// Print time per phase and rule to standard error.
    #[arg(long)]
    pub(super) timings: bool,
    /// Leave out everything but findings and verdict.
    #[arg(long, short)]
    pub(super) quiet: bool,
}

/// `--fail-on`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum FailOn {
    /// Errors only.
    Error,
    /// Warnings and errors.
    Warning,
    /// Anything.
    Info,
    /// Nothing.
    Never,
}

impl FailOn {
    pub(super) const fn level(self) -> Option<Level> {
        match self {
            Self::Error => Some(Level::Error),
            Self::Warning => Some(Level::Warning),
            Self::Info => Some(Level::Info),
            Self::Never => None,
        }
    }
}

fn application(text: &str) -> Result<Application, String> {
    let all = [Application::Makehuman2, Application::Makehuman1, Application::Mpfb];
    let found = all.into_iter().find(|application| application.word() == text);
    found.ok_or_else(|| "one of makehuman2, makehuman1, mpfb is wanted".to_owned())
}

fn level_setting(text: &str) -> Result<(String, Option<Level>), String> {
    let (rule, level) = text.split_once('=').ok_or("RULE=LEVEL is wanted, `target-zero-delta=off` say")?;
    let level = match level {
        "error" => Some(Level::Error),
        "warning" => Some(Level::Warning),
        "info" => Some(Level::Info),
        "off" => None,
        _ => return Err("the level is one of error, warning, info, off".to_owned()),
    };
    Ok((rule.to_owned(), level))
}
