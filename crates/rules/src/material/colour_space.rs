//! A picture stands for colours or for numbers.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::both_spaces(&RULE, view, out)).rule(RuleInfo {
    breaks: &[(Mpfb, "gives the picture one colour space for both: colours are too dark or too light, or surfaces bent")],
    docs: "One picture is named both for a map of colours (`diffuseTexture`) and for one of numbers, such as `normalmapTexture`.\n\n\
        Blender keeps the colour space with the picture, not with the map: MPFB sets it twice, and the later one counts for \
        both, without a message. (Bumps are often taken from the picture of the colours: that is not reported.) Usually a line was copied, and the name of the picture was not changed.\n\n\
        Name the picture that was made for the map.",
    ..RuleInfo::new("material-colour-space", Level::Warning, "one picture for colours and for numbers")
});
