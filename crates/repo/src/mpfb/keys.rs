//! The keywords of materials that MPFB reads, in whatever capitals
//! (`docs/loaders/mpfb/materials.md#lines-of-a-material`).

/// A keyword.
#[derive(Debug, PartialEq, Eq)]
pub struct Key {
    /// As it is written.
    pub name: &'static str,
    /// What its value has to be.
    pub reads: Reads,
}

/// What a value has to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reads {
    /// Any text.
    Text,
    /// The name of a file.
    File,
    /// One number.
    Number,
    /// True or false.
    Flag,
    /// Three numbers of digits and points.
    Colour,
    /// A parameter of a shader and its value.
    Parameter,
    /// A word on the shader.
    Shader,
}

impl Key {
    /// Whether it names a picture that is used.
    pub fn is_picture(&self) -> bool {
        self.reads == File && self.name.ends_with("Texture") && self.name != "litsphereTexture"
    }
}

const fn of(reads: Reads, name: &'static str) -> Key {
    Key { name, reads }
}

use Reads::{Colour, File, Flag, Number, Parameter, Shader, Text};

#[rustfmt::skip]
static KEYS: [Key; 58] = [
    of(Text, "tag"), of(Text, "name"), of(Text, "description"), of(Text, "uuid"),
    of(Text, "license"), of(Text, "homepage"), of(Text, "author"), of(File, "diffuseTexture"),
    of(File, "bumpmapTexture"), of(File, "normalmapTexture"), of(File, "displacementmapTexture"),
    of(File, "specularmapTexture"), of(File, "transmissionmapTexture"),
    of(File, "opacitymapTexture"), of(File, "roughnessmapTexture"), of(File, "metallicmapTexture"),
    of(File, "aomapTexture"), of(File, "emissionColorMapTexture"),
    of(File, "emissionStrengthMapTexture"), of(File, "subsurfaceColorMapTexture"),
    of(File, "subsurfaceStrengthMapTexture"), of(File, "litsphereTexture"),
    of(File, "blendMaterial"), of(Number, "diffuseIntensity"), of(Number, "bumpmapIntensity"),
    of(Number, "normalmapIntensity"), of(Number, "displacementMapIntensity"),
    of(Number, "specularmapIntensity"), of(Number, "opacitymapIntensity"),
    of(Number, "aomapIntensity"), of(Number, "emissionIntensity"),
    of(Number, "subsurfaceIntensity"), of(Number, "sssRScale"), of(Number, "sssGScale"),
    of(Number, "sssBScale"), of(Number, "metallic"), of(Number, "ior"), of(Number, "roughness"),
    of(Number, "shininess"), of(Number, "opacity"), of(Number, "translucency"),
    of(Flag, "sssEnabled"), of(Flag, "shadeless"), of(Flag, "wireframe"), of(Flag, "transparent"),
    of(Flag, "alphaToCoverage"), of(Flag, "backfaceCull"), of(Flag, "depthless"),
    of(Flag, "castShadows"), of(Flag, "receiveShadows"), of(Flag, "autoBlendSkin"),
    of(Colour, "diffuseColor"), of(Colour, "specularColor"), of(Colour, "emissiveColor"),
    of(Colour, "ambientColor"), of(Colour, "viewPortColor"), of(Parameter, "shaderParam"),
    of(Shader, "shader"),
];

/// Other words for the maps, in front of `Texture`.
#[rustfmt::skip]
const ALIASES: [(&str, &str); 11] = [
    ("diffusemap", "diffuse"), ("albedo", "diffuse"), ("albedomap", "diffuse"),
    ("basecolor", "diffuse"), ("basecolormap", "diffuse"), ("bump", "bumpmap"),
    ("opacity", "opacitymap"), ("emissive", "emissionColorMap"), ("emission", "emissionColorMap"),
    ("sss", "subsurfaceColorMap"), ("sssmap", "subsurfaceColorMap"),
];

/// The keyword that a word stands for.
pub(super) fn key(word: &str) -> Option<&'static Key> {
    let named = |name: &str| KEYS.iter().find(|key| key.name.eq_ignore_ascii_case(name));
    named(word).or_else(|| {
        let lower = word.to_ascii_lowercase();
        let map = lower.strip_suffix("texture")?;
        let (_, map) = ALIASES.iter().find(|(alias, _)| *alias == map)?;
        named(&format!("{map}Texture"))
    })
}

/// Whether it is a keyword, in whatever capitals.
pub fn is_key(word: &str) -> bool {
    KEYS.iter().any(|key| key.name.eq_ignore_ascii_case(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stand_for_keywords() {
        for (word, name) in [
            ("DIFFUSETEXTURE", Some("diffuseTexture")),
            ("bumpTexture", Some("bumpmapTexture")),
            ("albedoMapTexture", Some("diffuseTexture")),
            ("emissiveTexture", Some("emissionColorMapTexture")),
            ("roughnessFactor", None),
            ("transparencymapTexture", None),
            ("shaderConfig", None),
        ] {
            assert_eq!(key(word).map(|key| key.name), name, "{word}");
        }
    }
}
