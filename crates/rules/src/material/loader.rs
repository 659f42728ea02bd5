//! What MakeHuman 2 and MakeHuman 1 read of a material
//! (`docs/loaders/makehuman2/materials.md#lines`, `docs/loaders/makehuman2/materials.md#colours`;
//! `docs/loaders/makehuman1/materials.md#lines-of-a-material`,
//! `docs/loaders/makehuman1/materials.md#faults-of-materials`).

use mhlint_diag::Application;
use mhlint_formats::mhmat::{Line, keywords_of};
use mhlint_formats::python_int;
use mhlint_repo::{Surface, Wearer};

/// All keywords that an application reads.
pub(super) fn keywords(application: Application) -> impl Iterator<Item = &'static str> {
    keywords_of(application).map(|keyword| keyword.name)
}

/// Whether an application reads the keyword.
pub(super) fn reads(application: Application, keyword: &str) -> bool {
    keywords(application).any(|own| own == keyword)
}

/// Whether it is MakeHuman 1.
pub(super) const fn is_1(application: Application) -> bool {
    matches!(application, Application::Makehuman1)
}

/// The numbers that a keyword is held to.
pub(super) fn range(application: Application, keyword: &str) -> Option<(f64, f64)> {
    match keyword {
        "sssRScale" | "sssGScale" | "sssBScale" if is_1(application) => Some((0.0, f64::INFINITY)),
        "diffuseIntensity" | "specularIntensity" if is_1(application) => None,
        _ if is_1(application) => Some((0.0, 1.0)),
        "normalmapIntensity" | "roughnessFactor" | "metallicFactor" | "emissiveFactor"
        | "transmission" | "glassRoughness" => Some((0.0, 1.0)),
        "aomapIntensity" => Some((0.0, 2.0)),
        "ior" => Some((1.0, 2.5)),
        _ => None,
    }
}

/// The shaders that it has for materials.
pub(super) const SHADERS: [&str; 4] = ["litsphere", "pbr", "phong", "toon"];

/// The shader that the material asks for: the last part of a path; phong if it asks for none.
pub(super) fn shader<'s>(surface: &'s Surface<'_>) -> &'s str {
    let line = surface
        .material
        .last("shader")
        .filter(|line| line.count > 0);
    line.map_or("phong", |line| {
        line.word(0).rsplit('/').next().unwrap_or_default()
    })
}

/// Whether phong draws it, with all that phong wants. Of a litsphere without its picture nothing
/// else is left.
pub(super) fn is_phong(surface: &Surface<'_>) -> bool {
    let litsphere = surface.litsphere.as_ref();
    match shader(surface) {
        "phong" => true,
        "litsphere" => litsphere.is_none_or(|picture| picture.file.is_none() && !picture.is_open),
        _ => false,
    }
}

/// The lines that set parameters of the shader in the end.
pub(super) fn last_parameters<'s>(surface: &'s Surface<'_>) -> impl Iterator<Item = &'s Line> {
    let own = surface
        .material
        .lines_of("shaderParam")
        .filter(|line| line.count > 1);
    own.filter(|line| {
        surface
            .material
            .parameter(line.word(0))
            .is_some_and(|last| std::ptr::eq(last, *line))
    })
}

/// Parameters of shaders that MakeHuman 1 sets from other keywords.
#[rustfmt::skip]
pub(super) const PARAMETERS: [&str; 16] = [
    "diffuse", "ambient", "specular", "emissive", "diffuseTexture", "bumpmapTexture",
    "normalmapTexture", "displacementmapTexture", "specularmapTexture", "transparencymapTexture",
    "aomapTexture", "bumpmapIntensity", "normalmapIntensity", "specularmapIntensity",
    "transparencymapIntensity", "aomapIntensity",
];
/// Defines that follow from the material.
pub(super) const DEFINES: [&str; 8] = [
    "DIFFUSE",
    "BUMPMAP",
    "NORMALMAP",
    "DISPLACEMENT",
    "SPECULARMAP",
    "VERTEX_COLOR",
    "TRANSPARENCYMAP",
    "AOMAP",
];

/// A number that the last line of a keyword sets, as it is written.
pub(super) fn number(surface: &Surface<'_>, keyword: &str) -> Option<f64> {
    surface.material.last(keyword)?.number_at(0)
}

/// Whether the diffuse texture gets other colours.
pub(super) fn is_coloured(surface: &Surface<'_>) -> bool {
    let line = surface.material.last("colorationMethod");
    line.is_some_and(|line| matches!(python_int(line.word(0).as_bytes()), Some(1 | 2)))
}

/// What an exception at reading the material comes to, named as Python does.
pub(super) fn crash(surface: &Surface<'_>, exception: &str) -> String {
    if !is_1(surface.application) {
        return format!(
            "crashes with `{exception}` {}; {}",
            when(surface),
            models(surface)
        );
    }
    match surface.wearer {
        Wearer::Skin if surface.is_first => {
            format!("does not start: `{exception}` at the default skin")
        }
        Wearer::Skin => format!("does not show the skin: `{exception}` when it is chosen"),
        Wearer::Asset => format!("does not put the asset on: `{exception}` at its material"),
        Wearer::Choice => format!("does not show the material: `{exception}` when it is chosen"),
    }
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
