//! `.bvh`: a pose or a motion, line by line as MakeHuman 2 reads it
//! (`docs/loaders/makehuman2/poses.md#bvh`).
//!
//! Every line begins with the one keyword that is expected there, or with one of few; the loader
//! stops at the first line that does not. A byte order mark is looked through: it has a finding of
//! its own. What is behind the announced frames is passed over.

pub mod blender;

use std::ops::Range;

use crate::bvh::blender::ImportedMotion;
use crate::fields::fields;
use crate::number::{python_float, python_int};
use mhlint_diag::{EXAMPLES, Evidence};
use mhlint_source::{BYTE_ORDER_MARK, lines};

/// The file, as far as the loader gets.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Motion {
    /// Joints in file order, the root first. End sites are none.
    pub joints: Vec<Joint>,
    /// Channels whose names mean nothing: their numbers are read and not used.
    pub unknown_channels: Lines,
    /// The first of their names.
    pub first_unknown: Option<Box<str>>,
    /// How many channels all joints have.
    pub channels: usize,
    /// The first line at which the loader stops, and why.
    pub fault: Option<Fault>,
    /// `Frames` as it is written, if it is a whole number, and its line.
    pub frames: Option<(Box<str>, u32)>,
    /// The line of a `Frame Time` of 0.
    pub timeless: Option<u32>,
    /// Frames that there are.
    pub frames_there: usize,
    /// How many of them are behind the announced ones.
    pub surplus_frames: usize,
    /// Frames with more numbers than there are channels.
    pub surplus_numbers: Lines,
    /// Frames with NaN or infinity.
    pub non_finite: Lines,
    /// The same as an importer reads it that is less strict.
    pub imported: ImportedMotion,
}

/// A joint.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Joint {
    /// The first word of its name.
    pub name: Box<str>,
    /// Where that word stands, in bytes.
    pub span: Range<usize>,
}

/// Lines that have a fault in common.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Lines {
    /// How many.
    pub count: usize,
    /// The first few.
    pub first: Vec<u32>,
}

/// What stops the loader.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The line; the last one at the end of the file.
    pub line: u32,
    /// Whether the hierarchy has begun.
    pub is_inside: bool,
    /// Why.
    pub kind: FaultKind,
}

