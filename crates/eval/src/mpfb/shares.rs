//! The shares that the names of a setting have at a value.
//!
//! Gets parts and a value, returns names by number with their shares. Source: MPFB, macro settings
//! (`docs/loaders/mpfb/macros.md#shares-of-a-setting`).

/// A range between two names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Where it begins, this value excluded.
    pub lowest: f64,
    /// Where it ends, this value excluded.
    pub highest: f64,
    /// Name at the beginning.
    pub low: Option<u32>,
    /// Name at the end.
    pub high: Option<u32>,
}

impl Part {
    /// Whether a value is in it.
    pub fn holds(&self, value: f64) -> bool {
        self.lowest < value && value < self.highest
    }

    /// Shares of the beginning and of the end at a value.
    pub fn shares(&self, value: f64) -> [f64; 2] {
        let share = (value - self.lowest) / (self.highest - self.lowest);
        [rounded(1.0 - share), rounded(share)]
    }
}

/// Names with their shares, in the order of the parts; those of 0 as well. A name of several parts
/// comes several times.
pub fn shares(parts: &[Part], value: f64) -> Vec<(u32, f64)> {
    let of_part = |part: &Part| {
        let [low, high] = part.shares(value);
        [
            part.low.map(|name| (name, low)),
            part.high.map(|name| (name, high)),
        ]
    };
    parts
        .iter()
        .filter(|part| part.holds(value))
        .flat_map(of_part)
        .flatten()
        .collect()
}

/// To four decimals as Python rounds: the number as it is stored, halves to even.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.4}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HALF: [Part; 2] = [
        Part {
            lowest: -0.01,
            highest: 0.5,
            low: Some(0),
            high: Some(1),
        },
        Part {
            lowest: 0.5,
            highest: 1.01,
            low: Some(1),
            high: Some(2),
        },
    ];

    #[test]
    fn the_bounds_themselves_have_no_share() {
        assert_eq!(shares(&HALF, 0.5), []);
        assert_eq!(shares(&HALF, 1.01), []);
        assert_eq!(shares(&HALF, f64::NAN), []);
        assert_eq!(shares(&HALF, 0.0), [(0, 0.9804), (1, 0.0196)]);
        assert_eq!(shares(&HALF, 1.005), [(1, 0.0098), (2, 0.9902)]);
    }

    #[test]
    fn names_without_shape_have_no_share() {
        let part = Part {
            low: None,
            ..HALF[0]
        };
        assert_eq!(shares(&[part], 0.245), [(1, 0.5)]);
    }

    #[test]
    fn a_name_of_two_parts_comes_twice() {
        let wide = Part {
            highest: 0.75,
            ..HALF[0]
        };
        assert_eq!(shares(&[wide, HALF[1]], 0.5001).len(), 4);
        let turned = Part {
            lowest: 0.5,
            highest: 0.25,
            ..HALF[0]
        };
        assert_eq!(shares(&[turned], 0.3), []);
    }

    #[test]
    fn decimals_are_rounded_as_python_does() {
        // The first three are exact halves; 0.00005 is stored a little above, 0.00015 a little
        // below one.
        let cases = [
            (0.031_25, 0.0312),
            (0.093_75, 0.0938),
            (-0.031_25, -0.0312),
            (0.000_05, 0.0001),
            (0.000_15, 0.0001),
        ];
        for (value, expected) in cases {
            assert_eq!(rounded(value), expected, "{value}");
        }
        assert!(rounded(f64::NAN).is_nan());
    }
}
