//! The types of constraints of Blender 4.5 with their properties
//! (`docs/loaders/mpfb/rigs.md#types-of-constraints`).

use super::attribute::{Properties, Wants};

const WORLD: &[&str] = &["WORLD", "CUSTOM", "POSE", "LOCAL_WITH_PARENT", "LOCAL"];
const OF_TARGET: &[&str] = &[
    "WORLD",
    "CUSTOM",
    "POSE",
    "LOCAL_WITH_PARENT",
    "LOCAL",
    "LOCAL_OWNER_ORIENT",
];
const EULER: &[&str] = &["AUTO", "XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"];
const TRACK: &[&str] = &[
    "TRACK_X",
    "TRACK_Y",
    "TRACK_Z",
    "TRACK_NEGATIVE_X",
    "TRACK_NEGATIVE_Y",
    "TRACK_NEGATIVE_Z",
];
const AXES: &[&str] = &["X", "Y", "Z"];
const MAPPED: &[&str] = &["LOCATION", "ROTATION", "SCALE"];
const MIXED: &[&str] = &[
    "REPLACE",
    "BEFORE_FULL",
    "BEFORE",
    "BEFORE_SPLIT",
    "AFTER_FULL",
    "AFTER",
    "AFTER_SPLIT",
];
const ROTATIONS: &[&str] = &[
    "AUTO",
    "XYZ",
    "XZY",
    "YXZ",
    "YZX",
    "ZXY",
    "ZYX",
    "QUATERNION",
    "SWING_TWIST_X",
    "SWING_TWIST_Y",
    "SWING_TWIST_Z",
];

/// What all constraints have.
pub(super) const COMMON: Properties = &[
    ("active enabled mute show_expanded", Wants::Bool),
    ("influence", Wants::Number),
    ("owner_space", Wants::Word(WORLD)),
    ("target_space", Wants::Word(OF_TARGET)),
    ("space_subtarget", Wants::Text),
];

const BULGE: (&str, Wants) = ("bulge bulge_max bulge_min bulge_smooth", Wants::Number);
const BULGE_LIMITS: (&str, Wants) = ("use_bulge_max use_bulge_min", Wants::Bool);
const BONE: (&str, Wants) = ("subtarget", Wants::Text);
const ALONG: (&str, Wants) = ("head_tail", Wants::Number);
const SHAPE: (&str, Wants) = ("use_bbone_shape", Wants::Bool);
const LIMITS: Properties = &[
    ("max_x max_y max_z min_x min_y min_z", Wants::Number),
    (
        "use_max_x use_max_y use_max_z use_min_x use_min_y use_min_z use_transform_limit",
        Wants::Bool,
    ),
];
const CLIP: Properties = &[
    ("clip camera depth_object object", Wants::Nothing),
    ("use_active_clip", Wants::Bool),
];

