//! Rules on `modelling.json`, `target_cat.json` and user targets of MakeHuman 2.
//!
//! What they share: which of the files can be checked at all when another one is damaged, and the groups and
//! patterns that exist.

pub(super) mod barycentric_arity;
pub(super) mod blank_in_name;
pub(super) mod decr_only;
pub(super) mod default_range;
pub(super) mod display_text;
pub(super) mod duplicate_pattern;
pub(super) mod empty_category;
mod foreign;
mod generated;
mod groups;
pub(super) mod macro_without_influence;
mod marks;
pub(super) mod measure;
mod missing;
pub(super) mod missing_icon;
pub(super) mod missing_target;
pub(super) mod no_effect;
pub(super) mod one_sided_symmetry;
pub(super) mod opposites;
pub(super) mod text_slot;
pub(super) mod unknown_group;
pub(super) mod unknown_symmetry;
pub(super) mod unsafe_formula;
pub(super) mod user_key_collision;
pub(super) mod user_pair_at_top;

use super::cause::overlay::is_damaged;
use super::did_you_mean;
use crate::diag::Suggestions;
use crate::formats::modelling::Slider;
use crate::repo::makehuman2::{Base, BoundSlider};

/// The sliders, if their patterns can be told: `base.json` declares which pairs of targets make one slider.
fn with_patterns<'b, 'a>(base: &'b Base<'a>) -> Option<&'b [BoundSlider<'a>]> {
    base.settings().filter(|_| !is_damaged(&base.modelling)).map(|_| base.sliders.as_slice())
}

/// The counterpart of a slider that is read, behind its key: `rsym` before `lsym`.
fn counterpart(slider: &Slider) -> Option<(&'static str, &str)> {
    let right = slider.rsym.as_deref().map(|partner| ("rsym", partner));
    right.or_else(|| slider.lsym.as_deref().map(|partner| ("lsym", partner)))
}

/// What could be meant by an unknown pattern.
fn advice(base: &Base<'_>, name: &str, suggestions: &Suggestions) -> String {
    if let Some(slider) = base.entry(name)
        && let [pattern, ..] = slider.pattern.names()
    {
        return format!("write the pattern `{pattern}`; `{name}` is the key of the entry");
    }
    let patterns = base.sliders.iter().flat_map(|slider| slider.pattern.names()).map(String::as_str);
    did_you_mean(
        suggestions.nearest(name, patterns),
        "write a pattern: the `macro` of an entry, its `incr`, or `<decr>|<ending of incr>` for a pair",
    )
}
