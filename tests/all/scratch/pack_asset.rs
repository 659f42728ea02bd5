//! The members that MakeHuman 2 adds to a packed mesh for an asset, made from its text.

use super::pack::{int, npy, single};

/// What is in a text, as far as it is packed.
#[derive(Default)]
struct Asset {
    words: std::collections::BTreeMap<String, String>,
    rows: Vec<Vec<f64>>,
    hidden: Vec<usize>,
}

impl Asset {
    fn of(text: &str) -> Self {
        let mut asset = Self::default();
        let mut section = "";
        for line in text.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            match (section, words.as_slice()) {
                (_, [] | ["#", ..]) => {}
                (_, ["verts", ..]) => section = "verts",
                (_, ["delete_verts"]) => section = "delete_verts",
                ("verts", numbers) => asset
                    .rows
                    .push(numbers.iter().map(|word| word.parse().unwrap()).collect()),
                ("delete_verts", [first, "-", last]) => {
                    asset
                        .hidden
                        .extend(first.parse::<usize>().unwrap()..=last.parse().unwrap());
                }
                ("delete_verts", [only]) => asset.hidden.push(only.parse().unwrap()),
                (_, [keyword, rest @ ..]) => {
                    asset.words.insert((*keyword).to_owned(), rest.join(" "));
                }
            }
        }
        asset
    }

    fn word(&self, keyword: &str) -> &str {
        self.words.get(keyword).map_or("", String::as_str)
    }
}

/// The members, with a mask for a base mesh of so many vertices.
pub fn members(text: &str, base: usize) -> Vec<(&'static str, Vec<u8>)> {
    let asset = Asset::of(text);
    let mut members = vec![
        ("asset", head(&asset)),
        (
            "files",
            texts(&[asset.word("material"), asset.word("vertexboneweights_file")]),
        ),
    ];
    let full = asset.rows.iter().map(|row| match row.as_slice() {
        [vertex] => vec![*vertex, *vertex, *vertex, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        row => row.to_vec(),
    });
    let full: Vec<Vec<f64>> = full.collect();
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
    let floats = |from: usize| part(from).flat_map(|number| single(number).to_le_bytes());
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "vertices of a sample"
    )]
    let vertices = part(0).flat_map(|number| (number as u32).to_le_bytes());
    members.push(("ref_vIdxs", npy("'<u4'", &shape, vertices)));
    members.push(("weights", npy("'<f4'", &shape, floats(3))));
    if !is_exact {
        members.push(("offsets", npy("'<f4'", &shape, floats(6))));
    }
    if ["x_scale", "y_scale", "z_scale"]
        .iter()
        .all(|axis| !asset.word(axis).is_empty())
    {
        members.push(("scale", scale(&asset)));
    }
    let mask = (0..base).map(|vertex| u8::from(asset.hidden.contains(&vertex)));
    members.push(("deleteVerts", npy("'|b1'", &format!("({base},)"), mask)));
    members
}

fn scale(asset: &Asset) -> Vec<u8> {
    let row = |axis: &str| {
        let words: Vec<f64> = asset
            .word(axis)
            .split(' ')
            .map(|word| word.parse().unwrap())
            .collect();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "vertices of a sample"
        )]
        [
            int(words[0] as usize),
            int(words[1] as usize),
            single(words[2]).to_le_bytes().to_vec(),
        ]
        .concat()
    };
    let rows = ["x_scale", "y_scale", "z_scale"].into_iter().flat_map(row);
    npy(
        "[('v1', '<i4'), ('v2', '<i4'), ('dist', '<f4')]",
        "(3,)",
        rows,
    )
}

fn head(asset: &Asset) -> Vec<u8> {
    let depth = asset.word("z_depth").parse::<usize>().unwrap_or(50);
    let width = if asset.rows.iter().all(|row| row.len() == 1) {
        1
    } else {
        3
    };
    let texts =
        ["name", "uuid", "author", "description", "basemesh"].map(|keyword| asset.word(keyword));
    let last = [asset.word("license"), asset.word("tag")];
    let field = |(at, text): (usize, &&str)| format!("('f{at}', '|S{}')", text.len().max(1));
    let first: Vec<String> = texts.iter().enumerate().map(field).collect();
    let rest: Vec<String> = last
        .iter()
        .enumerate()
        .map(|(at, text)| field((at + 8, text)))
        .collect();
    let integers = "('f5', '<i4'), ('f6', '<i4'), ('f7', '<i4')";
    let descr = format!("[{}, {integers}, {}]", first.join(", "), rest.join(", "));
    let numbers = [width, 110, depth].into_iter().flat_map(int);
    npy(
        &descr,
        "(1,)",
        padded(&texts)
            .into_iter()
            .chain(numbers)
            .chain(padded(&last)),
    )
}

fn texts(texts: &[&str]) -> Vec<u8> {
    let field = |(at, text): (usize, &&str)| format!("('f{at}', '|S{}')", text.len().max(1));
    let fields: Vec<String> = texts.iter().enumerate().map(field).collect();
    npy(
        &format!("[{}]", fields.join(", ")),
        "(1,)",
        padded(texts).into_iter(),
    )
}

/// `NumPy` has no texts of no length.
fn padded(texts: &[&str]) -> Vec<u8> {
    texts
        .iter()
        .flat_map(|text| {
            if text.is_empty() {
                vec![0]
            } else {
                text.as_bytes().to_vec()
            }
        })
        .collect()
}
