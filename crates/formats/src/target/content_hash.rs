//! Hash over the rows of a target, whatever they were read from: text or archive.

use xxhash_rust::xxh3::Xxh3;

use crate::target::Row;

/// Hash over rows in their order: equal displacement, equal hash. Zeros of either sign are equal.
#[derive(Default)]
pub(crate) struct ContentHash(Xxh3);

impl ContentHash {
    pub(crate) fn add(&mut self, index: u32, delta: [f32; 3]) {
        let [x, y, z] = delta.map(|part| (part + 0.0).to_le_bytes());
        let mut row = [0; 16];
        for (to, from) in row.chunks_exact_mut(4).zip([index.to_le_bytes(), x, y, z]) {
            to.copy_from_slice(&from);
        }
        self.0.update(&row);
    }

    /// Over all of these rows.
    pub(crate) fn of<'r>(rows: impl IntoIterator<Item = &'r Row>) -> u64 {
        let mut hash = Self::default();
        rows.into_iter().for_each(|row| hash.add(row.0, row.1));
        hash.finish()
    }

    pub(crate) fn finish(&self) -> u64 {
        self.0.digest()
    }
}
