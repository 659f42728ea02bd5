//! Names of groups must be ASCII.

use super::super::cause::mesh::weigh;
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with a UnicodeEncodeError while it loads the base")],
        docs: "MakeHuman 2 stores the names of face groups as ASCII text and stops at any other letter. Groups \
            without faces are dropped before and do no harm.\n\nRename the group, here and in `visible groups` \
            of `base.json`.",
        ..RuleInfo::new("mesh-group-name", Level::Error, "the name of a group has letters beyond ASCII")
    },
    check: Check::File(run),
};

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // An archive has them packed, and unpacking does not mind.
    let Some(mesh) = file.mesh().filter(|_| file.kind == Kind::BaseMesh) else { return };
    for group in mesh.groups.iter().filter(|group| group.faces > 0 && !group.name.is_ascii()) {
        let finding = RULE
            .at(file, Place::Line(group.line), format!("the name of group `{}` is not ASCII", group.name))
            .key(&group.name)
            .help("use letters a to z, digits, `-` and `_`");
        out.push(weigh(view, file, finding));
    }
}