/// Why the loader stops.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FaultKind {
    /// Another word than those that may stand here.
    Expected(&'static str, Box<str>),
    /// A line without a word.
    Blank(&'static str),
    /// The end of the file.
    End(&'static str),
    /// A joint without a name.
    NoName,
    /// A word too few on a line.
    Missing(&'static str),
    /// A word that is not a number.
    NotANumber(&'static str, Box<str>),
    /// A number of channels that is not a whole number.
    ChannelsNotWhole(Box<str>),
    /// A joint without channels.
    NoChannels,
    /// Another number of channels than announced: announced, listed.
    Channels(i64, usize),
    /// `Frames` is not a whole number.
    NotWhole(Box<str>),
    /// `Frames` is 0 or less.
    NoFrames(i64),
    /// Fewer frames than announced.
    TooFew,
    /// A frame that is a blank line.
    BlankFrame,
    /// A frame with fewer numbers than channels: there, needed.
    ShortFrame(usize, usize),
    /// A word in a frame that is not a number.
    WordInFrame(Box<str>),
}

/// The names of channels that mean something.
const CHANNELS: [&[u8]; 6] = [
    b"Xposition",
    b"Yposition",
    b"Zposition",
    b"Xrotation",
    b"Yrotation",
    b"Zrotation",
];

type Words<'t> = Vec<(usize, &'t [u8])>;

struct Reader<'t, L> {
    lines: L,
    /// Number of the line that was read last, from 1, and its first byte.
    line: u32,
    start: usize,
    words: Words<'t>,
    /// Whether the number of each channel is used: rotations, and the places of the root.
    used: Vec<bool>,
    motion: Motion,
}

/// Reads a file up to the first fault. Costs what is announced or what is there, whichever is less.
pub fn read(text: &[u8]) -> Motion {
    let mut reader = Reader {
        lines: lines(text),
        line: 0,
        start: 0,
        words: Vec::new(),
        used: Vec::new(),
        motion: Motion::default(),
    };
    if let Err(kind) = reader.file() {
        let is_inside = !reader.motion.joints.is_empty();
        // Behind the last line there is nothing to show.
        let is_end = matches!(kind, FaultKind::End(_) | FaultKind::TooFew);
        reader.motion.fault = Some(Fault {
            line: reader.line.saturating_sub(u32::from(is_end)).max(1),
            is_inside,
            kind,
        });
    }
    Motion {
        imported: blender::read(text),
        ..reader.motion
    }
}

impl<'t, L: Iterator<Item = (Range<usize>, &'t [u8])>> Reader<'t, L> {
    fn file(&mut self) -> Result<(), FaultKind> {
        self.keyword("`HIERARCHY`", &["HIERARCHY"])?;
        self.keyword("`ROOT`", &["ROOT"])?;
        self.joint()?;
        let mut open = 1_usize;
        while open > 0 {
            match self.keyword("`JOINT`, `End Site` or `}`", &["JOINT", "End", "}"])? {
                "JOINT" => {
                    self.joint()?;
                    open += 1;
                }
                "End" => self.end_site()?,
                _ => open -= 1,
            }
        }
        self.keyword("`MOTION`", &["MOTION"])?;
        let frames = self.frame_count()?;
        self.keyword("`Frame Time:`", &["Frame"])?;
        let time = self.number(2, "`Frame Time:`")?;
        self.motion.timeless = (time == 0.0).then_some(self.line);
        self.frames(frames)
    }

    /// Reads the next line; whether there is one.
    fn next(&mut self) -> bool {
        self.line += 1;
        let next = self.lines.next();
        let is_there = next.is_some();
        if let Some((range, line)) = next {
            let unmarked = if self.line == 1 {
                line.strip_prefix(BYTE_ORDER_MARK)
            } else {
                None
            };
            self.start = range.start + line.len() - unmarked.unwrap_or(line).len();
            self.words = fields(unmarked.unwrap_or(line));
        }
        is_there
    }

    /// Reads the next line, which begins with one of these words.
    fn keyword(
        &mut self,
        expected: &'static str,
        words: &[&'static str],
    ) -> Result<&'static str, FaultKind> {
        if !self.next() {
            return Err(FaultKind::End(expected));
        }
        let Some((_, first)) = self.words.first() else {
            return Err(FaultKind::Blank(expected));
        };
        let found = words.iter().find(|word| word.as_bytes() == *first);
        found
            .copied()
            .ok_or_else(|| FaultKind::Expected(expected, text(first)))
    }

    /// A word of the line, as a number.
    fn number(&self, at: usize, of: &'static str) -> Result<f64, FaultKind> {
        let (_, word) = self.words.get(at).ok_or(FaultKind::Missing(of))?;
        python_float(word).ok_or_else(|| FaultKind::NotANumber(of, text(word)))
    }

    /// The name of a joint, which its line has already, and what is between its braces in front of
    /// other joints.
    fn joint(&mut self) -> Result<(), FaultKind> {
        let (at, name) = *self.words.get(1).ok_or(FaultKind::NoName)?;
        let at = self.start + at;
        self.motion.joints.push(Joint {
            name: String::from_utf8_lossy(name).into(),
            span: at..at + name.len(),
        });
        self.keyword("`{`", &["{"])?;
        self.offset()?;
        self.keyword("`CHANNELS`", &["CHANNELS"])?;
        self.channels()
    }

    fn offset(&mut self) -> Result<(), FaultKind> {
        self.keyword("`OFFSET`", &["OFFSET"])?;
        (1..=3).try_for_each(|at| self.number(at, "`OFFSET`").map(|_| ()))
    }

    fn channels(&mut self) -> Result<(), FaultKind> {
        let (_, word) = *self.words.get(1).ok_or(FaultKind::Missing("`CHANNELS`"))?;
        let announced = python_int(word).ok_or_else(|| FaultKind::ChannelsNotWhole(text(word)))?;
        let listed = self.words.get(2..).unwrap_or_default();
        match usize::try_from(announced) {
            Ok(0) => return Err(FaultKind::NoChannels),
            Ok(count) if count == listed.len() => {}
            _ => return Err(FaultKind::Channels(announced, listed.len())),
        }
        let is_root = self.motion.joints.len() == 1;
        for (_, name) in listed {
            let is_known = CHANNELS.contains(name);
            self.used
                .push(is_known && (is_root || name.ends_with(b"rotation")));
            if !is_known {
                self.motion.unknown_channels.add(self.line);
                self.motion.first_unknown.get_or_insert_with(|| text(name));
            }
        }
        self.motion.channels += listed.len();
        Ok(())
    }

    fn end_site(&mut self) -> Result<(), FaultKind> {
        self.keyword("`{`", &["{"])?;
        self.offset()?;
        self.keyword("`}`", &["}"]).map(|_| ())
    }

    fn frame_count(&mut self) -> Result<i64, FaultKind> {
        self.keyword("`Frames:`", &["Frames:"])?;
        let (_, word) = *self.words.get(1).ok_or(FaultKind::Missing("`Frames:`"))?;
        let count = python_int(word).ok_or_else(|| FaultKind::NotWhole(text(word)))?;
        self.motion.frames = Some((text(word), self.line));
        if count > 0 {
            Ok(count)
        } else {
            Err(FaultKind::NoFrames(count))
        }
    }

    fn frames(&mut self, announced: i64) -> Result<(), FaultKind> {
        for _ in 0..announced {
            if !self.next() {
                return Err(FaultKind::TooFew);
            }
            self.frame()?;
            self.motion.frames_there += 1;
        }
        while self.next() {
            self.motion.surplus_frames += usize::from(!self.words.is_empty());
        }
        self.motion.frames_there += self.motion.surplus_frames;
        Ok(())
    }

    fn frame(&mut self) -> Result<(), FaultKind> {
        if self.words.is_empty() {
            // Blank lines up to the end are no frames; one between frames is taken for one.
            let is_last = self.lines.all(|(_, line)| fields(line).is_empty());
            return Err(if is_last {
                FaultKind::TooFew
            } else {
                FaultKind::BlankFrame
            });
        }
        let needed = self.motion.channels;
        let mut is_finite = true;
        for (at, (_, word)) in self.words.iter().enumerate() {
            let number = python_float(word).ok_or_else(|| FaultKind::WordInFrame(text(word)))?;
            is_finite &= number.is_finite() || !self.used.get(at).is_some_and(|is_used| *is_used);
        }
        if self.words.len() < needed {
            return Err(FaultKind::ShortFrame(self.words.len(), needed));
        }
        if self.words.len() > needed {
            self.motion.surplus_numbers.add(self.line);
        }
        if !is_finite {
            self.motion.non_finite.add(self.line);
        }
        Ok(())
    }
}

