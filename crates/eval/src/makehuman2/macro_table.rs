//! A macro system with its names resolved once, so that a setting is evaluated with numbers only.
//!
//! Gets components, macrodefs and the sliders registered for patterns; returns a `MacroTable` that
//! holds for every possible combination of every macrodef what its name leads to. `macro_eval`
//! walks it. Source: MakeHuman 2, macro calculation (`docs/loaders/makehuman2/macros.md#loading`,
//! `docs/loaders/makehuman2/macros.md#evaluation`).

use std::collections::HashMap;
use std::fmt;

use super::component::{ComponentFault, ComponentState, DropReason, barycentric, stepped};
use super::macro_def::{Blend, Component, Macrodef, Slider};

/// More combinations than this (over all macrodefs) are not tabulated; the largest shipped system
/// has about six thousand.
pub const MAX_COMBINATIONS: usize = 1 << 20;
/// Longest `comp` list that is evaluated; the largest shipped one has six entries.
pub const MAX_COMPONENTS: usize = 32;

/// What the name of a combination leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// No macrodef lists the name.
    Missing,
    /// Listed with null.
    Null,
    /// The target of this number.
    Target(u32),
}

/// Why a macro system or a setting has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MacroError {
    /// A component stops the application at this setting.
    Component {
        /// Number of the component.
        component: usize,
        /// What is wrong with it.
        fault: ComponentFault,
    },
    /// This macrodef passes `MAX_COMPONENTS` or `MAX_COMBINATIONS`: a limit of this evaluation, not
    /// of the application.
    TooLarge {
        /// Number of the macrodef.
        macrodef: usize,
    },
}

impl fmt::Display for MacroError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Component { component, fault } => {
                write!(f, "component number {component}: {fault}")
            }
            Self::TooLarge { macrodef } => {
                write!(
                    f,
                    "macrodef number {macrodef} has too many combinations to evaluate"
                )
            }
        }
    }
}

impl std::error::Error for MacroError {}

/// The compiled system: see the module.
#[derive(Clone, Debug)]
pub struct MacroTable {
    components: Vec<Compiled>,
    pub(super) macrodefs: Vec<MacrodefTable>,
    target_count: usize,
}

#[derive(Clone, Debug)]
struct Compiled {
    values: Vec<String>,
    source: Source,
    used: bool,
}

#[derive(Clone, Debug)]
enum Source {
    Unregistered,
    Steps { slider: Slider, steps: Vec<f64> },
    Sum(Vec<Corner>),
}

/// One value of a sum component: where its number is, or the fault of asking for it.
type Corner = Result<Option<usize>, ComponentFault>;

/// The combinations of one macrodef. A combination is a number: the sum over its positions of the
/// stride, times 0 (left out) or 1 plus the number of the value.
#[derive(Clone, Debug)]
pub(super) struct MacrodefTable {
    pub(super) positions: Vec<Position>,
    pub(super) links: Vec<Link>,
    /// Positions of `comp` whose component is not defined.
    pub(super) undefined: Vec<usize>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Position {
    /// Place in `comp`.
    pub(super) place: usize,
    pub(super) component: usize,
    radix: usize,
    pub(super) stride: usize,
}

impl MacroTable {
    /// Resolves all names. `slider` says which slider is registered under a pattern, if any.
    ///
    /// Of two components or links with one name the last counts, links across all macrodefs.
    ///
    /// # Errors
    /// `TooLarge`; nothing else, since a faulty component matters only at the settings that reach
    /// the fault.
    pub fn new(
        components: &[Component],
        macrodefs: &[Macrodef],
        slider: impl Fn(&str) -> Option<Slider>,
    ) -> Result<Self, MacroError> {
        let links: HashMap<&str, Option<u32>> = macrodefs
            .iter()
            .flat_map(|m| m.links.iter().copied())
            .collect();
        let by_name: HashMap<&str, usize> = components
            .iter()
            .enumerate()
            .map(|(i, c)| (c.name, i))
            .collect();
        let target_count = macrodefs
            .iter()
            .flat_map(|m| &m.links)
            .filter_map(|l| l.1)
            .max()
            .map_or(0, |t| t as usize + 1);
        let components = components
            .iter()
            .map(|c| Compiled::new(c, &slider))
            .collect();
        let mut table = Self {
            components,
            macrodefs: Vec::new(),
            target_count,
        };
        let mut room = MAX_COMBINATIONS;
        for (number, macrodef) in macrodefs.iter().enumerate() {
            let too_large = MacroError::TooLarge { macrodef: number };
            let mut compiled = table.positions(macrodef, &by_name, room).ok_or(too_large)?;
            compiled.links = vec![Link::Missing; compiled.combination_count()];
            room -= compiled.links.len();
            table.fill(&mut compiled, &links);
            table.macrodefs.push(compiled);
        }
        Ok(table)
    }

