//! Shares of one macro component at one slider value.
//!
//! Gets steps or barycentric numbers, returns at most three (value, weight) pairs, or why the
//! component drops out of the product. Knows no names and no targets. Source: MakeHuman 2, macro
//! calculation (`docs/loaders/makehuman2/macros.md#evaluation`,
//! `docs/loaders/makehuman2/macros.md#special-cases`).

use std::fmt;

/// The value below a slider position counts only while the interpolation number is below this.
pub const LOWER_LIMIT: f64 = 0.999;
/// The value above a slider position, and every corner of a triangle, counts only above this.
pub const UPPER_LIMIT: f64 = 0.001;

/// One value of a component and its weight.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// Position in the component's `values`.
    pub value: usize,
    /// Nominally 0..1; above 1 below the first step.
    pub weight: f64,
}

/// The shares of a component: the application has room for three.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shares {
    items: [Share; 3],
    len: usize,
}

impl Shares {
    /// The shares in the order of `values`. Empty: the macrodef yields no combination at all.
    pub fn as_slice(&self) -> &[Share] {
        self.items.get(..self.len).unwrap_or_default()
    }

    /// A fourth share is lost, as in the application.
    fn push(&mut self, value: usize, weight: f64) {
        if let Some(slot) = self.items.get_mut(self.len) {
            *slot = Share { value, weight };
            self.len += 1;
        }
    }
}

/// What a component gives to the product.
#[derive(Clone, Copy, Debug)]
pub enum ComponentState {
    /// It takes part with these shares.
    Shares(Shares),
    /// It is left out; the names of the combinations become shorter.
    Dropped(DropReason),
}

/// Why a component has no part in the combinations of a macrodef.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DropReason {
    /// `comp` names a component that is not defined: the name lacks this part.
    UnknownComponent,
    /// No slider is registered under `pattern`: the name lacks this part.
    UnknownPattern,
    /// Fewer than two steps: the name lacks this part.
    TooFewSteps,
    /// The slider stands above the last step: the name lacks this part.
    AboveLastStep,
    /// No share is left (all corners of a triangle at zero, or NaN): the macrodef yields no
    /// combination at all.
    NoShare,
}

/// A component that stops the application at this setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComponentFault {
    /// Two equal steps at the bottom: division by zero.
    EqualSteps,
    /// The value number that the steps ask for does not exist.
    MissingValue(usize),
    /// `sum` has no entry of this number.
    MissingSum(usize),
    /// A fourth value of a triangle is registered; a triangle has three numbers.
    FourthCorner,
    /// The entry of `sum` with this number names a slider that is no triangle.
    NotBarycentric(usize),
    /// The caller gave fewer settings than the slider numbers it promised.
    MissingSetting(usize),
}

impl fmt::Display for DropReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::UnknownComponent => "the component is not defined",
            Self::UnknownPattern => "no slider has its pattern",
            Self::TooFewSteps => "it has fewer than two steps",
            Self::AboveLastStep => "the slider is above the last step",
            Self::NoShare => "no value has a weight",
        })
    }
}

impl fmt::Display for ComponentFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::EqualSteps => f.write_str("two steps are equal, which divides by zero"),
            Self::MissingValue(value) => write!(
                f,
                "the steps reach value number {value}, which does not exist"
            ),
            Self::MissingSum(entry) => write!(f, "entry number {entry} of `sum` does not exist"),
            Self::FourthCorner => f.write_str("a triangle slider has only three values"),
            Self::NotBarycentric(entry) => {
                write!(
                    f,
                    "entry number {entry} of `sum` names a slider that is not a triangle"
                )
            }
            Self::MissingSetting(place) => write!(f, "setting number {place} is missing"),
        }
    }
}

/// Shares of a stepped component at slider position `slider` (as in a model file, nominally 0..1,
/// not clamped).
///
/// The interval is the first whose upper step is not below the position; below the first step the
/// first interval is extrapolated. Weights that the two limits leave out are not redistributed.
///
/// # Errors
/// `EqualSteps` and `MissingValue`, where the application stops.
pub fn stepped(
    slider: f64,
    steps: &[f64],
    value_count: usize,
) -> Result<ComponentState, ComponentFault> {
    // Sliders hold percent; the two roundings can lift a position over the last step.
    let position = slider * 100.0 / 100.0;
    // `!(a > b)`, not `a <= b`: NaN takes the first interval and then passes neither limit.
    let interval = steps
        .windows(2)
        .position(|pair| !matches!(pair, [_, upper] if position > *upper));
    let Some(i) = interval else {
        let reason = if steps.len() < 2 {
            DropReason::TooFewSteps
        } else {
            DropReason::AboveLastStep
        };
        return Ok(ComponentState::Dropped(reason));
    };
    let width = steps[i + 1] - steps[i];
    if width == 0.0 {
        return Err(ComponentFault::EqualSteps);
    }
    let c = (position - steps[i]) / width;
    let mut shares = Shares::default();
    for (value, weight, counts) in [(i, 1.0 - c, c < LOWER_LIMIT), (i + 1, c, c > UPPER_LIMIT)] {
        if counts && value >= value_count {
            return Err(ComponentFault::MissingValue(value));
        }
        if counts {
            shares.push(value, weight);
        }
    }
    Ok(ComponentState::Shares(shares))
}

