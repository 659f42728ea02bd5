//! What belongs to a base mesh lies in a folder of its name.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "never reads it or the targets beside it: it only looks in the folder of the base mesh",
    )],
    docs: include_str!("base_folder_missing.md").trim_ascii_end(),
    of_library: true,
    ..RuleInfo::new(
        "overlay-base-folder-missing",
        Level::Error,
        "sliders and targets outside the folder of a base mesh",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    for (folder, file) in view.unsorted() {
        let message = format!(
            "`{}` is in `{folder}` itself, expected in the folder of a base mesh",
            file.file_name()
        );
        let finding = RULE
            .at(file, Place::File, message)
            .key(folder)
            .asset(layer.display(folder));
        let targets = layer
            .below(folder)
            .filter(|file| file.target().is_some())
            .count();
        let what = if targets > 0 {
            format!(", including {}", counted(targets, "target"))
        } else {
            String::new()
        };
        let base = base_of(view, folder).unwrap_or("<base>");
        out.push(finding.help(format!(
            "move the content of `{folder}` to `{folder}/{base}`{what}"
        )));
    }
}

/// The base mesh that most of the targets name.
fn base_of<'a>(view: &View<'a>, folder: &str) -> Option<&'a str> {
    let mut named: BTreeMap<&str, usize> = BTreeMap::new();
    let targets = view
        .layers()
        .checked
        .below(folder)
        .filter_map(|file| file.target());
    for (_, name) in targets.filter_map(|facts| facts.basemesh.as_ref()) {
        *named.entry(name).or_default() += 1;
    }
    let (name, _) = named.into_iter().max_by_key(|(_, count)| *count)?;
    view.body_names()
        .into_iter()
        .find(|base| base.eq_ignore_ascii_case(name))
}
