//! UV layers of MPFB, `uv_layers/*.json.gz`: face to loop to texture coordinates
//! (`docs/loaders/mpfb/materials.md#grammar-of-uv-layers`).

use super::json_file::JsonFault;
use super::packed_json::text_fault;
use super::python_int;
use mhlint_json::{Reader, SyntaxFault};
use mhlint_source::Encoding;

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct UvLayer {
    /// Why it is no JSON.
    pub fault: Option<JsonFault>,
    /// The first that stops the loader, and how much does.
    pub stop: Option<(Stop, usize)>,
    /// How many faces it has.
    pub faces: usize,
    /// All loops, in ascending order.
    pub loops: Vec<i64>,
    /// The highest loop, and its face.
    pub highest: Option<(i64, String)>,
    /// The lowest one, and its face.
    pub lowest: Option<(i64, String)>,
    /// Faces with loops of several faces of four corners.
    pub mixed: Found,
    /// Faces with the loops of one other face.
    pub elsewhere: Found,
    /// Loops with a coordinate outside 0 to 1.
    pub outside: Found,
    /// Loops with NaN or infinity.
    pub non_finite: Found,
}

/// What stops the loader.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stop {
    /// The face, if it is not the whole.
    pub face: Option<String>,
    /// The loop, if it is not the face.
    pub corner: Option<String>,
    /// What is wrong with it.
    pub why: StopWhy,
}

/// What is wrong where the loader stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopWhy {
    /// It is of this type and not an object.
    NotObject(&'static str),
    /// The name of a loop is not a whole number.
    Name,
    /// It is of this type and not a list.
    NotList(&'static str),
    /// It is a list of another length than two.
    Length(usize),
    /// It is a list with something that is not a number.
    NotNumbers,
}

/// What has a fault in common: how much there is, and the face of the first.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Found {
    /// How many.
    pub count: usize,
    /// The face of the first one.
    pub first: Option<String>,
}

/// Loops that are kept. The base mesh has a hundredth of it.
const MOST: usize = 8_000_000;
/// Corners of every face of the base mesh.
const CORNERS: i64 = 4;

type Step<T> = Result<T, SyntaxFault>;

/// Reads all faces.
pub fn read(text: &[u8], encoding: &Encoding) -> UvLayer {
    let mut layer = UvLayer {
        fault: text_fault(text, encoding),
        ..UvLayer::default()
    };
    if layer.fault.is_none() {
        layer.fault = layer
            .file(&mut Reader::new(text))
            .err()
            .map(JsonFault::Syntax);
    }
    layer.loops.sort_unstable();
    layer
}

impl UvLayer {
    /// How many loops the mesh does not have: those from `count` on, and those before `-count`,
    /// which count from the end.
    pub fn beyond(&self, count: i64) -> usize {
        let below = self.loops.partition_point(|one| *one < -count);
        self.loops.len() - self.loops.partition_point(|one| *one < count) + below
    }

    /// How many loops are negative.
    pub fn negative(&self) -> usize {
        self.loops.partition_point(|one| *one < 0)
    }

    /// How often a loop occurs that occurred before, and the first of these.
    pub fn repeated(&self) -> Option<(i64, usize)> {
        let again = self.loops.windows(2).filter_map(|pair| match pair {
            [one, other] if one == other => Some(*one),
            _ => None,
        });
        let first = again.clone().next()?;
        Some((first, again.count()))
    }

    fn file(&mut self, reader: &mut Reader<'_>) -> Step<()> {
        if let Some(found) = other(reader, b'{')? {
            self.stop(None, None, StopWhy::NotObject(found));
            return reader.finish();
        }
        reader.open()?;
        while reader.more(b'}')? {
            let (face, _) = reader.key()?;
            self.face(reader, &face)?;
        }
        reader.finish()
    }

    fn stop(&mut self, face: Option<&str>, corner: Option<&str>, why: StopWhy) {
        let stop = || Stop {
            face: face.map(str::to_owned),
            corner: corner.map(str::to_owned),
            why,
        };
        self.stop.get_or_insert_with(|| (stop(), 0)).1 += 1;
    }

    fn face(&mut self, reader: &mut Reader<'_>, face: &str) -> Step<()> {
        self.faces += 1;
        if let Some(found) = other(reader, b'{')? {
            self.stop(Some(face), None, StopWhy::NotObject(found));
            return Ok(());
        }
        let mut own: Option<(i64, i64)> = None;
        reader.open()?;
        while reader.more(b'}')? {
            let (name, _) = reader.key()?;
            if let Some(number) = python_int(name.trim().as_bytes()) {
                own = Some(own.map_or((number, number), |(low, high)| {
                    (low.min(number), high.max(number))
                }));
                self.take(face, number);
            } else {
                self.stop(Some(face), Some(&name), StopWhy::Name);
            }
            self.coordinates(reader, face, &name)?;
        }
        let Some((low, high)) = own else {
            return Ok(());
        };
        let quad = low.div_euclid(CORNERS);
        if quad != high.div_euclid(CORNERS) {
            self.mixed.add(face);
        } else if python_int(face.trim().as_bytes()) != Some(quad) {
            self.elsewhere.add(face);
        }
        Ok(())
    }

    fn take(&mut self, face: &str, number: i64) {
        if self.loops.len() < MOST {
            self.loops.push(number);
        }
        if self
            .highest
            .as_ref()
            .is_none_or(|(highest, _)| number > *highest)
        {
            self.highest = Some((number, face.to_owned()));
        }
        if self
            .lowest
            .as_ref()
            .is_none_or(|(lowest, _)| number < *lowest)
        {
            self.lowest = Some((number, face.to_owned()));
        }
    }

