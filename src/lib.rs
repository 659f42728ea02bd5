//! Checks asset repositories of `MakeHuman` 2, `MakeHuman` 1 and MPFB before these programs load them.
//!
//! The library reads everything an application would read, resolves every name the way that application
//! resolves it, and says what would happen to its user: a crash, a vanished asset, a dead slider. The
//! command `mhlint` is a thin layer over it.
//!
//! ```
//! use mhlint::{Config, Level, lint};
//!
//! let config = Config { only: vec!["macro-*".to_owned()], ..Config::default() };
//! let outcome = lint(&["fixtures/makehuman2/data".into()], &config)?;
//! for finding in &outcome.findings {
//!     println!("{}: {} [{}]", finding.path, finding.message, finding.rule);
//! }
//! assert!(config.passes(&outcome) && !outcome.has_at_least(Level::Warning));
//! # Ok::<(), mhlint::Error>(())
//! ```
//!
//! [`Config::load`] reads the settings of a repository (`mhlint.toml`), [`config::find`] finds them.
//! [`lint_trees`] does the same without a disk, on [`Tree`]s in memory. [`report`] writes an [`Outcome`] in
//! the formats of the command line, [`evaluate`] computes what the application would show, [`eval`] the same on
//! plain arrays.
//!
//! ```
//! use std::path::Path;
//! let mut evaluation = mhlint::open_base(Path::new("fixtures/makehuman2/data"), None, Some("figure"))?;
//! let rest = evaluation.morphed(&evaluation.setting(&[])?)?;
//! let oval = evaluation.setting(&[("head/head-oval".to_owned(), 1.0)])?;
//! let morphed = evaluation.morphed(&oval)?;
//! assert_eq!(rest.len(), morphed.len());
//! assert_ne!(rest, morphed);
//! # Ok::<(), mhlint::evaluate::Error>(())
//! ```
//!
//! [`lint_and_fix`] checks and fixes in memory; [`fix::write_all`] brings the changes to disk, each file as a whole.
//!
//! Two channels are never mixed: damaged data are [`Finding`]s, [`Error`] means that the run could not be
//! done. No input makes the library panic; where one of its own bugs does, the file, rule or base mesh is
//! skipped and [`Outcome::is_whole`] tells.
//!
//! One way through the house: source → discover → formats → repo → eval → evaluate → rules → engine → report → cli
//! (`docs/architecture.md`).

// Files, streams and surroundings have few doors, and who may use them says so; tests are free.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]
#![warn(missing_docs)]

#[doc(hidden)]
pub mod cli;

pub use mhlint_config::{self as config, Config};
pub use mhlint_diag::{self as diag, Application, Finding, Level, Outcome};
#[doc(hidden)]
pub use mhlint_engine::trial;
pub use mhlint_engine::{
    BaselineFault, CoveredKind, Error, Fixed, PathFault, Proposal, SelectorFault, covered_kinds, lint, lint_and_fix,
    lint_trees, lint_with_replacements, open_base, propose, rule_infos,
};
pub use mhlint_rules::Unread;
pub use mhlint_source::{Encoding, Limits, Tree};
pub use {
    mhlint_eval as eval, mhlint_evaluate as evaluate, mhlint_fix as fix, mhlint_formats as formats,
    mhlint_report as report,
};
