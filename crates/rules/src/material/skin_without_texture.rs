//! Ink layers need a skin with a texture.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::bare_skins(&RULE, view, out))
    .rule(RuleInfo {
        breaks: &[(
            Mpfb,
            "fails with `ValueError` when an ink layer is put on the skin",
        )],
        docs: include_str!("skin_without_texture.md").trim_ascii_end(),
        ..RuleInfo::new(
            "material-skin-without-texture",
            Level::Error,
            "a skin without a texture beside ink layers",
        )
    });
