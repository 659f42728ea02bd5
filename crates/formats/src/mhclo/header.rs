//! The lines with keywords, wherever they stand, and what a library reads of them without the rest.

use std::collections::BTreeMap;
use std::ops::Range;

use super::{Section, makehuman2};

/// A line that begins with a keyword.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// The keyword, without the colon behind it.
    pub keyword: Box<str>,
    /// Whether there is one: not every reader knows the keyword then.
    pub has_colon: bool,
    /// Whether the line is a comment, in which some readers look for who made the asset.
    pub is_comment: bool,
    /// The words behind the keyword, joined by one blank.
    pub value: Box<str>,
    /// The section it stands in.
    pub section: Section,
    /// Line from 1.
    pub line: u32,
    /// Where the keyword stands with its colon, in bytes.
    pub keyword_span: Range<usize>,
    /// Where the words behind it stand, in bytes; none behind the keyword if there are none.
    pub span: Range<usize>,
    /// Bytes of the first of these words.
    first: usize,
}

/// A value that a library shows or knows the asset by.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Value {
    /// As it is taken.
    pub text: Box<str>,
    /// Line from 1.
    pub line: u32,
    /// Where it stands, in bytes.
    pub span: Range<usize>,
}

/// What MakeHuman 2 takes from the text when it looks through the library
/// (`docs/loaders/makehuman2/clothes.md#keywords`, `docs/loaders/makehuman2/libraries.md#scan`):
/// keywords without a colon, before the first row of several numbers; of several lines the last.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Scanned {
    /// The first word of `name`.
    pub name: Option<Value>,
    /// The first word of `uuid`.
    pub uuid: Option<Value>,
    /// What is behind `author`, which it knows in comments alone.
    pub author: Option<Value>,
    /// What is behind the first word of each line with `tag` anywhere in it.
    pub tags: Vec<Value>,
    /// A comment that is meant to say who the author is and is not read, for want of a blank behind
    /// its `#`.
    pub glued_author: Option<Value>,
    /// A comment of one word with `author` in it, of which a second word is asked for.
    pub lone_author: Option<Value>,
    /// Whether the rows were reached.
    is_over: bool,
}

/// The keywords of lines of which the last is always kept; those that open a section are not.
/// Lines of others are kept as long as they are few.
fn known(keyword: &str) -> Option<&'static str> {
    let opens = |known: &&str| matches!(*known, "verts" | "delete_verts" | "weights");
    let of_makehuman2 = makehuman2::KEYWORDS.into_iter().filter(|own| !opens(own));
    let mut all = of_makehuman2.chain(["basemesh", "max_pole"]);
    all.find(|known| *known == keyword)
}

/// What comments say of an asset.
const REMARKS: [&str; 6] = [
    "author",
    "license",
    "licence",
    "homepage",
    "description",
    "copyright",
];

/// Lines kept in all; beyond that the last of each known keyword.
const KEPT: usize = 500;

/// Gathers lines.
#[derive(Default)]
pub(super) struct Header {
    pub(super) entries: Vec<Entry>,
    pub(super) scanned: Scanned,
    last: BTreeMap<&'static str, usize>,
}

/// The words of a line with the places where they start, and where the line starts.
#[derive(Clone, Copy)]
pub(super) struct Words<'l> {
    pub(super) start: usize,
    pub(super) list: &'l [(usize, &'l [u8])],
    pub(super) line: u32,
}

impl Header {
    /// Takes a line that is no row.
    pub(super) fn take(&mut self, words: Words<'_>, section: Section) {
        self.add(entry(words, section, false));
    }

    /// Takes a comment, if it says something of the asset.
    pub(super) fn remark(&mut self, words: Words<'_>, section: Section) {
        match words.list {
            [(_, only)] if holds(only, b"author") => self.scanned.lone_author = rest(words, 0),
            [(_, first), ..] if first.starts_with(b"#author") => {
                self.scanned.glued_author = rest(words, 0);
            }
            _ => {}
        }
        let [(_, b"#"), (_, second), ..] = words.list else {
            return;
        };
        let second = second.strip_suffix(b":").unwrap_or(second);
        if REMARKS
            .iter()
            .any(|known| known.as_bytes().eq_ignore_ascii_case(second))
        {
            let rest = words.list.get(1..).unwrap_or_default();
            self.add(entry(
                Words {
                    list: rest,
                    ..words
                },
                section,
                true,
            ));
        }
    }

