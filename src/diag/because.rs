//! Why a change can affect a finding.

/// Why a change can affect a finding. Paths are as printed; `report` has the words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Because {
    /// The file of the finding changed.
    Own,
    /// A file below its folder changed.
    Inside(String),
    /// A file that it speaks of, or the folder or link that holds one, changed.
    SpokenOf(String),
    /// A file of the same name in other capitals changed.
    OtherCapitals,
    /// A file that names its file changed.
    NamedBy(String),
    /// A file that is named where it stands changed.
    Names(String),
    /// A file that decides over all of a base mesh changed.
    Decides {
        /// The file.
        changed: String,
        /// The base mesh.
        base: String,
    },
    /// Another file of its base mesh changed.
    SameBase {
        /// The file.
        changed: String,
        /// The base mesh.
        base: String,
    },
    /// A data root, or a folder that holds it, changed as a whole.
    WholeFolder(String),
    /// A file of this name changed, which can decide which data lie over which.
    Layers(String),
}
