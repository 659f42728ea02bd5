//! What a reader should know of a run besides findings.

use super::Application;

/// Something to know. `report` has the words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Note {
    /// `--system` names the data to check itself, which are checked then.
    SystemIsChecked {
        /// Their path as printed.
        path: String,
    },
    /// A checked folder is the data of a program as well, so that those of `--system` are not laid
    /// below it.
    StandsAlone {
        /// Its path as printed.
        path: String,
        /// Whose data they are.
        application: Application,
    },
    /// Applications that were asked for, and of which there are no data.
    NothingFor {
        /// Which.
        applications: Vec<Application>,
    },
    /// Only what is new or worse is reported.
    Compared {
        /// What the data were compared with.
        with: String,
        /// Findings that no longer occur.
        gone: usize,
    },
    /// Both sides of a comparison are checked by the settings of now, and those have changed.
    SettingsChanged {
        /// Path of the configuration as printed.
        path: String,
    },
    /// Fixes gave rise to fixes until the run gave up.
    Unfinished {
        /// Turns that it took.
        turns: usize,
    },
}
