//! Pictures have names of their own.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::same_names(&RULE, view, out)).rule(RuleInfo {
    breaks: &[(Mpfb, "shows the picture of the asset that was put on first on the others as well")],
    docs: "Materials name different pictures that have the same file name, such as `diffuse.png` in two folders.\n\n\
        MPFB looks for a picture by its name in the whole scene first, so the second asset wears the picture of the first one, without a message.\n\n\
        Give each picture a name of its own, such as `hat_diffuse.png`.",
    ..RuleInfo::new("material-texture-name-clash", Level::Warning, "different pictures with one file name")
});
