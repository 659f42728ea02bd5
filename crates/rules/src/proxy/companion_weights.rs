//! The weights that an asset names are those which MPFB reads.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Body(|body, _, out| {
    if body.is_mpfb() {
        blender::companion::other(&RULE, body, out);
    }
})
.rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "takes the weights of the body, or of the file beside the asset, and not \
        those that are named",
    )],
    docs: include_str!("companion_weights.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-companion-weights",
        Level::Warning,
        "the bone weights that an asset names are not those in use",
    )
});
