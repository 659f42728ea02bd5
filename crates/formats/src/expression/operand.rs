//! What is known of a part of an expression: its types, as far as they decide what may follow.

/// The types of value that an expression may have.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "one for each type of Python")]
pub struct Results {
    /// `bool`, which counts as a whole number.
    pub truth: bool,
    /// `int`.
    pub whole: bool,
    /// `float`.
    pub fraction: bool,
    /// `str`.
    pub text: bool,
}

impl Results {
    const NONE: Self = Self {
        truth: false,
        whole: false,
        fraction: false,
        text: false,
    };
    pub(super) const TRUTH: Self = Self {
        truth: true,
        ..Self::NONE
    };
    pub(super) const WHOLE: Self = Self {
        whole: true,
        ..Self::NONE
    };
    pub(super) const FRACTION: Self = Self {
        fraction: true,
        ..Self::NONE
    };
    /// Texts alone.
    pub const TEXT: Self = Self {
        text: true,
        ..Self::NONE
    };

    const fn either(self, other: Self) -> Self {
        Self {
            truth: self.truth || other.truth,
            whole: self.whole || other.whole,
            fraction: self.fraction || other.fraction,
            text: self.text || other.text,
        }
    }

    /// Of two that are added, or otherwise calculated with.
    const fn calculated(self, other: Self) -> Self {
        let whole = (self.whole || self.truth) && (other.whole || other.truth);
        Self {
            truth: false,
            whole,
            fraction: self.fraction || other.fraction,
            text: self.text || other.text,
        }
    }

    /// Of one that is rounded to digits.
    pub(super) const fn rounded(self) -> Self {
        Self {
            whole: self.whole || self.truth,
            fraction: self.fraction,
            ..Self::NONE
        }
    }
}

/// What is known of a part of the expression.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Operand {
    pub(super) results: Results,
    /// Value of a literal number, and whether it is an integer.
    pub(super) literal: Option<(f64, bool)>,
    /// Is the variable itself.
    pub(super) variable: bool,
    /// A power is somewhere in it.
    pub(super) power: bool,
    /// Is a text in quotes with one short `%` layout for a number.
    pub(super) is_layout: bool,
}

impl Operand {
    pub(super) const TRUTH: Self = Self::of(Results::TRUTH);
    pub(super) const WHOLE: Self = Self::of(Results::WHOLE);
    pub(super) const FRACTION: Self = Self::of(Results::FRACTION);
    pub(super) const TEXT: Self = Self::of(Results::TEXT);

    pub(super) const fn of(results: Results) -> Self {
        Self {
            results,
            literal: None,
            variable: false,
            power: false,
            is_layout: false,
        }
    }

    /// One or the other.
    pub(super) const fn either(self, other: Self) -> Self {
        Self {
            power: self.power || other.power,
            ..Self::of(self.results.either(other.results))
        }
    }

    /// Both calculated into one.
    pub(super) const fn calculated(self, other: Self) -> Self {
        Self {
            power: self.power || other.power,
            ..Self::of(self.results.calculated(other.results))
        }
    }

    pub(super) const fn clashes_with(self, other: Self) -> bool {
        (self.is_text() && other.is_number()) || (self.is_number() && other.is_text())
    }

    pub(super) const fn may_be_text(self) -> bool {
        self.results.text
    }

    pub(super) const fn is_text(self) -> bool {
        self.results.text && !self.may_be_number()
    }

    pub(super) const fn is_number(self) -> bool {
        !self.results.text && self.may_be_number()
    }

    const fn may_be_number(self) -> bool {
        self.results.truth || self.results.whole || self.results.fraction
    }
}
