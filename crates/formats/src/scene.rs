//! `.mhscene` of MakeHuman 1: its lights, in pickles one behind the other
//! (`docs/loaders/makehuman1/scenes.md#values-of-a-scene`). And the lists of its libraries,
//! `cache/*.mhc`, which are pickles as well
//! (`docs/loaders/makehuman1/libraries.md#lists-of-libraries`).
//!
//! Gets bytes, returns what in them would run code, and what keeps them from being loaded.

use super::pickle::{self, COLOR, Danger, Fault, Heap, Node, Value};

/// A scene.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Scene {
    /// Instructions that import or call, in the pickles that are read.
    pub dangers: Vec<Danger>,
    /// What keeps it from being loaded.
    pub fault: Option<SceneFault>,
    /// Its lights.
    pub lights: usize,
}

/// Why a scene cannot be loaded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SceneFault {
    /// Its first byte is not that of a pickle, and nothing can be read of it.
    NoPickle,
    /// A pickle stops at a byte of the file.
    Pickle(usize, Fault),
    /// The file ends after so many pickles, before it has as many as it announces.
    Ends(usize, usize),
    /// Another version.
    Version(String),
    /// A value is not what it should be: what, what it should be, what it is.
    Value(String, &'static str, String),
}

/// The version of scenes.
const VERSION: i64 = 5;

/// What a light is made of, in its order.
const LIGHT: [(&str, Shape); 8] = [
    ("areaLightSize", Shape::Number),
    ("areaLights", Shape::Integer),
    ("attenuation", Shape::Number),
    ("color", Shape::Color),
    ("focus", Shape::Three),
    ("fov", Shape::Number),
    ("position", Shape::Three),
    ("specular", Shape::Color),
];

/// What a value has to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shape {
    Any,
    Integer,
    Number,
    Three,
    Color,
}

/// Reads a scene.
pub fn read(bytes: &[u8]) -> Scene {
    let mut scene = Scene::default();
    let mut reader = Reader {
        bytes,
        at: 0,
        count: 0,
        needed: 4,
        heap: Heap::default(),
        dangers: Vec::new(),
    };
    match reader.scene() {
        Ok(lights) => scene.lights = lights,
        Err(fault) => scene.fault = Some(fault),
    }
    scene.dangers = reader.dangers;
    // What stops behind an instruction that is never carried out here is not known.
    if !scene.dangers.is_empty() {
        scene.fault = None;
    }
    scene
}

struct Reader<'b> {
    bytes: &'b [u8],
    at: usize,
    /// Pickles so far, and how many there have to be.
    count: usize,
    needed: usize,
    heap: Heap,
    dangers: Vec<Danger>,
}

