//! Modifiers of MakeHuman 1 with their targets, descriptions and sliders.

pub(crate) mod default_value;
pub(crate) mod description;
pub(crate) mod duplicate;
pub(crate) mod equal_tails;
pub(crate) mod meant;
pub(crate) mod merged_boxes;
pub(crate) mod missing_companion;
pub(crate) mod missing_ruler;
pub(crate) mod missing_symmetric;
pub(crate) mod no_target;
pub(crate) mod renamed;
pub(crate) mod second_group;
mod spellings;
pub(crate) mod tab_clash;
pub(crate) mod unknown_in_slider;
pub(crate) mod unknown_macro_variable;
pub(crate) mod unknown_type;
pub(crate) mod unknown_view;
pub(crate) mod unpaired_tails;
pub(crate) mod unread;
pub(crate) mod unused;

use super::Rule;
use mhlint_repo::makehuman1::{KnownModifier, View};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &default_value::RULE,
    &description::OF_TYPE,
    &description::RULE,
    &duplicate::RULE,
    &equal_tails::RULE,
    &merged_boxes::RULE,
    &missing_companion::RULE,
    &missing_ruler::RULE,
    &missing_symmetric::RULE,
    &no_target::RULE,
    &renamed::RULE,
    &second_group::RULE,
    &tab_clash::RULE,
    &unknown_in_slider::RULE,
    &unknown_macro_variable::RULE,
    &unknown_type::RULE,
    &unknown_view::RULE,
    &unpaired_tails::RULE,
    &unread::RULE,
    &unused::UNDESCRIBED,
    &unused::WITHOUT_SLIDER,
];

/// What one bad slider costs (`docs/loaders/makehuman1/modifiers.md#what-a-failing-slider-costs`).
const LOST_TABS: &str = "shows neither the rest of its tab nor the tabs behind it in the file";
/// What one bad modifier costs.
const LOST_FILE: &str = "loads no further modifiers of the file and shows none of its tabs";

/// Whether it can be known which targets there are: in an archive nobody looks, and none is found
/// where the names of folders stop the search.
fn knows_targets(view: &View<'_>) -> bool {
    !view.targets.is_packed && view.targets.clashes.is_empty()
}

/// Whether no file makes any target of a modifier. That is a finding of its own
/// (`modifiers-no-target`), and the name is what is wrong: that no other file has it follows.
fn moves_nothing(view: &View<'_>, one: &KnownModifier<'_>) -> bool {
    let mut parts = one.parts.iter();
    knows_targets(view) && !is_hidden(view, one) && parts.all(|part| part.targets.is_empty())
}

/// Whether an archive hides a target of a modifier, which has a finding of its own.
fn is_hidden(view: &View<'_>, one: &KnownModifier<'_>) -> bool {
    let mut parts = one.parts.iter();
    parts.any(|part| part.targets.is_empty() && view.targets.hides(&part.group))
}

/// Whether an earlier modifier has the name, which is a finding of its own (`modifiers-duplicate`).
fn is_copy(view: &View<'_>, one: &KnownModifier<'_>) -> bool {
    let mut called = view.modifiers.called(&one.name);
    called.next().is_some_and(|first| !std::ptr::eq(first, one))
}
