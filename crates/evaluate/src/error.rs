//! Why there is no number to give.

use std::fmt;

use mhlint_diag::Application;
use mhlint_eval::error::EvalError;

/// An evaluation that cannot be done.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// The data folder cannot be opened; why.
    Open(String),
    /// No data that can be evaluated below the path.
    NoData(String),
    /// Several data folders hold the base.
    SeveralRoots(Vec<String>),
    /// Several bases and none named.
    BaseNeeded {
        /// The bases there are.
        known: Vec<String>,
        /// Those with a macro system.
        with_macros: Vec<String>,
    },
    /// A base that no layer has a mesh of.
    UnknownBase {
        /// As given.
        name: String,
        /// The one probably meant.
        nearest: Option<String>,
        /// The bases there are.
        known: Vec<String>,
    },
    /// The base has no macros to evaluate.
    NoMacros {
        /// The base.
        base: String,
        /// Why.
        reason: String,
    },
    /// No slider of that name.
    UnknownSlider {
        /// As given.
        name: String,
        /// The one probably meant.
        nearest: Option<String>,
    },
    /// A setting that cannot be understood.
    Setting {
        /// As given.
        text: String,
        /// Why.
        reason: String,
    },
    /// A target with a factor that has no file.
    MissingTarget {
        /// Whose slider asks for it.
        application: Application,
        /// The target.
        name: String,
    },
    /// A file that cannot be read or used.
    File {
        /// Its path.
        path: String,
        /// Why.
        reason: String,
    },
    /// The base has no pose skeleton or no weights.
    NoSkeleton {
        /// The base.
        base: String,
        /// Why.
        reason: String,
    },
    /// A bone that the skeleton does not have.
    UnknownBone {
        /// As given.
        name: String,
        /// The one probably meant.
        nearest: Option<String>,
    },
    /// A field of a case that is missing or of the wrong kind.
    Input(String),
    /// Data that stops an application with an exception.
    Stops {
        /// Which one.
        application: Application,
        /// Name of the exception in Python.
        exception: &'static str,
        /// What is wrong.
        reason: String,
    },
}

impl Error {
    /// A file that cannot be used.
    pub(super) fn file(path: impl Into<String>, reason: impl Into<String>) -> Self {
        Self::File {
            path: path.into(),
            reason: reason.into(),
        }
    }

    /// Indices that do not exist stop every application with an `IndexError`.
    pub(super) fn index(application: Application, error: EvalError) -> Self {
        Self::Stops {
            application,
            exception: "IndexError",
            reason: error.to_string(),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let meant = |nearest: &Option<String>| match nearest {
            Some(name) => format!("; did you mean `{name}`?"),
            None => String::new(),
        };
        match self {
            Self::Open(reason) => f.write_str(reason),
            Self::NoData(path) => {
                let titles = Application::ALL.map(Application::title);
                let titles = match titles.as_slice() {
                    [others @ .., last] if !others.is_empty() => {
                        format!("{} or {last}", others.join(", "))
                    }
                    other => other.concat(),
                };
                write!(
                    f,
                    "`{path}` contains no {titles} data (expected base/<name>/base.obj, \
                        base.mhbin or 3dobjs/base.obj in it)"
                )
            }
            Self::SeveralRoots(paths) => {
                write!(
                    f,
                    "several data folders contain this base mesh; use one of: {}",
                    paths.join(", ")
                )
            }
            Self::BaseNeeded { known, .. } if known.is_empty() => f.write_str(
                "the data folder has no base mesh (base.obj or base.mhbin); give the \
                    data of the program with `--system`",
            ),
            Self::BaseNeeded { known, .. } => {
                write!(
                    f,
                    "the data folder has several base meshes; choose one with `--base`: {}",
                    known.join(", ")
                )
            }
            Self::UnknownBase {
                name,
                nearest,
                known,
            } => {
                write!(f, "unknown base mesh `{name}`{}", meant(nearest))?;
                if known.is_empty() {
                    Ok(())
                } else {
                    write!(f, " (known: {})", known.join(", "))
                }
            }
            Self::NoMacros { base, reason } => write!(
                f,
                "base mesh `{base}` has no usable \
                macros: {reason}"
            ),
            Self::UnknownSlider { name, nearest } => {
                write!(f, "unknown slider `{name}`{}", meant(nearest))
            }
            Self::Setting { text, reason } => write!(f, "setting `{text}`: {reason}"),
            Self::MissingTarget { application, name } => {
                write!(
                    f,
                    "this setting needs target `{name}`, which does not exist; \
                    {application} would crash"
                )
            }
            Self::File { path, reason } => write!(f, "cannot use `{path}`: {reason}"),
            Self::NoSkeleton { base, reason } => write!(f, "base mesh `{base}`: {reason}"),
            Self::UnknownBone { name, nearest } => {
                write!(f, "unknown bone `{name}`{}", meant(nearest))
            }
            Self::Input(what) => f.write_str(what),
            Self::Stops {
                application,
                exception,
                reason,
            } => {
                write!(f, "{application} would crash with `{exception}`: {reason}")
            }
        }
    }
}

impl std::error::Error for Error {}
