//! The keywords of materials: all that one of the applications reads
//! (`docs/loaders/makehuman2/materials.md#lines`,
//! `docs/loaders/makehuman1/materials.md#material-keywords`,
//! `docs/loaders/mpfb/materials.md#lines-of-a-material`).

/// A keyword.
#[derive(Debug, PartialEq, Eq)]
pub struct Keyword {
    /// As it is written.
    pub name: &'static str,
    /// What stands behind it.
    pub value: Value,
    /// The keyword that it is another name for.
    pub alias_of: Option<&'static str>,
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

const fn row(name: &'static str, value: Value) -> Keyword {
    Keyword {
        name,
        value,
        alias_of: None,
    }
}

const fn alias(name: &'static str, of: &'static str) -> Keyword {
    Keyword {
        name,
        value: Picture,
        alias_of: Some(of),
    }
}

use Value::{Colour, Flag, Number, Parameter, Picture, Text, Whole, Word};

#[rustfmt::skip]
static KEYWORDS: [Keyword; 88] = [
    row("name", Text), row("description", Text), row("tag", Text), row("uuid", Text),
    row("author", Text), row("license", Text), row("homepage", Text),
    row("diffuseTexture", Picture), row("normalmapTexture", Picture), row("aomapTexture", Picture),
    row("metallicRoughnessTexture", Picture), row("emissiveTexture", Picture),
    row("bumpmapTexture", Picture), row("displacementmapTexture", Picture),
    row("specularmapTexture", Picture), row("transparencymapTexture", Picture),
    row("transmissionmapTexture", Picture), row("opacitymapTexture", Picture),
    row("roughnessmapTexture", Picture), row("metallicmapTexture", Picture),
    row("emissionColorMapTexture", Picture), row("emissionStrengthMapTexture", Picture),
    row("subsurfaceColorMapTexture", Picture), row("subsurfaceStrengthMapTexture", Picture),
    row("litsphereTexture", Picture), alias("diffusemapTexture", "diffuseTexture"),
    alias("albedoTexture", "diffuseTexture"), alias("albedoMapTexture", "diffuseTexture"),
    alias("basecolorTexture", "diffuseTexture"), alias("basecolorMapTexture", "diffuseTexture"),
    alias("bumpTexture", "bumpmapTexture"), alias("opacityTexture", "opacitymapTexture"),
    alias("emissionTexture", "emissionColorMapTexture"),
    alias("sssTexture", "subsurfaceColorMapTexture"),
    alias("sssMapTexture", "subsurfaceColorMapTexture"), row("shader", Word), row("uvMap", Word),
    row("blendMaterial", Word), row("shaderParam", Parameter), row("shaderDefine", Word),
    row("shaderConfig", Parameter), row("transparent", Flag), row("alphaToCoverage", Flag),
    row("backfaceCull", Flag), row("shadeless", Flag), row("wireframe", Flag),
    row("depthless", Flag), row("castShadows", Flag), row("receiveShadows", Flag),
    row("autoBlendSkin", Flag), row("sssEnabled", Flag), row("colorationMethod", Whole),
    row("ambientColor", Colour), row("diffuseColor", Colour), row("emissiveColor", Colour),
    row("specularColor", Colour), row("colorationColor", Colour), row("glassColor", Colour),
    row("viewPortColor", Colour), row("viewPortAlpha", Number), row("diffuseIntensity", Number),
    row("specularIntensity", Number), row("normalmapIntensity", Number),
    row("aomapIntensity", Number), row("bumpmapIntensity", Number),
    row("displacementmapIntensity", Number), row("specularmapIntensity", Number),
    row("transparencymapIntensity", Number), row("opacitymapIntensity", Number),
    row("emissionIntensity", Number), row("subsurfaceIntensity", Number),
    row("roughnessFactor", Number), row("metallicFactor", Number), row("emissiveFactor", Number),
    row("transmission", Number), row("glassRoughness", Number), row("ior", Number),
    row("roughness", Number), row("metallic", Number), row("shininess", Number),
    row("opacity", Number), row("translucency", Number), row("sssRScale", Number),
    row("sssGScale", Number), row("sssBScale", Number), row("displacementMapIntensity", Number),
    alias("opacityMapTexture", "opacitymapTexture"),
    alias("emissiveMapTexture", "emissionColorMapTexture"),
];

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
