//! Sliders bound to a base: their identity ("pattern") and where their files come from
//! (`docs/loaders/makehuman2/sliders.md#pattern`).

use crate::FileFacts;
use mhlint_diag::{Grouped, grouped};
use mhlint_formats::modelling::Slider;

/// A slider of a base.
#[derive(Debug)]
pub struct BoundSlider<'a> {
    /// The entry.
    pub slider: &'a Slider,
    /// File it stands in.
    pub file: &'a FileFacts,
    /// Its identity.
    pub pattern: Pattern,
    /// The identity it was meant to have, if its keys are misspelt.
    pub meant: Pattern,
}

impl<'a> BoundSlider<'a> {
    /// Whether this has two targets whose endings `target-opposites` does not cover: only one side
    /// is used.
    pub fn is_undeclared_pair(&self) -> bool {
        matches!(self.pattern, Pattern::Single(_)) && self.slider.decr.is_some()
    }

    /// The patterns of which this would have one if its pair of endings were declared: one for
    /// each ending that `incr` may have.
    pub fn undeclared(&self) -> impl Iterator<Item = Undeclared<'a>> + use<'a> {
        let slider = self.slider;
        let decr = slider.decr.as_deref().filter(|_| self.is_undeclared_pair());
        let both = decr.zip(slider.incr.as_deref());
        both.into_iter().flat_map(move |(decr, incr)| {
            let endings = incr.match_indices('-');
            endings.filter_map(move |(dash, _)| Some((slider.user, decr, incr.get(dash + 1..)?)))
        })
    }
}

/// The pattern of a pair: whether it is of a user target, `decr`, and the ending of `incr`.
pub type Undeclared<'s> = (bool, &'s str, &'s str);

/// What a pattern may be that of: a user target, or a target in a folder `custom`.
pub fn as_undeclared(pattern: &str) -> impl Iterator<Item = Undeclared<'_>> {
    let of_user = pattern.strip_prefix("custom/");
    let both = [(false, Some(pattern)), (true, of_user)];
    both.into_iter().filter_map(|(user, pattern)| {
        let (decr, ending) = pattern?.split_once('|')?;
        Some((user, decr, ending))
    })
}

/// Identity of a slider in models, presets, symmetry and macros.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Pattern {
    /// A barycentric set registers each of its texts.
    Barycentric(Vec<String>),
    /// Read by `macro.json`.
    Macro(String),
    /// Two-sided: `<decr>|<ending of incr>`.
    Pair(String),
    /// One-sided: the `incr` path.
    Single(String),
    /// No `incr`: cannot be set, is never saved.
    None,
}

impl BoundSlider<'_> {
    /// The entry without its misspelt keys, if it has any; else the entry.
    pub fn as_meant(&self) -> &Slider {
        self.slider.meant.as_deref().unwrap_or(self.slider)
    }
}

impl Pattern {
    /// Pattern of a slider, given `target-opposites` of `base.json`.
    pub fn of(slider: &Slider, opposites: &Opposites<'_>) -> Self {
        if let Some(patterns) = &slider.barycentric {
            return Self::Barycentric(patterns.clone());
        }
        if let Some(pattern) = &slider.macro_pattern {
            return Self::Macro(pattern.clone());
        }
        let Some(incr) = &slider.incr else {
            return Self::None;
        };
        let prefix = if slider.user { "custom/" } else { "" };
        let pair = slider.decr.as_ref().and_then(|decr| {
            opposites
                .covering(decr, incr)
                .map(|i| format!("{prefix}{decr}|{i}"))
        });
        pair.map_or_else(|| Self::Single(format!("{prefix}{incr}")), Self::Pair)
    }

    /// The names it registers.
    pub fn names(&self) -> &[String] {
        match self {
            Self::Barycentric(names) => names,
            Self::Macro(name) | Self::Pair(name) | Self::Single(name) => std::slice::from_ref(name),
            Self::None => &[],
        }
    }
}

/// `target-opposites` of `base.json`, by the ending of `decr`: place in the file and the ending of
/// `incr`.
pub struct Opposites<'o>(Grouped<&'o str, (usize, &'o str)>);

impl<'o> Opposites<'o> {
    /// For pairs in file order.
    pub fn of(pairs: &'o [(String, String)]) -> Self {
        let pairs = pairs.iter().enumerate();
        Self(grouped(pairs.map(|(place, (decr, incr))| {
            (decr.as_str(), (place, incr.as_str()))
        })))
    }

    /// The ending of `incr` in the first pair that both paths end in.
    fn covering(&self, decr: &str, incr: &str) -> Option<&'o str> {
        let endings = decr
            .match_indices('-')
            .filter_map(|(dash, _)| self.0.get(decr.get(dash + 1..)?));
        endings
            .flatten()
            .filter(|(_, ending)| ends_with(incr, ending))
            .min()
            .map(|(_, ending)| *ending)
    }
}

/// Whether a path ends in `-suffix`.
fn ends_with(path: &str, suffix: &str) -> bool {
    path.strip_suffix(suffix)
        .is_some_and(|rest| rest.ends_with('-'))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pattern(incr: Option<&str>, decr: Option<&str>, user: bool) -> Pattern {
        let slider = Slider {
            incr: incr.map(str::to_owned),
            decr: decr.map(str::to_owned),
            user,
            ..Slider::default()
        };
        Pattern::of(
            &slider,
            &Opposites::of(&[("decr".to_owned(), "incr".to_owned())]),
        )
    }

    #[test]
    fn pairs_need_a_declared_opposite() {
        assert_eq!(
            pattern(Some("a/b-incr"), Some("a/b-decr"), false),
            Pattern::Pair("a/b-decr|incr".to_owned())
        );
        assert_eq!(
            pattern(Some("a/b-up"), Some("a/b-down"), false),
            Pattern::Single("a/b-up".to_owned())
        );
        assert_eq!(pattern(None, Some("a/b-decr"), false), Pattern::None);
        assert_eq!(
            pattern(Some("f/x"), None, true),
            Pattern::Single("custom/f/x".to_owned())
        );
    }
}
