//! `body-poses.json` and `face-poses.json`: what poses and expressions are made of
//! (`docs/loaders/makehuman2/poses.md#pose-units`).

use super::macro_json::text;
use mhlint_json::{Document, Member, Node};

/// The file: units in file order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PoseUnits {
    /// The units.
    pub units: Vec<Unit>,
}

/// A unit.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Unit {
    /// Its name.
    pub name: String,
    /// What it turns; `None` without the key.
    pub bones: Option<Vec<Turn>>,
    /// What its negative half turns; `None` without the key.
    pub reverse: Option<Vec<Turn>>,
    /// The key and the name of its counterpart on the other side.
    pub partner: Option<(&'static str, String)>,
}

/// What a unit does to a bone.
#[derive(Debug, Clone, PartialEq)]
pub struct Turn {
    /// The bone.
    pub bone: String,
    /// What is wrong with its matrix, if anything is.
    pub fault: Option<TurnFault>,
    /// How far a matrix without a fault is from a rotation.
    pub bend: Bend,
}

/// How far a matrix M is from a rotation.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Bend {
    /// The largest entry of M·Mᵀ − 1, without its sign: rows that are too long or at no right
    /// angle.
    pub off: f64,
    /// Whether it swaps left and right: its determinant is below zero.
    pub mirrors: bool,
}

/// Why a matrix cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TurnFault {
    /// It is no list.
    NoList,
    /// It has another number of elements than nine.
    Count(usize),
    /// An element is no number.
    NotANumber,
    /// An element is NaN or infinite.
    NonFinite,
}

/// Numbers of a matrix.
const NUMBERS: usize = 9;

/// Takes what the loader would take.
pub fn read(document: &Document) -> PoseUnits {
    PoseUnits {
        units: document
            .root
            .effective_members()
            .into_iter()
            .map(unit)
            .collect(),
    }
}

fn unit(member: &Member) -> Unit {
    let node = &member.node;
    let turns = |key: &str| {
        let bones = node.get(key)?.effective_members().into_iter();
        let turn = |bone: &Member| {
            let (fault, bend) = match matrix(&bone.node) {
                Ok(matrix) => (None, bend(&matrix)),
                Err(fault) => (Some(fault), Bend::default()),
            };
            Turn {
                bone: bone.key.clone(),
                fault,
                bend,
            }
        };
        Some(bones.map(turn).collect())
    };
    Unit {
        name: member.key.clone(),
        bones: turns("bones"),
        reverse: turns("reverse"),
        partner: ["rsym", "lsym"]
            .into_iter()
            .find_map(|key| Some((key, text(node, key)?))),
    }
}

/// Nine numbers, or three rows of three.
fn matrix(node: &Node) -> Result<[[f64; 3]; 3], TurnFault> {
    if !node.is_array() {
        return Err(TurnFault::NoList);
    }
    let rows = node.elements();
    let is_nested = rows.iter().any(Node::is_array);
    let cells: Vec<&Node> = if is_nested {
        rows.iter().flat_map(Node::elements).collect()
    } else {
        rows.iter().collect()
    };
    let is_even = !is_nested || rows.iter().all(|row| row.elements().len() == 3);
    let count = cells.len();
    let numbers: Vec<f64> = cells
        .into_iter()
        .filter_map(Node::as_python_number)
        .collect();
    match <[f64; NUMBERS]>::try_from(numbers) {
        _ if count != NUMBERS => Err(TurnFault::Count(count)),
        Err(_) => Err(TurnFault::NotANumber),
        Ok(_) if !is_even => Err(TurnFault::Count(count)),
        Ok(numbers) if numbers.iter().any(|number| !number.is_finite()) => {
            Err(TurnFault::NonFinite)
        }
        Ok(all) => Ok([
            [all[0], all[1], all[2]],
            [all[3], all[4], all[5]],
            [all[6], all[7], all[8]],
        ]),
    }
}

