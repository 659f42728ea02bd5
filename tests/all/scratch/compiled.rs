//! `[[compiled]]`: something worn, or a mesh, packed as MakeHuman 1 does it.

use std::fs;
use std::path::Path;

use serde::Deserialize;

use super::Edit;
use super::pack::{int, npy, single};
use super::zipped::{named, zip};

/// An archive to make of a text as it is before the edits of the case.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Compiled {
    /// The archive.
    file: String,
    /// The text: a mesh if it is an OBJ.
    from: String,
    /// Something in the text that is otherwise in the archive.
    #[serde(default)]
    find: String,
    #[serde(default)]
    replace: String,
    /// Members that are left out.
    #[serde(default)]
    without: Vec<String>,
    /// Whether the text is removed.
    #[serde(default)]
    alone: bool,
    /// How many bytes are cut off its end.
    #[serde(default)]
    cut: usize,
}

impl Compiled {
    pub fn apply(&self, root: &Path) {
        let text = fs::read_to_string(root.join(&self.from)).unwrap();
        let edit = Edit {
            file: self.from.clone(),
            find: self.find.clone(),
            replace: self.replace.clone(),
            all: false,
        };
        let text = if self.find.is_empty() {
            text
        } else {
            edit.edited(&text)
        };
        // Archives of 1.0 do not say how many faces of a vertex they have room for, and have room
        // for eight.
        let columns = if self.without.iter().any(|name| name == "MAX_FACES") {
            8
        } else {
            16
        };
        let members = if self.from.ends_with(".obj") {
            mesh(&text, columns)
        } else {
            worn(&text)
        };
        let members = members
            .into_iter()
            .filter(|(name, _)| !self.without.iter().any(|own| own == name));
        let members: Vec<_> = members
            .map(|(name, bytes)| (named(&format!("{name}.npy")), bytes))
            .collect();
        let all: Vec<_> = members
            .iter()
            .map(|(name, bytes)| (name.clone(), bytes.as_slice()))
            .collect();
        let mut bytes = zip(&all);
        bytes.truncate(bytes.len() - self.cut);
        fs::write(root.join(&self.file), bytes).unwrap();
        if self.alone {
            fs::remove_file(root.join(&self.from)).unwrap();
        }
    }
}

fn floats(numbers: impl Iterator<Item = f64>) -> impl Iterator<Item = u8> {
    numbers.flat_map(|number| single(number).to_le_bytes())
}

fn whole(number: u32) -> [u8; 4] {
    number.to_le_bytes()
}

fn text_of(text: &str) -> Vec<u8> {
    npy("'|S1'", &format!("({},)", text.len()), text.bytes())
}

fn mesh(text: &str, columns: usize) -> Vec<(&'static str, Vec<u8>)> {
    let lines = |keyword: &'static str| {
        text.lines()
            .map(|line| line.split_whitespace())
            .filter_map(move |mut words| (words.next()? == keyword).then_some(words))
    };
    let positions: Vec<f64> = lines("v")
        .flat_map(|words| words.take(3).map(|word| word.parse().unwrap()))
        .collect();
    let mut corners: Vec<u32> = Vec::new();
    for face in lines("f") {
        let own: Vec<u32> = face
            .map(|word| word.split('/').next().unwrap().parse::<u32>().unwrap() - 1)
            .collect();
        corners.extend(own.iter().chain([&own[0]]).take(4));
    }
    let (names, groups) = groups(text);
    let starts = names.iter().scan(0, |next, name| {
        Some(std::mem::replace(next, *next + name.len()))
    });
    let starts: Vec<u8> = starts
        .flat_map(|start| whole(u32::try_from(start).unwrap()))
        .collect();
    let (vertices, faces) = (positions.len() / 3, corners.len() / 4);
    let texture: Vec<f64> = lines("vt")
        .flat_map(|words| words.take(2).map(|word| word.parse().unwrap()))
        .collect();
    let uvs = texture.len() / 2;
    vec![
        (
            "coord",
            npy(
                "'<f4'",
                &format!("({vertices}, 3)"),
                floats(positions.into_iter()),
            ),
        ),
        (
            "fvert",
            npy(
                "'<u4'",
                &format!("({faces}, 4)"),
                corners.into_iter().flat_map(whole),
            ),
        ),
        (
            "texco",
            npy("'<f4'", &format!("({uvs}, 2)"), floats(texture.into_iter())),
        ),
        // Which of them a corner has nobody asks.
        (
            "fuvs",
            npy(
                "'<u4'",
                &format!("({faces}, 4)"),
                std::iter::repeat_n(0, 16 * faces),
            ),
        ),
        // Nor which faces a vertex has.
        (
            "vface",
            npy(
                "'<u4'",
                &format!("({vertices}, {columns})"),
                std::iter::repeat_n(0, 4 * vertices * columns),
            ),
        ),
        ("MAX_FACES", npy("'<i4'", "(1,)", int(columns).into_iter())),
        (
            "nfaces",
            npy(
                "'|u1'",
                &format!("({vertices},)"),
                std::iter::repeat_n(0, vertices),
            ),
        ),
        (
            "group",
            npy(
                "'<u2'",
                &format!("({faces},)"),
                groups.into_iter().flat_map(u16::to_le_bytes),
            ),
        ),
        ("fgstr", text_of(&names.concat())),
        (
            "fgidx",
            npy("'<u4'", &format!("({},)", names.len()), starts.into_iter()),
        ),
    ]
}

