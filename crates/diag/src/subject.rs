//! What a finding is about.

use super::Parts;

/// With its rule, all that decides whether a finding is the same as another one: never line, count,
/// wording or level.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Subject {
    /// What the fault belongs to, written as paths are, where that is not the file at which the
    /// finding stands: a folder, a base mesh.
    pub asset: Option<String>,
    /// Structural name of the fault in the asset: a bone, a pattern. Must not depend on order or
    /// layout.
    pub key: String,
    /// Everything that the finding is about, where that is more than one thing, or reported one by
    /// one as well as together.
    pub parts: Parts,
}
