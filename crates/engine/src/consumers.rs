//! Which applications load which files.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::catalogue::has_rules;
use mhlint_diag::{Application, AssetGroup, Consumed, Consumer, Fares};
use mhlint_repo::FileFacts;
use mhlint_rules::unread;

/// The files that some application loads, by printed path: data roots of several applications have
/// files in common.
#[derive(Default)]
pub(super) struct Consumers(BTreeMap<String, (AssetGroup, Vec<Consumer>)>);

impl Consumers {
    /// Notes a file of a data root, if the application loads files of its kind; `archive` is read
    /// in its place.
    pub(super) fn add(
        &mut self,
        file: &FileFacts,
        application: Application,
        root: &Arc<str>,
        archive: Option<&FileFacts>,
    ) {
        let kind = file.kind_in(application);
        let Some(group) = kind.group() else { return };
        let has_rules = has_rules(application, kind);
        // Of what it neither checks nor misses nothing says that the application loads it.
        if !has_rules && unread(application, kind).is_empty() {
            return;
        }
        let fares = if has_rules {
            Fares::Fine
        } else {
            Fares::NotChecked
        };
        let archive = archive.map(|archive| archive.path.as_str().into());
        let consumer = Consumer {
            application,
            root: root.clone(),
            archive,
            fares,
        };
        let (_, by) = self
            .0
            .entry(file.path.clone())
            .or_insert_with(|| (group, Vec::new()));
        if !by.iter().any(|one| one.application == application) {
            by.push(consumer);
        }
    }

    /// Whether what is in a file was checked for some application.
    pub(super) fn has_checked(&self, path: &str) -> bool {
        self.0
            .get(path)
            .is_some_and(|(_, by)| by.iter().any(|one| one.fares != Fares::NotChecked))
    }

    /// All of them, sorted by path.
    pub(super) fn sorted(self) -> Vec<Consumed> {
        let row = |(path, (group, mut by)): (String, (AssetGroup, Vec<Consumer>))| {
            by.sort_by_key(|consumer| consumer.application);
            Consumed { path, group, by }
        };
        self.0.into_iter().map(row).collect()
    }
}
