//! `.mhmat`: how a surface looks (`docs/loaders/makehuman2/materials.md#lines`,
//! `docs/loaders/makehuman1/materials.md#lines-of-a-material`,
//! `docs/loaders/mpfb/materials.md#lines-of-a-material`).
//!
//! A line is a keyword and words, split at white space; what is behind the first word of a file
//! name is lost. Comments begin with `#` or `//`. A byte order mark belongs to the first word. All
//! keywords of all applications are kept as they are written; what a value comes to is a matter of
//! each application.

mod keyword;
pub mod mpfb;
mod reader;
mod statement;

use std::ops::Range;

pub use keyword::{Keyword, Value};
pub use keyword::{keywords, keywords_of};
pub use reader::read;
pub use statement::Statement;

use super::python_float;

/// The file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Material {
    /// The pictures that it names by keywords of which an application takes the last one that it
    /// finds, in file order.
    pub textures: Vec<Texture>,
    /// Lines with a keyword, in file order, up to `MOST_LINES`.
    pub lines: Vec<Line>,
    /// Words that are no keyword and begin no comment, each once, up to `MOST_UNKNOWN`.
    pub unknown: Vec<Unknown>,
    /// How many more lines there are of both.
    pub left_out: usize,
    /// The lines that are a word of letters and a value, whatever the word.
    pub statements: Vec<Statement>,
}

/// Lines with a keyword that are kept. Those that people write have fifty.
const MOST_LINES: usize = 1024;
/// Unknown words that are kept.
const MOST_UNKNOWN: usize = 64;

/// A line that names a picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Texture {
    /// What it is for.
    pub keyword: &'static str,
    /// The name: one word.
    pub word: Box<str>,
    /// What is written behind that word and lost, words joined by one blank.
    pub lost: Box<str>,
    /// Where the name stands, in bytes.
    pub span: Range<usize>,
}

/// A line with a keyword.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// The keyword.
    pub keyword: &'static Keyword,
    /// Its number, from 1.
    pub number: u32,
    /// The first five words behind the keyword.
    pub words: Vec<Word>,
    /// How many words there are behind the keyword.
    pub count: usize,
}

/// A word.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Word {
    /// As it is written.
    pub text: Box<str>,
    /// Where it stands, in bytes.
    pub span: Range<usize>,
}

/// A word at the beginning of lines that is no keyword.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unknown {
    /// The word, and its place in the first line.
    pub word: Word,
    /// The first word behind it there.
    pub value: Option<Box<str>>,
    /// How many lines begin with it.
    pub lines: usize,
}

impl Material {
    /// The lines of a keyword.
    pub fn lines_of(&self, keyword: &str) -> impl DoubleEndedIterator<Item = &Line> {
        self.lines
            .iter()
            .filter(move |line| line.keyword.name == keyword)
    }

    /// The last line of a keyword.
    pub fn last(&self, keyword: &str) -> Option<&Line> {
        self.lines_of(keyword).next_back()
    }

    /// The last line that sets this parameter of the shader, with a value.
    pub fn parameter(&self, name: &str) -> Option<&Line> {
        self.lines_of("shaderParam")
            .rfind(|line| line.word(0) == name && line.count > 1)
    }
}

impl Line {
    /// A word behind the keyword; nothing where it has not as many.
    pub fn word(&self, at: usize) -> &str {
        self.words.get(at).map_or("", |word| &word.text)
    }

    /// A word behind the keyword, as a number.
    pub fn number_at(&self, at: usize) -> Option<f64> {
        self.words.get(at)?.number()
    }
}

impl Word {
    /// As a number.
    pub fn number(&self) -> Option<f64> {
        python_float(self.text.as_bytes())
    }
}