impl Reader<'_> {
    fn scene(&mut self) -> Result<usize, SceneFault> {
        let version = self.value("the version", Shape::Any)?;
        let number = self.number(version);
        if number != Some(VERSION as f64) {
            return Err(SceneFault::Version(self.words(version)));
        }
        self.value("ambience", Shape::Color)?;
        self.value("skybox", Shape::Any)?;
        let lights = self.value("the number of lights", Shape::Integer)?;
        let Node::Integer(lights) = *self.heap.get(lights) else {
            return Ok(0);
        };
        let lights = usize::try_from(lights).unwrap_or_default();
        self.needed = lights
            .saturating_mul(LIGHT.len())
            .saturating_add(self.needed);
        for light in 0..lights {
            // Of each light nothing is kept: there may be many.
            self.heap = Heap::default();
            for (name, shape) in LIGHT {
                self.value(&format!("{name} of light {}", light + 1), shape)?;
            }
        }
        Ok(lights)
    }

    /// The value of the next pickle. Behind one that imports or calls the walk goes on as far as it
    /// can, without values.
    fn value(&mut self, what: &str, shape: Shape) -> Result<Value, SceneFault> {
        if self.at >= self.bytes.len() {
            return Err(SceneFault::Ends(self.count, self.needed));
        }
        let walk = pickle::walk(
            self.bytes,
            self.at,
            |module, name| (module, name) == COLOR,
            false,
        );
        let found = walk.dangers.len();
        self.dangers.extend(walk.dangers);
        if found > 0 {
            return Err(self.walk_on(walk.end.ok()));
        }
        let run = pickle::run(self.bytes, self.at, &mut self.heap);
        // Protocol 0 has no mark at its beginning.
        let is_none = self.count == 0 && self.bytes.first() != Some(&0x80);
        let (value, next) = run.map_err(|(at, fault)| {
            if is_none {
                SceneFault::NoPickle
            } else {
                SceneFault::Pickle(at, fault)
            }
        })?;
        self.at = next;
        self.count += 1;
        match self.expected(value, shape) {
            None => Ok(value),
            Some(expected) => Err(SceneFault::Value(
                what.to_owned(),
                expected,
                self.words(value),
            )),
        }
    }

    /// Gathers what else imports or calls, so that all of it is told at once.
    fn walk_on(&mut self, mut next: Option<usize>) -> SceneFault {
        while let Some(at) = next.filter(|at| *at < self.bytes.len()) {
            let walk = pickle::walk(
                self.bytes,
                at,
                |module, name| (module, name) == COLOR,
                false,
            );
            self.dangers.extend(walk.dangers);
            next = walk.end.ok();
        }
        SceneFault::Ends(self.count, self.needed)
    }

    /// What a value should be, if it is not.
    fn expected(&self, value: Value, shape: Shape) -> Option<&'static str> {
        let (fits, words) = match shape {
            Shape::Any => (true, ""),
            Shape::Integer => (
                matches!(self.heap.get(value), Node::Integer(_)),
                "an integer",
            ),
            Shape::Number => (self.number(value).is_some(), "a number"),
            Shape::Three => (self.is_three(value), "a tuple of three numbers"),
            Shape::Color => (self.is_color(value), "a colour"),
        };
        (!fits).then_some(words)
    }

    fn number(&self, value: Value) -> Option<f64> {
        match *self.heap.get(value) {
            Node::Integer(number) => Some(number as f64),
            Node::Float(number) => Some(number),
            _ => None,
        }
    }

    fn is_three(&self, value: Value) -> bool {
        let (Node::Tuple(values) | Node::List(values)) = self.heap.get(value) else {
            return false;
        };
        values.len() == 3 && values.iter().all(|value| self.number(*value).is_some())
    }

    fn is_color(&self, value: Value) -> bool {
        match self.heap.get(value) {
            Node::Color(members) => members
                .iter()
                .all(|own| own.is_some_and(|own| self.number(own).is_some())),
            _ => self.is_three(value),
        }
    }

    /// A value in words.
    fn words(&self, value: Value) -> String {
        match self.heap.get(value) {
            Node::None => "nothing".to_owned(),
            Node::Integer(number) => number.to_string(),
            Node::Float(number) => number.to_string(),
            Node::Text(text) => format!("the text `{}`", text.chars().take(40).collect::<String>()),
            Node::Tuple(values) => format!("a tuple of {} values", values.len()),
            Node::List(values) => format!("a list of {} values", values.len()),
            Node::Dict(_) => "a dictionary".to_owned(),
            Node::Class => "the class of colours".to_owned(),
            Node::Color(_) => "a colour without all of its parts".to_owned(),
            Node::Other => "something else".to_owned(),
        }
    }
}

/// What the program can put into the lists of its libraries: plain values, sets of tags, the
/// licence of a pose, classes of its own module for them. To make one of these runs nothing of a
/// stranger. Up to protocol 1 Python calls a function of its own for each object, with its class
/// and the class of all.
fn is_plain(module: &str, name: &str) -> bool {
    let is_builtin = matches!(
        name,
        "set" | "frozenset" | "dict" | "list" | "tuple" | "object"
    );
    matches!(module, "builtins" | "__builtin__") && is_builtin
        || matches!(module, "copyreg" | "copy_reg") && name == "_reconstructor"
        || matches!(
            (module, name),
            ("collections", "OrderedDict") | ("makehuman", "LicenseInfo")
        )
        || matches!(module, "filecache" | "shared.filecache")
            && name.starts_with(|first: char| first.is_ascii_uppercase())
            && !name.contains('.')
}

