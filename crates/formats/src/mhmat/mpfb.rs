//! The keywords of a material as MPFB reads them: in whatever capitals, and under other names
//! (`docs/loaders/mpfb/materials.md#lines-of-a-material`).

use super::keyword::{Keyword, Value, keywords_of};
use mhlint_diag::Application::Mpfb;

/// Other words for the maps, in front of `Texture`.
#[rustfmt::skip]
const ALIASES: [(&str, &str); 11] = [
    ("diffusemap", "diffuse"), ("albedo", "diffuse"), ("albedomap", "diffuse"),
    ("basecolor", "diffuse"), ("basecolormap", "diffuse"), ("bump", "bumpmap"),
    ("opacity", "opacitymap"), ("emissive", "emissionColorMap"), ("emission", "emissionColorMap"),
    ("sss", "subsurfaceColorMap"), ("sssmap", "subsurfaceColorMap"),
];

/// The keyword that a word stands for.
pub fn key(word: &str) -> Option<&'static Keyword> {
    named(word).or_else(|| {
        let lower = word.to_ascii_lowercase();
        let map = lower.strip_suffix("texture")?;
        let (_, map) = ALIASES.iter().find(|(alias, _)| *alias == map)?;
        named(&format!("{map}Texture"))
    })
}

/// Whether it is a keyword, in whatever capitals.
pub fn is_key(word: &str) -> bool {
    named(word).is_some()
}

/// Whether its value is the name of a file.
pub fn is_file(key: &Keyword) -> bool {
    key.value == Value::Picture || key.name == "blendMaterial"
}

/// Whether it names a picture that is used.
pub fn is_picture(key: &Keyword) -> bool {
    key.value == Value::Picture && key.name != "litsphereTexture"
}

fn named(word: &str) -> Option<&'static Keyword> {
    keywords_of(Mpfb).find(|key| key.name.eq_ignore_ascii_case(word))
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
