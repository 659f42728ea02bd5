//! How much work is done for the macros of a base: a small file may ask for any amount.

/// Steps of work that are done for the macros of a base: components looked at, combinations walked.
/// A character with twenty macro sliders takes a hundredth.
const STEPS: usize = 1 << 27;

/// How much of the work may still be done.
#[derive(Debug)]
pub struct Budget {
    left: usize,
    is_cut: bool,
}

impl Default for Budget {
    fn default() -> Self {
        Self::of(STEPS)
    }
}

impl Budget {
    /// A budget of so many steps.
    pub(super) const fn of(left: usize) -> Self {
        Self {
            left,
            is_cut: false,
        }
    }

    /// Steps that may still be done.
    #[cfg(test)]
    pub(super) const fn left(&self) -> usize {
        self.left
    }

    /// Whether something was left out.
    pub(super) const fn is_cut(&self) -> bool {
        self.is_cut
    }

    /// Whether work of so many steps may be done; notes what may not.
    pub(super) fn take(&mut self, steps: usize) -> bool {
        let left = self.left.checked_sub(steps);
        self.is_cut |= left.is_none();
        self.left = left.unwrap_or(self.left);
        left.is_some()
    }
}
