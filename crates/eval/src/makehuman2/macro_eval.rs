//! One setting of the macro sliders: every combination with its factor and fate, and the factor of
//! every target.
//!
//! Gets a `MacroTable` and the slider positions; fills a `MacroResult` that is meant to be reused.
//! No names are touched. Source: MakeHuman 2, macro calculation
//! (`docs/loaders/makehuman2/macros.md#evaluation`).

use super::component::{ComponentState, DropReason};
use super::macro_table::{Link, MacroError, MacroTable, MacrodefTable};

/// A combination counts only with a factor above this.
pub const FACTOR_LIMIT: f64 = 0.01;

/// What becomes of a combination.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// Its factor is added to the target of this number.
    Applied(u32),
    /// Listed with null: no morph, deliberately.
    Null,
    /// No such name: no morph, silently.
    Missing,
    /// Factor not above `FACTOR_LIMIT` (or NaN): the application does not look for its name.
    BelowThreshold,
}

/// One element of the cross product of a macrodef.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Combination {
    /// Number of the macrodef.
    pub macrodef: usize,
    /// Number of the combination; `MacroTable::name` spells it.
    pub number: usize,
    /// Product of the weights of its values.
    pub factor: f64,
    /// What becomes of it.
    pub fate: Fate,
}

/// A component without part in the combinations of a macrodef.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DroppedComponent {
    /// Number of the macrodef.
    pub macrodef: usize,
    /// Place in its `comp` list.
    pub place: usize,
    /// Why it has no part.
    pub reason: DropReason,
}

/// The outcome of one setting.
#[derive(Clone, Debug, Default)]
pub struct MacroResult {
    /// All combinations, macrodefs in file order, last component fastest.
    pub combinations: Vec<Combination>,
    /// Components without part, macrodefs in file order.
    pub dropped: Vec<DroppedComponent>,
    /// Target number and summed factor, in the order of first appearance.
    pub factors: Vec<(u32, f64)>,
    states: Vec<Option<ComponentState>>,
    slots: Vec<Option<usize>>,
}

impl MacroTable {
    /// Evaluates all macrodefs at `settings` (slider positions as in a model file, nominally 0..1,
    /// not clamped; places as the `Slider`s say).
    ///
    /// # Errors
    /// `Component`, where the application stops. `out` is then incomplete.
    pub fn evaluate(&self, settings: &[f64], out: &mut MacroResult) -> Result<(), MacroError> {
        out.combinations.clear();
        out.dropped.clear();
        out.states.clear();
        for component in 0..self.component_count() {
            out.states
                .push(self.state(component, settings).transpose()?);
        }
        for (number, table) in self.macrodefs.iter().enumerate() {
            out.note_dropped(number, table);
            out.expand(
                number,
                table,
                Node {
                    depth: 0,
                    combination: 0,
                    factor: 1.0,
                },
            );
        }
        out.add_up(self.target_count());
        Ok(())
    }
}

/// A place in the tree of combinations: the values chosen so far.
#[derive(Clone, Copy)]
struct Node {
    depth: usize,
    combination: usize,
    factor: f64,
}

impl MacroResult {
    fn state(&self, component: usize) -> Option<ComponentState> {
        self.states.get(component).copied().flatten()
    }

    fn note_dropped(&mut self, macrodef: usize, table: &MacrodefTable) {
        let unknown = table
            .undefined
            .iter()
            .map(|place| (*place, DropReason::UnknownComponent));
        let known = table
            .positions
            .iter()
            .filter_map(|p| match self.state(p.component)? {
                ComponentState::Dropped(reason) => Some((p.place, reason)),
                ComponentState::Shares(shares) => shares
                    .as_slice()
                    .is_empty()
                    .then_some((p.place, DropReason::NoShare)),
            });
        let mut found: Vec<_> = unknown.chain(known).collect();
        found.sort_by_key(|(place, _)| *place);
        self.dropped
            .extend(found.into_iter().map(|(place, reason)| DroppedComponent {
                macrodef,
                place,
                reason,
            }));
    }

    fn expand(&mut self, macrodef: usize, table: &MacrodefTable, node: Node) {
        let Some(position) = table.positions.get(node.depth) else {
            return self.leaf(macrodef, table, node);
        };
        let depth = node.depth + 1;
        match self.state(position.component) {
            Some(ComponentState::Shares(shares)) => {
                for share in shares.as_slice() {
                    let combination = node.combination + (share.value + 1) * position.stride;
                    self.expand(
                        macrodef,
                        table,
                        Node {
                            depth,
                            combination,
                            factor: node.factor * share.weight,
                        },
                    );
                }
            }
            Some(ComponentState::Dropped(_)) | None => {
                self.expand(macrodef, table, Node { depth, ..node });
            }
        }
    }

