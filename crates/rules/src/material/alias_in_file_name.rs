//! The correction of a keyword reaches the name of the file.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::rewritten(&RULE, view, out))
    .rule(RuleInfo {
        breaks: &[(
            Mpfb,
            "looks for the picture under another name and does without it",
        )],
        docs: include_str!("alias_in_file_name.md").trim_ascii_end(),
        ..RuleInfo::new(
            "material-alias-in-file-name",
            Level::Warning,
            "a keyword that is corrected in the name of its picture as well",
        )
    });
