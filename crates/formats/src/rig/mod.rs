//! Rigs of MPFB: `rig.*.json`, custom rigs and `.mpfbskel` (`docs/loaders/mpfb/rigs.md#layouts`,
//! `docs/loaders/mpfb/custom-rigs.md#listing-custom-rigs`,
//! `docs/loaders/mpfb/custom-rigs.md#what-differs`).
//!
//! The loader is strict on what a bone has and lenient on where it lies: what stops it, and what it
//! takes otherwise than it is written, is kept apart.

mod attribute;
mod bone;
mod constraint;
mod constraint_types;
mod end;
mod layers;
mod reader;
mod rigify;

pub use attribute::BENDY;
pub use constraint::{Constraint, Target};
pub use end::{DefaultPosition, End, Strategy};
pub use layers::LayersFault;
pub use reader::read;

use super::unfit::Unfits;

/// The newest version of the format.
pub const NEWEST: f64 = 110.0;

/// A rig.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rig {
    /// Whether the bones stand in `bones`; otherwise each key at the top is a bone.
    pub has_header: bool,
    /// Its version; that of a file without `bones` is 100.
    pub version: f64,
    /// The scale at which offsets were recorded; 0 where it is not said.
    pub scale_factor: f64,
    /// Whether it calls itself one that is added to another.
    pub is_subrig: bool,
    /// Bones in the order of the file.
    pub bones: Vec<RigBone>,
    /// Names of bone collections that it declares.
    pub collections: Vec<String>,
    /// Bones that Rigify makes later.
    pub extra_bones: Vec<String>,
    /// Whether there is anything for the panel of Rigify.
    pub has_rigify_ui: bool,
    /// By which bones it is recognised.
    pub identifying: Identifying,
    /// The first keys at the top of a file with a header and without `bones`.
    pub top_keys: Vec<String>,
    /// What is wrong with it.
    pub faults: RigFaults,
}

/// By which bones a custom rig is recognised.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Identifying {
    /// It does not say.
    #[default]
    Absent,
    /// Names of bones.
    Bones(Vec<String>),
    /// A value that is no list: its type.
    Other(&'static str),
}

/// A bone.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RigBone {
    /// Its name.
    pub name: String,
    /// Where it begins.
    pub head: Option<End>,
    /// Where it ends.
    pub tail: Option<End>,
    /// Turn about itself, radians.
    pub roll: f64,
    /// How the turn is found instead.
    pub roll_strategy: Option<String>,
    /// Where its z axis is to point.
    pub roll_reference_z: Option<[f64; 3]>,
    /// Name of the bone that it hangs on.
    pub parent: Option<String>,
    /// Whether its head is moved to the tail of its parent.
    pub use_connect: bool,
    /// What it takes of the scale of its parent.
    pub inherit_scale: String,
    /// Order of its angles, if that is said.
    pub rotation_mode: Option<String>,
    /// Names of the collections that it is put into.
    pub collections: Vec<String>,
    /// Names of collections in parameters of Rigify, each with its pointer.
    pub collection_references: Vec<(String, String)>,
    /// Bones that its handles are bound to, each with its key.
    pub handles: Vec<(&'static str, String)>,
    /// Segments that it is bent into, if that is said.
    pub segments: Option<f64>,
    /// What binds it to other bones.
    pub constraints: Vec<Constraint>,
}

/// What is wrong with a rig, apart from what the mesh says.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RigFaults {
    /// Why no rig is made of the file as a whole.
    pub layout: Vec<LayoutFault>,
    /// Keys that are missing, or of another type.
    pub keys: Unfits,
    /// Words that are none of those which are known.
    pub words: Unfits,
    /// Texts in place of lists, which are read letter by letter.
    pub letters: Unfits,
    /// Words that are passed over.
    pub ignored_words: Unfits,
    /// Properties of constraints and of bending that do not exist.
    pub properties: Unfits,
    /// Ends of which nobody can tell where they are.
    pub ends: Unfits,
    /// What is wrong with layers.
    pub layers: Vec<LayersFault>,
    /// Types and parameters of Rigify that stop the loader.
    pub rigify: Unfits,
    /// Those that are passed over.
    pub ignored_rigify: Unfits,
    /// Collections in the panel of Rigify that are not declared: pointer and name.
    pub panel_collections: Vec<(String, String)>,
    /// Pointers to what cannot be made without Rigify.
    pub needs_rigify: Vec<String>,
}

