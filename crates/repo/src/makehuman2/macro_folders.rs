//! Folders of macro definitions, and what lies beneath them. Backslashes and other capitals are
//! looked through: they have findings of their own, and which files are meant is clear.

use std::collections::BTreeSet;
use std::sync::Arc;

use mhlint_formats::macro_json::MacroFile;
use mhlint_source::parent;

/// The folders that macro definitions name, as they are compared.
#[derive(Debug, Default)]
pub struct MacroFolders(BTreeSet<String>);

impl MacroFolders {
    pub(super) fn of(file: &MacroFile) -> Self {
        let mut folders: Vec<&Arc<str>> = file
            .macrodefs
            .iter()
            .filter_map(|macrodef| macrodef.effective_folder.as_ref())
            .collect();
        // Those who inherit a folder share it. It may be long, so it is not compared for each of
        // them.
        folders.dedup_by(|one, other| Arc::ptr_eq(one, other));
        Self(
            folders
                .into_iter()
                .map(|folder| compared(folder))
                .filter(|folder| !folder.is_empty())
                .collect(),
        )
    }

    /// Whether a target lies in one of them, or below.
    pub(super) fn hold(&self, name: &str) -> bool {
        let name = name.to_lowercase();
        name.match_indices('/')
            .filter_map(|(end, _)| name.get(..end))
            .any(|folder| self.0.contains(folder))
    }

    /// Whether a target lies in one of them, and not below.
    pub(super) fn hold_directly(&self, name: &str) -> bool {
        self.0.contains(&parent(name).to_lowercase())
    }
}

/// A folder as it is compared.
fn compared(folder: &str) -> String {
    let parts = folder
        .split(['/', '\\'])
        .filter(|part| !matches!(*part, "" | "."));
    parts.map(str::to_lowercase).collect::<Vec<_>>().join("/")
}

/// Whether the target `name` lies beneath `folder` as a macro definition writes it.
pub fn is_beneath(folder: &str, name: &str) -> bool {
    let folder = compared(folder);
    let rest = name.to_lowercase().strip_prefix(&folder).map(str::to_owned);
    !folder.is_empty() && rest.is_some_and(|rest| rest.starts_with('/'))
}

#[cfg(test)]
mod tests {
    use super::is_beneath;

    #[test]
    fn a_folder_holds_what_lies_beneath_it() {
        for folder in ["macro/age", "/macro/age/", ".\\Macro\\age", "macro"] {
            assert!(is_beneath(folder, "macro/age/old"), "{folder}");
        }
        for folder in ["", "/", "macro/age/old", "macro/ag", "age"] {
            assert!(!is_beneath(folder, "macro/age/old"), "{folder}");
        }
    }
}
