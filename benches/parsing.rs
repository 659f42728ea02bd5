//! Parsers against the plain read of the same bytes: `cargo bench --bench parsing`.
//!
//! The data are made here; with `MHLINT_CORPORA` set, those of MakeHuman 2 are measured as well.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test may stop where it fails"
)]

mod data;

use data::Files;
use divan::{Bencher, counter::BytesCount};
use mhlint::Encoding;
use mhlint_formats::{mhw, target};

fn main() {
    divan::main();
}

#[divan::bench(args = data::targets())]
fn target_parse(bencher: Bencher<'_, '_>, files: &Files) {
    bencher.counter(BytesCount::new(files.bytes())).bench(|| {
        files
            .contents
            .iter()
            .map(|text| target::parse(text, None).rows.len())
            .sum::<usize>()
    });
}

#[divan::bench(args = data::targets())]
fn target_word_count(bencher: Bencher<'_, '_>, files: &Files) {
    bencher
        .counter(BytesCount::new(files.bytes()))
        .bench(|| files.words());
}

#[divan::bench(args = data::weights())]
fn weights_parse(bencher: Bencher<'_, '_>, files: &Files) {
    bencher.counter(BytesCount::new(files.bytes())).bench(|| {
        let parsed = files
            .contents
            .iter()
            .map(|text| mhw::parse(text, &Encoding::of(text), None));
        parsed
            .flatten()
            .map(|weights| weights.bones.len())
            .sum::<usize>()
    });
}

#[divan::bench(args = data::weights())]
fn weights_word_count(bencher: Bencher<'_, '_>, files: &Files) {
    bencher
        .counter(BytesCount::new(files.bytes()))
        .bench(|| files.words());
}
