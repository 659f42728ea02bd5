//! The arguments and their help.

use std::path::PathBuf;

use clap::error::{ContextKind, ErrorKind};
use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use super::eval::EvalCommand;
use super::fix::FixArgs;
use super::one_of::not_one_of;
use super::output::Target;
use crate::config::MOST_SAMPLES;
use crate::diag::{Application, Level};

const AFTER_HELP: &str = "\
Exit codes: 0 nothing at or above --fail-on, 1 findings, 2 could not work, 3 nothing was checked of a PATH.

Examples:
  mhlint data/                                     judge a data folder
  mhlint my-pack/ --system makehuman2/data         judge a pack against MakeHuman's own data
  mhlint data/ --report human --report json=r.json read it here, keep it for a program
  mhlint data/ --diff                              what --fix would change
  mhlint explain macro-steps-length                what a finding means, with an example";

const COMPLETIONS_HELP: &str = "\
Where they go:
  bash  mhlint completions bash > ~/.local/share/bash-completion/completions/mhlint
  zsh   mhlint completions zsh > a folder of $fpath, as _mhlint
  fish  mhlint completions fish > ~/.config/fish/completions/mhlint.fish
  PowerShell and Elvish: add the script to your profile";

/// Judges asset repositories of the MakeHuman family before an application meets them.
#[derive(Debug, Parser)]
#[command(name = "mhlint", version, args_conflicts_with_subcommands = true, after_help = AFTER_HELP)]
pub(super) struct Args {
    #[command(subcommand)]
    pub(super) command: Option<Command>,
    #[command(flatten)]
    pub(super) check: CheckArgs,
    /// Colour in what is printed.
    #[arg(long, value_name = "WHEN", default_value = "auto", global = true)]
    pub(super) color: ColorChoice,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Judge data roots (what happens without a command).
    #[command(after_help = AFTER_HELP)]
    Check(CheckArgs),
    /// Show the settings in force and where each comes from.
    Config(CheckArgs),
    /// Compute what the application would show.
    #[command(subcommand)]
    Eval(EvalCommand),
    /// Say what a rule means: consequence, remedy, a bad and a good example.
    Explain {
        /// A rule, or the start of its name to list a family.
        rule: String,
        /// How; as Markdown a family is not listed but explained, rule by rule.
        #[arg(long, value_name = "FORMAT", default_value = "text")]
        format: ExplainFormat,
    },
    /// Write a commented mhlint.toml; overwrites nothing.
    Init {
        /// Where to; the current directory if none is given.
        #[arg(value_name = "FOLDER")]
        folder: Option<PathBuf>,
    },
    /// List all rules.
    Rules {
        /// How.
        #[arg(long, value_name = "FORMAT", default_value = "table")]
        format: ListFormat,
    },
    /// Print an embedded JSON Schema, or the names of all.
    Schema {
        /// Which one.
        name: Option<String>,
    },
    /// Print a completion script for a shell.
    #[command(after_help = COMPLETIONS_HELP)]
    Completions {
        /// Which shell.
        shell: Shell,
    },
    /// Print a man page: of mhlint, or of one of its commands.
    Man {
        /// The command, `eval mesh` say.
        #[arg(value_name = "COMMAND")]
        words: Vec<String>,
    },
}

