//! A picture stands for colours or for numbers.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::both_spaces(&RULE, view, out))
    .rule(RuleInfo {
        breaks: &[(
            Mpfb,
            "gives the picture one colour space for both: colours are too dark or too light, or \
            surfaces bent",
        )],
        docs: include_str!("colour_space.md").trim_ascii_end(),
        ..RuleInfo::new(
            "material-colour-space",
            Level::Warning,
            "one picture for colours and for \
        numbers",
        )
    });
