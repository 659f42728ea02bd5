//! The arguments and their help.

use std::path::PathBuf;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use super::eval::EvalCommand;
use super::fix::FixArgs;
use super::one_of::not_one_of;
use super::output::Target;
use mhlint_config::MOST_SAMPLES;
use mhlint_diag::{Application, Edition, EditionFault, Level, Version};

const AFTER_HELP: &str = "\
Exit codes: 0 passed, 1 findings at or above --fail-on, 2 could not run, 3 nothing was checked in \
a PATH.

Examples:
  mhlint data/                                     check a data folder
  mhlint my-pack/ --system makehuman2/data         check a pack against MakeHuman's own data
  mhlint my-pack.zip --system makehuman2/data      check a zip as the folder that it becomes
  mhlint data/ --fix                               fix what can be fixed safely
  mhlint data/ --report human --report json=r.json print a report, and write another for a program
  mhlint explain macro-steps-length                what a rule means, with examples";

const SEE_LONG_HELP: &str =
    "Run with --help for all options, examples and exit codes; `mhlint rules` lists all rules.";

const COMPLETIONS_HELP: &str = "\
Where to save the script:
  bash  mhlint completions bash > ~/.local/share/bash-completion/completions/mhlint
  zsh   mhlint completions zsh > _mhlint, in a folder of $fpath
  fish  mhlint completions fish > ~/.config/fish/completions/mhlint.fish
  PowerShell and Elvish: add the script to your profile";

/// Checks asset repositories of MakeHuman 2, MakeHuman 1 and MPFB.
#[derive(Debug, Parser)]
#[command(
    name = "mhlint",
    version,
    args_conflicts_with_subcommands = true,
    after_help = SEE_LONG_HELP,
    after_long_help = AFTER_HELP
)]
pub(super) struct Args {
    #[command(subcommand)]
    pub(super) command: Option<Command>,
    #[command(flatten)]
    pub(super) check: CheckArgs,
    /// When to use colour.
    ///
    /// `auto` uses colour on a terminal, unless `NO_COLOR` is set; `FORCE_COLOR` and
    /// `CLICOLOR_FORCE` turn it on in pipes.
    #[arg(
        long,
        value_name = "WHEN",
        default_value = "auto",
        global = true,
        help_heading = "Output",
        hide_short_help = true
    )]
    pub(super) color: ColorChoice,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Check files and folders (the default command).
    #[command(after_help = SEE_LONG_HELP, after_long_help = AFTER_HELP)]
    Check(CheckArgs),
    /// Show the settings in effect and where each comes from.
    Config(CheckArgs),
    /// Compute what an application would compute: shapes, joints, skinning.
    #[command(subcommand)]
    Eval(EvalCommand),
    /// Explain a rule: consequences, how to fix it, a bad and a good example.
    Explain {
        /// A rule, or a family such as `macro`.
        rule: String,
        /// Output format.
        ///
        /// As Markdown, each rule of a family is explained; as text, the family is listed.
        #[arg(long, value_name = "FORMAT", default_value = "text")]
        format: ExplainFormat,
    },
    /// Write a commented mhlint.toml; never overwrites a file.
    Init {
        /// Folder to write it to [default: the current folder].
        #[arg(value_name = "FOLDER")]
        folder: Option<PathBuf>,
    },
    /// List all rules.
    Rules {
        /// Output format.
        #[arg(long, value_name = "FORMAT", default_value = "table")]
        format: ListFormat,
    },
    /// Print a JSON Schema, or list all of them.
    Schema {
        /// Name of the schema.
        name: Option<String>,
    },
    /// Print a completion script for a shell.
    #[command(after_help = COMPLETIONS_HELP)]
    Completions {
        /// The shell.
        shell: Shell,
    },
    /// Print a man page for mhlint or one of its commands.
    Man {
        /// A command, for example `eval mesh`.
        #[arg(value_name = "COMMAND")]
        words: Vec<String>,
    },
}

impl Command {
    /// The words for the commands, to find slips of the pen.
    pub(super) const WORDS: [&'static str; 10] = [
        "check",
        "config",
        "eval",
        "explain",
        "init",
        "rules",
        "schema",
        "completions",
        "man",
        "help",
    ];
}

