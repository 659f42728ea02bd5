//! Rules on what evaluation measured: what a setting of the sliders does to shape, joints and
//! weights.
//!
//! A finding names the setting in the application's slider names and stands at the target that
//! moves the thing most, because that is where an author can act. What a damaged target does to
//! several things at once is told once: by the first rule in the order of [`Trouble`].

use std::collections::BTreeMap;

use mhlint_diag::{Finding, Place};
use mhlint_eval::measures::{Measures, Seen};
use mhlint_eval::settings::SliderSetting;
use mhlint_eval::survey::Trouble;
use mhlint_formats::macro_json::{Component, MacroFile, Macrodef};
use mhlint_repo::Body;

use super::cause::component::has_sound_steps;
use super::{Rule, counted, percent};

mod collapsed_faces;
mod dead_range;
mod discontinuity;
mod exploded_vertex;
mod implausible_size;
mod joint_drift;
mod non_finite;
mod proxy_detached;
mod rest_skinning;
mod threshold_loss;
mod weights_sum;
mod zero_length_bone;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &collapsed_faces::RULE,
    &dead_range::RULE,
    &discontinuity::RULE,
    &exploded_vertex::RULE,
    &implausible_size::RULE,
    &joint_drift::RULE,
    &non_finite::RULE,
    &proxy_detached::RULE,
    &rest_skinning::RULE,
    &threshold_loss::RULE,
    &weights_sum::RULE,
    &zero_length_bone::RULE,
];

/// `message` at the target that moves the thing most, or without one at the mesh; beside it the
/// setting that shows it.
fn at_setting(rule: &Rule, body: &Body<'_>, seen: &Seen, message: &str) -> Finding {
    let mesh = || body.mesh.map(|(file, _)| file.path.clone());
    let path = seen.target.clone().or_else(mesh).unwrap_or_default();
    let asset = mesh().unwrap_or_default();
    let finding = Finding::new(&rule.info, path.clone(), Place::File, message).asset(asset);
    finding.related(path, Place::File, to_see(&seen.setting))
}

/// More sliders than this are not spelled out: only sampled settings have so many.
const MOST_NAMED: usize = 12;

/// What to set to see it: ``set `macrodetails/Age = 0` to see it``.
fn to_see(setting: &[SliderSetting]) -> String {
    if setting.is_empty() {
        return "all sliders at their defaults show it".to_owned();
    }
    let named = setting
        .iter()
        .take(MOST_NAMED)
        .map(|(slider, value)| format!("{slider} = {}", short(*value)));
    let named = named.collect::<Vec<_>>().join(", ");
    match setting.len().saturating_sub(MOST_NAMED) {
        0 => format!("set `{named}` to see it"),
        more => format!(
            "set `{named}` and {} to see it",
            counted(more, "more slider")
        ),
    }
}

fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// What was seen, unless something graver was seen of the same target, or the setting moves a
/// slider whose steps are at fault.
fn untold<'m>(body: &Body<'_>, measures: &'m Measures, trouble: Trouble) -> Option<&'m Seen> {
    let space = measures.space.as_ref()?;
    gravest(space, trouble).filter(|seen| !is_of_unsound_steps(body, &seen.setting))
}

/// What was seen, unless something graver was seen of the same target.
fn gravest(space: &BTreeMap<Trouble, Seen>, trouble: Trouble) -> Option<&Seen> {
    let seen = space.get(&trouble)?;
    let same = |other: &Seen| other.target.is_some() && other.target == seen.target;
    (!space.range(..trouble).any(|(_, other)| same(other))).then_some(seen)
}

/// Whether a setting moves a slider of a component whose steps have a finding of their own: outside
/// of them, weights go to any size.
fn is_of_unsound_steps(body: &Body<'_>, setting: &[SliderSetting]) -> bool {
    let components = body
        .macros
        .map(|(_, file)| file.components.as_slice())
        .unwrap_or_default();
    let mut unsound = components
        .iter()
        .filter(|component| component.steps.is_some() && !has_sound_steps(component));
    unsound.any(|component| {
        setting
            .iter()
            .any(|(slider, _)| component.pattern.as_ref() == Some(slider))
    })
}

/// A component of a macrodef by its position in `comp`.
fn component(
    macros: &MacroFile,
    macrodef: usize,
    position: usize,
) -> Option<(&Macrodef, &Component)> {
    let macrodef = macros.macrodefs.get(macrodef)?;
    let name = macrodef.components.get(position)?;
    Some((
        macrodef,
        macros
            .components
            .iter()
            .rev()
            .find(|component| component.name == *name)?,
    ))
}

/// What a macrodef is called in messages and keys.
fn title(macrodef: &Macrodef) -> String {
    macrodef.components.join("-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_target_is_told_once_by_the_gravest() {
        let seen = |target: &str| Seen {
            elements: Vec::new(),
            value: 1.0,
            element: 0,
            name: String::new(),
            count: 1,
            all: Vec::new(),
            length: None,
            setting: Vec::new(),
            target: Some(target.to_owned()),
        };
        let space = [
            (Trouble::ShortBone, "a"),
            (Trouble::FlatPlane, "b"),
            (Trouble::Drifted, "a"),
        ];
        let space = space
            .map(|(trouble, target)| (trouble, seen(target)))
            .into();
        assert!(gravest(&space, Trouble::ShortBone).is_some());
        assert!(gravest(&space, Trouble::FlatPlane).is_some());
        assert!(gravest(&space, Trouble::Drifted).is_none());
    }

    #[test]
    fn a_setting_is_worded_by_what_differs() {
        assert_eq!(to_see(&[]), "all sliders at their defaults show it");
        let setting = |count: usize| {
            (0..count)
                .map(|at| (format!("s{at}"), 0.25))
                .collect::<Vec<_>>()
        };
        assert_eq!(
            to_see(&[("Age".to_owned(), 0.0), ("nose".to_owned(), 1.0)]),
            "set `Age = 0, nose = 1` to see it"
        );
        assert!(to_see(&setting(13)).ends_with("s11 = 0.25` and 1 more slider to see it"));
    }
}
