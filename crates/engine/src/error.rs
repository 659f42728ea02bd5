//! Why a run could not be done at all.

use std::fmt;

use mhlint_diag::Application;
use mhlint_discover::Layout;

/// Why a run could not be done at all.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Error {
    /// A PATH or `--system` that is of no use.
    Path {
        /// As given.
        path: String,
        /// Why.
        fault: PathFault,
    },
    /// `--base` that no root has.
    UnknownBase {
        /// As given.
        name: String,
        /// The bases there are.
        known: Vec<String>,
    },
    /// Several `--base`, and files outside of data folders, which are for one.
    SeveralBases {
        /// One of the files.
        file: String,
    },
    /// A zip that is to be fixed.
    FixPack {
        /// As printed.
        path: String,
    },
    /// A selector that matches no rule that it may, or no glob at all.
    Selector {
        /// As given.
        text: String,
        /// Why.
        fault: SelectorFault,
    },
    /// A baseline that cannot be used.
    Baseline {
        /// The file.
        path: String,
        /// Why.
        fault: BaselineFault,
    },
}

/// Why a path is of no use.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PathFault {
    /// As the system says it.
    Unreadable(String),
    /// Nothing in it is data of an application.
    NoData,
    /// A second `--system` of one application.
    SecondSystem {
        /// Whose data both are.
        application: Application,
        /// The first, as printed.
        first: String,
    },
}

/// Why a selector cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SelectorFault {
    /// It is no glob, as the library says it.
    NoGlob(String),
    /// It matches no rule.
    NoRule {
        /// One that may be meant.
        nearest: Option<&'static str>,
    },
    /// It is several, with commas between them.
    Several,
    /// All of `select` in the configuration file matches no rule.
    EmptySelect {
        /// The file, with the line.
        place: String,
        /// A rule that may be meant.
        nearest: Option<&'static str>,
    },
    /// It turns off or lowers a rule that is a matter of safety.
    Safety,
}

/// Why a baseline cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BaselineFault {
    /// It cannot be read, as the system says it.
    Unreadable(String),
    /// It is too large for a baseline.
    TooLarge,
    /// git left the lines of both sides of a merge in it.
    Conflict,
    /// It is not what it says, as the reader puts it.
    Damaged(String),
    /// It has a format that this version does not read.
    Format {
        /// That format.
        found: String,
        /// The one that it reads.
        read: &'static str,
    },
    /// It is no baseline.
    Other,
    /// Nothing that it names is here.
    Foreign {
        /// The first path that it names.
        first: String,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Path {
                path,
                fault: fault @ (PathFault::NoData | PathFault::SecondSystem { .. }),
            } => {
                write!(f, "`{path}` {fault}")
            }
            Self::Path { path, fault } => write!(f, "cannot read `{path}`: {fault}"),
            Self::UnknownBase { name, known } if known.is_empty() => {
                write!(f, "unknown base mesh `{name}`")
            }
            Self::UnknownBase { name, known } => {
                write!(
                    f,
                    "unknown base mesh `{name}`; use one of: {}",
                    known.join(", ")
                )
            }
            Self::SeveralBases { file } => write!(
                f,
                "`{file}` is not in a data folder and is checked for one base mesh only; use \
                 `--base` once, or check such files in a separate run"
            ),
            Self::FixPack { path } => write!(
                f,
                "`{path}` is a zip, which mhlint reads and never writes; unpack it, fix the \
                    folder, and pack it again"
            ),
            Self::Baseline { path, fault } => write!(f, "the baseline `{path}` {fault}"),
            Self::Selector { text, fault } => write!(f, "`{text}` {fault}"),
        }
    }
}

impl fmt::Display for PathFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(reason) => f.write_str(reason),
            Self::NoData => {
                let shape = |application: &Application| Layout::of(*application).shape;
                let wanted = Application::ALL
                    .iter()
                    .map(|one| format!("{one} data (expected a folder with {} in it)", shape(one)));
                write!(
                    f,
                    "contains no {}",
                    wanted.collect::<Vec<_>>().join(", and no ")
                )
            }
            Self::SecondSystem { application, first } => {
                write!(
                    f,
                    "and `{first}` are both given with `--system` as data of {application}; name \
                        one of them"
                )
            }
        }
    }
}

impl fmt::Display for SelectorFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let meant = |nearest: Option<&str>| match nearest {
            Some(name) => format!("did you mean `{name}`?"),
            None => "`mhlint rules` lists all rules".to_owned(),
        };
        match self {
            Self::NoGlob(reason) => write!(f, "is not a valid glob: {reason}"),
            Self::NoRule { nearest } => write!(f, "matches no rule; {}", meant(*nearest)),
            Self::Several => f.write_str("matches no rule; give the option once for each rule"),
            Self::EmptySelect { place, nearest } => {
                write!(
                    f,
                    "matches no rule, so `select` in {place} selects nothing; {}",
                    meant(*nearest)
                )
            }
            Self::Safety => f.write_str(
                "cannot be ignored or lowered: it protects against running foreign code, leaving \
                 the data folder or filling the memory",
            ),
        }
    }
}

impl fmt::Display for BaselineFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let anew = "create a new one with `--write-baseline`";
        match self {
            Self::Unreadable(reason) => write!(
                f,
                "cannot be read: {reason}; create one with `--write-baseline`"
            ),
            Self::TooLarge => f.write_str("is too large; use another file with `--baseline`"),
            Self::Conflict => write!(
                f,
                "has an unresolved merge conflict; keep the entries of both sides, or remove the \
                    file and {anew}"
            ),
            Self::Damaged(reason) => write!(
                f,
                "is damaged ({reason}); restore it, or remove it and {anew}"
            ),
            Self::Format { found, read } => {
                write!(
                    f,
                    "has the format `{found}`, but this version reads `{read}`; remove it and \
                        {anew}"
                )
            }
            Self::Other => {
                f.write_str("is not a baseline of mhlint; use another file with `--baseline`")
            }
            Self::Foreign { first } => write!(
                f,
                "seems to belong to another repository: none of its paths exist here, neither \
                 `{first}` nor its folder; use another file with `--baseline`, or remove this one \
                 and {anew}"
            ),
        }
    }
}

impl std::error::Error for Error {}
