//! Assets of another base mesh: whatever of them does not fit has one cause, and one finding.

use super::super::shown;
use super::{Text, is_told_by_scale};
use mhlint_repo::Body;

/// Of so many rows one names a vertex that does not exist: fewer are slips.
const FEW: u64 = 20;

impl<'v> Text<'_, 'v> {
    /// The base mesh that it says it is for, if that is another one than it lies with.
    pub(super) fn other_base(&self) -> Option<&'v str> {
        Some(self.reading.last("basemesh")?.word()).filter(|word| *word != self.worn.base)
    }

    /// Whether `proxy-vertex-out-of-range` reports vertices that the base mesh does not have.
    pub(super) fn reaches_beyond(&self, body: &Body<'_>) -> bool {
        let counts = [
            &self.clothes.rows.out_of_range,
            &self.clothes.deletes.out_of_range,
        ]
        .map(|tally| tally.count);
        counts != [0; 2] && self.is_counted(body)
    }

    /// Whether it is one of another base mesh by its rows or its list, which is reported for them.
    pub(super) fn is_foreign(&self, body: &Body<'_>) -> bool {
        let rows = &self.clothes.rows;
        let beyond = rows.out_of_range.count + rows.in_seams.count;
        let are_many = || beyond.saturating_mul(FEW) >= rows.count as u64;
        let says_so =
            self.other_base().is_some() && beyond + self.clothes.deletes.out_of_range.count > 0;
        self.is_counted(body) && (says_so || beyond > 0 && are_many())
    }

    fn is_counted(&self, body: &Body<'_>) -> bool {
        !self.reading.stops() && self.size_of_base(body).is_some()
    }

    /// Whether it is one of another base mesh by its scale lines, which is reported for these.
    pub(super) fn is_foreign_by_scale(&self, body: &Body<'_>) -> bool {
        let is_scaled =
            (self.is_makehuman1() || !self.worn.is_topology()) && self.clothes.rows.has_offsets;
        is_scaled
            && self.other_base().is_some()
            && !self.reading.stops()
            && is_told_by_scale(body, self)
    }

    /// What to do with an asset that says which base mesh it is for; `otherwise` if that is this
    /// one.
    pub(super) fn use_with_its_base(&self, otherwise: &str) -> String {
        self.other_base().map_or_else(
            || otherwise.to_owned(),
            |other| {
                let (other, own) = (shown(other), self.worn.base);
                format!(
                    "use the asset with the base mesh that it names, `{other}`, or export it \
                    again for `{own}`"
                )
            },
        )
    }
}
