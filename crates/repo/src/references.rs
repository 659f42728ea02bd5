//! All references of a view, found by the file they stand in, the base they are for, and the file
//! they lead to.

use std::collections::BTreeMap;
use std::ops::Range;

use super::{FileFacts, Reference};

/// References in the order of their bases, with indexes.
#[derive(Debug, Default)]
pub struct References<'a> {
    all: Vec<Reference<'a>>,
    by_base: BTreeMap<&'a str, Range<usize>>,
    by_owner: BTreeMap<&'a str, Vec<usize>>,
    by_target: BTreeMap<&'a str, Vec<usize>>,
}

impl<'a> References<'a> {
    /// Groups references.
    pub fn new(mut all: Vec<Reference<'a>>) -> Self {
        all.sort_by_key(|reference| reference.base);
        let mut references = Self::default();
        for (number, reference) in all.iter().enumerate() {
            let of_base = references
                .by_base
                .entry(reference.base)
                .or_insert(number..number);
            of_base.end = number + 1;
            references
                .by_owner
                .entry(&reference.from.path)
                .or_default()
                .push(number);
            if let Some(file) = reference.meant() {
                references
                    .by_target
                    .entry(&file.path)
                    .or_default()
                    .push(number);
            }
        }
        Self { all, ..references }
    }

    /// All of them.
    pub fn iter(&self) -> std::slice::Iter<'_, Reference<'a>> {
        self.all.iter()
    }

    /// Those for a base.
    pub fn of_base(&self, base: &str) -> &[Reference<'a>] {
        self.by_base
            .get(base)
            .and_then(|range| self.all.get(range.clone()))
            .unwrap_or_default()
    }

    /// Those that stand in a file.
    pub fn of_file(&self, file: &FileFacts) -> impl Iterator<Item = &Reference<'a>> {
        self.numbered(&self.by_owner, file)
    }

    /// Those that lead to a file, also where the name is not quite right.
    pub fn to_file(&self, file: &FileFacts) -> impl Iterator<Item = &Reference<'a>> {
        self.numbered(&self.by_target, file)
    }

    fn numbered<'s>(
        &'s self,
        index: &'s BTreeMap<&'a str, Vec<usize>>,
        file: &FileFacts,
    ) -> impl Iterator<Item = &'s Reference<'a>> + use<'s, 'a> {
        let numbers = index.get(file.path.as_str()).into_iter().flatten();
        numbers.filter_map(|number| self.all.get(*number))
    }
}

impl<'s, 'a> IntoIterator for &'s References<'a> {
    type Item = &'s Reference<'a>;
    type IntoIter = std::slice::Iter<'s, Reference<'a>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
