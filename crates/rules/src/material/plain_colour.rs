//! What is worn has a texture.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::plain(&RULE, view, out)).rule(RuleInfo {
    breaks: &[(Mpfb, "turns all clothes of a saved character into game engine materials")],
    docs: "The material of clothes, hair or another part of the body has no `diffuseTexture`.\n\n\
        MPFB takes such a material for one of a game engine. When a character with it is saved, all clothes and body parts get that kind of material; loaded again, they have lost all maps but colour and normals.\n\n\
        Add a texture: a small picture of one colour does.",
    ..RuleInfo::new("material-plain-colour", Level::Warning, "the material of an asset has no texture")
});
