//! `[[targets]]`: all targets of a repository packed as MakeHuman 1 does it, with what damages may
//! come of it.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;

use super::pack::npy;
use super::zipped::{named, zip};
use super::{content, remove};

/// An archive to make in a data folder, of the texts as they are before the edits of the case.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TargetArchive {
    /// The data folder.
    data: String,
    /// Members that are left out, without `.npy`.
    without: Vec<String>,
    /// Members with what is in them: a type and a shape as they stand in a header, then bytes; or a
    /// text alone.
    member: Vec<Member>,
    /// What is put before each path.
    prefix: String,
    /// Whether there is no list of pictures.
    no_list: bool,
    /// Lines of the list, if not all pictures there are.
    list: Option<Vec<String>>,
    /// Texts that are removed when the archive is made, without suffix. `*` stands for all.
    removed: Vec<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Member {
    name: String,
    #[serde(default)]
    descr: String,
    #[serde(default)]
    shape: String,
    text: String,
}

impl TargetArchive {
    pub fn apply(&self, root: &Path) {
        let data = root.join(&self.data);
        let files = content(&data);
        let mut members: BTreeMap<String, Vec<u8>> = BTreeMap::new();
        let mut pictures = Vec::new();
        for (path, bytes) in &files {
            let rel = path.to_str().unwrap();
            if let Some(stem) = rel.strip_suffix(".target") {
                let (index, vector) = packed(std::str::from_utf8(bytes).unwrap());
                members.insert(format!("{}{stem}.index", self.prefix), index);
                members.insert(format!("{}{stem}.vector", self.prefix), vector);
                if self.removed.iter().any(|own| own == stem || own == "*") {
                    remove(&data.join(path));
                }
            } else if rel.ends_with(".png") {
                pictures.push(format!("data/{rel}"));
            }
        }
        // The licence of all targets, as every archive has it.
        members.insert(
            "targets/targets.license".to_owned(),
            npy("'|O'", "(2,)", std::iter::empty()),
        );
        self.without
            .iter()
            .for_each(|name| drop(members.remove(name).unwrap()));
        for Member {
            name,
            descr,
            shape,
            text,
        } in &self.member
        {
            let bytes = text.bytes();
            let array = if descr.is_empty() {
                bytes.collect()
            } else {
                npy(descr, shape, bytes)
            };
            members.insert(name.clone(), array);
        }
        let all: Vec<_> = members
            .iter()
            .map(|(name, bytes)| (named(&format!("{name}.npy")), bytes.as_slice()))
            .collect();
        std::fs::write(data.join("targets.npz"), zip(&all)).unwrap();
        if !self.no_list {
            let lines = self.list.as_ref().unwrap_or(&pictures);
            std::fs::write(data.join("images.list"), lines.join("\n")).unwrap();
        }
    }
}

/// The two arrays of a text.
#[expect(
    clippy::cast_possible_truncation,
    reason = "what does not fit goes around"
)]
fn packed(text: &str) -> (Vec<u8>, Vec<u8>) {
    let rows: Vec<Vec<f64>> = text
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| {
            line.split_whitespace()
                .map(|word| word.parse().unwrap())
                .collect()
        })
        .filter(|row: &Vec<f64>| row.len() == 4)
        .collect();
    let whole = |number: f64| (number.round_ties_even() as i64 as i16).to_le_bytes();
    let index = rows.iter().flat_map(|row| whole(row[0]));
    let vector = rows
        .iter()
        .flat_map(|row| row[1..].iter().flat_map(|part| whole(part * 1000.0)));
    (
        npy("'<u2'", &format!("({},)", rows.len()), index),
        npy("'<i2'", &format!("({}, 3)", rows.len()), vector),
    )
}
