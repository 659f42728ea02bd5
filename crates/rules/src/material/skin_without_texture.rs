//! Ink layers need a skin with a texture.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::bare_skins(&RULE, view, out)).rule(RuleInfo {
    breaks: &[(Mpfb, "fails with `ValueError` when an ink layer is put on the skin")],
    docs: "A skin has no `diffuseTexture`, and there are ink layers.\n\n\
        MPFB recognises its own skins by the texture. Without one every ink layer fails with `ValueError` on this skin.\n\n\
        Add a `diffuseTexture`, or use the skin without ink layers.",
    ..RuleInfo::new("material-skin-without-texture", Level::Error, "a skin without a texture beside ink layers")
});
