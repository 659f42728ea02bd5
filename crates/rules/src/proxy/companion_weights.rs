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
    breaks: &[(Mpfb, "takes the weights of the body, or of the file beside the asset, and not those that are named")],
    docs: "`vertexboneweights_file` names a file that is not called like the asset.\n\n\
        MPFB never reads this line. It takes the weights beside the asset that have its name (`hat.mhw` for `hat.mhclo`, \
        also `hat.force.mhw`, or `hat.default.mhw` for one rig), and what these leave out from the body. MakeHuman 1 and 2 \
        read the file that is named: in them the asset moves in another way.\n\n\
        Give the file of the weights the name of the asset, in its folder.",
    ..RuleInfo::new("proxy-companion-weights", Level::Warning, "the bone weights that an asset names are not those in use")
});
