//! Pictures have names of their own.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::same_names(&RULE, view, out))
    .rule(RuleInfo {
        breaks: &[(
            Mpfb,
            "shows the picture of the asset that was put on first on the others as well",
        )],
        docs: include_str!("texture_name_clash.md").trim_ascii_end(),
        ..RuleInfo::new(
            "material-texture-name-clash",
            Level::Warning,
            "different pictures with one file name",
        )
    });