/// Types, whether they have a target, and their properties.
pub(super) const TYPES: [(&str, bool, Properties); 28] = [
    (
        "ACTION",
        true,
        &[
            BONE,
            ("eval_time max min", Wants::Number),
            ("frame_end frame_start", Wants::Whole),
            ("mix_mode", Wants::Word(MIXED)),
            (
                "transform_channel",
                Wants::Word(&[
                    "LOCATION_X",
                    "LOCATION_Y",
                    "LOCATION_Z",
                    "ROTATION_X",
                    "ROTATION_Y",
                    "ROTATION_Z",
                    "SCALE_X",
                    "SCALE_Y",
                    "SCALE_Z",
                ]),
            ),
            ("use_bone_object_action use_eval_time", Wants::Bool),
            ("action action_slot", Wants::Nothing),
            ("action_slot_handle", Wants::Whole),
            ("last_slot_identifier", Wants::Text),
        ],
    ),
    (
        "ARMATURE",
        true,
        &[(
            "use_bone_envelopes use_current_location use_deform_preserve_volume",
            Wants::Bool,
        )],
    ),
    ("CAMERA_SOLVER", false, CLIP),
    ("CHILD_OF", true, CHILD_OF),
    (
        "CLAMP_TO",
        true,
        &[
            (
                "main_axis",
                Wants::Word(&["CLAMPTO_AUTO", "CLAMPTO_X", "CLAMPTO_Y", "CLAMPTO_Z"]),
            ),
            ("use_cyclic", Wants::Bool),
        ],
    ),
    (
        "COPY_LOCATION",
        true,
        &[
            BONE,
            ALONG,
            SHAPE,
            (
                "invert_x invert_y invert_z use_offset use_x use_y use_z",
                Wants::Bool,
            ),
        ],
    ),
    (
        "COPY_ROTATION",
        true,
        &[
            BONE,
            ("euler_order", Wants::Word(EULER)),
            (
                "mix_mode",
                Wants::Word(&["REPLACE", "ADD", "BEFORE", "AFTER", "OFFSET"]),
            ),
            (
                "invert_x invert_y invert_z use_offset use_x use_y use_z",
                Wants::Bool,
            ),
        ],
    ),
    (
        "COPY_SCALE",
        true,
        &[
            BONE,
            ("power", Wants::Number),
            (
                "use_add use_make_uniform use_offset use_x use_y use_z",
                Wants::Bool,
            ),
        ],
    ),
    (
        "COPY_TRANSFORMS",
        true,
        &[
            BONE,
            ALONG,
            SHAPE,
            ("mix_mode", Wants::Word(MIXED)),
            ("remove_target_shear", Wants::Bool),
        ],
    ),
    (
        "DAMPED_TRACK",
        true,
        &[BONE, ALONG, SHAPE, ("track_axis", Wants::Word(TRACK))],
    ),
    (
        "FLOOR",
        true,
        &[
            BONE,
            (
                "floor_location",
                Wants::Word(&[
                    "FLOOR_X",
                    "FLOOR_Y",
                    "FLOOR_Z",
                    "FLOOR_NEGATIVE_X",
                    "FLOOR_NEGATIVE_Y",
                    "FLOOR_NEGATIVE_Z",
                ]),
            ),
            ("offset", Wants::Number),
            ("use_rotation", Wants::Bool),
        ],
    ),
    (
        "FOLLOW_PATH",
        true,
        &[
            (
                "forward_axis",
                Wants::Word(&[
                    "FORWARD_X",
                    "FORWARD_Y",
                    "FORWARD_Z",
                    "TRACK_NEGATIVE_X",
                    "TRACK_NEGATIVE_Y",
                    "TRACK_NEGATIVE_Z",
                ]),
            ),
            ("offset offset_factor", Wants::Number),
            ("up_axis", Wants::Word(&["UP_X", "UP_Y", "UP_Z"])),
            (
                "use_curve_follow use_curve_radius use_fixed_location",
                Wants::Bool,
            ),
        ],
    ),
    (
        "FOLLOW_TRACK",
        false,
        &[
            ("clip camera depth_object", Wants::Nothing),
            ("frame_method", Wants::Word(&["STRETCH", "FIT", "CROP"])),
            ("object track", Wants::Text),
            (
                "use_3d_position use_active_clip use_undistorted_position",
                Wants::Bool,
            ),
        ],
    ),
    (
        "IK",
        true,
        &[
            BONE,
            ("chain_count iterations", Wants::Whole),
            ("distance orient_weight pole_angle weight", Wants::Number),
            ("ik_type", Wants::Word(&["COPY_POSE", "DISTANCE"])),
            ("limit_mode", Wants::Word(INSIDE)),
            (
                "lock_location_x lock_location_y lock_location_z lock_rotation_x lock_rotation_y \
                 lock_rotation_z use_location use_rotation use_stretch use_tail",
                Wants::Bool,
            ),
            ("pole_subtarget", Wants::Text),
            ("pole_target", Wants::Nothing),
            ("reference_axis", Wants::Word(&["BONE", "TARGET"])),
        ],
    ),
    (
        "LIMIT_DISTANCE",
        true,
        &[
            BONE,
            ALONG,
            SHAPE,
            ("distance", Wants::Number),
            ("limit_mode", Wants::Word(INSIDE)),
            ("use_transform_limit", Wants::Bool),
        ],
    ),
    ("LIMIT_LOCATION", false, LIMITS),
    (
        "LIMIT_ROTATION",
        false,
        &[
            ("euler_order", Wants::Word(EULER)),
            ("max_x max_y max_z min_x min_y min_z", Wants::Number),
            (
                "use_legacy_behavior use_limit_x use_limit_y use_limit_z use_transform_limit",
                Wants::Bool,
            ),
        ],
    ),
    ("LIMIT_SCALE", false, LIMITS),
    (
        "LOCKED_TRACK",
        true,
        &[
            BONE,
            ALONG,
            SHAPE,
            ("lock_axis", Wants::Word(&["LOCK_X", "LOCK_Y", "LOCK_Z"])),
            ("track_axis", Wants::Word(TRACK)),
        ],
    ),
    (
        "MAINTAIN_VOLUME",
        false,
        &[
            (
                "free_axis",
                Wants::Word(&["SAMEVOL_X", "SAMEVOL_Y", "SAMEVOL_Z"]),
            ),
            ("mode", Wants::Word(&["STRICT", "UNIFORM", "SINGLE_AXIS"])),
            ("volume", Wants::Number),
        ],
    ),
    (
        "OBJECT_SOLVER",
        false,
        &[
            ("clip camera", Wants::Nothing),
            ("object", Wants::Text),
            ("set_inverse_pending use_active_clip", Wants::Bool),
        ],
    ),
    (
        "PIVOT",
        true,
        &[
            BONE,
            ALONG,
            SHAPE,
            ("offset", Wants::Numbers(3)),
            (
                "rotation_range",
                Wants::Word(&["ALWAYS_ACTIVE", "NX", "NY", "NZ", "X", "Y", "Z"]),
            ),
            ("use_relative_location", Wants::Bool),
        ],
    ),
    (
        "SHRINKWRAP",
        true,
        &[
            ("cull_face", Wants::Word(&["OFF", "FRONT", "BACK"])),
            ("distance project_limit", Wants::Number),
            (
                "project_axis",
                Wants::Word(&["POS_X", "POS_Y", "POS_Z", "NEG_X", "NEG_Y", "NEG_Z"]),
            ),
            ("project_axis_space", Wants::Word(WORLD)),
            (
                "shrinkwrap_type",
                Wants::Word(&[
                    "NEAREST_SURFACE",
                    "PROJECT",
                    "NEAREST_VERTEX",
                    "TARGET_PROJECT",
                ]),
            ),
            ("track_axis", Wants::Word(TRACK)),
            (
                "use_invert_cull use_project_opposite use_track_normal",
                Wants::Bool,
            ),
            (
                "wrap_mode",
                Wants::Word(&[
                    "ON_SURFACE",
                    "INSIDE",
                    "OUTSIDE",
                    "OUTSIDE_SURFACE",
                    "ABOVE_SURFACE",
                ]),
            ),
        ],
    ),
    (
        "SPLINE_IK",
        true,
        &[
            BULGE,
            BULGE_LIMITS,
            ("chain_count", Wants::Whole),
            (
                "use_chain_offset use_curve_radius use_even_divisions use_original_scale",
                Wants::Bool,
            ),
            (
                "xz_scale_mode",
                Wants::Word(&[
                    "NONE",
                    "BONE_ORIGINAL",
                    "INVERSE_PRESERVE",
                    "VOLUME_PRESERVE",
                ]),
            ),
            (
                "y_scale_mode",
                Wants::Word(&["NONE", "FIT_CURVE", "BONE_ORIGINAL"]),
            ),
        ],
    ),
    (
        "STRETCH_TO",
        true,
        &[
            BONE,
            ALONG,
            SHAPE,
            BULGE,
            BULGE_LIMITS,
            ("keep_axis", Wants::Word(&["PLANE_X", "PLANE_Z", "SWING_Y"])),
            ("rest_length", Wants::Number),
            (
                "volume",
                Wants::Word(&["VOLUME_XZX", "VOLUME_X", "VOLUME_Z", "NO_VOLUME"]),
            ),
        ],
    ),
    (
        "TRACK_TO",
        true,
        &[
            BONE,
            ALONG,
            SHAPE,
            ("track_axis", Wants::Word(TRACK)),
            ("up_axis", Wants::Word(&["UP_X", "UP_Y", "UP_Z"])),
            ("use_target_z", Wants::Bool),
        ],
    ),
    ("TRANSFORM", true, TRANSFORM),
    (
        "TRANSFORM_CACHE",
        false,
        &[("cache_file", Wants::Nothing), ("object_path", Wants::Text)],
    ),
];