/// The names of groups, and the group of each face.
fn groups(text: &str) -> (Vec<String>, Vec<u16>) {
    let mut names = Vec::new();
    let mut of_faces = Vec::new();
    let mut current = "default-dummy-group";
    for line in text.lines() {
        match line.split_once(' ') {
            Some(("g", name)) => current = name.trim(),
            Some(("f", _)) => {
                let at = names
                    .iter()
                    .position(|name| name == current)
                    .unwrap_or(names.len());
                if at == names.len() {
                    names.push(current.to_owned());
                }
                of_faces.push(u16::try_from(at).unwrap());
            }
            _ => {}
        }
    }
    (names, of_faces)
}

/// All tags in one text, and where each begins.
fn tags(text: &str) -> (String, Vec<usize>) {
    let (mut all, mut starts) = (String::new(), Vec::new());
    for tag in text.lines().filter_map(|line| line.strip_prefix("tag ")) {
        starts.push(all.len());
        all.push_str(&tag.to_lowercase());
    }
    (all, starts)
}

/// What comments say of author and licence, with lengths in letters.
fn licence(text: &str) -> (String, Vec<usize>) {
    let (mut all, mut lengths) = (String::new(), Vec::new());
    for (name, usual) in [
        ("author", ""),
        ("license", "CC0"),
        ("copyright", ""),
        ("homepage", ""),
    ] {
        let start = format!("# {name} ");
        let value = text
            .lines()
            .find_map(|line| line.strip_prefix(start.as_str()))
            .unwrap_or(usual);
        lengths.extend([name.len(), value.chars().count()]);
        all.extend([name, value]);
    }
    (all, lengths)
}

fn worn(text: &str) -> Vec<(&'static str, Vec<u8>)> {
    let word = |keyword: &str| {
        let mut lines = text
            .lines()
            .filter_map(|line| line.strip_prefix(keyword)?.strip_prefix(' '));
        lines.next_back().unwrap_or_default().trim().to_owned()
    };
    let rows = text.lines().map(|line| {
        line.split_whitespace()
            .map(str::parse)
            .collect::<Result<Vec<f64>, _>>()
    });
    let rows: Vec<Vec<f64>> = rows
        .filter_map(Result::ok)
        .filter(|row| matches!(row.len(), 1 | 6 | 9))
        .collect();
    let full: Vec<[f64; 9]> = rows
        .iter()
        .map(|row| match row.as_slice() {
            [vertex] => [*vertex, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            row => std::array::from_fn(|at| row.get(at).copied().unwrap_or_default()),
        })
        .collect();
    let is_exact = full.iter().all(|row| row[4] == 0.0 && row[5] == 0.0);
    let width = if is_exact { 1 } else { 3 };
    let shape = if is_exact {
        format!("({},)", full.len())
    } else {
        format!("({}, 3)", full.len())
    };
    let part = |from: usize| {
        full.iter()
            .flat_map(move |row| row[from..from + width].to_vec())
    };
    let scalar = |number: u32| npy("'<i4'", "()", whole(number).into_iter());
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "vertices of a sample"
    )]
    let vertices = part(0).flat_map(|number| whole(number as u32));
    let depth = word("z_depth").parse().unwrap_or(50);
    let (tags, starts) = tags(text);
    let (licence, lengths) = licence(text);
    let numbers = |numbers: Vec<usize>| {
        npy(
            "'<u4'",
            &format!("({},)", numbers.len()),
            numbers.into_iter().flat_map(int),
        )
    };
    let pole: usize = word("max_pole").parse().unwrap_or(8);
    let mut members = vec![
        ("name", text_of(&word("name"))),
        ("uuid", text_of(&word("uuid"))),
        ("basemesh", text_of("hm08")),
        ("tags_str", text_of(&tags)),
        ("tags_idx", numbers(starts)),
        ("lic_str", text_of(&licence)),
        ("lic_idx", numbers(lengths)),
        ("uvLayers_str", text_of("")),
        ("uvLayers_idx", numbers(Vec::new())),
        ("max_pole", npy("'<u4'", "()", int(2 * pole).into_iter())),
        ("obj_file", text_of(&word("obj_file"))),
        ("z_depth", scalar(depth)),
        ("num_refverts", scalar(if is_exact { 1 } else { 3 })),
        ("ref_vIdxs", npy("'<u4'", &shape, vertices)),
        ("weights", npy("'<f4'", &shape, floats(part(3)))),
    ];
    if !is_exact {
        members.push(("offsets", npy("'<f4'", &shape, floats(part(6)))));
    }
    for (member, keyword) in [
        ("material_file", "material"),
        ("vertexBoneWeights_file", "vertexboneweights_file"),
    ] {
        if !word(keyword).is_empty() {
            members.push((member, text_of(&word(keyword))));
        }
    }
    members
}