/// Instructions in the list of a library that import or call something else. What is damaged in it
/// is made again.
pub fn dangers_of_list(bytes: &[u8]) -> Vec<Danger> {
    pickle::walk(bytes, 0, is_plain, true).dangers
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::pickle::Break;

    /// The scene of the example: one light.
    const EXAMPLE: &[u8] =
        include_bytes!("../../../fixtures/makehuman1/data/scenes/default.mhscene");
    /// Instructions that import or call, but for the class of colours.
    const CALLS: &[u8] = b"RiocPQ\x82\x83\x84\x92\x93";

    /// Where the instructions of a file begin.
    fn instructions(bytes: &[u8]) -> Vec<usize> {
        (0..bytes.len())
            .filter(|at| is_instruction(bytes, *at))
            .collect()
    }

    /// A file that is cut off there has read everything before.
    fn is_instruction(bytes: &[u8], at: usize) -> bool {
        let cut = read(&bytes[..at]).fault;
        let end = SceneFault::Pickle(at, Fault::Break(Break::Truncated));
        cut == Some(end) || matches!(cut, Some(SceneFault::Ends(..)))
    }

    #[test]
    fn the_example_has_a_light() {
        assert_eq!(
            read(EXAMPLE),
            Scene {
                lights: 1,
                ..Scene::default()
            }
        );
    }

    #[test]
    fn every_truncation_is_a_fault_and_nothing_worse() {
        for length in 0..EXAMPLE.len() {
            let scene = read(&EXAMPLE[..length]);
            assert!(
                scene.fault.is_some() && scene.dangers.is_empty(),
                "{length}"
            );
            assert_ne!(scene.fault, Some(SceneFault::NoPickle));
        }
    }

    #[test]
    fn every_change_of_one_instruction_is_judged() {
        let all = instructions(EXAMPLE);
        assert!(all.len() > 60, "{}", all.len());
        for at in all {
            for code in 0..=u8::MAX {
                let mut changed = EXAMPLE.to_vec();
                changed[at] = code;
                let scene = read(&changed);
                assert!(scene.dangers.is_empty() || scene.fault.is_none());
                // One whose argument goes beyond the file is cut off.
                let is_cut =
                    scene.fault == Some(SceneFault::Pickle(at, Fault::Break(Break::Truncated)));
                if CALLS.contains(&code) && EXAMPLE[at] != code && !is_cut {
                    assert!(
                        scene.dangers.iter().any(|danger| danger.offset == at),
                        "{at} {code:#04x}"
                    );
                }
            }
        }
    }

    #[test]
    fn values_that_are_shared_stay_small() {
        // A tuple of two times the tuple before, sixty times.
        let doubled = [b"K\x01q\x00".to_vec(), b"h\x00h\x00\x86q\x00".repeat(60)].concat();
        let bomb = [b"\x80\x02K\x05.\x80\x02".to_vec(), doubled, b".".to_vec()].concat();
        assert!(matches!(read(&bomb).fault, Some(SceneFault::Value(..))));
        // A dictionary of many members, given to a colour again and again.
        let members: Vec<u8> = (0..4000_u16)
            .flat_map(|at| [b'M', at.to_le_bytes()[0], at.to_le_bytes()[1], b'N'])
            .collect();
        let given = [
            b"cmaterial\nColor\n)\x81}(".to_vec(),
            members,
            b"uq\x01b".to_vec(),
            b"h\x01b".repeat(4000),
        ]
        .concat();
        let bomb = [b"\x80\x02K\x05.".to_vec(), given, b".".to_vec()].concat();
        assert!(matches!(
            read(&bomb).fault,
            Some(SceneFault::Pickle(_, Fault::Unbounded))
        ));
    }

    /// Each of these has a value for each of its bytes, or nearly.
    #[test]
    fn a_pickle_of_too_many_values_is_given_up() {
        for bytes in [b"N".as_slice(), b"N\x85", b"]", b"(", b"N0", b"N\x94"] {
            let large = [b"\x80\x02", &bytes.repeat(1 << 20)[..]].concat();
            let found = read(&large);
            assert!(
                matches!(
                    found.fault,
                    Some(SceneFault::Pickle(_, Fault::Unbounded | Fault::Break(_)))
                ),
                "{found:?}"
            );
            let unsafe_one = [&large[..], b"cos\nsystem\n."].concat();
            assert_eq!(
                read(&unsafe_one)
                    .dangers
                    .first()
                    .and_then(|one| one.import.as_deref()),
                Some("os.system")
            );
        }
    }

    #[test]
    fn lists_of_libraries_have_sets_and_nothing_else_to_call() {
        let named = |import: &str| {
            dangers_of_list(&[b"\x80\x02c", import.as_bytes(), b"\n](K\x01e\x85R."].concat()).len()
        };
        assert_eq!(named("__builtin__\nset"), 0);
        assert_eq!(named("builtins\nfrozenset"), 0);
        assert_eq!(named("builtins\neval"), 1);
        assert_eq!(named("os\nsystem"), 1);
        let of_stack = |module: &[u8], name: &[u8]| {
            let text = |text: &[u8]| [&[0x8c, u8::try_from(text.len()).unwrap()], text].concat();
            dangers_of_list(
                &[
                    b"\x80\x04".to_vec(),
                    text(module),
                    b"\x94".to_vec(),
                    text(name),
                    b"\x94\x93.".to_vec(),
                ]
                .concat(),
            )
        };
        assert_eq!(of_stack(b"builtins", b"set"), []);
        assert_eq!(
            of_stack(b"os", b"system")[0].import.as_deref(),
            Some("os.system")
        );
    }

    /// As Python 3 writes the list of a user's poses in each protocol.
    #[test]
    fn a_list_of_poses_has_licences() {
        let old = b"ccopy_reg\n_reconstructor\np0\n(cfilecache\nFileCache\np1\nc__builtin__\nobject\np2\nNtp3\nRp4\n(dp5\nV_cache\n\
            p7\n(dp8\nVa.bvh\np9\n(F1.5\nVa\np15\ng0\n(cmakehuman\nLicenseInfo\np17\ng2\nNtp18\nRp19\n(dp20\nVauthor\np21\nVAnn\np22\n\
            sV_keys\np28\n(lp29\ng21\nasV_customized\np30\nI00\nsbtp32\nssb.";
        assert_eq!(dangers_of_list(old), []);
        let binary =
            b"ccopy_reg\n_reconstructor\nq\x00(cmakehuman\nLicenseInfo\nq\x01c__builtin__\nobject\nq\x02Ntq\x03R}q\x04\
            X\x06\x00\x00\x00authorX\x03\x00\x00\x00Annsb.";
        assert_eq!(dangers_of_list(binary), []);
        let object =
            |class: &[u8]| [b"\x80\x02c", class, b"\n)\x81}U\x06authorU\x03Annsb."].concat();
        assert_eq!(dangers_of_list(&object(b"makehuman\nLicenseInfo")), []);
        for other in [
            &b"makehuman\nsys"[..],
            b"makehuman\nLicenseInfo.x",
            b"mh\nLicenseInfo",
            b"copyreg\n__newobj__",
        ] {
            assert_eq!(dangers_of_list(&object(other)).len(), 1);
        }
        let stacked = b"\x80\x04\x95\x20\0\0\0\0\0\0\0\x8c\x09makehuman\x94\x8c\x0bLicenseInfo\x94\x93\x94)\x81.";
        assert_eq!(dangers_of_list(stacked), []);
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
            let scene = read(&bytes);
            prop_assert!(scene.fault.is_some() || !scene.dangers.is_empty());
            dangers_of_list(&bytes);
        }

        #[test]
        fn any_change_of_the_example_is_read_or_refused(changes in proptest::collection::vec((0..EXAMPLE.len(), any::<u8>()), 1..6)) {
            let mut bytes = EXAMPLE.to_vec();
            changes.iter().for_each(|(at, byte)| bytes[*at] = *byte);
            let scene = read(&bytes);
            prop_assert!(scene.dangers.is_empty() || scene.fault.is_none());
        }
    }
}
