//! No file is committed with both sides of a merge in it.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, BOTH), (Makehuman1, BOTH), (Mpfb, BOTH)],
    docs: include_str!("merge_conflict.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-merge-conflict",
        Level::Warning,
        "a file with both sides of a merge in it",
    )
});

const BOTH: &str = "reads the lines of both sides";
const MARKER: usize = "<<<<<<<".len();

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_read = matches!(
        file.kind_in(view.application()),
        Kind::Clothes
            | Kind::Material
            | Kind::Model
            | Kind::BaseMesh
            | Kind::AssetMesh
            | Kind::Motion
            | Kind::MotionMeta
    );
    let Some(at) = file.encoding.conflict_at.filter(|_| is_read) else {
        return;
    };
    let finding = RULE.at(
        file,
        Place::Span(at..at + MARKER),
        "unresolved merge conflict: both sides are in the file",
    );
    out.push(
        finding.help("keep one side, and remove the lines `<<<<<<<`, `=======` and `>>>>>>>`"),
    );
}