impl FaultKind {
    /// Whether the frames or what announces them are at fault.
    pub fn is_of_frames(&self) -> bool {
        match self {
            Self::NotANumber(of, _) | Self::Missing(of) => of.starts_with("`Frame"),
            Self::Expected(..) | Self::Blank(_) | Self::End(_) | Self::NoName => false,
            _ if self.is_of_channels() => false,
            _ => true,
        }
    }

    /// Whether the channels of a joint are at fault.
    pub fn is_of_channels(&self) -> bool {
        matches!(
            self,
            Self::NoChannels | Self::Channels(..) | Self::ChannelsNotWhole(_)
        )
    }
}

impl Lines {
    fn add(&mut self, line: u32) {
        self.count += 1;
        if self.first.len() < EXAMPLES {
            self.first.push(line);
        }
    }

    /// As evidence, told by the first lines.
    pub fn evidence(&self) -> Evidence {
        let lines = Evidence::of_unnamed(self.first.iter().map(|line| format!("line {line}")));
        Evidence {
            count: self.count as u64,
            ..lines
        }
    }
}

/// A word as it is shown, cut to a length that a message can have.
fn text(word: &[u8]) -> Box<str> {
    String::from_utf8_lossy(word)
        .chars()
        .take(LONGEST)
        .collect()
}

