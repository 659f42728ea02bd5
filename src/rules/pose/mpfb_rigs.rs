//! What the folder of a pose says of its rig (formats/mpfb.md §21.3, §23, §25.1).

/// The rigs that MPFB brings, as it calls them, and whether they have the bones by which default rigs are measured.
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

/// What the folder of a rig ends in.
pub(super) const ENDINGS: [&str; 3] = ["_fk", "_ik", "_partial"];

/// The rig of the folder that a pose lies in; `None` where the folder is that of no rig.
pub(super) fn rig_of(rel: &str) -> Option<&str> {
    let (folders, _) = rel.strip_prefix("poses/")?.rsplit_once('/')?;
    // A folder in a folder is copied by its own name alone.
    folders.rsplit('/').find_map(|folder| ENDINGS.iter().find_map(|ending| folder.strip_suffix(ending)))
}

/// Whether a rig has the bones by which default rigs are measured; `None` for one that MPFB does not bring.
pub(super) fn has_spine(rig: &str) -> Option<bool> {
    RIGS.iter().find(|(known, _)| *known == rig).map(|(_, has)| *has)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_folder_names_the_rig() {
        assert_eq!(rig_of("poses/game_engine_fk/bow.json"), Some("game_engine"));
        assert_eq!(rig_of("poses/more/default_partial/bow.json"), Some("default"));
        assert_eq!(rig_of("poses/default_fk/more/bow.json"), Some("default"));
        assert_eq!([rig_of("poses/bow.json"), rig_of("poses/default_FK/bow.json")], [None, None]);
        assert_eq!([has_spine("default"), has_spine("mixamo"), has_spine("mine")], [Some(true), Some(false), None]);
    }
}