impl Command {
    /// The words for the commands, to find slips of the pen.
    pub(super) const WORDS: [&'static str; 10] =
        ["check", "config", "eval", "explain", "init", "rules", "schema", "completions", "man", "help"];
}

/// Arguments of `check`.
#[derive(Debug, clap::Args)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of the command line")]
pub(super) struct CheckArgs {
    /// Folders or files; the current directory if none is given.
    #[arg(value_name = "PATH")]
    pub(super) paths: Vec<PathBuf>,
    /// MakeHuman's own data: read to resolve references, not reported.
    #[arg(long, value_name = "DIR")]
    pub(super) system: Option<PathBuf>,
    /// Judge only what this application loads: makehuman2, makehuman1, mpfb; repeatable.
    #[arg(long = "app", value_name = "APPLICATION", value_parser = application)]
    pub(super) applications: Vec<Application>,
    /// Report only this base mesh; repeatable.
    #[arg(long = "base", value_name = "NAME")]
    pub(super) bases: Vec<String>,
    /// Leave out everything that needs evaluation.
    #[arg(long)]
    pub(super) no_eval: bool,
    /// Random slider settings to look at besides the deliberate ones, at most 100000.
    #[arg(long, value_name = "N", conflicts_with = "no_eval", value_parser = samples)]
    pub(super) samples: Option<usize>,
    /// Look at every corner of the slider space.
    #[arg(long, conflicts_with = "no_eval")]
    pub(super) exhaustive: bool,
    /// Run only rules that fit the glob; repeatable.
    #[arg(long, value_name = "GLOB")]
    pub(super) only: Vec<String>,
    /// Leave out rules that fit the glob; repeatable.
    #[arg(long, value_name = "GLOB")]
    pub(super) skip: Vec<String>,
    /// Report a rule (or glob) at another level: error, warning, info or off; repeatable.
    #[arg(long = "level", value_name = "RULE=LEVEL", value_parser = level_setting)]
    pub(super) levels: Vec<(String, Option<Level>)>,
    /// The level from which on findings make the exit code 1; error unless set.
    #[arg(long, value_name = "LEVEL")]
    pub(super) fail_on: Option<FailOn>,
    /// Make the exit code 1 when there are more warnings than this.
    #[arg(long, value_name = "N")]
    pub(super) max_warnings: Option<usize>,
    /// Hide the findings that this file knows.
    #[arg(long, value_name = "FILE")]
    pub(super) baseline: Option<PathBuf>,
    /// Write what is found now to the baseline, without what is found no more.
    #[arg(long, conflicts_with_all = ["fixing", "staged", "since", "against"])]
    pub(super) write_baseline: bool,
    /// Configuration; the nearest mhlint.toml at or above the first PATH if none is given.
    #[arg(long, value_name = "FILE")]
    pub(super) config: Option<PathBuf>,
    /// Report as human, concise, json, sarif, github, gitlab, junit, markdown or html; to a file instead of
    /// standard output; repeatable.
    #[arg(long = "report", value_name = "FORMAT[=FILE]", value_parser = Target::parse)]
    pub(super) reports: Vec<Target>,
    /// Show every finding with its consequences and help, infos too, and leave none out of a long list.
    #[arg(long, conflicts_with = "statistics")]
    pub(super) full: bool,
    /// Show how many findings each rule has instead of the findings.
    #[arg(long)]
    pub(super) statistics: bool,
    /// Check what is staged for the commit, and report only what is new or worse than at HEAD; everything where nothing
    /// is staged. Gives way to a --since or --against after it.
    #[arg(long, overrides_with_all = ["since", "against"])]
    pub(super) staged: bool,
    /// Report only what is new or worse than where the folder left this git revision.
    #[arg(long, value_name = "REV", conflicts_with = "against", overrides_with = "since")]
    pub(super) since: Option<String>,
    /// Report only what is new or worse than in another folder.
    #[arg(long, value_name = "FOLDER")]
    pub(super) against: Option<PathBuf>,
    #[command(flatten)]
    pub(super) fixes: FixArgs,
    /// Print time per phase and rule to standard error.
    #[arg(long)]
    pub(super) timings: bool,
    /// Leave out everything but findings and verdict.
    #[arg(long, short)]
    pub(super) quiet: bool,
}

impl CheckArgs {
    /// The PATHs, or the current directory.
    pub(super) fn paths_or_here(&self) -> Vec<PathBuf> {
        if self.paths.is_empty() { vec![PathBuf::from(".")] } else { self.paths.clone() }
    }

    /// The option that compares.
    pub(super) const fn comparing(&self) -> Option<&'static str> {
        match (&self.against, &self.since, self.staged) {
            (Some(_), ..) => Some("--against"),
            (None, Some(_), _) => Some("--since"),
            (None, None, true) => Some("--staged"),
            (None, None, false) => None,
        }
    }
}

/// `--color`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ColorChoice {
    /// On a terminal, unless the environment says otherwise.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// `explain --format`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ExplainFormat {
    /// For a terminal.
    Text,
    /// For a document.
    Markdown,
}

/// `rules --format`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ListFormat {
    /// Columns.
    Table,
    /// For programs.
    Json,
    /// For a document.
    Markdown,
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

/// Ends the command with what is wrong with its arguments. That an unknown option could be a value is left out: no value
/// of ours begins with a dash.
pub(super) fn refuse(mut error: clap::Error) -> ! {
    if error.kind() == ErrorKind::UnknownArgument {
        error.remove(ContextKind::Suggested);
    }
    error.exit()
}

fn application(text: &str) -> Result<Application, String> {
    let all = Application::ALL;
    let found = all.into_iter().find(|application| application.word() == text);
    found.ok_or_else(|| not_one_of("application", text, &all.map(Application::word)))
}

fn samples(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|number| *number <= MOST_SAMPLES);
    number.ok_or_else(|| format!("a whole number from 0 to {MOST_SAMPLES} is wanted"))
}

fn level_setting(text: &str) -> Result<(String, Option<Level>), String> {
    let (rule, level) = text.split_once('=').ok_or("RULE=LEVEL is wanted, `target-zero-delta=off` say")?;
    let level = match level {
        "error" => Some(Level::Error),
        "warning" => Some(Level::Warning),
        "info" => Some(Level::Info),
        "off" => None,
        _ => return Err(not_one_of("level", level, &["error", "warning", "info", "off"])),
    };
    Ok((rule.to_owned(), level))
}
