//! What can be done about a finding without a person: plain words, and steps that name a place.
//!
//! A step describes a change and holds no bytes of the file: a target with a thousand rows to
//! remove is one step. The bytes to change ([`Edit`]) are computed from the file when somebody asks
//! for them.

use std::ops::Range;

use super::FixKind;

/// How a finding is fixed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    /// Whether it may change what the applications do beyond fixing the fault.
    pub kind: FixKind,
    /// What is done, as an order: `remove the rows`.
    pub title: String,
    /// What is changed; all of it or nothing.
    pub steps: Vec<Step>,
    /// Files of the steps that are not to be written, because of an ignore or of the PATHs; filled
    /// by the engine.
    pub left_out: Vec<String>,
    /// The texts that it replaces, by file and place; filled by the engine where somebody asks for
    /// them.
    pub replaced: Vec<Replaced>,
}

/// A part of a file and what comes in its place, for programs that edit the text themselves.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Replaced {
    /// File, as in [`super::Finding::path`].
    pub path: String,
    /// Line and column of its first character, from 1.
    pub from: [u32; 2],
    /// Line and column behind its last character.
    pub to: [u32; 2],
    /// What stands there instead.
    pub text: String,
}

/// A change of one file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// File, as in [`super::Finding::path`].
    pub path: String,
    /// What is done to it.
    pub change: Change,
}

/// What is done to a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Change {
    /// The JSON value at a pointer becomes a text, or `null`.
    Value {
        /// Where.
        pointer: String,
        /// The text; `None` for `null`.
        text: Option<String>,
    },
    /// The key of the JSON member at a pointer becomes another one.
    Key {
        /// Where.
        pointer: String,
        /// The new key.
        key: &'static str,
    },
    /// The element of a JSON list at a pointer goes away.
    Element(String),
    /// An operation on the whole file.
    Rewrite(Rewrite),
    /// The file goes away.
    Remove,
}

/// Operations on files of one format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rewrite {
    /// A text without its byte order mark.
    DropByteOrderMark,
    /// A target without rows that move nothing.
    DropZeroRows,
    /// A target with only the last row of each vertex.
    KeepLastRows,
    /// Weights without entries that the loaders drop.
    DropSmallWeights,
    /// Weights with one entry for each vertex of a bone.
    MergeWeights,
    /// Weights that sum to 1 at each vertex.
    NormalizeWeights,
}

/// Bytes of a file that become others.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// Which bytes.
    pub range: Range<usize>,
    /// What stands there instead.
    pub text: Vec<u8>,
}

impl Fix {
    /// A fix of the kind that a rule declares, without steps.
    pub fn new(kind: FixKind, title: impl Into<String>) -> Self {
        Self {
            kind,
            title: title.into(),
            steps: Vec::new(),
            left_out: Vec::new(),
            replaced: Vec::new(),
        }
    }

    /// Adds a step.
    #[must_use]
    pub fn step(mut self, path: impl Into<String>, change: Change) -> Self {
        self.steps.push(Step {
            path: path.into(),
            change,
        });
        self
    }
}

impl Edit {
    /// Takes bytes away.
    pub fn removal(range: Range<usize>) -> Self {
        Self {
            range,
            text: Vec::new(),
        }
    }

    /// Puts `text` in the place of bytes.
    pub fn replacement(range: Range<usize>, text: impl Into<Vec<u8>>) -> Self {
        Self {
            range,
            text: text.into(),
        }
    }
}
