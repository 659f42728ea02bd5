//! All tests through files and the binary, in one program: most of what a test program takes to
//! build is linking it.
//!
//! `cargo test compare::` runs those of one file, `cargo test -- --ignored` those over corpora
//! (CONTRIBUTING.md).
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test may stop where it fails"
)]

mod advice;
mod architecture;
mod baseline;
mod bounded;
mod citations;
mod cli;
mod compare;
mod compared_cases;
mod compared_changes;
mod config;
mod corpora;
mod coverage;
mod damage;
mod doubles;
mod eval;
#[cfg(unix)]
mod files;
#[cfg(unix)]
mod fixes;
mod folders;
mod generated;
mod growth;
#[cfg(unix)]
mod help;
mod honest;
mod hostile;
mod hostile_makehuman1;
mod hostile_mpfb;
mod hostile_worn;
mod ignores;
mod listing;
mod loose;
mod mixed;
mod mpfb;
mod observed;
mod overlay;
#[cfg(unix)]
mod packs;
#[cfg(unix)]
mod pictures;
mod places;
mod reflexive;
mod replacements;
mod reports;
mod rules;
mod scratch;
mod versions;
mod vocabulary;
mod workspace;
