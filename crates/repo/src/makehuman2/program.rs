//! What the program has and its users have not.

use crate::Layer;
use mhlint_discover::Kind;

/// What it opens at start.
pub const PROGRAM_FILES: [&str; 2] = ["makehuman2_version.json", "shaders/shader.json"];

/// Whether a layer holds parts of the program that belong to no base mesh.
pub fn holds_program(layer: &Layer) -> bool {
    PROGRAM_FILES.iter().any(|rel| layer.is_there(rel)) || has_shaders(layer)
}

/// Whether it has sources of shaders.
pub fn has_shaders(layer: &Layer) -> bool {
    let is_shader = |rel: &str| matches!(rel.rsplit('.').next(), Some("vert" | "frag"));
    layer.below("shaders").any(|file| is_shader(&file.rel))
}

/// Whether it is the program's and has lost all base meshes. Nobody else has macros in `target/`.
pub fn lacks_bases(layer: &Layer) -> bool {
    let has_macros = || {
        layer
            .below("target")
            .any(|file| file.kind == Kind::MacroJson)
    };
    // One that is called otherwise has a finding of its own.
    let is_base = |rel: &String| {
        rel.split('/')
            .next()
            .is_some_and(|top| top.eq_ignore_ascii_case("base"))
    };
    !layer.files.keys().any(is_base) && (holds_program(layer) || has_macros())
}