    /// Two numbers; anything else stops the loader.
    fn coordinates(&mut self, reader: &mut Reader<'_>, face: &str, name: &str) -> Step<()> {
        if let Some(found) = other(reader, b'[')? {
            self.stop(Some(face), Some(name), StopWhy::NotList(found));
            return Ok(());
        }
        reader.open()?;
        let (mut numbers, mut length, mut is_number) = ([0.0; 2], 0, true);
        while reader.more(b']')? {
            let number = number(reader)?;
            is_number &= number.is_some();
            if let Some((slot, number)) = numbers.get_mut(length).zip(number) {
                *slot = number;
            }
            length += 1;
        }
        match (length, is_number) {
            (2, true) if numbers.iter().all(|one| (0.0..=1.0).contains(one)) => {}
            (2, true) if numbers.iter().all(|one| one.is_finite()) => self.outside.add(face),
            (2, true) => self.non_finite.add(face),
            (2, false) => self.stop(Some(face), Some(name), StopWhy::NotNumbers),
            (length, _) => self.stop(Some(face), Some(name), StopWhy::Length(length)),
        }
        Ok(())
    }
}

/// Reads past a value that does not begin so, and says what it is.
fn other(reader: &mut Reader<'_>, begin: u8) -> Step<Option<&'static str>> {
    let found = match reader.peek() {
        Some(byte) if byte == begin => return Ok(None),
        Some(b'{') => "an object",
        Some(b'[') => "a list",
        Some(b'"') => "a string",
        Some(b'n') => "null",
        Some(b't' | b'f') => "true or false",
        _ => "a number",
    };
    reader.pass()?;
    Ok(Some(found))
}

/// A number, or nothing for any other value.
fn number(reader: &mut Reader<'_>) -> Step<Option<f64>> {
    if matches!(reader.peek(), Some(b'-' | b'0'..=b'9' | b'N' | b'I')) {
        return Ok(reader.number()?.map(|(number, _)| number));
    }
    // Blender takes these for numbers.
    if reader.literal("true") {
        return Ok(Some(1.0));
    }
    if reader.literal("false") {
        return Ok(Some(0.0));
    }
    reader.pass()?;
    Ok(None)
}

impl Found {
    fn add(&mut self, face: &str) {
        self.count += 1;
        self.first.get_or_insert_with(|| face.to_owned());
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn of(text: &str) -> UvLayer {
        read(text.as_bytes(), &Encoding::of(text.as_bytes()))
    }

    #[test]
    fn loops_of_faces_have_two_numbers() {
        let layer = of(
            r#"{"0": {"0": [0, 1], "1": [0.5, 0.5]}, "2": {"8": [0, 0], "11": [1, 1.5]}, "3": {}}"#,
        );
        assert_eq!(
            (layer.faces, layer.loops.as_slice(), layer.fault.as_ref()),
            (3, [0, 1, 8, 11].as_slice(), None)
        );
        assert_eq!(
            (layer.highest.as_ref().unwrap().0, layer.outside.count),
            (11, 1)
        );
        assert_eq!(
            (
                layer.beyond(11),
                layer.beyond(12),
                layer.negative(),
                layer.repeated()
            ),
            (1, 0, 0, None)
        );
        assert_eq!(
            (layer.mixed.count, layer.elsewhere.count, layer.stop),
            (0, 0, None)
        );
    }

    #[test]
    fn what_stops_the_loader_is_noted() {
        let stop = |text: &str| of(text).stop.map(|(stop, count)| (stop.why, count));
        assert_eq!(stop("[]"), Some((StopWhy::NotObject("a list"), 1)));
        assert_eq!(
            stop(r#"{"0": [1], "1": null}"#),
            Some((StopWhy::NotObject("a list"), 2))
        );
        for (value, why) in [
            ("[0]", Some(StopWhy::Length(1))),
            ("[0, \"1\"]", Some(StopWhy::NotNumbers)),
            ("[0, 0, \"1\"]", Some(StopWhy::Length(3))),
            ("5", Some(StopWhy::NotList("a number"))),
            ("[true, NaN]", None),
        ] {
            let found = of(&format!(r#"{{"0": {{"3": {value}}}}}"#)).stop;
            assert_eq!(
                found.map(|(stop, _)| (stop.corner, stop.why)),
                why.map(|why| (Some("3".to_owned()), why))
            );
        }
        assert_eq!(stop(r#"{"0": {"a": [0, 0]}}"#), Some((StopWhy::Name, 1)));
        assert!(of("{\"0\": ").fault.is_some());
        assert!(of("\u{feff}{}").fault.is_some());
    }

    #[test]
    fn loops_belong_to_one_face() {
        let layer = of(
            r#"{"0": {"3": [0, 0], "4": [0, 0]}, "1": {"8": [0, 0]}, "2": {"8": [NaN, 0], "-1": [0, 0]}}"#,
        );
        assert_eq!(
            (
                layer.mixed.count,
                layer.elsewhere.count,
                layer.non_finite.count
            ),
            (2, 1, 1)
        );
        assert_eq!(
            (layer.repeated(), layer.negative(), layer.beyond(1)),
            (Some((8, 1)), 1, 4)
        );
    }

    proptest! {
        #[test]
        fn no_text_stops_the_reader(text in "[\\[\\]{},0-9\":. -]{0,40}") {
            of(&text);
        }
    }
}
