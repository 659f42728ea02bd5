//! Rules on the macro settings of MPFB: `macro.json`, its parts, and the targets that their names are composed to.

pub(super) mod coverage;
pub(super) mod discontinuity;
pub(super) mod empty_range;
pub(super) mod end_share;
pub(super) mod gap;
pub(super) mod missing_setting;
pub(super) mod missing_target;
pub(super) mod overlap;
pub(super) mod reversed;
mod stretch;
pub(super) mod unknown_combination;
mod wanted;
