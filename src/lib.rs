//! Checks asset repositories of `MakeHuman` 2, `MakeHuman` 1 and MPFB before these programs load
//! them.
//!
//! The library reads everything an application would read, resolves every name the way that
//! application resolves it, and says what would happen to its user: a crash, a vanished asset, a
//! dead slider. The command `mhlint` is a thin layer over it.
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
//! [`Config::load`] reads the settings of a repository (`mhlint.toml`), [`config::find`] finds
//! them. [`lint_trees`] does the same without a disk, on [`Tree`]s in memory. [`report`] writes an
//! [`Outcome`] in the formats of the command line, [`evaluate`] computes what the application would
//! show, [`eval`] the same on plain arrays.
//!
//! ```
//! use std::path::Path;
//! let data = Path::new("fixtures/makehuman2/data");
//! let mut evaluation = mhlint::open_base(data, None, Some("figure"))?;
//! let rest = evaluation.morphed(&evaluation.setting(&[])?)?;
//! let oval = evaluation.setting(&[("head/head-oval".to_owned(), 1.0)])?;
//! let morphed = evaluation.morphed(&oval)?;
//! assert_eq!(rest.len(), morphed.len());
//! assert_ne!(rest, morphed);
//! # Ok::<(), mhlint::evaluate::Error>(())
//! ```
//!
//! [`lint_and_fix`] checks and fixes in memory; [`fix::write_all`] brings the changes to disk, each
//! file as a whole.
//!
//! Two channels are never mixed: damaged data are [`Finding`]s, [`Error`] means that the run could
//! not be done. No input makes the library panic; where one of its own bugs does, the file, rule or
//! base mesh is skipped and [`Outcome::is_whole`] tells.
//!
//! These modules are the door: what they name is kept, and what else the members of the workspace
//! (`mhlint-formats`, `mhlint-rules` and the others) have in public is for one another. Rust has no
//! word for that; whoever depends on a member itself follows its changes.
//!
//! One way through the house: source → discover → formats → repo → eval → evaluate → rules → engine
//! → report → cli (`docs/architecture.md`).

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]
#![warn(missing_docs)]

#[doc(hidden)]
pub mod cli;

pub use mhlint_config::Config;
pub use mhlint_diag::{Application, Finding, Level, Outcome};
pub use mhlint_engine::{
    BaselineFault, CoveredKind, Error, Fixed, PathFault, Proposal, SelectorFault, covered_kinds,
    lint, lint_and_fix, lint_trees, lint_trees_beside, lint_with_replacements, open_base, propose,
    rule_infos,
};
pub use mhlint_rules::Unread;
pub use mhlint_source::{Encoding, Limits, Tree};

/// What a run is asked to do, and the settings of a repository (`mhlint.toml`).
pub mod config {
    pub use mhlint_config::{
        Before, Compare, ConfigFile, Date, Error, FILE_NAME, Fault, Globs, Ignore, MOST_SAMPLES,
        PathBlock, PathGlob, Selector, TEMPLATE, find, schema, template_for,
    };
}

/// What a run found, and what it did not check: plain data.
pub mod diag {
    pub use mhlint_diag::{
        ApplicationVerdict, AssetGroup, Baseline, BaselineUse, Break, Change, Compared, Confidence,
        Consumed, Consumer, Edit, Edition, EditionFault, Element, Entry, Evidence, Excerpt,
        FailedStep, Fares, Figure, Fix, FixKind, Folder, Grown, Grows, Identity, IdleGlob,
        IgnoreState, IgnoreUse, IgnoredFiles, Location, Measure, MeasureKind, Name, NewParts,
        NotChecked, Note, OptionInfo, Parts, Phase, Place, PlaceKind, Related, Replaced, Rewrite,
        RootSummary, RuleInfo, Scope, Sign, Speaks, Step, Subject, Summary, TakenOver, Timed,
        Timing, Towards, Unchecked, UnknownRule, Untouched, Upkeep, Verdict, Version,
    };
}

/// An outcome as text.
pub mod report {
    pub use mhlint_report::{Format, Paint, View, summary, write};
}

/// Changes to files: as text, and to disk.
pub mod fix {
    pub use mhlint_fix::{FileChange, Patch, Pending, Plan, WriteError, apply, unified, write_all};
}

/// What an application would show of a base mesh, computed from its files.
pub mod evaluate {
    pub use mhlint_evaluate::{
        CaseReport, CaseRun, Comparison, Deviation, Error, Evaluation, Fitted, NamedWeights,
        OpenBase, Point, PosedBase, Poses, RestSkeleton, Roots, Setting, SkeletonFile,
        SliderSetting, parse_setting, read_poses, read_positions, read_settings, run_cases,
        with_positions,
    };
}

/// The formulas on plain arrays: macros and sliders, morphs, skeletons, weights, skinning, fitting.
pub mod eval {
    pub use mhlint_eval::{
        error, faces, fit, load, macros, makehuman1, makehuman2, mesh, morph, mpfb, scene,
        settings, skeleton, skin, vector, weights,
    };
}

/// The example of the guide compiles.
#[cfg(doctest)]
#[doc = include_str!("../docs/library.md")]
struct Guide;
