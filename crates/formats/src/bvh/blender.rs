//! `.bvh` as Blender's importer reads it, with which MPFB loads poses
//! (`docs/loaders/mpfb/poses.md#motions`).
//!
//! Blank lines, capitals of keywords, numbers of channels and of frames do not matter to it. It
//! stops where a number is missing, or is none.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::bvh::Joint;
use crate::fields::fields;
use crate::python_float;
use mhlint_source::{BYTE_ORDER_MARK, lines};

/// The file, as far as the importer gets.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ImportedMotion {
    /// Joints in file order. Their names are all words of their lines.
    pub joints: Vec<Joint>,
    /// Joints that have the name of an earlier one, as places in `joints`, each with the earlier
    /// one.
    pub repeated: Vec<(usize, usize)>,
    /// Channels whose names mean nothing, as lines with the first name.
    pub unknown_channels: Vec<(u32, Box<str>)>,
    /// How many channels there are.
    pub channels: usize,
    /// The first line at which the importer stops, and why.
    pub fault: Option<ImportFault>,
}

/// What stops the importer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportFault {
    /// The line; the last one at the end of the file.
    pub line: u32,
    /// Why.
    pub kind: ImportFaultKind,
}

/// Why the importer stops.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ImportFaultKind {
    /// The first word is not `HIERARCHY`.
    NotBvh(Box<str>),
    /// A joint without a name.
    NoName,
    /// Fewer than three numbers.
    ShortOffset,
    /// A word of this that is not a number.
    NotANumber(&'static str, Box<str>),
    /// There is no line `MOTION`.
    NoMotion,
    /// There is no time of a frame.
    NoTime,
    /// A frame with fewer numbers than channels: there, needed.
    ShortFrame(usize, usize),
}

use ImportFaultKind::{NoMotion, NoName, NoTime, NotANumber, NotBvh, ShortFrame, ShortOffset};

const CHANNELS: [&str; 6] = [
    "xposition",
    "yposition",
    "zposition",
    "xrotation",
    "yrotation",
    "zrotation",
];

/// A line with its number, first byte and words.
struct Line<'t> {
    number: u32,
    start: usize,
    words: Vec<(usize, &'t [u8])>,
}

impl Line<'_> {
    fn is(&self, at: usize, word: &str) -> bool {
        self.words
            .get(at)
            .is_some_and(|(_, own)| own.eq_ignore_ascii_case(word.as_bytes()))
    }

    fn fault(&self, kind: ImportFaultKind) -> ImportFault {
        ImportFault {
            line: self.number,
            kind,
        }
    }

    /// A word as a number.
    fn number_at(&self, at: usize, of: &'static str) -> Result<Option<f64>, ImportFault> {
        let Some((_, word)) = self.words.get(at) else {
            return Ok(None);
        };
        python_float(word)
            .map(Some)
            .ok_or_else(|| self.fault(NotANumber(of, text(word))))
    }
}

/// Reads a file up to the first fault.
pub fn read(text: &[u8]) -> ImportedMotion {
    let mut motion = ImportedMotion::default();
    let numbered = (1..).zip(lines(text));
    let mut rest = numbered.filter_map(|(number, (range, line))| {
        // A byte order mark has a finding of its own.
        let unmarked = if number == 1 {
            line.strip_prefix(BYTE_ORDER_MARK).unwrap_or(line)
        } else {
            line
        };
        let words = fields(unmarked);
        (!words.is_empty()).then_some(Line {
            number,
            start: range.start + line.len() - unmarked.len(),
            words,
        })
    });
    motion.fault = motion.file(&mut rest).err();
    motion
}

impl ImportedMotion {
    fn file<'t>(&mut self, rest: &mut impl Iterator<Item = Line<'t>>) -> Result<(), ImportFault> {
        // A blank file has a finding of its own.
        let Some(first) = rest.next() else {
            return Ok(());
        };
        if !first.is(0, "hierarchy") {
            let word = first
                .words
                .first()
                .map_or_else(|| "".into(), |(_, word)| text(word));
            return Err(first.fault(NotBvh(word)));
        }
        // Each place among the numbers of a frame that is read.
        let mut used: Vec<usize> = Vec::new();
        let mut names: BTreeMap<Box<str>, usize> = BTreeMap::new();
        let mut last = first.number;
        loop {
            let Some(line) = rest.next() else {
                return Err(ImportFault {
                    line: last,
                    kind: NoMotion,
                });
            };
            last = line.number;
            if line.is(0, "root") || line.is(0, "joint") {
                last = self.joint(&line, rest, &mut used, &mut names)?;
            } else if line.is(0, "end") && line.is(1, "site") {
                let brace = rest.next().map_or(last, |brace| brace.number);
                last = offset(rest, brace)?;
            } else if line.is(0, "motion") && line.words.len() == 1 {
                return frames(rest, last, &used, self.channels);
            }
        }
    }

    fn joint<'t>(
        &mut self,
        line: &Line<'t>,
        rest: &mut impl Iterator<Item = Line<'t>>,
        used: &mut Vec<usize>,
        names: &mut BTreeMap<Box<str>, usize>,
    ) -> Result<u32, ImportFault> {
        let joint = named(line).ok_or_else(|| line.fault(NoName))?;
        let at = self.joints.len();
        match names.get(&joint.name) {
            Some(before) => self.repeated.push((at, *before)),
            None => drop(names.insert(joint.name.clone(), at)),
        }
        self.joints.push(joint);
        let brace = rest.next().map_or(line.number, |brace| brace.number);
        let last = offset(rest, brace)?;
        let Some(channels) = rest.next() else {
            return Err(ImportFault {
                line: last,
                kind: NoMotion,
            });
        };
        for (_, name) in channels.words.iter().skip(2) {
            let is_known = CHANNELS
                .iter()
                .any(|known| name.eq_ignore_ascii_case(known.as_bytes()));
            if is_known {
                used.push(self.channels);
            } else {
                self.unknown_channels.push((channels.number, text(name)));
            }
            self.channels += 1;
        }
        Ok(channels.number)
    }
}

