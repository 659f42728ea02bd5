//! Names of groups must be ASCII.

use super::super::cause::mesh::weigh;
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes with `UnicodeEncodeError` while loading the base mesh")],
    docs: "The name of a face group contains a letter beyond ASCII.\n\n\
        MakeHuman 2 stores group names as ASCII text and crashes on any other letter. Groups without faces are \
        dropped before that and do no harm.\n\n\
        Rename the group, here and in `visible groups` of `base.json`.",
    ..RuleInfo::new("mesh-group-name", Level::Error, "a group name is not ASCII")
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // An archive has them packed, and unpacking does not mind.
    let Some(mesh) = file.mesh().filter(|_| file.kind == Kind::BaseMesh) else { return };
    for group in mesh.groups.iter().filter(|group| group.faces > 0 && !group.name.is_ascii()) {
        let finding = RULE
            .at(file, Place::Line(group.line), format!("group name `{}` is not ASCII", group.name))
            .key(&group.name)
            .help("rename the group with letters a to z, digits, `-` and `_` only");
        out.push(weigh(view, file, finding));
    }
}
