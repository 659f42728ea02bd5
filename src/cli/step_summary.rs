//! The summary of a GitHub workflow step: a file to which every command of the step appends
//! Markdown.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::exit::Failure;
use super::output::remedy;
use mhlint_diag::Outcome;
use mhlint_report::{self as report, View};

/// GitHub drops the summary of a step as a whole when it is larger than 1 MiB.
const LIMIT: u64 = 1 << 20;

/// The file, where mhlint runs in such a step.
pub(super) fn file() -> Option<PathBuf> {
    std::env::var_os("GITHUB_STEP_SUMMARY")
        .filter(|path| !path.is_empty())
        .map(PathBuf::from)
}

/// Appends the Markdown report, shortened to the room that is left.
pub(super) fn append(file: &Path, outcome: &Outcome, view: &View<'_>) -> Result<(), Failure> {
    let used = fs::metadata(file).map_or(0, |metadata| metadata.len());
    let room = usize::try_from(LIMIT.saturating_sub(used + 1)).unwrap_or(0);
    // What stands there may end within a line.
    let text = format!("\n{}", report::summary(outcome, view, room));
    let append = || {
        fs::OpenOptions::new()
            .create(true)
            .append(true)
            .open(file)?
            .write_all(text.as_bytes())
    };
    append().map_err(|error| {
        let (shown, remedy) = (file.display(), remedy(&error));
        Failure::Usage(format!(
            "cannot append to `{shown}` (GITHUB_STEP_SUMMARY): {error}; {remedy}"
        ))
    })
}
