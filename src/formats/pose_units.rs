//! `body-poses.json` and `face-poses.json`: what poses and expressions are made of (formats/makehuman2.md §12).

use super::macro_json::text;
use crate::json::{Document, Member, Node};

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
    PoseUnits { units: document.root.effective_members().into_iter().map(unit).collect() }
}

fn unit(member: &Member) -> Unit {
    let node = &member.node;
    let turns = |key: &str| {
        let bones = node.get(key)?.effective_members().into_iter();
        Some(bones.map(|bone| Turn { bone: bone.key.clone(), fault: fault(&bone.node) }).collect())
    };
    Unit {
        name: member.key.clone(),
        bones: turns("bones"),
        reverse: turns("reverse"),
        partner: ["rsym", "lsym"].into_iter().find_map(|key| Some((key, text(node, key)?))),
    }
}

/// Nine numbers, or three rows of three.
fn fault(matrix: &Node) -> Option<TurnFault> {
    if !matrix.is_array() {
        return Some(TurnFault::NoList);
    }
    let rows = matrix.elements();
    let is_nested = rows.iter().any(Node::is_array);
    let cells: Vec<&Node> =
        if is_nested { rows.iter().flat_map(Node::elements).collect() } else { rows.iter().collect() };
    let numbers = cells.iter().filter_map(|cell| cell.as_python_number());
    let (known, finite) = numbers.fold((0, true), |(known, finite), one| (known + 1, finite && one.is_finite()));
    match cells.len() {
        NUMBERS if known < NUMBERS => Some(TurnFault::NotANumber),
        NUMBERS if !is_nested || rows.iter().all(|row| row.elements().len() == 3) => {
            (!finite).then_some(TurnFault::NonFinite)
        }
        count => Some(TurnFault::Count(count)),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::json::parse;

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
    fn units_know_their_halves_and_partners() {
        let units = of(r#"{"Rest": {}, "L": {"bones": {}, "rsym": "R"}, "N": {"reverse": {}}, "x": 5}"#).units;
        let told: Vec<_> = units.iter().map(|unit| (unit.bones.is_some(), unit.reverse.is_some())).collect();
        assert_eq!(told, [(false, false), (true, false), (false, true), (false, false)]);
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