/// Arguments of `check`.
#[derive(Debug, clap::Args)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a flag of the command line"
)]
pub(super) struct CheckArgs {
    /// Files, folders or zips to check [default: the current folder].
    ///
    /// A zip is checked, without unpacking it to disk, as what MakeHuman 2 imports of it, as what
    /// MakeHuman 1 has once it is unpacked, and as what MPFB makes of it if it is asked for or
    /// `packs/` is at the top.
    ///
    /// In data folders files with these extensions are read: bmp bvh gif gz jpeg jpg json jsonw
    /// list meta mhbin mhc mhclo mhm mhmat mhpose mhpxy mhscene mhskel mhuv mhw npz obj png proxy
    /// target tga thumb tif tiff toml txt webp zip.
    #[arg(value_name = "PATH")]
    pub(super) paths: Vec<PathBuf>,
    /// Data of the application itself, to resolve references; can be repeated.
    ///
    /// It is read, not reported on. Each application has its own.
    #[arg(long = "system", value_name = "FOLDER", help_heading = "Input")]
    pub(super) systems: Vec<PathBuf>,
    /// Check only for this application; can be repeated.
    ///
    /// One of makehuman2, makehuman1, mpfb, perhaps in a version: makehuman1@1.0 to @1.3,
    /// makehuman2@2024, @2025, @2026-08-05, @2026-08-20, mpfb@2.0.5 to @2.0.17. Without one, the
    /// version that the data show, else the newest.
    #[arg(
        long = "app",
        value_name = "APPLICATION",
        value_parser = application,
        help_heading = "Input",
    )]
    pub(super) applications: Vec<Edition>,
    /// Report only on this base mesh; can be repeated.
    ///
    /// For files outside data folders it names the base mesh that they are for.
    #[arg(
        long = "base",
        value_name = "NAME",
        help_heading = "Input",
        hide_short_help = true
    )]
    pub(super) bases: Vec<String>,
    /// Configuration file [default: the nearest mhlint.toml].
    ///
    /// Looked for at or above the first PATH, up to the top of the repository.
    #[arg(
        long,
        value_name = "FILE",
        help_heading = "Input",
        hide_short_help = true
    )]
    pub(super) config: Option<PathBuf>,
    /// Run only this rule, family or glob; can be repeated.
    ///
    /// For example `macro-steps-length`, `macro` or `*-duplicate-*`.
    #[arg(long, value_name = "RULE", help_heading = "Rules")]
    pub(super) only: Vec<String>,
    /// Skip this rule, family or glob; can be repeated.
    #[arg(long, value_name = "RULE", help_heading = "Rules")]
    pub(super) skip: Vec<String>,
    /// Change the level of a rule, family or glob; can be repeated.
    ///
    /// The level is one of error, warning, info, off.
    #[arg(
        long = "level",
        value_name = "RULE=LEVEL",
        value_parser = level_setting,
        help_heading = "Rules",
        hide_short_help = true,
    )]
    pub(super) levels: Vec<(String, Option<Level>)>,
    /// Skip all rules that need evaluation.
    #[arg(long, help_heading = "Rules")]
    pub(super) no_eval: bool,
    /// Number of random slider settings to try (at most 100000).
    ///
    /// They are tried in addition to the systematic ones.
    #[arg(
        long,
        value_name = "N",
        conflicts_with = "no_eval",
        value_parser = samples,
        help_heading = "Rules",
        hide_short_help = true,
    )]
    pub(super) samples: Option<usize>,
    /// Try every corner of the slider space.
    #[arg(
        long,
        conflicts_with = "no_eval",
        help_heading = "Rules",
        hide_short_help = true
    )]
    pub(super) exhaustive: bool,
    /// Lowest level that makes the exit code 1 [default: error].
    ///
    /// One of error, warning, info, never.
    #[arg(
        long,
        value_name = "LEVEL",
        hide_possible_values = true,
        help_heading = "Output"
    )]
    pub(super) fail_on: Option<FailOn>,
    /// Exit with code 1 if there are more warnings than this.
    #[arg(
        long,
        value_name = "N",
        help_heading = "Output",
        hide_short_help = true
    )]
    pub(super) max_warnings: Option<usize>,
    /// Check the staged files; report what is new since HEAD.
    ///
    /// If nothing is staged, everything is reported. A later --since or --against overrides it.
    #[arg(long, overrides_with_all = ["since", "against"], help_heading = "Only new findings")]
    pub(super) staged: bool,
    /// Report only what is new or worse since this git revision.
    ///
    /// The folder is compared with the merge base of REV and HEAD.
    #[arg(
        long,
        value_name = "REV",
        conflicts_with = "against",
        overrides_with = "since",
        help_heading = "Only new findings"
    )]
    pub(super) since: Option<String>,
    /// Report only what is new or worse than in another folder or zip.
    #[arg(
        long,
        value_name = "FOLDER",
        help_heading = "Only new findings",
        hide_short_help = true
    )]
    pub(super) against: Option<PathBuf>,
    /// Hide the findings that are listed in this file.
    #[arg(long, value_name = "FILE", help_heading = "Only new findings")]
    pub(super) baseline: Option<PathBuf>,
    /// Write the current findings to the baseline.
    ///
    /// Findings that no longer occur are removed from it.
    #[arg(
        long,
        conflicts_with_all = ["fixing", "staged", "since", "against"],
        help_heading = "Only new findings",
        hide_short_help = true
    )]
    pub(super) write_baseline: bool,
    /// Report format, and file to write it to; can be repeated.
    ///
    /// One of human, concise, json, sarif, github, gitlab, junit, markdown, html; to standard
    /// output unless a FILE is named.
    #[arg(
        long = "report",
        value_name = "FORMAT[=FILE]",
        value_parser = Target::parse,
        help_heading = "Output",
    )]
    pub(super) reports: Vec<Target>,
    /// Show every finding in full, including infos.
    ///
    /// Without it infos take one line each, and long lists are cut.
    #[arg(long, conflicts_with = "statistics", help_heading = "Output")]
    pub(super) full: bool,
    /// Show the number of findings for each rule instead.
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub(super) statistics: bool,
    /// Print the time taken by each phase and rule.
    ///
    /// It goes to standard error.
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub(super) timings: bool,
    /// Print only findings and the verdict.
    #[arg(long, short, help_heading = "Output")]
    pub(super) quiet: bool,
    #[command(flatten)]
    pub(super) fixes: FixArgs,
}

