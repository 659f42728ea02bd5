//! Values of modifiers that are outside the range of their sliders.

use mhlint_formats::mhm::Modifier;
use mhlint_repo::makehuman2::{Base, Pattern};

/// A modifier whose value is outside the range of its slider.
pub(super) struct Faulty<'m> {
    pub(super) modifier: &'m Modifier,
    pub(super) value: f64,
    is_two_sided: bool,
    /// Whether the slider is divided into steps, of which the last ends at 1.
    has_steps: bool,
    /// Whether the slider has a target for negative values, although it shows no negative values.
    has_decr: bool,
}

/// The modifier, if its value is outside the range of its slider.
pub(super) fn faulty<'m>(base: &Base<'_>, modifier: &'m Modifier) -> Option<Faulty<'m>> {
    let value = *modifier
        .value
        .as_ref()
        .ok()
        .filter(|value| value.is_finite())?;
    let bound = base.slider(&modifier.pattern.text)?;
    let is_two_sided = matches!(bound.pattern, Pattern::Pair(_));
    let has_steps = matches!(bound.pattern, Pattern::Macro(_));
    let is_macro = has_steps || matches!(bound.pattern, Pattern::Barycentric(_));
    let least = if is_two_sided { -1.0 } else { 0.0 };
    let is_inside = (least..=1.0).contains(&value);
    let has_decr = is_macro || bound.slider.decr.is_some();
    (!is_inside).then_some(Faulty {
        modifier,
        value,
        is_two_sided,
        has_steps,
        has_decr,
    })
}

impl Faulty<'_> {
    pub(super) const fn range(&self) -> &'static str {
        if self.is_two_sided {
            "-1 to 1"
        } else {
            "0 to 1"
        }
    }

    pub(super) const fn effect(&self) -> &'static str {
        match (self.has_steps, self.value > 0.0) {
            (true, true) => "does not limit the value: the shape of this macro vanishes",
            (_, false) if !self.is_two_sided && !self.has_decr => "silently ignores the value",
            _ => "does not limit the value and exaggerates the shape",
        }
    }

    pub(super) fn help(&self) -> String {
        let value = self.value / 100.0;
        if self.value.abs() >= 2.0 && value.abs() <= 1.0 && (self.is_two_sided || value >= 0.0) {
            return format!("write {value} if you meant per cent");
        }
        format!("write a value from {}", self.range())
    }
}
