//! Rules on `modelling.json`, `target_cat.json` and user targets of MakeHuman 2.
//!
//! What they share: which of the files can be checked at all when another one is damaged, and the
//! groups and patterns that exist.

mod absent_categories;
mod barycentric_arity;
mod blank_in_name;
mod decr_only;
mod default_range;
mod display_text;
mod duplicate_pattern;
mod empty_category;
mod foreign;
mod generated;
mod groups;
mod macro_without_influence;
mod marks;
mod measure;
mod missing;
mod missing_icon;
mod missing_target;
mod no_effect;
mod one_sided_symmetry;
mod opposites;
mod text_slot;
mod unknown_group;
mod unknown_symmetry;
mod unsafe_formula;
mod user_key_collision;
mod user_pair_at_top;

use super::Rule;
use super::cause::overlay::is_damaged;
use super::did_you_mean;
use mhlint_diag::Suggestions;
use mhlint_formats::modelling::Slider;
use mhlint_repo::makehuman2::{Base, BoundSlider};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &barycentric_arity::RULE,
    &blank_in_name::RULE,
    &decr_only::RULE,
    &default_range::RULE,
    &display_text::RULE,
    &duplicate_pattern::RULE,
    &empty_category::RULE,
    &macro_without_influence::RULE,
    &measure::RULE,
    &missing_icon::RULE,
    &missing_target::RULE,
    &no_effect::RULE,
    &one_sided_symmetry::RULE,
    &opposites::RULE,
    &text_slot::RULE,
    &unknown_group::RULE,
    &unknown_symmetry::RULE,
    &unsafe_formula::RULE,
    &user_key_collision::RULE,
    &user_pair_at_top::RULE,
];

/// The sliders, if their patterns can be told: `base.json` declares which pairs of targets make one
/// slider.
fn with_patterns<'b, 'a>(base: &'b Base<'a>) -> Option<&'b [BoundSlider<'a>]> {
    base.settings()
        .filter(|_| !is_damaged(&base.modelling))
        .map(|_| base.sliders.as_slice())
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
    let patterns = base
        .sliders
        .iter()
        .flat_map(|slider| slider.pattern.names())
        .map(String::as_str);
    did_you_mean(
        suggestions.nearest(name, patterns),
        "write a pattern: the `macro` of an entry, its `incr`, or `<decr>|<ending of incr>` for a \
            pair",
    )
}
