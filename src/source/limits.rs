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
        Self { file_bytes: 512 << 20, unpacked_bytes: 512 << 20, unpacked_ratio: 200, ratio_free_bytes: 16 << 20 }
    }
}

/// Arrays of numbers pack two to five fold, and become several times as large in memory.
const ARRAY_RATIO: u64 = 32;
/// Unpacked bytes up to which that ratio does not matter: a packed cube.
const ARRAY_FREE_BYTES: u64 = 64 << 10;

impl Limits {
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
        let by_ratio = packed.saturating_mul(self.unpacked_ratio).max(self.ratio_free_bytes);
        by_ratio.min(self.unpacked_bytes)
    }
}