/// Most characters of a word that are kept.
const LONGEST: usize = 100;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const HEAD: &str = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 2 Xrotation Zrotation\nJOINT b c\n{\nOFFSET 0 0 1\n\
        CHANNELS 1 yrotation\nEnd Site\n{\nOFFSET 0 0 1\n}\n}\n}\nMOTION\n";

    fn fault(text: &str) -> Option<(u32, FaultKind)> {
        read(text.as_bytes())
            .fault
            .map(|fault| (fault.line, fault.kind))
    }

    #[test]
    fn a_motion_is_read_line_by_line() {
        let text = format!("\u{feff}{HEAD}Frames: 2\nFrame Time: 0\n1 2 3\r\n4 nan 6 7\n\n8\n");
        let motion = read(text.as_bytes());
        let names = motion
            .joints
            .iter()
            .map(|joint| (&*joint.name, &text[joint.span.clone()]));
        assert_eq!(names.collect::<Vec<_>>(), [("a", "a"), ("b", "b")]);
        assert_eq!(
            (motion.fault, motion.channels, motion.frames),
            (None, 3, Some(("2".into(), 17)))
        );
        assert_eq!(
            (motion.unknown_channels.first, motion.first_unknown),
            (vec![9], Some("yrotation".into()))
        );
        assert_eq!(
            (
                motion.non_finite.first,
                motion.surplus_numbers.first,
                motion.surplus_frames
            ),
            (vec![20], vec![20], 1)
        );
    }

    #[test]
    fn the_first_line_that_is_not_expected_stops_it() {
        let of = |text: &str| fault(&format!("{HEAD}{text}"));
        assert_eq!(fault(""), Some((1, FaultKind::End("`HIERARCHY`"))));
        assert_eq!(
            fault("HIERARCHY\n\n"),
            Some((2, FaultKind::Blank("`ROOT`")))
        );
        assert_eq!(
            fault("hierarchy"),
            Some((1, FaultKind::Expected("`HIERARCHY`", "hierarchy".into())))
        );
        assert_eq!(
            of("Frames: 1\nFrame Time: 0,1\n"),
            Some((18, FaultKind::NotANumber("`Frame Time:`", "0,1".into())))
        );
        assert_eq!(
            read(format!("{HEAD}Frames: 1\nFrame Time: 0.0\n1 2 3\n").as_bytes()).timeless,
            Some(18)
        );
        assert_eq!(
            of("Frames: 9\nFrame Time: 1\n1 2 3\n \n"),
            Some((19, FaultKind::TooFew))
        );
        assert_eq!(
            of("Frames: 9\nFrame Time: 1\n1 2 3\n \n1 2 3\n"),
            Some((20, FaultKind::BlankFrame))
        );
        assert_eq!(
            of("Frames: 1\nFrame Time: 1\n1 2\n"),
            Some((19, FaultKind::ShortFrame(2, 3)))
        );
        assert_eq!(
            of("Frames: 99999999999999999999\nFrame Time: 1\n"),
            Some((18, FaultKind::TooFew))
        );
    }

    #[test]
    fn joints_may_be_nested_however_deep() {
        let joint = "JOINT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n";
        let text = format!("HIERARCHY\nROOT{}{}", &joint[5..], joint.repeat(100_000));
        let motion = read(text.as_bytes());
        assert_eq!((motion.joints.len(), motion.channels), (100_001, 100_001));
        assert!(matches!(
            motion.fault,
            Some(Fault {
                kind: FaultKind::End(_),
                ..
            })
        ));
    }

    proptest! {
        #[test]
        fn every_text_is_read(cut in 0..HEAD.len(), bytes in proptest::collection::vec(any::<u8>(), 0..40)) {
            let text = [&HEAD.as_bytes()[..cut], &bytes, &HEAD.as_bytes()[cut..]].concat();
            let motion = read(&text);
            for joint in motion.joints {
                let name = String::from_utf8_lossy(&text[joint.span]);
                prop_assert_eq!(&*joint.name, &*name);
            }
        }
    }
}
