//! Which rig MPFB takes an armature for, by the names of its bones.
//!
//! Source: MPFB (`docs/loaders/mpfb/custom-rigs.md#identification`).

/// Bones by which MPFB knows its own rigs; later rows count before earlier ones.
const BUILT_IN: [(&str, &[&str]); 10] = [
    ("default_no_toes", &["oculi02.R"]),
    ("default", &["oculi02.R", "toe2-1.L"]),
    ("game_engine", &["thumb_01_l"]),
    ("game_engine_with_breast", &["thumb_01_l", "breast_l"]),
    ("cmu_mb", &["RThumb"]),
    ("mixamo", &["mixamo:Hips"]),
    ("openpose", &["LBigToe"]),
    (
        "mixamo_unity",
        &["mixamorig:LeftHandThumb1", "mixamorig:LeftBreast"],
    ),
    ("rigify.human", &["brow.T.R.002"]),
    ("rigify.human_toes", &["brow.T.R.002", "toe2-1.L"]),
];

/// The rig of MPFB whose bones an armature has, and these bones.
pub fn built_in(has: impl Fn(&str) -> bool) -> Option<(&'static str, &'static [&'static str])> {
    BUILT_IN
        .iter()
        .rev()
        .find(|(_, marks)| marks.iter().all(|mark| has(mark)))
        .copied()
}

/// What MPFB calls an armature with these bones; rigs of users are not asked for here.
pub fn identified<'b>(bones: impl Iterator<Item = &'b str> + Clone) -> &'static str {
    let has = |name: &str| bones.clone().any(|bone| bone == name);
    match built_in(has) {
        Some((name, _)) => name,
        None if bones.clone().any(|bone| bone.contains("mixamo")) => "mixamo",
        None => "unknown",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn later_rows_count_first() {
        let of = |bones: &[&str]| identified(bones.iter().copied());
        assert_eq!(of(&["oculi02.R"]), "default_no_toes");
        assert_eq!(of(&["oculi02.R", "toe2-1.L"]), "default");
        assert_eq!(of(&["oculi02.R", "toe2-1.L", "thumb_01_l"]), "game_engine");
        assert_eq!(of(&["mixamorig:Hips"]), "mixamo");
        assert_eq!(of(&["a"]), "unknown");
    }
}
