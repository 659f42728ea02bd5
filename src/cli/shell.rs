//! `mhlint completions` and `mhlint man`: what a shell and `man` know about the arguments, taken
//! from the arguments.

use std::io::Write;

use clap::builder::PossibleValuesParser;
use clap::{Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;

use super::args::Args;
use super::exit::{Exit, Failure};
use super::one_of::not_one_of;
use mhlint_engine::rule_infos;

/// Writes the completion script of a shell.
pub(super) fn write_completions(shell: Shell, out: &mut dyn Write) -> Result<Exit, Failure> {
    // The generator panics when its writer fails, and a closed pipe is no bug: it gets memory.
    let mut script = Vec::new();
    clap_complete::generate(
        shell,
        &mut naming_rules(Args::command()),
        "mhlint",
        &mut script,
    );
    out.write_all(&script)?;
    Ok(Exit::Clean)
}

/// The commands with the names of rules where they are wanted. Only for completion: when arguments
/// are read, globs and the beginnings of names are welcome, too.
fn naming_rules(mut command: Command) -> Command {
    for wanted in ["rule", "only", "skip"] {
        if command
            .get_arguments()
            .any(|argument| argument.get_id() == wanted)
        {
            let rules = PossibleValuesParser::new(rule_infos().into_iter().map(|rule| rule.id));
            command = command.mut_arg(wanted, |argument| argument.value_parser(rules));
        }
    }
    let inner: Vec<String> = command
        .get_subcommands()
        .map(|inner| inner.get_name().to_owned())
        .collect();
    inner.into_iter().fold(command, |command, name| {
        command.mut_subcommand(name, naming_rules)
    })
}

/// Writes the man page of `mhlint`, or of the command that `words` lead to (`eval mesh`).
pub(super) fn write_man_page(words: &[String], out: &mut dyn Write) -> Result<Exit, Failure> {
    let mut root = Args::command();
    // Gives each command the name of its page, `mhlint-eval-mesh`.
    root.build();
    let mut command = &root;
    for word in words {
        let known: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
        let found = command.find_subcommand(word);
        command = found.ok_or_else(|| Failure::Usage(not_one_of("command", word, &known)))?;
    }
    let source = concat!("mhlint ", env!("CARGO_PKG_VERSION"));
    Man::new(command.clone()).source(source).render(out)?;
    Ok(Exit::Clean)
}