/// A joint by all words of its name.
fn named(line: &Line<'_>) -> Option<Joint> {
    let (first, _) = *line.words.get(1)?;
    let (last, word) = *line.words.last()?;
    let names = line
        .words
        .iter()
        .skip(1)
        .map(|(_, word)| String::from_utf8_lossy(word));
    let name = names.collect::<Vec<_>>().join("_").into_boxed_str();
    let span: Range<usize> = line.start + first..line.start + last + word.len();
    Some(Joint { name, span })
}

/// Reads the line with three numbers; its number.
fn offset<'t>(rest: &mut impl Iterator<Item = Line<'t>>, last: u32) -> Result<u32, ImportFault> {
    let Some(line) = rest.next() else {
        return Err(ImportFault {
            line: last,
            kind: ShortOffset,
        });
    };
    for at in 1..=3 {
        line.number_at(at, "`OFFSET`")?
            .ok_or_else(|| line.fault(ShortOffset))?;
    }
    Ok(line.number)
}

/// Reads what is behind `MOTION`. A line that is another than expected is passed over.
fn frames<'t>(
    rest: &mut impl Iterator<Item = Line<'t>>,
    mut last: u32,
    used: &[usize],
    channels: usize,
) -> Result<(), ImportFault> {
    let no_time = |line| ImportFault { line, kind: NoTime };
    let count = rest.next().ok_or_else(|| no_time(last))?;
    if count.is(0, "frames:") && count.words.len() == 2 {
        count.number_at(1, "`Frames:`")?;
    }
    let time = rest.next().ok_or_else(|| no_time(count.number))?;
    last = time.number.max(last);
    if !(time.is(0, "frame") && time.is(1, "time:") && time.words.len() == 3) {
        return Err(no_time(last));
    }
    time.number_at(2, "`Frame Time:`")?;
    for frame in rest {
        for at in used {
            let short = || frame.fault(ShortFrame(frame.words.len(), channels));
            frame.number_at(*at, "a frame")?.ok_or_else(short)?;
        }
    }
    Ok(())
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

    const HEAD: &str = "hierarchy\n\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 9 Xrotation zrotation\nJOINT b c\n{\nOFFSET 0 0 1\n\
        CHANNELS 1 yrot\nEnd Site\n{\nOFFSET 0 0 1\n}\n}\n}\n";

    fn fault(text: &str) -> Option<(u32, ImportFaultKind)> {
        read(format!("{HEAD}{text}").as_bytes())
            .fault
            .map(|fault| (fault.line, fault.kind))
    }

    #[test]
    fn much_is_tolerated() {
        let text = format!("{HEAD}MOTION\nframes: 9\nframe time: 1\n\n1 2 x\n4 5 6 7\n");
        let motion = read(text.as_bytes());
        assert_eq!((motion.fault, motion.channels), (None, 3));
        assert_eq!(motion.unknown_channels, [(10, "yrot".into())]);
        let names = motion
            .joints
            .iter()
            .map(|joint| (&*joint.name, &text[joint.span.clone()]));
        assert_eq!(names.collect::<Vec<_>>(), [("a", "a"), ("b_c", "b c")]);
        assert_eq!(read(b"\n").fault, None);
    }

    #[test]
    fn some_lines_stop_the_importer() {
        assert_eq!(fault(""), Some((16, NoMotion)));
        assert_eq!(fault("MOTION\n"), Some((17, NoTime)));
        assert_eq!(fault("MOTION\nFrames: 1\n"), Some((18, NoTime)));
        let of = |frame: &str| fault(&format!("MOTION\nFrames: 1\nFrame Time: 0.1\n{frame}\n"));
        assert_eq!(of("1 2"), None);
        assert_eq!(of("1"), Some((20, ShortFrame(1, 3))));
        assert_eq!(
            of("1 2,5 3"),
            Some((20, NotANumber("a frame", "2,5".into())))
        );
        assert_eq!(
            fault("MOTION\nFrames: 1\nFrame Time: 0,1\n"),
            Some((19, NotANumber("`Frame Time:`", "0,1".into())))
        );
        let kind = |text: &str| read(text.as_bytes()).fault.map(|fault| fault.kind);
        assert_eq!(kind("{}"), Some(NotBvh("{}".into())));
        assert_eq!(kind("HIERARCHY\nROOT\n"), Some(NoName));
        assert_eq!(
            kind("HIERARCHY\nROOT a\n{\nOFFSET 0 0\n"),
            Some(ShortOffset)
        );
        let twice = read(b"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT a\n{\nOFFSET 0 0 0\nCHANNELS 0\n");
        assert_eq!(twice.repeated, [(1, 0)]);
    }

    proptest! {
        #[test]
        fn every_text_is_read(cut in 0..HEAD.len(), bytes in proptest::collection::vec(any::<u8>(), 0..40)) {
            let text = [&HEAD.as_bytes()[..cut], &bytes, &HEAD.as_bytes()[cut..]].concat();
            for joint in read(&text).joints {
                prop_assert!(joint.span.end <= text.len());
            }
        }
    }
}
