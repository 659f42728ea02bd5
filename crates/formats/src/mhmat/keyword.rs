//! The keywords of materials: all that one of the applications reads
//! (`docs/loaders/makehuman2/materials.md#lines`,
//! `docs/loaders/makehuman1/materials.md#material-keywords`,
//! `docs/loaders/mpfb/materials.md#lines-of-a-material`).

use mhlint_diag::Application::{self, Makehuman1, Makehuman2, Mpfb};

/// A keyword.
#[derive(Debug, PartialEq, Eq)]
pub struct Keyword {
    /// As it is written.
    pub name: &'static str,
    /// What stands behind it.
    pub value: Value,
    /// The keyword that it is another name for.
    pub alias_of: Option<&'static str>,
    /// Who reads it under this name.
    readers: &'static [Application],
}

impl Keyword {
    /// Whether an application reads it under this name.
    pub fn is_read_by(&self, application: Application) -> bool {
        self.readers.contains(&application)
    }
}

/// What stands behind a keyword.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// The rest of the line.
    Text,
    /// The name of a picture.
    Picture,
    /// A word.
    Word,
    /// Yes or no.
    Flag,
    /// A number.
    Number,
    /// A whole number.
    Whole,
    /// Red, green and blue.
    Colour,
    /// The name of a setting of the shader, and its value.
    Parameter,
}

const fn row(name: &'static str, value: Value, readers: &'static [Application]) -> Keyword {
    Keyword {
        name,
        value,
        alias_of: None,
        readers,
    }
}

const fn alias(name: &'static str, of: &'static str) -> Keyword {
    Keyword {
        name,
        value: Picture,
        alias_of: Some(of),
        readers: &[],
    }
}

use Value::{Colour, Flag, Number, Parameter, Picture, Text, Whole, Word};

const ALL: &[Application] = &[Makehuman2, Makehuman1, Mpfb];
const MH2: &[Application] = &[Makehuman2];
const MH1: &[Application] = &[Makehuman1];
const MPFB: &[Application] = &[Mpfb];
/// What MPFB has kept of MakeHuman 1.
const OLDER: &[Application] = &[Makehuman1, Mpfb];
/// What came with physically based shading.
const NEWER: &[Application] = &[Makehuman2, Mpfb];

#[rustfmt::skip]
static KEYWORDS: [Keyword; 88] = [
    row("name", Text, ALL), row("description", Text, ALL), row("tag", Text, ALL),
    row("uuid", Text, MPFB), row("author", Text, OLDER), row("license", Text, OLDER),
    row("homepage", Text, MPFB), row("diffuseTexture", Picture, ALL),
    row("normalmapTexture", Picture, ALL), row("aomapTexture", Picture, ALL),
    row("metallicRoughnessTexture", Picture, MH2), row("emissiveTexture", Picture, MH2),
    row("bumpmapTexture", Picture, OLDER), row("displacementmapTexture", Picture, OLDER),
    row("specularmapTexture", Picture, OLDER), row("transparencymapTexture", Picture, MH1),
    row("transmissionmapTexture", Picture, MPFB), row("opacitymapTexture", Picture, MPFB),
    row("roughnessmapTexture", Picture, MPFB), row("metallicmapTexture", Picture, MPFB),
    row("emissionColorMapTexture", Picture, MPFB), row("emissionStrengthMapTexture", Picture, MPFB),
    row("subsurfaceColorMapTexture", Picture, MPFB),
    row("subsurfaceStrengthMapTexture", Picture, MPFB), row("litsphereTexture", Picture, MPFB),
    alias("diffusemapTexture", "diffuseTexture"), alias("albedoTexture", "diffuseTexture"),
    alias("albedoMapTexture", "diffuseTexture"), alias("basecolorTexture", "diffuseTexture"),
    alias("basecolorMapTexture", "diffuseTexture"), alias("bumpTexture", "bumpmapTexture"),
    alias("opacityTexture", "opacitymapTexture"),
    alias("emissionTexture", "emissionColorMapTexture"),
    alias("sssTexture", "subsurfaceColorMapTexture"),
    alias("sssMapTexture", "subsurfaceColorMapTexture"), row("shader", Word, ALL),
    row("uvMap", Word, MH1), row("blendMaterial", Word, MPFB), row("shaderParam", Parameter, ALL),
    row("shaderDefine", Word, MH1), row("shaderConfig", Parameter, MH1),
    row("transparent", Flag, ALL), row("alphaToCoverage", Flag, ALL),
    row("backfaceCull", Flag, ALL), row("shadeless", Flag, OLDER), row("wireframe", Flag, OLDER),
    row("depthless", Flag, OLDER), row("castShadows", Flag, OLDER),
    row("receiveShadows", Flag, OLDER), row("autoBlendSkin", Flag, OLDER),
    row("sssEnabled", Flag, OLDER), row("colorationMethod", Whole, MH2),
    row("ambientColor", Colour, ALL), row("diffuseColor", Colour, ALL),
    row("emissiveColor", Colour, ALL), row("specularColor", Colour, ALL),
    row("colorationColor", Colour, MH2), row("glassColor", Colour, MH2),
    row("viewPortColor", Colour, OLDER), row("viewPortAlpha", Number, MH1),
    row("diffuseIntensity", Number, OLDER), row("specularIntensity", Number, MH1),
    row("normalmapIntensity", Number, ALL), row("aomapIntensity", Number, ALL),
    row("bumpmapIntensity", Number, OLDER), row("displacementmapIntensity", Number, MH1),
    row("specularmapIntensity", Number, OLDER), row("transparencymapIntensity", Number, MH1),
    row("opacitymapIntensity", Number, MPFB), row("emissionIntensity", Number, MPFB),
    row("subsurfaceIntensity", Number, MPFB), row("roughnessFactor", Number, MH2),
    row("metallicFactor", Number, MH2), row("emissiveFactor", Number, MH2),
    row("transmission", Number, MH2), row("glassRoughness", Number, MH2), row("ior", Number, NEWER),
    row("roughness", Number, MPFB), row("metallic", Number, MPFB), row("shininess", Number, OLDER),
    row("opacity", Number, OLDER), row("translucency", Number, OLDER),
    row("sssRScale", Number, OLDER), row("sssGScale", Number, OLDER),
    row("sssBScale", Number, OLDER), row("displacementMapIntensity", Number, MPFB),
    alias("opacityMapTexture", "opacitymapTexture"),
    alias("emissiveMapTexture", "emissionColorMapTexture"),
];

/// The keywords that an application reads.
pub fn keywords_of(application: Application) -> impl Iterator<Item = &'static Keyword> {
    keywords().filter(move |keyword| keyword.is_read_by(application))
}

/// All keywords of all applications.
pub fn keywords() -> impl Iterator<Item = &'static Keyword> {
    KEYWORDS.iter()
}

/// The keyword written so.
pub(super) fn written(word: &[u8]) -> Option<&'static Keyword> {
    KEYWORDS
        .iter()
        .find(|keyword| keyword.name.as_bytes() == word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_keyword_has_one_row_and_every_alias_a_meaning() {
        for keyword in &KEYWORDS {
            assert_eq!(
                KEYWORDS
                    .iter()
                    .filter(|other| other.name == keyword.name)
                    .count(),
                1,
                "{}",
                keyword.name
            );
            let meant = keyword.alias_of.map(|name| written(name.as_bytes()));
            assert!(
                meant.is_none_or(|meant| meant.is_some_and(|meant| meant.alias_of.is_none())),
                "{}",
                keyword.name
            );
        }
    }
}
