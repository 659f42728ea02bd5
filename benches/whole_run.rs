//! A whole run without a disk, against the plain read of the same bytes:
//! `cargo bench --bench whole_run`.
//!
//! On the example repository; with `MHLINT_CORPORA` set, on the data of MakeHuman 2 as well.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test may stop where it fails"
)]

mod data;

use std::fmt;
use std::path::{Path, PathBuf};

use divan::{Bencher, counter::BytesCount};
use mhlint::{Config, Tree, lint_trees};

fn main() {
    divan::main();
}

/// A repository in memory.
struct Repository {
    name: &'static str,
    files: Vec<(String, Vec<u8>)>,
}

impl Repository {
    fn read(name: &'static str, root: &Path) -> Self {
        let named = |path: PathBuf| {
            let rel = path
                .strip_prefix(root)
                .unwrap()
                .to_str()
                .unwrap()
                .replace('\\', "/");
            (rel, std::fs::read(path).unwrap())
        };
        Self {
            name,
            files: data::files_below(root).into_iter().map(named).collect(),
        }
    }

    fn bytes(&self) -> usize {
        self.files.iter().map(|(_, bytes)| bytes.len()).sum()
    }
}

impl fmt::Display for Repository {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

fn repositories() -> Vec<Repository> {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/makehuman2");
    let mut all = vec![Repository::read("example", &example)];
    if let Some(corpora) = std::env::var_os("MHLINT_CORPORA") {
        all.push(Repository::read(
            "makehuman2",
            &PathBuf::from(corpora).join("makehuman2/data"),
        ));
    }
    all
}

#[divan::bench(args = repositories())]
fn lint(bencher: Bencher<'_, '_>, repository: &Repository) {
    bencher
        .counter(BytesCount::new(repository.bytes()))
        .with_inputs(|| Tree::in_memory("", repository.files.iter().cloned()))
        .bench_values(|tree| {
            lint_trees(vec![tree], None, &Config::default())
                .unwrap()
                .findings
                .len()
        });
}

#[divan::bench(args = repositories())]
fn word_count(bencher: Bencher<'_, '_>, repository: &Repository) {
    bencher
        .counter(BytesCount::new(repository.bytes()))
        .bench(|| {
            repository
                .files
                .iter()
                .map(|(_, bytes)| data::count_words(bytes))
                .sum::<usize>()
        });
}