    /// Steps that evaluating one setting takes at most: steps of components looked through, and
    /// combinations walked. A slider gives a component up to two shares, a triangle three.
    pub fn cost(&self) -> usize {
        let components = self
            .components
            .iter()
            .filter(|component| component.used)
            .map(Compiled::cost);
        let macrodefs = self.macrodefs.iter().map(|table| {
            let shares = table.positions.iter().map(|position| {
                let most = self
                    .components
                    .get(position.component)
                    .map_or(1, |component| component.source.shares());
                (position.radix - 1).clamp(1, most)
            });
            // A tree has hardly more than twice as many nodes as leaves.
            shares
                .fold(2, usize::saturating_mul)
                .saturating_add(table.positions.len())
        });
        components.chain(macrodefs).fold(0, usize::saturating_add)
    }

    /// Highest target number plus one.
    pub fn target_count(&self) -> usize {
        self.target_count
    }

    /// Number of macrodefs.
    pub fn macrodef_count(&self) -> usize {
        self.macrodefs.len()
    }

    /// Number of combinations of a macrodef, those with components left out included.
    pub fn combination_count(&self, macrodef: usize) -> usize {
        self.macrodefs
            .get(macrodef)
            .map_or(0, |table| table.links.len())
    }

    /// Name of a combination: its values joined by `-`; components left out have no part.
    pub fn name(&self, macrodef: usize, combination: usize) -> String {
        let Some(table) = self.macrodefs.get(macrodef) else {
            return String::new();
        };
        let parts: Vec<&str> = table
            .positions
            .iter()
            .filter_map(|p| self.value_name(p, combination))
            .collect();
        parts.join("-")
    }

    /// What a combination leads to; `None` if there is no such combination.
    pub fn link(&self, macrodef: usize, combination: usize) -> Option<Link> {
        self.macrodefs
            .get(macrodef)?
            .links
            .get(combination)
            .copied()
    }

    /// The value of each defined component in a combination; `None` where the component is left
    /// out.
    pub fn values(
        &self,
        macrodef: usize,
        combination: usize,
    ) -> impl Iterator<Item = Option<usize>> {
        let positions = self
            .macrodefs
            .get(macrodef)
            .map(|table| table.positions.as_slice())
            .unwrap_or_default();
        positions
            .iter()
            .map(move |position| position.digit(combination).checked_sub(1))
    }

    /// Number of values of a component of a macrodef, by its place among the defined ones.
    pub(super) fn value_count(&self, macrodef: usize, position: usize) -> usize {
        let position = self
            .macrodefs
            .get(macrodef)
            .and_then(|table| table.positions.get(position));
        position.map_or(0, |position| position.radix - 1)
    }

    pub(super) fn component_count(&self) -> usize {
        self.components.len()
    }

    /// The state of a component at a setting; `None` if no macrodef uses it: the application does
    /// not look at it then.
    pub(super) fn state(
        &self,
        component: usize,
        settings: &[f64],
    ) -> Option<Result<ComponentState, MacroError>> {
        let compiled = self.components.get(component).filter(|c| c.used)?;
        Some(
            compiled
                .state(settings)
                .map_err(|fault| MacroError::Component { component, fault }),
        )
    }

    fn value_name(&self, position: &Position, combination: usize) -> Option<&str> {
        let value = position.digit(combination).checked_sub(1)?;
        self.components
            .get(position.component)?
            .values
            .get(value)
            .map(String::as_str)
    }