/// Shares of a triangle: `corners` gives for each value its barycentric number, or `None` where no
/// slider is registered (left out). Nothing is normalised.
pub fn barycentric(corners: impl IntoIterator<Item = Option<f64>>) -> Shares {
    let mut shares = Shares::default();
    for (value, weight) in corners.into_iter().enumerate() {
        if let Some(weight) = weight.filter(|w| *w > UPPER_LIMIT) {
            shares.push(value, weight);
        }
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    const THIRDS: &[f64] = &[0.0, 0.5, 1.0];

    fn shares(slider: f64, steps: &[f64], count: usize) -> Vec<(usize, f64)> {
        match stepped(slider, steps, count).unwrap() {
            ComponentState::Shares(s) => s.as_slice().iter().map(|s| (s.value, s.weight)).collect(),
            ComponentState::Dropped(reason) => panic!("{reason:?}"),
        }
    }

    fn dropped(slider: f64, steps: &[f64]) -> Option<DropReason> {
        match stepped(slider, steps, steps.len()).unwrap() {
            ComponentState::Shares(_) => None,
            ComponentState::Dropped(reason) => Some(reason),
        }
    }

    #[test]
    fn middle_of_an_interval_is_shared() {
        assert_eq!(shares(0.75, &[0.0, 1.0], 2), [(0, 0.25), (1, 0.75)]);
        assert_eq!(shares(0.25, THIRDS, 3), [(0, 0.5), (1, 0.5)]);
    }

    #[test]
    fn a_step_belongs_to_the_interval_below() {
        assert_eq!(shares(0.5, THIRDS, 3), [(1, 1.0)]);
        assert_eq!(shares(0.0, THIRDS, 3), [(0, 1.0)]);
        assert_eq!(shares(1.0, THIRDS, 3), [(2, 1.0)]);
    }

    #[test]
    fn small_shares_vanish_without_compensation() {
        assert_eq!(shares(0.9992, &[0.0, 1.0], 2), [(1, 0.9992)]);
        assert_eq!(shares(0.9985, &[0.0, 1.0], 2).len(), 2);
        assert_eq!(shares(0.0008, &[0.0, 1.0], 2), [(0, 1.0 - 0.0008)]);
        // The limits are strict: at the limit itself the share is left out.
        assert_eq!(shares(0.001, &[0.0, 1.0], 2), [(0, 0.999)]);
        assert_eq!(shares(0.999, &[0.0, 1.0], 2).len(), 1);
    }

    #[test]
    fn below_the_first_step_the_lower_value_is_extrapolated() {
        let low = shares(0.5, &[0.6, 1.0], 2);
        assert_eq!(low.len(), 1);
        assert!((low[0].1 - 1.25).abs() < 1e-12);
        assert_eq!(shares(-1.0, &[0.0, 1.0], 2), [(0, 2.0)]);
    }

    #[test]
    fn above_the_last_step_the_component_is_dropped() {
        assert_eq!(dropped(5.0, THIRDS), Some(DropReason::AboveLastStep));
        assert_eq!(
            dropped(f64::INFINITY, THIRDS),
            Some(DropReason::AboveLastStep)
        );
        assert_eq!(dropped(1.0, THIRDS), None);
    }

    #[test]
    fn fewer_than_two_steps_drop_the_component() {
        assert_eq!(dropped(0.5, &[]), Some(DropReason::TooFewSteps));
        assert_eq!(dropped(0.5, &[0.0]), Some(DropReason::TooFewSteps));
    }

    #[test]
    fn equal_first_steps_divide_by_zero_only_at_or_below_them() {
        assert_eq!(
            stepped(0.0, &[0.0, 0.0, 1.0], 3).unwrap_err(),
            ComponentFault::EqualSteps
        );
        assert_eq!(shares(0.5, &[0.0, 0.0, 1.0], 3), [(1, 0.5), (2, 0.5)]);
    }

    #[test]
    fn equal_inner_steps_jump_to_the_next_interval() {
        let steps = [0.0, 0.5, 0.5, 1.0];
        assert_eq!(shares(0.5, &steps, 4), [(1, 1.0)]);
        assert_eq!(shares(0.75, &steps, 4), [(2, 0.5), (3, 0.5)]);
    }

    #[test]
    fn first_matching_interval_of_unordered_steps_is_used() {
        assert_eq!(shares(0.25, &[0.0, 1.0, 0.5], 3), [(0, 0.75), (1, 0.25)]);
    }

    #[test]
    fn missing_values_stop_only_where_they_are_reached() {
        assert_eq!(
            stepped(0.75, THIRDS, 2).unwrap_err(),
            ComponentFault::MissingValue(2)
        );
        assert_eq!(shares(0.25, THIRDS, 2).len(), 2);
        assert_eq!(shares(0.5, THIRDS, 2), [(1, 1.0)]);
    }

    #[test]
    fn surplus_values_are_unreachable() {
        assert_eq!(shares(1.0, &[0.0, 1.0], 5), [(1, 1.0)]);
    }

    #[test]
    fn nan_slider_leaves_no_share() {
        assert_eq!(shares(f64::NAN, THIRDS, 3), []);
    }

    #[test]
    fn triangle_takes_numbers_as_they_are() {
        let s = barycentric([Some(0.5), None, Some(0.9)]);
        assert_eq!(
            s.as_slice(),
            [
                Share {
                    value: 0,
                    weight: 0.5
                },
                Share {
                    value: 2,
                    weight: 0.9
                }
            ]
        );
        assert!(
            barycentric([Some(0.001), Some(0.0), Some(f64::NAN)])
                .as_slice()
                .is_empty()
        );
    }
}