impl CheckArgs {
    /// The PATHs, or the current directory.
    pub(super) fn paths_or_here(&self) -> Vec<PathBuf> {
        if self.paths.is_empty() {
            vec![PathBuf::from(".")]
        } else {
            self.paths.clone()
        }
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

/// Options of other linters, with the one of ours.
const MEANT: [(&str, &str); 7] = [
    ("--json", "--report json"),
    ("--format", "--report FORMAT"),
    ("--output-format", "--report FORMAT"),
    ("--output", "--report FORMAT=FILE"),
    ("--output-file", "--report FORMAT=FILE"),
    ("--select", "--only RULE"),
    ("--ignore", "--skip RULE"),
];

/// Ends the command with what is wrong with its arguments. That an unknown option could be a value
/// is left out: no value of ours begins with a dash.
pub(super) fn refuse(mut error: clap::Error) -> ! {
    if error.kind() == ErrorKind::UnknownArgument {
        error.remove(ContextKind::Suggested);
        let unknown = error
            .get(ContextKind::InvalidArg)
            .map(ToString::to_string)
            .unwrap_or_default();
        if let Some((_, own)) = MEANT.iter().find(|(other, _)| *other == unknown) {
            error.remove(ContextKind::SuggestedArg);
            let tip = format!("use `{own}`").into();
            error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip]));
        }
    }
    error.exit()
}

fn application(text: &str) -> Result<Edition, String> {
    Edition::parse(text).map_err(|fault| match fault {
        EditionFault::Application => not_one_of(
            "application",
            text,
            &Application::ALL.map(Application::word),
        ),
        EditionFault::Version(application) => {
            let known =
                Version::names(application).map(|name| format!("{}@{name}", application.word()));
            let known: Vec<String> = known.collect();
            not_one_of(
                "version",
                text,
                &known.iter().map(String::as_str).collect::<Vec<_>>(),
            )
        }
    })
}

fn samples(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|number| *number <= MOST_SAMPLES);
    number.ok_or_else(|| format!("expected a whole number from 0 to {MOST_SAMPLES}"))
}

fn level_setting(text: &str) -> Result<(String, Option<Level>), String> {
    let (rule, level) = text
        .split_once('=')
        .ok_or("expected RULE=LEVEL, for example `target-zero-delta=off`")?;
    let level = match level {
        "error" => Some(Level::Error),
        "warning" => Some(Level::Warning),
        "info" => Some(Level::Info),
        "off" => None,
        _ => {
            return Err(not_one_of(
                "level",
                level,
                &["error", "warning", "info", "off"],
            ));
        }
    };
    Ok((rule.to_owned(), level))
}
