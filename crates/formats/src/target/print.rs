//! What rows of targets are compared by where `MakeHuman` 1 packs them: thousandths of a decimetre
//! in 16 bits, and the vertex in 16 bits (`docs/loaders/makehuman1/target-archive.md#content`).

/// Added to a number this moves its whole part, rounded to even, to the lowest bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// An odd number that spreads bits.
const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;

/// A hash over rows in their order. It is made of every target of a repository, so it costs a few
/// instructions a row.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PackedPrint(u64);

impl PackedPrint {
    /// Takes a row, its displacement in thousandths of a decimetre. What does not fit goes around,
    /// as `NumPy` lets it.
    #[inline]
    pub(crate) fn add(&mut self, vertex: u32, [x, y, z]: [f64; 3]) {
        let part = |number: f64| (number + WHOLE).to_bits() & 0xffff;
        let row = part(x) << 48 | part(y) << 32 | part(z) << 16 | u64::from(vertex) & 0xffff;
        self.0 = (self.0.rotate_left(5) ^ row).wrapping_mul(SPREAD);
    }

    pub(crate) const fn finish(self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(rows: &[(u32, [f64; 3])]) -> u64 {
        let mut print = PackedPrint::default();
        rows.iter()
            .for_each(|(vertex, parts)| print.add(*vertex, *parts));
        print.finish()
    }

    #[test]
    fn numbers_are_rounded_to_even_and_go_around() {
        assert_eq!(
            of(&[(3, [119.4, -10_205.5, 0.5])]),
            of(&[(3, [119.0, -10_206.0, 0.0])])
        );
        assert_eq!(of(&[(3, [1.5, -1.5, -0.0])]), of(&[(3, [2.0, -2.0, 0.0])]));
        assert_eq!(
            of(&[(65_539, [33_100.0, -32_769.0, 65_536.0])]),
            of(&[(3, [-32_436.0, 32_767.0, 0.0])])
        );
    }

    #[test]
    fn rows_count_with_their_order_and_each_of_their_parts() {
        let rows = [(1, [1.0, 2.0, 3.0]), (2, [4.0, 5.0, 6.0])];
        for other in [
            vec![rows[1], rows[0]],
            vec![rows[0]],
            vec![rows[0], (2, [4.0, 5.0, 7.0])],
            vec![rows[0], (3, [4.0, 5.0, 6.0])],
            vec![rows[0], (2, [5.0, 4.0, 6.0])],
        ] {
            assert_ne!(of(&rows), of(&other), "{other:?}");
        }
    }
}
