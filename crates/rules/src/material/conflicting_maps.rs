//! Roughness has one map.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::conflicting(&RULE, view, out))
    .rule(RuleInfo {
        breaks: &[(Mpfb, "fails with `ValueError` when it makes the material")],
        docs: include_str!("conflicting_maps.md").trim_ascii_end(),
        ..RuleInfo::new(
            "material-conflicting-maps",
            Level::Error,
            "maps of a material that cannot be used together",
        )
    });
