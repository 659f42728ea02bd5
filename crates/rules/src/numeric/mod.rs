//! Rules on what evaluation measured: what a setting of the sliders does to shape, joints and
//! weights.
//!
//! A finding names the setting in the application's slider names and stands at the target that
//! moves the thing most, because that is where an author can act. What a damaged target does to
//! several things at once is told once: by the first rule in the order of [`Trouble`].

use std::collections::{BTreeMap, BTreeSet};

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
    let mut all = all_untold(body, measures);
    all.find(|(own, _)| *own == trouble).map(|(_, seen)| seen)
}

/// All that was seen, with the same exceptions.
fn all_untold<'m>(
    body: &Body<'_>,
    measures: &'m Measures,
) -> impl Iterator<Item = (Trouble, &'m Seen)> {
    let unsound = unsound_patterns(body);
    let is_sound = move |setting: &[SliderSetting]| {
        !setting
            .iter()
            .any(|(slider, _)| unsound.contains(slider.as_str()))
    };
    let seen = measures.space.iter().flat_map(gravest);
    seen.filter(move |(_, seen)| is_sound(&seen.setting))
}

/// What was seen, without what is less grave than something else of the same target.
fn gravest(space: &BTreeMap<Trouble, Seen>) -> impl Iterator<Item = (Trouble, &Seen)> {
    let mut targets: BTreeSet<&str> = BTreeSet::new();
    let seen = space.iter().map(|(trouble, seen)| (*trouble, seen));
    seen.filter(move |(_, seen)| {
        let target = seen.target.as_deref();
        target.is_none_or(|target| targets.insert(target))
    })
}

/// Patterns of the components whose steps have a finding of their own: outside of them, weights go
/// to any size.
fn unsound_patterns<'v>(body: &Body<'v>) -> BTreeSet<&'v str> {
    let components = body
        .macros
        .into_iter()
        .flat_map(|(_, file)| &file.components);
    let unsound =
        components.filter(|component| component.steps.is_some() && !has_sound_steps(component));
    unsound
        .filter_map(|component| component.pattern.as_deref())
        .collect()
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
        let told: Vec<Trouble> = gravest(&space).map(|(trouble, _)| trouble).collect();
        assert_eq!(told, [Trouble::ShortBone, Trouble::FlatPlane]);
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
