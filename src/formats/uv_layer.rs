//! UV layers of MPFB, `uv_layers/*.json.gz`: face to loop to texture coordinates (formats/mpfb.md §24.3).

use super::json_file::JsonFault;
use super::packed_json::{skip, text_fault};
use super::python_int;
use super::unfit::{NamedAt, Unfits, Why, below};
use crate::json::{Reader, SyntaxFault};
use crate::source::Encoding;

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct UvLayer {
    /// Why it is no JSON.
    pub fault: Option<JsonFault>,
    /// What stops the loader.
    pub stops: Unfits,
    /// How many faces it has.
    pub faces: usize,
    /// All loops, in ascending order.
    pub loops: Vec<i64>,
    /// The highest loop, and where it stands.
    pub highest: Option<(i64, String)>,
    /// The lowest one.
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

/// What has a fault in common: how much there is, and the first of it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Found {
    /// How many.
    pub count: usize,
    /// The first one.
    pub first: Option<NamedAt>,
}

/// Loops that are kept. The base mesh has a hundredth of it.
const MOST: usize = 8_000_000;
/// Corners of every face of the base mesh.
const CORNERS: i64 = 4;

type Step<T> = Result<T, SyntaxFault>;

/// Reads all faces.
pub fn read(text: &[u8], encoding: &Encoding) -> UvLayer {
    let mut layer = UvLayer { fault: text_fault(text, encoding), ..UvLayer::default() };
    if layer.fault.is_none() {
        layer.fault = layer.file(&mut Reader::new(text)).err().map(JsonFault::Syntax);
    }
    layer.loops.sort_unstable();
    layer
}

impl UvLayer {
    /// How many loops the mesh does not have: those from `count` on, and those before `-count`, which count from the end.
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
        if self.is_other(reader, "", b'{', "an object")? {
            return reader.finish();
        }
        reader.open()?;
        while reader.more(b'}')? {
            let (face, _) = reader.key()?;
            self.face(reader, &face)?;
        }
        reader.finish()
    }

    /// Reads past a value that does not begin so, and notes it.
    fn is_other(&mut self, reader: &mut Reader<'_>, pointer: &str, begin: u8, wanted: &'static str) -> Step<bool> {
        let found = match reader.peek() {
            Some(byte) if byte == begin => return Ok(false),
            Some(b'{') => "an object",
            Some(b'[') => "a list",
            Some(b'"') => "a string",
            Some(b'n') => "null",
            Some(b't' | b'f') => "true or false",
            _ => "a number",
        };
        skip(reader)?;
        self.stops.add(pointer, Why::Type { found, wanted });
        Ok(true)
    }

    fn face(&mut self, reader: &mut Reader<'_>, face: &str) -> Step<()> {
        self.faces += 1;
        let pointer = below("", face);
        if self.is_other(reader, &pointer, b'{', "an object of loops")? {
            return Ok(());
        }
        let mut own: Option<(i64, i64)> = None;
        reader.open()?;
        while reader.more(b'}')? {
            let (key, _) = reader.key()?;
            let number = python_int(key.trim().as_bytes());
            self.corner(reader, &pointer, face, &key, number)?;
            own = number.map(|one| own.map_or((one, one), |(low, high)| (low.min(one), high.max(one)))).or(own);
        }
        let Some((low, high)) = own else { return Ok(()) };
        let quad = low.div_euclid(CORNERS);
        if quad != high.div_euclid(CORNERS) {
            self.mixed.add(&pointer, face);
        } else if python_int(face.trim().as_bytes()) != Some(quad) {
            self.elsewhere.add(&pointer, face);
        }
        Ok(())
    }

    fn corner(
        &mut self,
        reader: &mut Reader<'_>,
        face_at: &str,
        face: &str,
        key: &str,
        number: Option<i64>,
    ) -> Step<()> {
        match number {
            Some(number) => self.take(face_at, key, number),
            None => self.stops.add(&below(face_at, key), Why::Unknown(key.to_owned())),
        }
        let Some(uv) = self.pair(reader, face_at, key)? else { return Ok(()) };
        if !uv.iter().all(|one| one.is_finite()) {
            self.non_finite.add(&below(face_at, key), face);
        } else if !uv.iter().all(|one| (0.0..=1.0).contains(one)) {
            self.outside.add(&below(face_at, key), face);
        }
        Ok(())
    }

    fn take(&mut self, face_at: &str, key: &str, number: i64) {
        if self.loops.len() < MOST {
            self.loops.push(number);
        }
        let at = || (number, below(face_at, key));
        if self.highest.as_ref().is_none_or(|(highest, _)| number > *highest) {
            self.highest = Some(at());
        }
        if self.lowest.as_ref().is_none_or(|(lowest, _)| number < *lowest) {
            self.lowest = Some(at());
        }
    }

    /// Two numbers; anything else is noted.
    fn pair(&mut self, reader: &mut Reader<'_>, face_at: &str, key: &str) -> Step<Option<[f64; 2]>> {
        if reader.peek() != Some(b'[') {
            let pointer = below(face_at, key);
            self.is_other(reader, &pointer, b'[', "a list of two numbers")?;
            return Ok(None);
        }
        reader.open()?;
        let (mut numbers, mut length, mut is_number) = ([0.0; 2], 0, true);
        while reader.more(b']')? {
            let number = match reader.peek() {
                Some(b'-' | b'0'..=b'9' | b'N' | b'I') => reader.number()?,
                _ if reader.literal("true") => Some((1.0, false)),
                _ if reader.literal("false") => Some((0.0, false)),
                _ => {
                    skip(reader)?;
                    None
                }
            };
            is_number &= number.is_some();
            if let Some((slot, (number, _))) = numbers.get_mut(length).zip(number) {
                *slot = number;
            }
            length += 1;
        }
        if is_number && length == 2 {
            return Ok(Some(numbers));
        }
        let why = match length {
            2 => Why::Type { found: "a list with something else", wanted: "a list of two numbers" },
            length => Why::Length(length, 2),
        };
        self.stops.add(&below(face_at, key), why);
        Ok(None)
    }
}

