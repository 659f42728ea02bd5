//! The correction of a keyword reaches the name of the file.

use super::super::{Check, Rule};
use super::blender;
use mhlint_diag::{Application::Mpfb, Level, RuleInfo};

pub(crate) static RULE: Rule = Check::Mpfb(|view, _, out| blender::rewritten(&RULE, view, out)).rule(RuleInfo {
    breaks: &[(Mpfb, "looks for the picture under another name and does without it")],
    docs: "A material has another word for a keyword, such as `bumpTexture` for `bumpmapTexture`, or other capitals, and the name of the picture has the same word in it.\n\n\
        MPFB corrects the word wherever it stands in the line: for `bumpTexture hat_bumpTexture.png` it looks for `hat_bumpmapTexture.png` and does not find it.\n\n\
        Write the keyword as MPFB has it.",
    ..RuleInfo::new("material-alias-in-file-name", Level::Warning, "a keyword that is corrected in the name of its picture as well")
});