fn bend(matrix: &[[f64; 3]; 3]) -> Bend {
    let [a, b, c] = matrix;
    let dot = |one: &[f64; 3], other: &[f64; 3]| {
        one.iter()
            .zip(other)
            .map(|(one, other)| one * other)
            .sum::<f64>()
    };
    let lengths = [a, b, c].map(|row| dot(row, row) - 1.0);
    let angles = [dot(a, b), dot(b, c), dot(c, a)];
    let off = lengths
        .into_iter()
        .chain(angles)
        .map(f64::abs)
        .fold(0.0, f64::max);
    let across = [
        b[1] * c[2] - b[2] * c[1],
        b[2] * c[0] - b[0] * c[2],
        b[0] * c[1] - b[1] * c[0],
    ];
    Bend {
        off,
        mirrors: dot(a, &across) < 0.0,
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    fn of(text: &str) -> PoseUnits {
        read(&parse(text.as_bytes()).unwrap())
    }

    #[test]
    fn a_matrix_has_nine_numbers_flat_or_in_rows() {
        let cases = [
            ("[1,0,0,0,1,0,0,0,1]", None),
            ("[[1,0,0],[0,1,0],[0,0,1]]", None),
            ("[1,0,0,0,1,0,0,0]", Some(TurnFault::Count(8))),
            ("[[1,0,0,0],[1,0],[0,0,1]]", Some(TurnFault::Count(9))),
            (r#"[1,0,0,0,1,0,0,0,"1"]"#, Some(TurnFault::NotANumber)),
            ("[1,0,0,0,1,0,0,0,1e999]", Some(TurnFault::NonFinite)),
            ("0", Some(TurnFault::NoList)),
        ];
        for (matrix, fault) in cases {
            let units = of(&format!(r#"{{"u": {{"bones": {{"b": {matrix}}}}}}}"#)).units;
            assert_eq!(units[0].bones.as_ref().unwrap()[0].fault, fault, "{matrix}");
        }
    }

    #[test]
    fn a_matrix_is_a_rotation_or_off_by_so_much() {
        for (matrix, off, mirrors) in [
            ("[0.8,-0.6,0,0.6,0.8,0,0,0,1]", 0.0, false),
            ("[1,0,0,0,1,0,0,0,-1]", 0.0, true),
            ("[2,0,0,0,1,0,0,0,1]", 3.0, false),
            ("[[1,0.5,0],[0,1,0],[0,0,1]]", 0.5, false),
            ("[0,0,0,0,0,0,0,0,0]", 1.0, false),
            ("[1,0]", 0.0, false),
        ] {
            let units = of(&format!(r#"{{"u": {{"bones": {{"b": {matrix}}}}}}}"#)).units;
            let bend = units[0].bones.as_ref().unwrap()[0].bend;
            assert!(
                (bend.off - off).abs() < 1e-12 && bend.mirrors == mirrors,
                "{matrix}: {bend:?}"
            );
        }
    }

    #[test]
    fn units_know_their_halves_and_partners() {
        let units =
            of(r#"{"Rest": {}, "L": {"bones": {}, "rsym": "R"}, "N": {"reverse": {}}, "x": 5}"#)
                .units;
        let told: Vec<_> = units
            .iter()
            .map(|unit| (unit.bones.is_some(), unit.reverse.is_some()))
            .collect();
        assert_eq!(
            told,
            [(false, false), (true, false), (false, true), (false, false)]
        );
        assert_eq!(units[1].partner, Some(("rsym", "R".to_owned())));
    }

    proptest! {
        #[test]
        fn no_json_stops_the_reader(text in r#"[\[\]{},:"0-9a-c ]{0,40}"#) {
            let text = format!(r#"{{"u": {{"bones": {{"b": {text}}}, "reverse": {text}}}}}"#);
            if let Ok(document) = parse(text.as_bytes()) {
                prop_assert!(read(&document).units.len() <= 1);
            }
        }
    }
}
