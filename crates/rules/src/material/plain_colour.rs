//! What is worn has a texture.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule =
    Check::Mpfb(|view, _, out| blender::plain(&RULE, view, out)).rule(RuleInfo {
        breaks: &[(
            Mpfb,
            "turns all clothes of a saved character into game engine materials",
        )],
        docs: include_str!("plain_colour.md").trim_ascii_end(),
        ..RuleInfo::new(
            "material-plain-colour",
            Level::Warning,
            "the material of an asset has no texture",
        )
    });
