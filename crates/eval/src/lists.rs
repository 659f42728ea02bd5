//! Many lists, one after the other in one piece of memory.

/// Lists that are asked for by their numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Lists<T> {
    starts: Vec<u32>,
    entries: Vec<T>,
}

impl<T: Clone + Default> Lists<T> {
    /// `count` lists of what comes with their numbers, in that order. What comes with another
    /// number is left out.
    pub(super) fn new(count: usize, pairs: impl Iterator<Item = (usize, T)> + Clone) -> Self {
        let mut starts = vec![0; count + 1];
        for (list, _) in pairs.clone() {
            if let Some(length) = starts.get_mut(list + 1) {
                *length += 1;
            }
        }
        for list in 0..count {
            starts[list + 1] += starts[list];
        }
        let mut free = starts.clone();
        let mut entries = vec![T::default(); starts[count] as usize];
        for (list, entry) in pairs.filter(|(list, _)| *list < count) {
            entries[free[list] as usize] = entry;
            free[list] += 1;
        }
        Self { starts, entries }
    }

    /// Adds a list.
    pub(super) fn push(&mut self, entries: impl IntoIterator<Item = T>) {
        self.entries.extend(entries);
        self.starts
            .push(u32::try_from(self.entries.len()).unwrap_or(u32::MAX));
    }

    /// A list; an empty one beyond the last.
    pub(super) fn of(&self, list: usize) -> &[T] {
        let ends = self.starts.get(list).zip(self.starts.get(list + 1));
        ends.and_then(|(start, end)| self.entries.get(*start as usize..*end as usize))
            .unwrap_or_default()
    }

    /// All lists in order.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[T]> {
        (1..self.starts.len()).map(|next| self.of(next - 1))
    }
}
