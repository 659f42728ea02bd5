//! Targets for vertices in another order: asymmetric nearly everywhere, while the other end of the
//! slider is not.

use std::collections::BTreeMap;

use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Case, Confidence, Finding, Level, Place,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::target_measure::TargetMeasure;
use mhlint_repo::{Body, FileFacts};

const RENUMBERED: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "moves other vertices than those it was made for",
    ),
    (
        Mpfb,
        Level::Warning,
        "moves other vertices than those it was made for",
    ),
];

/// Share of the vertices from which on nearly all are asymmetric, and below which nearly none is.
/// Of the shipped pairs only those that move sideways have one.
const NEARLY_ALL: f64 = 0.5;
const EVEN: f64 = 0.05;
/// Fewer are asymmetric by chance.
const FEW: usize = 20;

/// Symmetric targets by the other ends of their sliders.
pub(super) struct Opposites(BTreeMap<String, String>);

impl Opposites {
    pub(super) fn of(body: &Body<'_>, measures: &Measures) -> Self {
        let share: BTreeMap<&str, f64> = measures
            .targets
            .iter()
            .map(|target| (target.path.as_str(), asymmetric(target)))
            .collect();
        let is_even = |file: &FileFacts| {
            share
                .get(file.path.as_str())
                .is_some_and(|share| *share < EVEN)
        };
        let pairs = body
            .slider_ends
            .iter()
            .flat_map(|[one, other]| [(*one, *other), (*other, *one)]);
        Self(
            pairs
                .filter(|(_, other)| is_even(other))
                .map(|(one, other)| (one.path.clone(), other.path.clone()))
                .collect(),
        )
    }

    /// The finding on an asymmetric target, worse if its vertices are not those of the mesh.
    pub(super) fn weigh(
        &self,
        finding: Finding,
        file: &FileFacts,
        target: &TargetMeasure,
    ) -> Finding {
        let is_whole = target.own_mirror.different.len() >= FEW && asymmetric(target) > NEARLY_ALL;
        let Some(opposite) = self.0.get(&file.path).filter(|_| is_whole) else {
            return finding;
        };
        let finding = finding.related(
            opposite,
            Place::File,
            "the other end of its slider, which is symmetric",
        );
        let help = "export it again from the base mesh: its vertices have another order, or are \
            counted from 1";
        finding
            .case(RENUMBERED)
            .confidence(Confidence::Medium)
            .help(help)
    }
}

/// Share of the vertices that differ from their mirror image.
#[expect(
    clippy::cast_precision_loss,
    reason = "a share of the vertices of a mesh"
)]
fn asymmetric(target: &TargetMeasure) -> f64 {
    target.own_mirror.different.len() as f64 / target.own_mirror.compared as f64
}
