//! The list of vertices to hide begins where it is looked for.

use super::super::{Check, Rule, RuleCx};
use super::blender;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Mpfb, "hides nothing, or less: the body shows through the asset")],
    docs: "`delete_verts` is there, and MPFB does not see its list, or not all of it.\n\n\
        The vertex rows end at the first line that is not a row, and this line is thrown away. If it is `delete_verts`, \
        the list is lost. The list itself ends at the first line that does not begin with a number: an empty line directly \
        below `delete_verts`, a range without spaces (`5-7`), a dash.\n\n\
        Put an empty line between the rows and `delete_verts`, and none below it.",
    ..RuleInfo::new("proxy-delete-list-lost", Level::Warning, "a list of vertices to hide that is not seen")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    blender::list::lost(&RULE, body, out);
}
