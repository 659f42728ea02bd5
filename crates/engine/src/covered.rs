//! What this version reads for each application, as data.

use super::catalogue::has_rules;
use mhlint_diag::{Application, AssetGroup};
use mhlint_formats::FORMATS;
use mhlint_rules::{Unread, unread};

/// What is known of a kind of files in an application.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CoveredKind {
    /// The kind, as the code names it.
    pub kind: String,
    /// What its files are parts of, if an application is known to load them.
    pub group: Option<AssetGroup>,
    /// Whether rules are about what is in such files; of others only the name, the encoding and the
    /// syntax are checked.
    pub has_rules: bool,
    /// What becomes of one that cannot be read.
    pub unread: Vec<Unread>,
}

/// The kinds of files that are checked for an application, or known to it.
pub fn covered_kinds(application: Application) -> Vec<CoveredKind> {
    let all = FORMATS.iter().map(|format| CoveredKind {
        kind: format!("{:?}", format.kind),
        group: format.kind.group(),
        has_rules: has_rules(application, format.kind),
        unread: unread(application, format.kind),
    });
    all.filter(|one| one.has_rules || !one.unread.is_empty())
        .collect()
}