    fn leaf(&mut self, macrodef: usize, table: &MacrodefTable, node: Node) {
        // False for NaN, as in the application.
        let counts = node.factor > FACTOR_LIMIT;
        let fate = match table.links.get(node.combination) {
            _ if !counts => Fate::BelowThreshold,
            Some(Link::Target(target)) => Fate::Applied(*target),
            Some(Link::Null) => Fate::Null,
            Some(Link::Missing) | None => Fate::Missing,
        };
        self.combinations.push(Combination {
            macrodef,
            number: node.combination,
            factor: node.factor,
            fate,
        });
    }

    /// One factor a target, however many combinations lead to it.
    fn add_up(&mut self, target_count: usize) {
        self.factors.clear();
        self.slots.clear();
        self.slots.resize(target_count, None);
        for combination in &self.combinations {
            let Fate::Applied(target) = combination.fate else {
                continue;
            };
            let Some(slot) = self.slots.get_mut(target as usize) else {
                continue;
            };
            let place = *slot.get_or_insert(self.factors.len());
            match self.factors.get_mut(place) {
                Some((_, factor)) => *factor += combination.factor,
                None => self.factors.push((target, combination.factor)),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::component::ComponentFault;
    use super::super::macro_def::{Blend, Component, Macrodef, Slider};
    use super::*;

    fn steps<'a>(name: &'a str, values: &[&'a str], steps: &[f64]) -> Component<'a> {
        Component {
            name,
            pattern: name,
            values: values.to_vec(),
            blend: Blend::Steps(steps.to_vec()),
        }
    }

    fn sum<'a>(values: &[&'a str], sum: &[&'a str]) -> Component<'a> {
        Component {
            name: "race",
            pattern: "m/",
            values: values.to_vec(),
            blend: Blend::Sum(sum.to_vec()),
        }
    }

    fn human() -> Vec<Component<'static>> {
        vec![
            steps("gender", &["female", "male"], &[0.0, 1.0]),
            steps("age", &["baby", "young", "old"], &[0.0, 0.5, 1.0]),
            steps("muscle", &["min", "avg", "max"], &[0.0, 0.5, 1.0]),
            sum(&["a", "b", "c"], &["A", "B", "C"]),
        ]
    }

    /// Settings: gender, age, muscle, then the triangle A B C.
    fn slider(pattern: &str) -> Option<Slider> {
        match pattern {
            "gender" => Some(Slider::Value(0)),
            "age" => Some(Slider::Value(1)),
            "muscle" => Some(Slider::Value(2)),
            "m/A" | "m/B" | "m/C" => Some(Slider::Barycentric([3, 4, 5])),
            _ => None,
        }
    }

    fn comp<'a>(components: &[&'a str], links: &[(&'a str, Option<u32>)]) -> Macrodef<'a> {
        Macrodef {
            components: components.to_vec(),
            links: links.to_vec(),
        }
    }

    fn run(
        components: &[Component],
        macrodefs: &[Macrodef],
        settings: [f64; 6],
    ) -> (MacroTable, MacroResult) {
        let table = MacroTable::new(components, macrodefs, slider).unwrap();
        let mut result = MacroResult::default();
        table.evaluate(&settings, &mut result).unwrap();
        (table, result)
    }

    fn raw(
        components: &[Component],
        macrodefs: &[Macrodef],
        settings: [f64; 6],
    ) -> Vec<(String, f64)> {
        let (table, result) = run(components, macrodefs, settings);
        result
            .combinations
            .iter()
            .map(|c| (table.name(c.macrodef, c.number), c.factor))
            .collect()
    }

    fn names(components: &[Component], comps: &[&str], settings: [f64; 6]) -> Vec<String> {
        raw(components, &[comp(comps, &[])], settings)
            .into_iter()
            .map(|c| c.0)
            .collect()
    }

    const NEUTRAL: [f64; 6] = [0.0, 0.5, 0.5, 1.0, 0.0, 0.0];

    #[test]
    fn worked_example_of_the_documentation() {
        let found = raw(
            &human(),
            &[comp(&["gender", "age", "muscle"], &[])],
            [0.75, 0.5, 0.25, 0.0, 0.0, 0.0],
        );
        let expected = [
            ("female-young-min", 0.125),
            ("female-young-avg", 0.125),
            ("male-young-min", 0.375),
            ("male-young-avg", 0.375),
        ];
        assert_eq!(
            found,
            expected.map(|(name, factor)| (name.to_string(), factor))
        );
    }

    #[test]
    fn every_fate_is_reported() {
        let links = [("female-young", Some(0)), ("female-old", None)];
        let (table, result) = run(
            &human(),
            &[comp(&["gender", "age"], &links)],
            [0.005, 0.75, 0.5, 0.0, 0.0, 0.0],
        );
        let fates: Vec<_> = result
            .combinations
            .iter()
            .map(|c| (table.name(0, c.number), c.fate))
            .collect();
        assert_eq!(fates[0], ("female-young".into(), Fate::Applied(0)));
        assert_eq!(fates[1], ("female-old".into(), Fate::Null));
        assert_eq!(fates[2], ("male-young".into(), Fate::BelowThreshold));
        let (_, missing) = run(
            &human(),
            &[comp(&["gender", "age"], &links)],
            [1.0, 0.5, 0.5, 0.0, 0.0, 0.0],
        );
        assert_eq!(missing.combinations[0].fate, Fate::Missing);
    }

    #[test]
    fn factor_threshold_is_strict() {
        let (_, result) = run(
            &human(),
            &[comp(&["gender"], &[("male", Some(0))])],
            [0.01, 0.5, 0.5, 0.0, 0.0, 0.0],
        );
        assert_eq!(result.combinations[1].fate, Fate::BelowThreshold);
        let (_, result) = run(
            &human(),
            &[comp(&["gender"], &[("male", Some(0))])],
            [0.0101, 0.5, 0.5, 0.0, 0.0, 0.0],
        );
        assert_eq!(result.combinations[1].fate, Fate::Applied(0));
    }

    #[test]
    fn aliases_are_summed_into_one_factor() {
        let links = [("female-young", Some(7)), ("male-young", Some(7))];
        let (table, result) = run(
            &human(),
            &[comp(&["gender", "age"], &links)],
            [0.3, 0.5, 0.5, 0.0, 0.0, 0.0],
        );
        assert_eq!(result.factors, [(7, 1.0)]);
        assert_eq!(table.target_count(), 8);
    }

    #[test]
    fn last_link_wins_across_macrodefs_and_applies_twice() {
        let defs = [
            comp(&["gender"], &[("female", Some(0))]),
            comp(&["gender"], &[("female", Some(1))]),
        ];
        let (_, result) = run(&human(), &defs, NEUTRAL);
        assert_eq!(result.factors, [(1, 2.0)]);
    }

    #[test]
    fn slider_above_the_last_step_shortens_all_names() {
        let mut settings = NEUTRAL;
        settings[0] = 1.2;
        let (table, result) = run(
            &human(),
            &[comp(&["gender", "age"], &[("young", Some(3))])],
            settings,
        );
        assert_eq!(table.name(0, result.combinations[0].number), "young");
        // The shorter name may be the name of something else, and is then used.
        assert_eq!(result.factors, [(3, 1.0)]);
        assert_eq!(
            result.dropped,
            [DroppedComponent {
                macrodef: 0,
                place: 0,
                reason: DropReason::AboveLastStep
            }]
        );
    }

    #[test]
    fn extrapolation_below_the_first_step_scales_the_target() {
        let mut settings = NEUTRAL;
        settings[2] = -0.1;
        assert_eq!(
            raw(&human(), &[comp(&["muscle"], &[])], settings),
            [("min".to_string(), 1.2)]
        );
    }

    #[test]
    fn undefined_components_and_unknown_patterns_shorten_names() {
        let mut components = human();
        components.push(steps("lost", &["x", "y"], &[0.0, 1.0]));
        let (table, result) = run(
            &components,
            &[comp(&["typo", "gender", "lost"], &[])],
            NEUTRAL,
        );
        assert_eq!(table.name(0, result.combinations[0].number), "female");
        let reasons: Vec<_> = result.dropped.iter().map(|d| (d.place, d.reason)).collect();
        assert_eq!(
            reasons,
            [
                (0, DropReason::UnknownComponent),
                (2, DropReason::UnknownPattern)
            ]
        );
    }

    #[test]
    fn empty_comp_yields_the_empty_name_once() {
        let (_, result) = run(
            &human(),
            &[comp(&[], &[("", Some(0))]), comp(&["typo"], &[])],
            NEUTRAL,
        );
        assert_eq!(result.factors, [(0, 2.0)]);
    }

    #[test]
    fn repeated_component_repeats_its_value() {
        assert_eq!(
            names(&human(), &["gender", "gender"], NEUTRAL),
            ["female-female"]
        );
    }

    #[test]
    fn triangle_at_zero_silences_the_macrodef() {
        let mut settings = NEUTRAL;
        settings[3] = 0.0;
        let (_, result) = run(&human(), &[comp(&["race", "gender"], &[])], settings);
        assert!(result.combinations.is_empty());
        assert_eq!(result.dropped[0].reason, DropReason::NoShare);
    }

    #[test]
    fn nan_slider_silences_the_macrodef() {
        let mut settings = NEUTRAL;
        settings[1] = f64::NAN;
        assert!(names(&human(), &["gender", "age"], settings).is_empty());
    }

    #[test]
    fn sum_is_read_by_place_not_by_name() {
        let components = [sum(&["a", "b", "c"], &["C", "B", "A"])];
        let found = raw(
            &components,
            &[comp(&["race"], &[])],
            [0.0, 0.0, 0.0, 0.7, 0.2, 0.1],
        );
        assert_eq!(found[0], ("a".to_string(), 0.7));
        let two = raw(
            &[sum(&["a", "b"], &["A", "B"])],
            &[comp(&["race"], &[])],
            [0.0, 0.0, 0.0, 0.7, 0.2, 0.1],
        );
        assert_eq!(two.len(), 2);
    }

    #[test]
    fn unregistered_corner_is_left_out() {
        let found = raw(
            &[sum(&["a", "b"], &["A", "X"])],
            &[comp(&["race"], &[])],
            [0.0, 0.0, 0.0, 0.7, 0.2, 0.1],
        );
        assert_eq!(found, [("a".to_string(), 0.7)]);
    }

    fn fault(components: &[Component], name: &str, settings: &[f64]) -> MacroError {
        let table = MacroTable::new(components, &[comp(&[name], &[])], slider).unwrap();
        table
            .evaluate(settings, &mut MacroResult::default())
            .unwrap_err()
    }

    #[test]
    fn faulty_components_stop_the_evaluation() {
        let expect = |fault| MacroError::Component {
            component: 0,
            fault,
        };
        let equal = [steps("gender", &["female", "male"], &[0.5, 0.5])];
        assert_eq!(
            fault(&equal, "gender", &NEUTRAL),
            expect(ComponentFault::EqualSteps)
        );
        assert_eq!(
            fault(&[sum(&["a", "b"], &["A"])], "race", &NEUTRAL),
            expect(ComponentFault::MissingSum(1))
        );
        let four = [sum(&["a", "b", "c", "d"], &["A", "B", "C", "A"])];
        assert_eq!(
            fault(&four, "race", &NEUTRAL),
            expect(ComponentFault::FourthCorner)
        );
        let plain = [Component {
            pattern: "",
            ..sum(&["a"], &["gender"])
        }];
        assert_eq!(
            fault(&plain, "race", &NEUTRAL),
            expect(ComponentFault::NotBarycentric(0))
        );
        assert_eq!(
            fault(&human()[..1], "gender", &[]),
            expect(ComponentFault::MissingSetting(0))
        );
    }

    #[test]
    fn unused_faulty_component_is_not_looked_at() {
        let components = [
            steps("gender", &["female"], &[0.0, 0.0]),
            steps("age", &["baby", "young"], &[0.0, 1.0]),
        ];
        assert_eq!(names(&components, &["age"], [0.0; 6]), ["baby"]);
    }

    #[test]
    fn systems_beyond_the_limit_are_refused() {
        let components = human();
        let names = vec!["muscle"; 12];
        assert!(MacroTable::new(&components, &[comp(&names, &[])], slider).is_err());
        let names = vec!["typo"; 100];
        assert!(MacroTable::new(&components, &[comp(&names, &[])], slider).is_err());
    }

    #[test]
    fn order_of_macrodefs_does_not_change_factors() {
        let defs = [
            comp(&["gender"], &[("female", Some(0))]),
            comp(&["gender", "age"], &[("female-young", Some(1))]),
        ];
        let settings = [0.25, 0.5, 0.5, 0.0, 0.0, 0.0];
        let (_, forward) = run(&human(), &defs, settings);
        let (_, backward) = run(&human(), &[defs[1].clone(), defs[0].clone()], settings);
        let mut reversed = backward.factors.clone();
        reversed.reverse();
        assert_eq!(forward.factors, reversed);
    }
}
