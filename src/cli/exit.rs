//! Outcomes of the command and their exit codes.

use std::fmt;
use std::io;
use std::process::ExitCode;

use crate::{config, evaluate};
use mhlint_engine as engine;
use mhlint_report::printable;

/// How the command ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Exit {
    /// Nothing at or above the level to fail on.
    Clean,
    /// Findings.
    Findings,
    /// Could not work.
    CannotWork,
    /// Nothing was checked of a PATH.
    NothingToCheck,
}

impl Exit {
    pub(super) fn code(self) -> ExitCode {
        ExitCode::from(match self {
            Self::Clean => 0,
            Self::Findings => 1,
            Self::CannotWork => 2,
            Self::NothingToCheck => 3,
        })
    }
}

/// Why the command could not work.
#[derive(Debug)]
pub(super) enum Failure {
    /// What is asked for cannot be done; the text says why, and names the remedy where it can.
    Usage(String),
    /// Writing failed.
    Io(io::Error),
}

impl Failure {
    /// A reader that went away (`| head`) is no failure.
    pub(super) fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::Io(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }
}

impl From<engine::Error> for Failure {
    fn from(error: engine::Error) -> Self {
        Self::Usage(printable(&error.to_string()))
    }
}

impl From<config::Error> for Failure {
    fn from(error: config::Error) -> Self {
        Self::Usage(error.to_string())
    }
}

impl From<evaluate::Error> for Failure {
    fn from(error: evaluate::Error) -> Self {
        Self::Usage(printable(&error.to_string()))
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage(text) => f.write_str(text),
            Self::Io(error) => {
                write!(
                    f,
                    "cannot write to standard output: {error}; redirect it to a file or another \
                        program"
                )
            }
        }
    }
}
