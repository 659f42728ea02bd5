//! The rigs that MPFB brings, for which poses are stored
//! (`docs/loaders/mpfb/custom-rigs.md#identification`,
//! `docs/loaders/mpfb/shipped-rigs.md#the-rigs`).

/// The rigs that MPFB brings, as it calls them, and whether they have the bones by which default
/// rigs are measured.
pub(super) const RIGS: [(&str, bool); 9] = [
    ("default", true),
    ("cmu_mb", false),
    ("game_engine", false),
    ("game_engine_with_breast", false),
    ("mixamo", false),
    ("mixamo_unity", false),
    ("openpose", false),
    ("rigify.human", false),
    ("rigify.human_toes", false),
];

/// Whether a rig has the bones by which default rigs are measured; `None` for one that MPFB does
/// not bring.
pub(super) fn has_spine(rig: &str) -> Option<bool> {
    RIGS.iter()
        .find(|(known, _)| *known == rig)
        .map(|(_, has)| *has)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_rig_has_a_spine() {
        assert_eq!(
            [has_spine("default"), has_spine("mixamo"), has_spine("mine")],
            [Some(true), Some(false), None]
        );
    }
}