const INSIDE: &[&str] = &[
    "LIMITDIST_INSIDE",
    "LIMITDIST_OUTSIDE",
    "LIMITDIST_ONSURFACE",
];

const CHILD_OF: Properties = &[
    BONE,
    (
        "set_inverse_pending use_location_x use_location_y use_location_z use_rotation_x \
         use_rotation_y use_rotation_z use_scale_x use_scale_y use_scale_z",
        Wants::Bool,
    ),
    ("inverse_matrix", Wants::Nothing),
];

const TRANSFORM: Properties = &[
    BONE,
    (
        "from_max_x from_max_y from_max_z from_min_x from_min_y from_min_z from_max_x_rot \
         from_max_y_rot from_max_z_rot from_min_x_rot from_min_y_rot from_min_z_rot \
         from_max_x_scale from_max_y_scale from_max_z_scale from_min_x_scale from_min_y_scale \
         from_min_z_scale to_max_x to_max_y to_max_z to_min_x to_min_y to_min_z to_max_x_rot \
         to_max_y_rot to_max_z_rot to_min_x_rot to_min_y_rot to_min_z_rot to_max_x_scale \
         to_max_y_scale to_max_z_scale to_min_x_scale to_min_y_scale to_min_z_scale",
        Wants::Number,
    ),
    ("from_rotation_mode", Wants::Word(ROTATIONS)),
    ("map_from map_to", Wants::Word(MAPPED)),
    (
        "map_to_x_from map_to_y_from map_to_z_from",
        Wants::Word(AXES),
    ),
    ("mix_mode", Wants::Word(&["REPLACE", "ADD"])),
    (
        "mix_mode_rot",
        Wants::Word(&["REPLACE", "ADD", "BEFORE", "AFTER"]),
    ),
    ("mix_mode_scale", Wants::Word(&["REPLACE", "MULTIPLY"])),
    ("to_euler_order", Wants::Word(EULER)),
    ("use_motion_extrapolate", Wants::Bool),
];

/// The names of all types.
pub(super) const NAMES: &[&str] = &[
    "ACTION",
    "ARMATURE",
    "CAMERA_SOLVER",
    "CHILD_OF",
    "CLAMP_TO",
    "COPY_LOCATION",
    "COPY_ROTATION",
    "COPY_SCALE",
    "COPY_TRANSFORMS",
    "DAMPED_TRACK",
    "FLOOR",
    "FOLLOW_PATH",
    "FOLLOW_TRACK",
    "IK",
    "LIMIT_DISTANCE",
    "LIMIT_LOCATION",
    "LIMIT_ROTATION",
    "LIMIT_SCALE",
    "LOCKED_TRACK",
    "MAINTAIN_VOLUME",
    "OBJECT_SOLVER",
    "PIVOT",
    "SHRINKWRAP",
    "SPLINE_IK",
    "STRETCH_TO",
    "TRACK_TO",
    "TRANSFORM",
    "TRANSFORM_CACHE",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_type_is_named() {
        assert!(TYPES.iter().map(|(name, ..)| name).eq(NAMES));
    }
}
