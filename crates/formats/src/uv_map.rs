//! `.mhuv` of `MakeHuman` 1: texture coordinates for a mesh, face by face
//! (`docs/loaders/makehuman1/materials.md#uv-maps`).

use super::fields::fields;
use super::{python_float, python_int};
use mhlint_source::lines;

/// What is counted of a map.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct UvMap {
    /// Texture coordinates.
    pub uvs: usize,
    /// Faces.
    pub faces: usize,
    /// Corners of the first face.
    pub corners: usize,
    /// The first line with a fault, and the fault.
    pub fault: Option<(u32, UvFault)>,
}

/// What the application stumbles over.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum UvFault {
    /// A corner without `/` and the number of a texture coordinate, as it is written.
    NoUv(Box<str>),
    /// A face with as many corners, unlike the first.
    Ragged(usize),
    /// A number for which there is no texture coordinate.
    OutOfRange(i64),
    /// A texture coordinate that is not two numbers.
    NotTwoNumbers,
}

/// Reads all lines; others than `vt` and `f` say nothing.
pub fn read(text: &[u8]) -> UvMap {
    let mut map = UvMap::default();
    let mut highest = None;
    for (number, (_, line)) in (1..).zip(lines(text)) {
        let words = fields(line);
        match words.split_first() {
            Some(((_, b"vt"), numbers)) => {
                map.uvs += 1;
                let is_sound = numbers.len() > 1
                    && numbers
                        .iter()
                        .take(2)
                        .all(|(_, word)| python_float(word).is_some());
                if map.fault.is_none() && !is_sound {
                    map.fault = Some((number, UvFault::NotTwoNumbers));
                }
            }
            Some(((_, b"f"), corners)) => {
                map.faces += 1;
                if map.faces == 1 {
                    map.corners = corners.len();
                }
                let fault = face(corners, map.corners, number, &mut highest);
                map.fault = map
                    .fault
                    .take()
                    .or_else(|| fault.map(|fault| (number, fault)));
            }
            _ => {}
        }
    }
    if map.fault.is_none() {
        let beyond = highest
            .filter(|(number, _)| usize::try_from(*number).is_ok_and(|number| number > map.uvs));
        map.fault = beyond.map(|(number, line)| (line, UvFault::OutOfRange(number)));
    }
    map
}

/// What is wrong with a face by itself; the highest number is noted with its line.
fn face(
    corners: &[(usize, &[u8])],
    expected: usize,
    line: u32,
    highest: &mut Option<(i64, u32)>,
) -> Option<UvFault> {
    for (_, corner) in corners {
        let uv = corner
            .split(|byte| *byte == b'/')
            .nth(1)
            .and_then(python_int);
        let Some(uv) = uv else {
            return Some(UvFault::NoUv(String::from_utf8_lossy(corner).into()));
        };
        if highest.is_none_or(|(most, _)| uv > most) {
            *highest = Some((uv, line));
        }
    }
    (corners.len() != expected).then_some(UvFault::Ragged(corners.len()))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn faults_are_found_with_their_lines() {
        let uvs = "# no\nvt 0 0\nvt 1 0\nvt 1 1\n";
        let read = |faces: &str| read(format!("{uvs}{faces}").as_bytes());
        let sound = read("f 9/1 9/2/7 9/3\ng x\nf 1/3 2/2 3/1\n");
        assert_eq!(
            (sound.uvs, sound.faces, sound.corners, sound.fault),
            (3, 2, 3, None)
        );
        for (faces, fault) in [
            ("f 1/1 2/2 3\n", (5, UvFault::NoUv("3".into()))),
            ("f 1/1 2/2 3//4\n", (5, UvFault::NoUv("3//4".into()))),
            ("f 1/1 2/2 3/3\nf 1/1 2/2\n", (6, UvFault::Ragged(2))),
            (
                "f 1/1 2/2 3/3\nf 1/1 2/4 3/3\n",
                (6, UvFault::OutOfRange(4)),
            ),
            ("vt 0,5 1\nf 1/1 2/2 3/9\n", (5, UvFault::NotTwoNumbers)),
            ("vt 0.5\n", (5, UvFault::NotTwoNumbers)),
        ] {
            assert_eq!(read(faces).fault, Some(fault), "{faces}");
        }
        assert_eq!(super::read(b""), UvMap::default());
    }

    proptest! {
        #[test]
        fn hostile_bytes_are_read(text in proptest::collection::vec(any::<u8>(), 0..200)) {
            let map = read(&text);
            prop_assert!(map.uvs + map.faces <= text.len());
        }
    }
}
