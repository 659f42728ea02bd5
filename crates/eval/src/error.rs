//! Why an evaluation has no result: the application would stop here, too.

use std::fmt;

/// Data that stops the application, so that there is no number to give.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EvalError {
    /// A vertex index at or beyond the number of vertices.
    VertexOutOfRange {
        /// The index as written, 0-based.
        vertex: i64,
        /// Number of vertices there are.
        count: usize,
    },
    /// A joint index that the skeleton does not have.
    JointOutOfRange(usize),
    /// A bone index that the skeleton does not have.
    BoneOutOfRange(usize),
    /// A joint without vertices has no position.
    EmptyJoint,
    /// No bone without parent.
    NoRoot,
    /// A second bone without parent: the given index.
    SecondRoot(usize),
    /// A scale that lacks the given axis while others are there.
    IncompleteScale {
        /// 0, 1 or 2.
        axis: usize,
    },
}

impl EvalError {
    pub(super) fn vertex(vertex: u32, count: usize) -> Self {
        Self::VertexOutOfRange {
            vertex: i64::from(vertex),
            count,
        }
    }
}

impl fmt::Display for EvalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::VertexOutOfRange { vertex, count } => {
                write!(f, "vertex {vertex} is outside the mesh of {count} vertices")
            }
            Self::JointOutOfRange(joint) => write!(f, "joint number {joint} does not exist"),
            Self::BoneOutOfRange(bone) => write!(f, "bone number {bone} does not exist"),
            Self::EmptyJoint => f.write_str("a joint without vertices has no position"),
            Self::NoRoot => f.write_str("every bone has a parent, so there is no root"),
            Self::SecondRoot(bone) => {
                write!(f, "bone number {bone} is a second bone without parent")
            }
            Self::IncompleteScale { axis } => {
                write!(
                    f,
                    "the scale of the {} axis is missing",
                    ["x", "y", "z"].get(*axis).unwrap_or(&"?")
                )
            }
        }
    }
}

impl std::error::Error for EvalError {}
