//! What one application takes of the lines of an asset: which of them it knows, which faults are
//! any to it, and where it stops.

use super::{Clothes, Entry, Fault, FaultKind, Section};

/// How an application reads; each has its own in the file of its name.
pub struct Reader {
    /// Whether it knows a line by its keyword.
    pub(super) knows: fn(&Entry) -> bool,
    /// Whether what is wrong with a line is wrong for it.
    pub(super) is_fault: fn(&Clothes, &Fault) -> bool,
    /// Keywords of old that it knows and passes over.
    pub(super) passes_over: &'static [&'static str],
    /// Whether it reads the word behind a keyword, whether there is one or not.
    pub(super) needs_value: fn(&str) -> bool,
    /// Where it stops before anything is put on.
    pub(super) stop: fn(&Clothes) -> Option<Stopped>,
}

/// A line at which an application stops.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stopped {
    /// Line from 1.
    pub line: u32,
    /// The exception of Python.
    pub exception: &'static str,
    /// Why, in words.
    pub reason: String,
}

/// A text as an application reads it.
#[derive(Clone, Copy)]
pub struct Reading<'t> {
    reader: &'static Reader,
    clothes: &'t Clothes,
}

impl Reader {
    /// What it takes of a text.
    pub const fn of<'t>(&'static self, clothes: &'t Clothes) -> Reading<'t> {
        Reading {
            reader: self,
            clothes,
        }
    }
}

impl<'t> Reading<'t> {
    /// The last line of a keyword that has a value.
    pub fn last(&self, keyword: &str) -> Option<&'t Entry> {
        let mut lines = self.clothes.all(keyword).rev();
        lines.find(|entry| self.knows(entry))
    }

    /// The first few faults of one kind, and how many there are.
    pub fn faults(&self, is_wanted: impl Fn(FaultKind) -> bool) -> Option<(Vec<&'t Fault>, u64)> {
        let (faults, count) = self.clothes.faults.of(is_wanted)?;
        let is_fault = |fault: &&Fault| (self.reader.is_fault)(self.clothes, fault);
        let own: Vec<&Fault> = faults.iter().filter(is_fault).collect();
        // Those that were counted and not kept are like these.
        let spared = faults.len().saturating_sub(own.len()) as u64;
        (!own.is_empty()).then(|| (own, count.saturating_sub(spared)))
    }

    /// Whether the application knows a line by its keyword.
    pub fn knows(&self, entry: &Entry) -> bool {
        (self.reader.knows)(entry)
    }

    /// Whether it knows the keyword of a line as one of old, and passes over it.
    pub fn passes_over(&self, entry: &Entry) -> bool {
        self.knows(entry) && self.reader.passes_over.contains(&&*entry.keyword)
    }

    /// Whether it reads the word behind a keyword, whether there is one or not.
    pub fn needs_value(&self, keyword: &str) -> bool {
        (self.reader.needs_value)(keyword)
    }

    /// Whether it stops before anything is put on.
    pub fn stops(&self) -> bool {
        self.stop().is_some()
    }

    /// Where it stops before anything is put on.
    pub fn stop(&self) -> Option<Stopped> {
        (self.reader.stop)(self.clothes)
    }

    /// Whether the section of the rows is ever opened.
    pub fn opens_rows(&self) -> bool {
        let opens = |entry: &Entry| {
            entry.section == Section::Vertices && &*entry.keyword == "verts" && self.knows(entry)
        };
        self.clothes.entries.iter().any(opens)
    }
}

/// The first fault at which a reader stops.
pub(super) fn first_stop(
    clothes: &Clothes,
    stops: impl Fn(&Fault) -> Option<(&'static str, String)>,
) -> Option<Stopped> {
    let (line, (exception, reason)) = clothes.faults.first(stops)?;
    Some(Stopped {
        line,
        exception,
        reason,
    })
}