impl Found {
    fn add(&mut self, pointer: &str, name: &str) {
        self.count += 1;
        self.first.get_or_insert_with(|| NamedAt::new(pointer, name));
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
        let layer = of(r#"{"0": {"0": [0, 1], "1": [0.5, 0.5]}, "2": {"8": [0, 0], "11": [1, 1.5]}, "3": {}}"#);
        assert_eq!((layer.faces, layer.loops.as_slice(), layer.fault.as_ref()), (3, [0, 1, 8, 11].as_slice(), None));
        assert_eq!((layer.highest.as_ref().unwrap().0, layer.outside.count), (11, 1));
        assert_eq!((layer.beyond(11), layer.beyond(12), layer.negative(), layer.repeated()), (1, 0, 0, None));
        assert_eq!((layer.mixed.count, layer.elsewhere.count, layer.stops.all().len()), (0, 0, 0));
    }

    #[test]
    fn what_stops_the_loader_is_noted() {
        let pointers = |text: &str| of(text).stops.all().iter().map(|one| one.pointer.clone()).collect::<Vec<_>>();
        assert_eq!(pointers("[]"), [""]);
        assert_eq!(pointers(r#"{"0": [1], "1": null}"#), ["/0", "/1"]);
        assert_eq!(
            pointers(r#"{"0": {"a": [0, 0], "0": [0], "1": [0, "1"], "2": 5, "3": [0, 0, 0]}}"#),
            ["/0/a", "/0/0", "/0/1", "/0/2", "/0/3"]
        );
        assert!(of("{\"0\": ").fault.is_some());
        assert!(of("\u{feff}{}").fault.is_some());
    }

    #[test]
    fn loops_belong_to_one_face() {
        let layer = of(r#"{"0": {"3": [0, 0], "4": [0, 0]}, "1": {"8": [0, 0]}, "2": {"8": [NaN, 0], "-1": [0, 0]}}"#);
        assert_eq!((layer.mixed.count, layer.elsewhere.count, layer.non_finite.count), (2, 1, 1));
        assert_eq!((layer.repeated(), layer.negative(), layer.beyond(1)), (Some((8, 1)), 1, 4));
    }

    proptest! {
        #[test]
        fn no_text_stops_the_reader(text in "[\\[\\]{},0-9\":. -]{0,40}") {
            of(&text);
        }
    }
}
