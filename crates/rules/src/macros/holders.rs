//! Which components have values, by value.

use std::collections::BTreeSet;

use mhlint_formats::macro_json::{Component, MacroFile};

/// The components of a file by their values.
pub(super) struct Holders<'a> {
    components: &'a [Component],
    /// Values, each with the place of its component.
    values: BTreeSet<(&'a str, usize)>,
}

impl<'a> Holders<'a> {
    pub(super) fn of(macros: &'a MacroFile) -> Self {
        let components = macros.components.iter().enumerate();
        let values = components.flat_map(|(at, component)| {
            let values = component.values.iter();
            values.map(move |value| (value.as_str(), at))
        });
        Self {
            components: &macros.components,
            values: values.collect(),
        }
    }

    /// The components that have all of some values, in the order of the file.
    pub(super) fn of_all<'h>(
        &'h self,
        values: &'h [&'h str],
    ) -> impl Iterator<Item = &'a Component> + use<'a, 'h> {
        let of_first = values.first().into_iter().flat_map(|first| {
            let places = self.values.range((*first, 0)..);
            let own = places.take_while(move |(value, _)| value == first);
            own.map(|(_, at)| *at)
        });
        let has_all = |at: &usize| values.iter().all(|own| self.values.contains(&(*own, *at)));
        of_first
            .filter(has_all)
            .filter_map(|at| self.components.get(at))
    }
}
