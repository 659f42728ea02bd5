//! The keywords of assets, and which one a misspelt one is meant to be.

use crate::diag::nearest;
use crate::formats::mhclo::{Entry, Section};

/// What MakeHuman 2 reads.
const READ: [&str; 18] = [
    "name",
    "uuid",
    "description",
    "author",
    "license",
    "homepage",
    "tag",
    "obj_file",
    "material",
    "vertexboneweights_file",
    "version",
    "z_depth",
    "x_scale",
    "y_scale",
    "z_scale",
    "verts",
    "delete_verts",
    "weights",
];

/// What only other applications read, or once did.
const OTHERS: [&str; 27] = [
    "basemesh",
    "max_pole",
    "special_pose",
    "uvLayer",
    "shear_x",
    "shear_y",
    "shear_z",
    "l_shear_x",
    "l_shear_y",
    "l_shear_z",
    "r_shear_x",
    "r_shear_y",
    "r_shear_z",
    "backface_culling",
    "transparent",
    "shapekey",
    "subsurf",
    "shrinkwrap",
    "solidify",
    "objfile_layer",
    "uvtex_layer",
    "use_projection",
    "mask_uv_layer",
    "texture_uv_layer",
    "delete",
    "vertexgroup_file",
    "texture",
];

/// Other words for the same.
const ALIASES: [(&str, &str); 5] = [
    ("tags", "tag"),
    ("licence", "license"),
    ("vertexboneweights", "vertexboneweights_file"),
    ("mesh", "obj_file"),
    ("obj", "obj_file"),
];

/// Keywords that nothing but a text to read depends on.
pub(super) fn is_harmless(keyword: &str) -> bool {
    matches!(keyword, "description" | "author" | "license" | "homepage" | "version")
}

/// The keyword that a line of an unknown one is meant to have.
pub(super) fn meant(entry: &Entry) -> Option<&'static str> {
    let written = &*entry.keyword;
    if entry.is_comment || entry.section == Section::Deleted && entry.value.is_empty() {
        return None;
    }
    if READ.contains(&written) || OTHERS.contains(&written) {
        return None;
    }
    let folded = folded(written);
    let same = READ.into_iter().find(|known| self::folded(known) == folded);
    let alias = || ALIASES.iter().find(|(other, _)| *other == folded).map(|(_, known)| *known);
    let near = || {
        // One that is nearer to a keyword of another application is meant as that.
        let near = nearest(written, READ.into_iter().chain(OTHERS))?;
        READ.into_iter().find(|known| *known == near)
    };
    same.or_else(alias).or_else(near)
}

/// Without capitals, lines and dashes.
fn folded(word: &str) -> String {
    word.chars().filter(|letter| letter.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}
