//! What vertices lose to the threshold of the loader, and whether that can be seen.

use super::has_unusable_entries;
use crate::RuleCx;
use mhlint_diag::OptionInfo;
use mhlint_repo::{Body, FileFacts};

/// The rule on losses that can be seen, and its option.
pub(super) const ID: &str = "weights-lost-after-threshold";
pub(super) const DISTANCE: OptionInfo = OptionInfo {
    name: "distance",
    default: 0.01,
    docs: "pull from which the finding is a warning, in units of the mesh (1 = 10 cm); from a \
        tenth of it, an info",
};

/// What the weights of the default rig lose, and the vertex that it moves farthest.
pub(super) struct Loss<'a> {
    pub(super) file: &'a FileFacts,
    /// Vertices that lose something.
    pub(super) vertices: Vec<u32>,
    /// The vertex that is pulled farthest.
    pub(super) vertex: u32,
    /// Share of its weight, 0..1.
    pub(super) share: f32,
    /// How far that pulls it towards the origin at rest, mesh units.
    pub(super) pull: f64,
}

/// The loss in the weights of the default rig, if it is large enough to be seen: from a tenth of
/// `distance`.
pub(super) fn noticeable_loss<'v>(body: &Body<'v>, cx: &RuleCx<'_>) -> Option<Loss<'v>> {
    let file = body.default_weights()?;
    let weights = file
        .weights()
        .filter(|weights| !has_unusable_entries(weights))?;
    let mesh = body.whole_mesh()?;
    let losses = weights.facts.lost.iter().filter_map(|(vertex, share)| {
        let place = mesh.positions.get(*vertex as usize)?.map(f64::from);
        let pull = f64::from(*share) * place.iter().map(|part| part * part).sum::<f64>().sqrt();
        Some((*vertex, *share, pull))
    });
    let (vertex, share, pull) = losses.max_by(|a, b| a.2.total_cmp(&b.2))?;
    let loss = Loss {
        file,
        vertices: weights
            .facts
            .lost
            .iter()
            .map(|(vertex, _)| *vertex)
            .collect(),
        vertex,
        share,
        pull,
    };
    (pull >= cx.option_of(ID, &DISTANCE) / 10.0).then_some(loss)
}
