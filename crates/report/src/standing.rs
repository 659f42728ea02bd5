//! Where a finding stands for readers that know only files: code hosts, CI systems, editors.

use super::phrase;
use mhlint_diag::{Finding, Location};

/// A file of which nothing more is known.
const SOMEWHERE: &Location = &Location {
    line: None,
    column: None,
    pointer: None,
    element: None,
    excerpt: None,
    folder: None,
};

/// The file for a finding, and the place in it.
pub(super) struct Standing<'f> {
    /// None where the finding stands at a folder without files.
    pub(super) file: Option<&'f str>,
    /// Of the file, or of that folder.
    pub(super) location: &'f Location,
}

impl<'f> Standing<'f> {
    /// Of a finding at a folder the file that stands in for it.
    pub(super) fn of(finding: &'f Finding) -> Self {
        let Some(folder) = &finding.location.folder else {
            return Self {
                file: Some(&finding.path),
                location: &finding.location,
            };
        };
        let Some(file) = folder.file.as_deref() else {
            return Self {
                file: None,
                location: &finding.location,
            };
        };
        let related = finding.related.iter().find(|one| one.path == file);
        Self {
            file: Some(file),
            location: related.map_or(SOMEWHERE, |one| &one.location),
        }
    }
}

/// The folder, to be put before a message that is shown at a file or at none.
pub(super) fn folder(finding: &Finding) -> String {
    if finding.location.folder.is_none() {
        return String::new();
    }
    format!("`{}`: ", phrase::path_of(finding))
}
