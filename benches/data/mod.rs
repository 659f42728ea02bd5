//! What the benchmarks read: made here, or taken from the corpora.
#![allow(dead_code, unreachable_pub, reason = "each benchmark uses its part")]

use std::fmt;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// Files in memory.
pub struct Files {
    pub name: &'static str,
    pub contents: Vec<Vec<u8>>,
}

impl Files {
    /// Size of all.
    pub fn bytes(&self) -> usize {
        self.contents.iter().map(Vec::len).sum()
    }

    /// The plain read that a parser is measured against: words, as `wc -w` counts them.
    pub fn words(&self) -> usize {
        self.contents.iter().map(|text| count_words(text)).sum()
    }
}

impl fmt::Display for Files {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// Words of a text.
pub fn count_words(text: &[u8]) -> usize {
    let mut words = 0;
    let mut inside = false;
    for byte in text {
        let is_word = !byte.is_ascii_whitespace();
        words += usize::from(is_word && !inside);
        inside = is_word;
    }
    words
}

/// Targets: fifty of 4000 rows with the short header of today, the same with the long one of old
/// exporters, which has more than one blank in its comments, and those of the corpus.
pub fn targets() -> Vec<Files> {
    let made = |header| {
        (0..50)
            .map(|number| made_target(header, 4_000, number))
            .collect()
    };
    let mut all = vec![
        Files {
            name: "made",
            contents: made("# made for a benchmark\n"),
        },
        Files {
            name: "made, old header",
            contents: made(OLD_HEADER),
        },
    ];
    all.extend(
        corpus("makehuman2/data/target", "target").map(|contents| Files {
            name: "makehuman2",
            contents,
        }),
    );
    all
}

/// Weights: 100 bones of 600 vertices, and those of the corpus.
pub fn weights() -> Vec<Files> {
    let mut all = vec![Files {
        name: "made",
        contents: vec![made_weights(100, 600)],
    }];
    all.extend(corpus("makehuman2/data/rigs", "mhw").map(|contents| Files {
        name: "makehuman2",
        contents,
    }));
    all
}

const OLD_HEADER: &str = "# This is a made target  (for a benchmark)\n#\n# written by:    nobody\n#  on:          a day\n";

fn made_target(header: &str, rows: u32, seed: u32) -> Vec<u8> {
    let mut text = String::from(header);
    for row in 0..rows {
        let delta = |factor: u32| f64::from((row * factor + seed) % 2_001) / 1_000.0 - 1.0;
        writeln!(
            text,
            "{} {:.3} {:.3} {:.3}",
            row * 4 + seed % 4,
            delta(37),
            delta(91),
            delta(53)
        )
        .unwrap();
    }
    text.into_bytes()
}

fn made_weights(bones: u32, vertices: u32) -> Vec<u8> {
    let mut text = String::from("{\n\"name\": \"made\",\n\"weights\": {\n");
    for bone in 0..bones {
        let pairs: Vec<String> = (0..vertices)
            .map(|vertex| {
                format!(
                    "[{}, {:.4}]",
                    bone * 150 + vertex,
                    f64::from(vertex % 99 + 1) / 100.0
                )
            })
            .collect();
        let comma = if bone + 1 < bones { "," } else { "" };
        writeln!(text, "\"bone{bone}\": [{}]{comma}", pairs.join(", ")).unwrap();
    }
    text.push_str("}\n}\n");
    text.into_bytes()
}

/// All files below a folder of the corpora that end in `extension`; `None` without corpora.
fn corpus(folder: &str, extension: &str) -> Option<Vec<Vec<u8>>> {
    let root = PathBuf::from(std::env::var_os("MHLINT_CORPORA")?).join(folder);
    let files = files_below(&root)
        .into_iter()
        .filter(|path| path.extension().is_some_and(|found| found == extension));
    Some(files.map(|path| fs::read(path).unwrap()).collect())
}

/// All files below a folder, sorted.
pub fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(files_below(&path));
        } else {
            files.push(path);
        }
    }
    files.sort();
    files
}
