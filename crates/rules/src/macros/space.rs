//! The cross product of a macro definition: which names it can generate.
//!
//! Gets components and a definition, answers for single names; it never walks the product, which
//! may be huge.

use std::collections::{BTreeMap, BTreeSet};

use mhlint_formats::macro_json::{Component, MacroFile, Macrodef};

/// The components of a definition in the order of its names.
pub(super) struct Space<'a> {
    pub(super) axes: Vec<&'a Component>,
}

/// A value of each component, by position.
pub(super) type Combination = Vec<usize>;

impl<'a> Space<'a> {
    /// Nothing if a component is unknown, repeated, or repeats a value: other findings speak of
    /// those.
    pub(super) fn of(macros: &'a MacroFile, macrodef: &Macrodef) -> Option<Self> {
        let names: BTreeSet<&String> = macrodef.components.iter().collect();
        if names.is_empty() || names.len() < macrodef.components.len() {
            return None;
        }
        let find = |name: &String| {
            macros
                .components
                .iter()
                .find(|component| component.name == *name)
        };
        let axes: Vec<&Component> = macrodef
            .components
            .iter()
            .map(find)
            .collect::<Option<_>>()?;
        let is_plain = |axis: &&Component| {
            let values: BTreeSet<&String> = axis.values.iter().collect();
            !values.is_empty() && values.len() == axis.values.len()
        };
        axes.iter().all(is_plain).then_some(Self { axes })
    }

    /// Number of values of each component.
    pub(super) fn sizes(&self) -> Vec<usize> {
        self.axes.iter().map(|axis| axis.values.len()).collect()
    }

    /// Number of combinations, if it fits.
    pub(super) fn size(&self) -> Option<usize> {
        self.sizes()
            .into_iter()
            .try_fold(1_usize, usize::checked_mul)
    }

    /// The name of a combination.
    pub(super) fn name(&self, combination: &[usize]) -> String {
        let values = self
            .axes
            .iter()
            .zip(combination)
            .map(|(axis, value)| axis.values.get(*value));
        values
            .map(|value| value.map_or("", String::as_str))
            .collect::<Vec<_>>()
            .join("-")
    }

    /// The combination a name spells, the first if there are several.
    pub(super) fn parse(&self, name: &str) -> Option<Combination> {
        let layers = self.layers(name);
        let mut at = name.len() + 1;
        let mut combination = Vec::with_capacity(self.axes.len());
        for layer in layers.iter().rev() {
            let step = layer.get(&at)?;
            combination.push(step.value);
            at = step.from;
        }
        combination.reverse();
        Some(combination)
    }

    /// How many combinations spell a name.
    pub(super) fn spellings(&self, name: &str) -> usize {
        let last = self.layers(name).pop();
        last.and_then(|layer| Some(layer.get(&(name.len() + 1))?.ways))
            .unwrap_or(0)
    }

    /// For each component the places in the name that can be reached behind one of its values.
    fn layers(&self, name: &str) -> Vec<BTreeMap<usize, Step>> {
        let start = BTreeMap::from([(
            0,
            Step {
                from: 0,
                value: 0,
                ways: 1,
            },
        )]);
        let mut layers: Vec<BTreeMap<usize, Step>> = Vec::with_capacity(self.axes.len());
        for axis in &self.axes {
            let mut layer: BTreeMap<usize, Step> = BTreeMap::new();
            for (from, step) in layers.last().unwrap_or(&start) {
                for (value, text) in axis.values.iter().enumerate() {
                    let Some(rest) = name
                        .get(*from..)
                        .and_then(|rest| rest.strip_prefix(text.as_str()))
                    else {
                        continue;
                    };
                    if rest.is_empty() || rest.starts_with('-') {
                        let to = from + text.len() + 1;
                        let slot = layer.entry(to).or_insert(Step {
                            from: *from,
                            value,
                            ways: 0,
                        });
                        slot.ways = slot.ways.saturating_add(step.ways);
                    }
                }
            }
            layers.push(layer);
        }
        layers
    }
}

struct Step {
    from: usize,
    value: usize,
    ways: usize,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn component(values: &[&str]) -> Component {
        Component {
            values: values.iter().map(|value| (*value).to_owned()).collect(),
            ..Component::default()
        }
    }

    #[test]
    fn names_are_parsed_into_their_values() {
        let (gender, age) = (component(&["female", "male"]), component(&["child", "old"]));
        let space = Space {
            axes: vec![&gender, &age],
        };
        assert_eq!(space.parse("male-child"), Some(vec![1, 0]));
        assert_eq!(space.name(&[1, 0]), "male-child");
        for stranger in [
            "male",
            "child-male",
            "male-child-",
            "male-",
            "",
            "malechild",
            "male-child-old",
        ] {
            assert_eq!(space.parse(stranger), None, "{stranger}");
        }
    }

    #[test]
    fn dashes_make_several_spellings() {
        let (first, second) = (component(&["a", "a-b"]), component(&["c", "b-c"]));
        let space = Space {
            axes: vec![&first, &second],
        };
        assert_eq!(
            [
                space.spellings("a-b-c"),
                space.spellings("a-c"),
                space.spellings("c-a")
            ],
            [2, 1, 0]
        );
    }
}
