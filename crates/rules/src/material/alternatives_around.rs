//! Materials that lie around an asset, but not around its mesh.

use super::alternatives_shared::materials_of;
use mhlint_diag::{Cases, EXAMPLES, Evidence};
use mhlint_repo::Layer;
use mhlint_source::is_below;

/// Names in one run: the assets of one folder lose the same materials, each by its own finding.
const MOST_NAMED: usize = 1 << 18;

/// The materials of a layer, by folder.
pub(super) struct Around<'l> {
    /// Their paths, in order.
    paths: Vec<&'l str>,
    /// How many more may be named.
    room: usize,
}

impl<'l> Around<'l> {
    pub(super) fn of(layer: &'l Layer) -> Self {
        let all = materials_of(layer.files.values());
        Self {
            paths: all.map(|file| file.rel.as_str()).collect(),
            room: MOST_NAMED,
        }
    }

    /// The places of those below a folder.
    fn below(&self, folder: &str) -> (usize, usize) {
        let within = format!("{folder}/");
        let start = self.paths.partition_point(|path| *path < within.as_str());
        let from = self.paths.get(start..).unwrap_or_default();
        (
            start,
            start + from.partition_point(|path| path.starts_with(&within)),
        )
    }

    /// Those below `own` and not below `searched`, but for the standard one: how many, and which.
    pub(super) fn lost(
        &mut self,
        own: &str,
        searched: &str,
        standard: Option<&str>,
    ) -> Option<(usize, Cases)> {
        let (start, end) = self.below(own);
        let inner = if is_below(searched, own) {
            self.below(searched)
        } else {
            (end, end)
        };
        let parts = [(start, inner.0), (inner.1, end)];
        let [before, behind] =
            parts.map(|(start, end)| self.paths.get(start..end).unwrap_or_default());
        let has_standard = standard.is_some_and(|path| {
            before.binary_search(&path).is_ok() || behind.binary_search(&path).is_ok()
        });
        let count = before.len() + behind.len() - usize::from(has_standard);
        let lost = before.iter().chain(behind).copied();
        let lost = lost.filter(|path| Some(*path) != standard);
        let evidence = if let Some(room) = self.room.checked_sub(count) {
            self.room = room;
            Evidence::of_cases(lost)
        } else {
            let examples = Evidence::of_unnamed(lost.take(EXAMPLES));
            Evidence {
                count: count as u64,
                ..examples
            }
            .into()
        };
        (count > 0).then_some((count, evidence))
    }
}
