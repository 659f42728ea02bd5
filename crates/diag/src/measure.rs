//! How much of a fault there is, where a fault can grow.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

/// What a measure is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeasureKind {
    /// How many elements show the fault.
    Count,
    /// How far something is from where it should be, mesh units.
    Distance,
    /// How much of a range nothing covers.
    Gap,
    /// A part of a whole.
    Share,
    /// How many times as much as expected, or how far from one.
    Factor,
    /// How long something is, mesh units.
    Length,
    /// Weights of a vertex, together or alone.
    Weight,
    /// The sine of an angle.
    Sine,
}

/// Which way a measure becomes worse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Towards {
    /// Up, or away from zero.
    More,
    /// Down to zero.
    Less,
    /// Away from one.
    AwayFromOne,
}

/// What the worst value of a rule's findings measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grows {
    /// What.
    pub of: MeasureKind,
    /// Which way.
    pub towards: Towards,
}

impl Grows {
    /// A measure that becomes worse as it becomes more.
    pub const fn more(of: MeasureKind) -> Option<Self> {
        Some(Self {
            of,
            towards: Towards::More,
        })
    }

    /// One that becomes worse as it becomes less.
    pub const fn less(of: MeasureKind) -> Option<Self> {
        Some(Self {
            of,
            towards: Towards::Less,
        })
    }

    /// One that should be one.
    pub const fn from_one(of: MeasureKind) -> Option<Self> {
        Some(Self {
            of,
            towards: Towards::AwayFromOne,
        })
    }

    /// How bad a value is.
    fn badness(self, value: f64) -> f64 {
        match self.towards {
            Towards::More => value.abs(),
            Towards::Less => 1.0 / value.abs().max(ROUNDING),
            Towards::AwayFromOne => (value - 1.0).abs(),
        }
    }
}

/// A fault that grew by less than this share is the same.
const A_TENTH: f64 = 1.1;
/// What two computers may differ by.
const ROUNDING: f64 = 1e-6;

/// How much of a fault there is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure {
    /// What grows, and which way.
    pub grows: Grows,
    /// The value.
    pub value: Figure,
}

impl Measure {
    /// Whether it is worse than a value before, by more than a tenth and more than rounding.
    pub fn is_worse_than(self, before: Figure) -> bool {
        let (before, now) = (
            self.grows.badness(before.0),
            self.grows.badness(self.value.0),
        );
        now > before * A_TENTH && now - before > ROUNDING
    }

    /// Whether it is better than a value before, by as much.
    pub fn is_better_than(self, before: Figure) -> bool {
        Self {
            value: before,
            ..self
        }
        .is_worse_than(self.value)
    }

    /// Which of two values is worse.
    pub fn compare(self, one: Figure, other: Figure) -> Ordering {
        self.grows
            .badness(one.0)
            .total_cmp(&self.grows.badness(other.0))
    }
}

/// A number that can be sorted.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Figure(pub f64);

impl PartialEq for Figure {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Figure {}

impl PartialOrd for Figure {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Figure {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// A measure that became worse.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Grown {
    /// What of.
    pub of: MeasureKind,
    /// What it was.
    pub from: f64,
    /// What it is.
    pub to: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_worse(grows: Option<Grows>, before: f64, now: f64) -> bool {
        Measure {
            grows: grows.unwrap(),
            value: Figure(now),
        }
        .is_worse_than(Figure(before))
    }

    #[test]
    fn worse_is_more_than_a_tenth_and_more_than_rounding() {
        let count = Grows::more(MeasureKind::Count);
        assert!(
            !is_worse(count, 10.0, 11.0)
                && is_worse(count, 10.0, 12.0)
                && !is_worse(count, 10.0, 5.0)
        );
        assert!(
            !is_worse(Grows::more(MeasureKind::Distance), 1e-7, 5e-7),
            "rounding"
        );
        assert!(
            is_worse(Grows::more(MeasureKind::Weight), -0.1, -0.2),
            "away from zero"
        );
    }

    #[test]
    fn a_length_is_worse_when_less_and_a_sum_away_from_one() {
        assert!(is_worse(Grows::less(MeasureKind::Length), 0.02, 0.01));
        assert!(!is_worse(Grows::less(MeasureKind::Length), 0.01, 0.02));
        assert!(is_worse(Grows::from_one(MeasureKind::Weight), 0.9, 0.8));
        assert!(!is_worse(Grows::from_one(MeasureKind::Weight), 0.9, 1.05));
    }

    #[test]
    fn what_is_no_number_is_worse_only_than_numbers() {
        let more = Grows::more(MeasureKind::Factor);
        assert!(
            !is_worse(more, f64::NAN, f64::NAN) && !is_worse(more, f64::INFINITY, f64::INFINITY)
        );
        assert!(is_worse(more, 1.0, f64::INFINITY));
    }
}
