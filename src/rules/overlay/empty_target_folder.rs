//! The folder that all targets come from holds none.

use super::super::{Check, Rule, RuleCx};
use super::{has_broken_override, has_misnamed_override};
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::repo::makehuman2::{Base, TargetFolder, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "leaves an empty archive behind at the first start, and stops with an EOFError at each start after it",
        )],
        docs: "MakeHuman 2 packs all targets of the folder in use into `compressedtargets.npz` when there is none. It creates the \
            file first and fills it then; if there is no `.target` at all in the folder or below, a file of 0 bytes stays, and \
            from the second start on the program stops with an EOFError (target.py:648) until somebody deletes it. The folder \
            in use is `contarget/<base>` where a macro.json there is accepted, otherwise `target/<base>` of the system. Without \
            any modelling.json the step is left out.\n\nReported is a folder from which nothing is wanted either: where names of \
            targets lead to nothing, these names are the findings.\n\nPut a target into the folder; any will do.",
        ..RuleInfo::new(
            "overlay-empty-target-folder",
            Level::Error,
            "the folder that the targets of a base come from holds no target",
        )
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if has_broken_override(base) || has_misnamed_override(view, base) {
        return;
    }
    let Some(folder) = base.targets.filter(TargetFolder::exists) else { return };
    let has_sliders = base.modelling.winner().is_some() || base.user_modelling.accepted().is_some();
    let rel = folder.rel();
    let is_wanted = |rel: &str| view.references_of(base).any(|one| one.kind.is_target() && one.rel.starts_with(rel));
    let has_targets = folder.targets().next().is_some() || folder.archive().is_some();
    if has_sliders && !has_targets && std::ptr::eq(view.layers.checked, folder.layer) && !is_wanted(&format!("{rel}/"))
    {
        let message = format!("there is no `.target` in `{}` nor below it", folder.layer.display(&rel));
        out.push(
            RULE.in_layer(folder.layer, &rel, message).key(base.name).help("put a target into the folder; any will do"),
        );
    }
}
