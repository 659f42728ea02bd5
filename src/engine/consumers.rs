//! Which applications load which files.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::catalogue::has_rules;
use crate::diag::{Application, Consumed, Consumer, Fares};
use crate::repo::FileFacts;

/// The files that some application loads, by printed path: data roots of several applications have files in common.
#[derive(Default)]
pub(super) struct Consumers(BTreeMap<String, Consumed>);

impl Consumers {
    /// Notes a file of a data root, if the application loads files of its kind; `archive` is read in its place.
    pub(super) fn add(
        &mut self,
        file: &FileFacts,
        application: Application,
        root: &Arc<str>,
        archive: Option<&FileFacts>,
    ) {
        let kind = file.kind_in(application);
        let Some(group) = kind.group() else { return };
        let fares = if has_rules(application, kind) { Fares::Fine } else { Fares::NotChecked };
        let archive = archive.map(|archive| archive.path.as_str().into());
        let consumer = Consumer { application, root: root.clone(), archive, fares };
        let none = || Consumed { path: file.path.clone(), group, by: Vec::new() };
        let by = &mut self.0.entry(file.path.clone()).or_insert_with(none).by;
        if !by.iter().any(|one| one.application == application) {
            by.push(consumer);
        }
    }

    /// All of them, sorted by path.
    pub(super) fn sorted(self) -> Vec<Consumed> {
        let mut all: Vec<Consumed> = self.0.into_values().collect();
        all.iter_mut().for_each(|one| one.by.sort_by_key(|consumer| consumer.application));
        all
    }
}
