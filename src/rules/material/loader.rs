//! What MakeHuman 2 reads of a material (formats/makehuman2.md §17, makehuman2-worn-observed.md 2).

use crate::formats::python_int;
use crate::repo::{Surface, Wearer};

/// The keywords that it reads.
const READ: [&str; 28] = [
    "alphaToCoverage",
    "ambientColor",
    "aomapIntensity",
    "aomapTexture",
    "backfaceCull",
    "colorationColor",
    "colorationMethod",
    "description",
    "diffuseColor",
    "diffuseTexture",
    "emissiveColor",
    "emissiveFactor",
    "emissiveTexture",
    "glassColor",
    "glassRoughness",
    "ior",
    "metallicFactor",
    "metallicRoughnessTexture",
    "name",
    "normalmapIntensity",
    "normalmapTexture",
    "roughnessFactor",
    "shader",
    "shaderParam",
    "specularColor",
    "tag",
    "transmission",
    "transparent",
];

/// Whether it reads the keyword.
pub(super) fn reads(keyword: &str) -> bool {
    READ.contains(&keyword)
}

/// All keywords that it reads.
pub(super) fn keywords() -> impl Iterator<Item = &'static str> {
    READ.into_iter()
}

/// The numbers that a keyword is held to.
pub(super) fn range(keyword: &str) -> Option<(f64, f64)> {
    match keyword {
        "normalmapIntensity" | "roughnessFactor" | "metallicFactor" | "emissiveFactor" | "transmission"
        | "glassRoughness" => Some((0.0, 1.0)),
        "aomapIntensity" => Some((0.0, 2.0)),
        "ior" => Some((1.0, 2.5)),
        _ => None,
    }
}

/// The shaders that it has for materials.
pub(super) const SHADERS: [&str; 4] = ["litsphere", "pbr", "phong", "toon"];

/// The shader that the material asks for: the last part of a path; phong if it asks for none.
pub(super) fn shader<'s>(surface: &'s Surface<'_>) -> &'s str {
    let line = surface.material.last("shader").filter(|line| line.count > 0);
    line.map_or("phong", |line| line.word(0).rsplit('/').next().unwrap_or_default())
}

/// Whether phong draws it, with all that phong wants. Of a litsphere without its picture nothing else is left.
pub(super) fn is_phong(surface: &Surface<'_>) -> bool {
    let litsphere = surface.litsphere.as_ref();
    match shader(surface) {
        "phong" => true,
        "litsphere" => litsphere.is_none_or(|picture| picture.file.is_none() && !picture.is_open),
        _ => false,
    }
}

/// A number that the last line of a keyword sets, as it is written.
pub(super) fn number(surface: &Surface<'_>, keyword: &str) -> Option<f64> {
    surface.material.last(keyword)?.number_at(0)
}

/// Whether the diffuse texture gets other colours.
pub(super) fn is_coloured(surface: &Surface<'_>) -> bool {
    let line = surface.material.last("colorationMethod");
    line.is_some_and(|line| matches!(python_int(line.word(0).as_bytes()), Some(1 | 2)))
}

/// When the material is read.
pub(super) const fn when(surface: &Surface<'_>) -> &'static str {
    match surface.wearer {
        Wearer::Skin => "when the skin is chosen",
        Wearer::Asset => "when the asset is put on",
        Wearer::Choice => "when the material is chosen",
    }
}

/// What becomes of models then.
pub(super) const fn models(surface: &Surface<'_>) -> &'static str {
    match surface.wearer {
        Wearer::Skin => "models with this skin load only in part",
        Wearer::Asset => "models that wear it load only in part",
        Wearer::Choice => "models that name it load only in part",
    }
}
