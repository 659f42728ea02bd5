//! Roughness has one map.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::conflicting(&RULE, view, out)).rule(RuleInfo {
    breaks: &[(Mpfb, "fails with `ValueError` when it makes the material")],
    docs: "A material has both `roughnessmapTexture` and `specularmapTexture`. In MPFB both lead to the same input of the shader, and the second one fails.\n\n\
        Remove one of the two lines.",
    ..RuleInfo::new("material-conflicting-maps", Level::Error, "maps of a material that cannot be used together")
});
