//! Bounds on what is read. Assets come from strangers: nothing in them is trusted as a size.

/// Bounds of one run.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Largest file that is read at all, in bytes.
    pub file_bytes: u64,
    /// Largest unpacked size of a packed file, in bytes.
    pub unpacked_bytes: u64,
    /// Largest ratio of unpacked to packed size once [`Limits::ratio_free_bytes`] are passed.
    pub unpacked_ratio: u64,
    /// Unpacked bytes up to which the ratio does not matter.
    pub ratio_free_bytes: u64,
}

impl Default for Limits {
    /// The largest known asset (a mesh with 30 MB) fits many times; text packs 3 to 10 fold.
    fn default() -> Self {
        Self {
            file_bytes: 512 << 20,
            unpacked_bytes: 512 << 20,
            unpacked_ratio: 200,
            ratio_free_bytes: 16 << 20,
        }
    }
}

/// Assets pack three to ten fold, and their texts become several times as large in memory.
const PACK_RATIO: u64 = 100;
/// Arrays of numbers pack two to five fold, and become several times as large in memory.
const ARRAY_RATIO: u64 = 32;
/// Unpacked bytes up to which that ratio does not matter: a packed cube.
const ARRAY_FREE_BYTES: u64 = 64 << 10;

/// Unpacked bytes up to which the ratio does not matter for all packed files of a folder together.
const FREE_OF_ALL: u64 = 32 << 20;
/// What of that one file has at least, however many there are.
const FREE_OF_ONE: u64 = 64 << 10;

impl Limits {
    /// Those of one of so many packed files: thousands of them would be too much together.
    #[must_use]
    pub fn among(&self, packed_files: usize) -> Self {
        let share = FREE_OF_ALL / (packed_files as u64).max(1);
        Self {
            ratio_free_bytes: self.ratio_free_bytes.min(share.max(FREE_OF_ONE)),
            ..*self
        }
    }

    /// Those of a zip with assets.
    #[must_use]
    pub fn of_pack(&self) -> Self {
        Self {
            unpacked_ratio: self.unpacked_ratio.min(PACK_RATIO),
            ..*self
        }
    }

    /// Those of an archive of arrays.
    #[must_use]
    pub fn of_arrays(&self) -> Self {
        Self {
            unpacked_ratio: self.unpacked_ratio.min(ARRAY_RATIO),
            ratio_free_bytes: self.ratio_free_bytes.min(ARRAY_FREE_BYTES),
            ..*self
        }
    }

    /// Unpacked bytes that a file of `packed` bytes may have.
    pub fn unpacked_limit(&self, packed: u64) -> u64 {
        let by_ratio = packed
            .saturating_mul(self.unpacked_ratio)
            .max(self.ratio_free_bytes);
        by_ratio.min(self.unpacked_bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_packed_files_share_what_is_free() {
        let of_each = |files| Limits::default().among(files).ratio_free_bytes;
        assert_eq!(
            [0, 1, 2, 4, 512, 9999].map(of_each),
            [16 << 20, 16 << 20, 16 << 20, 8 << 20, 64 << 10, 64 << 10]
        );
    }
}
