//! What a loader cannot take of a JSON, as the reader of the format finds it.

use mhlint_diag::add_step;
use mhlint_json::{Node, Value};

/// A place in a JSON at which a loader stops, or which it passes over.
#[derive(Debug, Clone, PartialEq)]
pub struct Unfit {
    /// Pointer to the value; for a key that is missing, to the object that lacks it.
    pub pointer: String,
    /// What is wrong with it.
    pub why: Why,
}

/// What is wrong with a value.
#[derive(Debug, Clone, PartialEq)]
pub enum Why {
    /// It has no such key.
    Lacks(&'static str),
    /// Its key is none of those that are known.
    Key(&'static [&'static str]),
    /// Its key is no property of what it is set on; those that are, some of them in one text with
    /// blanks between them.
    Property(Vec<&'static str>),
    /// It is of another type.
    Type {
        /// The type.
        found: &'static str,
        /// What the loader takes.
        wanted: &'static str,
    },
    /// It is a text that is none of a few.
    Word(String, &'static [&'static str]),
    /// It is a text of which no number can be made.
    Text(String),
    /// It is a list of another length.
    Length(usize, usize),
    /// It is a number that has no such value.
    Range(f64),
    /// It stands for what something earlier in the file stands for as well.
    Twice(String),
    /// It is a second link to this input of a node.
    SecondLink(String),
    /// It names something that is not in the file.
    Unknown(String),
}

/// A name in a JSON.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedAt {
    /// Pointer to it.
    pub pointer: String,
    /// The name.
    pub name: String,
}

/// What is kept of one sort. No file that anybody wrote has as many.
const MOST: usize = 20_000;

/// Faults of one sort.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Unfits(Vec<Unfit>);

impl Unfits {
    /// All of them, in the order of the file.
    pub fn all(&self) -> &[Unfit] {
        &self.0
    }

    /// Adds one.
    pub(super) fn add(&mut self, pointer: &str, why: Why) {
        if self.0.len() < MOST {
            self.0.push(Unfit {
                pointer: pointer.to_owned(),
                why,
            });
        }
    }

    /// Adds those of another sort.
    pub(super) fn extend(&mut self, others: Self) {
        let room = MOST.saturating_sub(self.0.len());
        self.0.extend(others.0.into_iter().take(room));
    }

    /// Adds that a value is of another type.
    pub(super) fn add_type(&mut self, pointer: &str, node: &Node, wanted: &'static str) {
        self.add(
            pointer,
            Why::Type {
                found: node.type_word(),
                wanted,
            },
        );
    }

    /// Adds a text that is none of the known ones. Any other type is passed over.
    pub(super) fn check_word(
        &mut self,
        pointer: &str,
        node: &Node,
        known: &'static [&'static str],
    ) {
        if let Some(text) = node.as_str().filter(|text| !known.contains(text)) {
            self.add(pointer, Why::Word(text.to_owned(), known));
        }
    }
}

impl NamedAt {
    /// A name at a pointer.
    pub(super) fn new(pointer: &str, name: &str) -> Self {
        Self {
            pointer: pointer.to_owned(),
            name: name.to_owned(),
        }
    }
}

/// Adds a name, as long as there are not too many.
pub(super) fn keep(names: &mut Vec<NamedAt>, pointer: &str, name: &str) {
    if names.len() < MOST {
        names.push(NamedAt::new(pointer, name));
    }
}

/// The pointer to what is one step below.
pub(super) fn below(pointer: &str, step: &str) -> String {
    let mut pointer = pointer.to_owned();
    add_step(&mut pointer, step);
    pointer
}

/// The pointer to an element of a list.
pub(super) fn nth(pointer: &str, index: usize) -> String {
    below(pointer, &index.to_string())
}

/// Whether Python takes the value for a number.
pub(super) const fn is_number(node: &Node) -> bool {
    matches!(node.value, Value::Number(..) | Value::Bool(_))
}

/// What a loader makes of a file of settings, as far as it does not fit.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoaderFaults {
    /// What stops it.
    pub stops: Unfits,
    /// What it passes over, or takes otherwise than it is meant.
    pub ignored: Unfits,
    /// Keys of the top of which others are known, and none of these is misspelt.
    pub absent: Vec<&'static str>,
}