    fn positions(
        &mut self,
        macrodef: &Macrodef,
        by_name: &HashMap<&str, usize>,
        room: usize,
    ) -> Option<MacrodefTable> {
        if macrodef.components.len() > MAX_COMPONENTS {
            return None;
        }
        let mut table = MacrodefTable {
            positions: Vec::new(),
            links: Vec::new(),
            undefined: Vec::new(),
        };
        for (place, name) in macrodef.components.iter().enumerate() {
            let Some(&component) = by_name.get(name) else {
                table.undefined.push(place);
                continue;
            };
            let stride = table.combination_count();
            let compiled = &mut self.components[component];
            compiled.used = true;
            table.positions.push(Position {
                place,
                component,
                radix: compiled.values.len() + 1,
                stride,
            });
            if table.combination_count() > room {
                return None;
            }
        }
        (table.combination_count() <= room).then_some(table)
    }

    fn fill(&self, table: &mut MacrodefTable, links: &HashMap<&str, Option<u32>>) {
        let mut name = String::new();
        for combination in 0..table.links.len() {
            name.clear();
            for (i, part) in table
                .positions
                .iter()
                .filter_map(|p| self.value_name(p, combination))
                .enumerate()
            {
                name.push_str(if i > 0 { "-" } else { "" });
                name.push_str(part);
            }
            table.links[combination] = match links.get(name.as_str()) {
                None => Link::Missing,
                Some(None) => Link::Null,
                Some(Some(target)) => Link::Target(*target),
            };
        }
    }
}

impl MacrodefTable {
    fn combination_count(&self) -> usize {
        self.positions
            .last()
            .map_or(1, |p| p.stride.saturating_mul(p.radix))
    }
}

impl Position {
    fn digit(&self, combination: usize) -> usize {
        combination / self.stride % self.radix
    }
}

impl Source {
    /// Most values that have a share at once.
    const fn shares(&self) -> usize {
        match self {
            Self::Unregistered => 1,
            Self::Steps { .. } => 2,
            Self::Sum(_) => 3,
        }
    }
}

impl Compiled {
    /// What looking for its shares takes.
    fn cost(&self) -> usize {
        match &self.source {
            Source::Unregistered => 1,
            Source::Steps { steps, .. } => 1 + steps.len(),
            Source::Sum(corners) => 1 + corners.len(),
        }
    }

    fn new(component: &Component, slider: &impl Fn(&str) -> Option<Slider>) -> Self {
        let source = match &component.blend {
            Blend::Steps(steps) => match slider(component.pattern) {
                Some(slider) => Source::Steps {
                    slider,
                    steps: steps.clone(),
                },
                None => Source::Unregistered,
            },
            Blend::Sum(sum) => Source::Sum(
                (0..component.values.len())
                    .map(|i| corner(component.pattern, sum, i, slider))
                    .collect(),
            ),
        };
        Self {
            values: component.values.iter().map(ToString::to_string).collect(),
            source,
            used: false,
        }
    }

    fn state(&self, settings: &[f64]) -> Result<ComponentState, ComponentFault> {
        let at = |place: usize| {
            settings
                .get(place)
                .copied()
                .ok_or(ComponentFault::MissingSetting(place))
        };
        match &self.source {
            Source::Unregistered => Ok(ComponentState::Dropped(DropReason::UnknownPattern)),
            Source::Steps {
                slider: Slider::Value(place),
                steps,
            } => stepped(at(*place)?, steps, self.values.len()),
            // The own position of a triangle entry is never set from a model file.
            Source::Steps {
                slider: Slider::Barycentric(_),
                steps,
            } => stepped(0.0, steps, self.values.len()),
            Source::Sum(corners) => {
                let numbers: Result<Vec<_>, _> = corners
                    .iter()
                    .map(|corner| (*corner)?.map(at).transpose())
                    .collect();
                Ok(ComponentState::Shares(barycentric(numbers?)))
            }
        }
    }
}

/// Value number `i` takes number `i` of the triangle that is registered under pattern + `sum[i]`:
/// by place, not by name.
fn corner(
    pattern: &str,
    sum: &[&str],
    i: usize,
    slider: impl Fn(&str) -> Option<Slider>,
) -> Corner {
    let Some(entry) = sum.get(i) else {
        return Err(ComponentFault::MissingSum(i));
    };
    match slider(&format!("{pattern}{entry}")) {
        None => Ok(None),
        Some(Slider::Value(_)) => Err(ComponentFault::NotBarycentric(i)),
        Some(Slider::Barycentric(places)) => places
            .get(i)
            .map_or(Err(ComponentFault::FourthCorner), |place| Ok(Some(*place))),
    }
}