    fn add(&mut self, entry: Option<Entry>) {
        let Some(entry) = entry else { return };
        let known = known(&entry.keyword).filter(|_| !entry.is_comment);
        let earlier = known.and_then(|known| self.last.get(known).copied());
        if self.entries.len() >= KEPT {
            match earlier.and_then(|at| self.entries.get_mut(at)) {
                Some(slot) => *slot = entry,
                None if known.is_none() => {}
                None => self.push(known, entry),
            }
            return;
        }
        self.push(known, entry);
    }

    fn push(&mut self, known: Option<&'static str>, entry: Entry) {
        if let Some(known) = known {
            self.last.insert(known, self.entries.len());
        }
        self.entries.push(entry);
    }

    /// Looks at any line as the scan of a library does.
    pub(super) fn scan(&mut self, words: Words<'_>, line: &[u8], is_row: bool) {
        let [(_, first), (at, second), ..] = words.list else {
            return;
        };
        if self.scanned.is_over || is_row {
            self.scanned.is_over = true;
            return;
        }
        let span = words.start + at..words.start + at + second.len();
        let one = || {
            Some(Value {
                text: String::from_utf8_lossy(second).into(),
                line: words.line,
                span: span.clone(),
            })
        };
        match *first {
            b"name" => self.scanned.name = one(),
            b"uuid" => self.scanned.uuid = one(),
            b"obj_file" => {}
            _ if holds(line, b"author") => {
                self.scan_author(words, second);
            }
            _ if holds(line, b"tag") && self.scanned.tags.len() < KEPT => {
                self.scanned.tags.extend(rest(words, 1));
            }
            _ => {}
        }
    }
}

impl Header {
    /// A line with `author` in it counts as nothing else.
    fn scan_author(&mut self, words: Words<'_>, second: &[u8]) {
        if second.starts_with(b"author") {
            self.scanned.author = rest(words, 2);
        }
    }
}

fn holds(line: &[u8], word: &[u8]) -> bool {
    line.windows(word.len()).any(|part| part == word)
}

/// The words from a number on.
fn rest(words: Words<'_>, from: usize) -> Option<Value> {
    let (text, span) = joined(words, from)?;
    Some(Value {
        text,
        line: words.line,
        span,
    })
}

fn joined(words: Words<'_>, from: usize) -> Option<(Box<str>, Range<usize>)> {
    let rest = words.list.get(from..)?;
    let (first, _) = rest.first()?;
    let (at, last) = rest.last()?;
    let texts: Vec<_> = rest
        .iter()
        .map(|(_, word)| String::from_utf8_lossy(word))
        .collect();
    Some((
        texts.join(" ").into(),
        words.start + first..words.start + at + last.len(),
    ))
}

fn entry(words: Words<'_>, section: Section, is_comment: bool) -> Option<Entry> {
    let (at, first) = words.list.first()?;
    let keyword = first.strip_suffix(b":").unwrap_or(first);
    let keyword_span = words.start + at..words.start + at + first.len();
    let (value, span) =
        joined(words, 1).unwrap_or_else(|| ("".into(), keyword_span.end..keyword_span.end));
    Some(Entry {
        keyword: String::from_utf8_lossy(keyword).into(),
        has_colon: keyword.len() < first.len(),
        is_comment,
        value,
        section,
        line: words.line,
        keyword_span,
        span,
        first: words.list.get(1).map_or(0, |(_, word)| word.len()),
    })
}

impl Entry {
    /// The keyword as the line has it.
    pub fn written(&self) -> String {
        format!("{}{}", self.keyword, if self.has_colon { ":" } else { "" })
    }

    /// The first word behind the keyword; empty if there is none.
    pub fn word(&self) -> &str {
        self.value.split(' ').next().unwrap_or_default()
    }

    /// Where that word stands, in bytes.
    pub fn word_span(&self) -> Range<usize> {
        self.span.start..self.span.start + self.first
    }
}