/// Why no rig is made of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum LayoutFault {
    /// It is no object: its type.
    NotObject(&'static str),
    /// It has a key of a header, and no `bones`: the key counts as a bone.
    HeaderWithoutBones(String),
    /// It has `bones`, and no `version`.
    WithoutVersion,
    /// `version` is no number: its type.
    VersionType(&'static str),
    /// `version` is newer than what is read.
    TooNew(f64),
    /// It has `joints`: it is a skeleton of MakeHuman.
    Skeleton,
}

impl Rig {
    /// The steps of a pointer to a bone.
    pub fn steps_to<'s>(&self, bone: &'s str) -> Vec<&'s str> {
        if self.has_header {
            vec!["bones", bone]
        } else {
            vec![bone]
        }
    }

    /// The steps of a pointer to a key of a bone.
    pub fn steps_below<'s>(&self, bone: &'s str, key: &'s str) -> Vec<&'s str> {
        let mut steps = self.steps_to(bone);
        steps.push(key);
        steps
    }

    /// Whether its layers count: since version 110 there are collections.
    pub fn has_layers(&self) -> bool {
        self.version < NEWEST
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::unfit::Why;
    use mhlint_json::parse;

    fn of(text: &str) -> Rig {
        read(&parse(text.as_bytes()).unwrap())
    }

    /// A rig of one bone in which a key has this value.
    fn with(key: &str, value: &str) -> Rig {
        let keys = [
            ("head", r#"{"strategy": "VERTEX", "vertex_index": 1}"#),
            ("tail", r#"{"strategy": "MEAN", "vertex_indices": [1, 2]}"#),
            ("roll", "0"),
            ("parent", r#""""#),
            ("use_connect", "false"),
            ("use_inherit_rotation", "true"),
            ("use_local_location", "true"),
            ("inherit_scale", r#""FULL""#),
            ("rigify", "{}"),
        ];
        let mut members: Vec<String> = keys
            .iter()
            .map(|(own, usual)| format!("\"{own}\": {usual}"))
            .collect();
        members.push(format!("\"{key}\": {value}"));
        of(&format!(
            "{{\"version\": 110, \"bones\": {{\"a\": {{{}}}}}}}",
            members.join(", ")
        ))
    }

    fn faults(rig: &Rig) -> usize {
        let RigFaults {
            keys,
            words,
            properties,
            ends,
            rigify,
            ..
        } = &rig.faults;
        [keys, words, properties, ends, rigify]
            .iter()
            .map(|own| own.all().len())
            .sum()
    }

    #[test]
    fn what_blender_takes_is_no_fault() {
        for (key, value) in [
            ("roll", "7.5"),
            ("roll", "true"),
            ("parent", "null"),
            ("use_connect", "1"),
            ("inherit_scale", "\"NONE_LEGACY\""),
            ("rotation_mode", "\"AXIS_ANGLE\""),
            ("collections", "null"),
            (
                "bendy_bone",
                r#"{"segments": 4, "handle_use_scale_start": [true, 0, 1], "x": 1}"#,
            ),
            ("rigify", r#"{"rigify_type": "", "rigify_parameters": {}}"#),
            (
                "constraints",
                r#"[{"type": "IK", "name": "i", "target": true, "subtarget": "b", "chain_count": 2}]"#,
            ),
            ("anything", "[]"),
        ] {
            assert_eq!(faults(&with(key, value)), 0, "{key}: {value}");
        }
    }

    #[test]
    fn what_it_refuses_is_one_fault() {
        for (key, value) in [
            ("head", "[0, 0, 0]"),
            ("head", r#"{"vertex_index": 1}"#),
            ("head", r#"{"strategy": "VERTEX", "vertex_index": 1.0}"#),
            ("head", r#"{"strategy": "XYZ", "vertex_indices": 1}"#),
            ("head", r#"{"strategy": "CUBE"}"#),
            (
                "head",
                r#"{"strategy": "VERTEX", "vertex_index": 1, "offset": [0, 0]}"#,
            ),
            ("roll", "\"0\""),
            ("roll", "null"),
            ("parent", "5"),
            ("use_connect", "null"),
            ("use_connect", "2"),
            ("inherit_scale", "\"Full\""),
            ("inherit_scale", "1"),
            ("rotation_mode", "null"),
            ("rigify", "null"),
            ("rigify", r#"{"rigify_type": 1}"#),
            ("rigify", r#"{"rigify_parameters": null}"#),
            ("rigify", r#"{"rigify_parameters": {"bbones": 1.5}}"#),
            (
                "rigify",
                r#"{"rigify_parameters": {"skin_chain_falloff": [1, 2]}}"#,
            ),
            ("bendy_bone", "null"),
            ("bendy_bone", r#"{"segments": 1.0}"#),
            ("bendy_bone", r#"{"scalein": [1, 1]}"#),
            ("bendy_bone", r#"{"custom_handle_end": null}"#),
            ("bendy_bone", r#"{"scaleinx": 1}"#),
            ("constraints", "null"),
            ("constraints", "[1]"),
            ("constraints", r#"[{"type": "IK"}]"#),
            ("constraints", r#"[{"type": "IKK", "name": "i"}]"#),
            (
                "constraints",
                r#"[{"type": "IK", "name": "i", "target": "b"}]"#,
            ),
            (
                "constraints",
                r#"[{"type": "IK", "name": "i", "chain_count": 2.5}]"#,
            ),
            (
                "constraints",
                r#"[{"type": "IK", "name": "i", "pole_target": true}]"#,
            ),
            (
                "constraints",
                r#"[{"type": "LIMIT_SCALE", "name": "i", "target": true}]"#,
            ),
            ("constraints", r#"[{"type": "ARMATURE", "name": "i"}]"#),
            (
                "constraints",
                r#"[{"type": "ARMATURE", "name": "i", "targets": [{"subtarget": "b"}]}]"#,
            ),
        ] {
            assert_eq!(faults(&with(key, value)), 1, "{key}: {value}");
        }
        assert!(
            of(r#"{"a": {}}"#)
                .faults
                .keys
                .all()
                .iter()
                .all(|one| matches!(one.why, Why::Lacks(_)))
        );
    }

    #[test]
    fn layouts_are_told_apart() {
        let layout = |text: &str| of(text).faults.layout;
        assert_eq!(layout("[]"), [LayoutFault::NotObject("a list")]);
        assert_eq!(layout(r#"{"bones": {}}"#), [LayoutFault::WithoutVersion]);
        assert_eq!(
            layout(r#"{"version": 110}"#),
            [LayoutFault::HeaderWithoutBones("version".to_owned())]
        );
        assert_eq!(
            layout(r#"{"version": "1", "bones": {}}"#),
            [LayoutFault::VersionType("a string")]
        );
        assert_eq!(
            layout(r#"{"version": 110.5, "bones": {}}"#),
            [LayoutFault::TooNew(110.5)]
        );
        assert_eq!(
            layout(r#"{"version": 90, "bones": null, "joints": 1}"#),
            [LayoutFault::Skeleton]
        );
        assert_eq!(layout("{}"), []);
    }

    #[test]
    fn the_schema_fits_what_the_loader_takes() {
        let check = |text: &str| {
            mhlint_json::check("mpfb_rig", &parse(text.as_bytes()).unwrap())
                .faults
                .len()
        };
        for sound in [
            include_str!("../../../../fixtures/mpfb/data/rigs/standard/rig.cube.json"),
            include_str!("../../../../fixtures/mpfb/data/rigs/rigify/rig.cube_control.json"),
            include_str!("../../../../fixtures/mpfb/user/data/rigs/stick.json"),
        ] {
            assert_eq!(check(sound), 0);
            assert_eq!(faults(&of(sound)), 0);
            assert!(check(&sound.replacen("\"roll\": 0.0", "\"roll\": null", 1)) > 0);
        }
    }

    #[test]
    fn a_hundred_thousand_bones_are_read() {
        let bones: Vec<String> = (0..100_000)
            .map(|at| format!("\"b{at}\": {{\"roll\": null}}"))
            .collect();
        let rig = of(&format!("{{{}}}", bones.join(",")));
        assert_eq!(rig.bones.len(), 100_000);
        // Faults are kept for those that a report can name.
        assert!(rig.faults.keys.all().len() <= 20_000);
    }

    proptest! {
        #[test]
        fn no_json_stops_the_reader(text in r#"[\[\]{},:"0-9a-c ]{0,30}"#, key in 0usize..14) {
            let keys = ["head", "tail", "roll", "parent", "use_connect", "inherit_scale", "rigify", "rotation_mode",
                "collections", "layers", "roll_strategy", "bendy_bone", "constraints", "roll_reference_z"];
            let own = keys.get(key).copied().unwrap_or_default();
            for text in [
                format!("{{\"version\": 110, \"rigify_ui\": {text}, \"bones\": {{\"a\": \
                    {{\"{own}\": {text}}}}}}}"),
                format!("{{\"a\": {{\"{own}\": {text}}}, \"b\": {text}}}"),
                text,
            ] {
                if let Ok(document) = parse(text.as_bytes()) {
                    read(&document);
                }
            }
        }
    }
}
