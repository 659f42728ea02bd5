//! The folder that all targets come from holds none.

use super::super::{Check, Rule, RuleCx};
use super::{has_broken_override, has_misnamed_override};
use mhlint_diag::{Application::Makehuman2, Finding, Level, RuleInfo};
use mhlint_repo::makehuman2::{Base, TargetFolder, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "writes an empty archive at the first start, and crashes with `EOFError` at every later \
            start",
    )],
    docs: include_str!("empty_target_folder.md").trim_ascii_end(),
    ..RuleInfo::new(
        "overlay-empty-target-folder",
        Level::Error,
        "the folder that the targets of a base come from contains no target",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if has_broken_override(base) || has_misnamed_override(view, base) {
        return;
    }
    let Some(folder) = base.targets.filter(TargetFolder::exists) else {
        return;
    };
    let has_sliders = base.modelling.winner().is_some() || base.user_modelling.accepted().is_some();
    let rel = folder.rel();
    let is_wanted = |rel: &str| {
        view.references_of(base)
            .any(|one| one.kind.is_target() && one.rel.starts_with(rel))
    };
    let has_targets = folder.targets().next().is_some() || folder.archive().is_some();
    if has_sliders
        && !has_targets
        && std::ptr::eq(view.layers.checked, folder.layer)
        && !is_wanted(&format!("{rel}/"))
    {
        let message = format!(
            "`{}` contains no `.target` file",
            folder.layer.display(&rel)
        );
        out.push(
            RULE.in_layer(folder.layer, &rel, message)
                .key(base.name)
                .help(
                    "copy a target of this \
                base into the folder; if MakeHuman 2 was started before, also delete \
                compressedtargets.npz there",
                ),
        );
    }
}
