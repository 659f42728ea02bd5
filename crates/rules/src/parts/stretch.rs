//! Stretches of the settings that no part covers, and what MPFB drops there.

use std::ops::Range;

use super::super::enumerated;
use mhlint_diag::Level;
use mhlint_eval::mpfb::cover::{Hole, holes, is_live};
use mhlint_eval::mpfb::loops::DEFAULTS;
use mhlint_formats::macro_parts::{Part, Setting};
use mhlint_repo::mpfb::loops::{AGE, GENDER, LOOPS};
use mhlint_repo::mpfb::{Parts, View};

/// The value of every setting of a new character.
pub(super) const DEFAULT: f64 = DEFAULTS.0;

/// The macro settings, if they are those of the checked layer.
pub(super) fn checked<'v, 'a>(view: &'v View<'a>) -> Option<&'v Parts<'a>> {
    view.parts
        .as_ref()
        .filter(|parts| view.layers.is_checked(parts.file) && !parts.is_too_large)
}

/// The settings whose parts can all be read: of others nobody can tell what they cover.
pub(super) fn whole<'v>(parts: &'v Parts<'_>) -> impl Iterator<Item = &'v Setting> {
    parts
        .settings
        .settings
        .iter()
        .filter(|setting| setting.is_whole)
}

pub(super) fn ranges(setting: &Setting) -> Vec<(f64, f64)> {
    setting
        .parts
        .iter()
        .map(|part| (part.lowest, part.highest))
        .collect()
}

/// The holes of a setting in which a shape is lost. Where the names on both sides are empty there
/// is none.
pub(super) fn harmful(setting: &Setting) -> Vec<Hole> {
    let part = |number: Option<usize>| number.and_then(|number| setting.parts.get(number));
    let is_harmful = |hole: &Hole| {
        let (before, after) = (part(hole.before), part(hole.after));
        let is_named = |part: Option<&Part>, name: fn(&Part) -> &Option<String>| {
            part.is_some_and(|part| name(part).is_some())
        };
        is_named(before, |part| &part.high)
            || is_named(after, |part| &part.low)
            || before.is_none() && after.is_none()
    };
    holes(&ranges(setting))
        .into_iter()
        .filter(is_harmful)
        .collect()
}

/// The harmful holes where no part lies that never matches: such a part has a finding of its own.
pub(super) fn without_dead(setting: &Setting) -> Vec<Hole> {
    let holes = harmful(setting);
    // How many of the parts begin at a hole, less those that ended before it.
    let mut changes = vec![0_isize; holes.len() + 1];
    for touched in dead(setting).map(|part| touched(part, &holes)) {
        for (end, change) in [(touched.start, 1), (touched.end, -1)] {
            if let Some(own) = changes.get_mut(end) {
                *own += change;
            }
        }
    }
    let mut parts = 0;
    let with_parts = holes.into_iter().zip(changes);
    let free = with_parts.filter(|(_, change)| {
        parts += change;
        parts == 0
    });
    free.map(|(hole, _)| hole).collect()
}

/// The parts that never match.
pub(super) fn dead(setting: &Setting) -> impl Iterator<Item = &Part> {
    setting
        .parts
        .iter()
        .filter(|part| !is_live((part.lowest, part.highest)))
}

/// Which of the holes, which are in order, a part touches.
pub(super) fn touched(part: &Part, holes: &[Hole]) -> Range<usize> {
    let (from, to) = (part.lowest.min(part.highest), part.lowest.max(part.highest));
    // Of one without numbers nobody can tell.
    let start = holes.partition_point(|hole| hole.to < from);
    start..holes.partition_point(|hole| !(hole.from > to))
}

/// How bad holes, which are in order, are: without gender or age there is no shape at all, and at
/// the default no character.
pub(super) fn level(setting: &Setting, holes: &[Hole]) -> Level {
    let at_default = holes.get(holes.partition_point(|hole| hole.to < DEFAULT));
    let has_default = at_default.is_some_and(|hole| hole.from <= DEFAULT);
    if has_default && [GENDER, AGE].contains(&setting.place) {
        Level::Error
    } else {
        Level::Warning
    }
}

/// What `effect` calls the values where the finding names them.
pub(super) const THESE_VALUES: &str = "these values";

/// A hole in words.
pub(super) fn shown(hole: &Hole) -> String {
    if hole.from < hole.to {
        format!("{} to {}", hole.from, hole.to)
    } else {
        hole.from.to_string()
    }
}

/// What a user sees of values without a share.
pub(super) fn effect(setting: &Setting, level: Level, values: &str) -> String {
    let lost: Vec<&str> = LOOPS
        .iter()
        .filter(|own| own.needs(setting.place))
        .map(|own| own.title)
        .collect();
    match (level, lost.len() == LOOPS.len()) {
        (Level::Error, _) => {
            "makes characters without any shape key: 0.5 is the value of a new character".to_owned()
        }
        (_, true) => format!(
            "drops all macro targets at {values} ({})",
            enumerated(&lost)
        ),
        (_, false) => format!("drops the {} targets at {values}", enumerated(&lost)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    proptest::proptest! {
        #[test]
        fn holes_are_free_where_no_dead_part_touches_them(
            bounds in proptest::collection::vec((0_u8..12, 0_u8..12), 0..8),
            at in 0_usize..8,
        ) {
            let number = |eighth: u8| match eighth {
                11 => f64::NAN,
                eighth => f64::from(eighth) / 8.0 - 0.1,
            };
            let part = |(index, (lowest, highest)): (usize, &(u8, u8))| Part {
                index,
                lowest: number(*lowest),
                highest: number(*highest),
                low: Some("low".to_owned()),
                high: Some("high".to_owned()),
            };
            let setting = Setting {
                place: GENDER,
                parts: bounds.iter().enumerate().map(part).collect(),
                is_whole: true,
            };
            let holes = harmful(&setting);
            let touches = |part: &Part, hole: &Hole| {
                let (from, to) = (part.lowest.min(part.highest), part.lowest.max(part.highest));
                !(from > hole.to || to < hole.from)
            };
            let mut free = holes.clone();
            free.retain(|hole| !dead(&setting).any(|part| touches(part, hole)));
            proptest::prop_assert_eq!(without_dead(&setting), free);
            if let Some(part) = setting.parts.get(at) {
                let mut own = holes.clone();
                own.retain(|hole| touches(part, hole));
                proptest::prop_assert_eq!(holes.get(touched(part, &holes)), Some(&*own));
            }
        }
    }
}
