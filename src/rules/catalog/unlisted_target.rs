//! Targets that MPFB brings have a slider, or a place in the macro loops.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, counted};
use super::{checked, forgotten_ends, sliders};
use crate::diag::{Application::Mpfb, Case, Evidence, Finding, Level, RuleInfo, grouped};
use crate::repo::mpfb::{View, is_custom};
use crate::repo::{FileFacts, parent};

pub(in crate::rules) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "shows no slider for it")],
    docs: "A target lies in the folder of a section of `target.json`, no slot of the section names it, and the macro system \
        never asks for it. MPFB shows no slider for it; saved characters still find it by its name.\n\n\
        Targets in other folders are meant to be found by name, such as those of the face: they are an info.\n\n\
        Add a slider, or remove the target.",
    counts: "targets",
    ..RuleInfo::new("catalog-unlisted-target", Level::Warning, "a target that no slider uses")
});

const BY_NAME: Case = &[(Mpfb, Level::Info, "shows no slider for them; saved characters find them by name")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    // A section that another one of its key takes away is told as such.
    if !catalog.file.json.duplicates.is_empty() {
        return;
    }
    // Their slider is there, and lacks the slots.
    let forgotten: Vec<String> = sliders(&catalog)
        .filter_map(|(section, category)| Some((section, forgotten_ends(&catalog, section, category)?)))
        .flat_map(|(section, ends)| ends.map(|end| format!("{}/{end}.target.gz", catalog.folder(&section.name))))
        .collect();
    // What its slider lists is missing in a slot.
    let listed: BTreeSet<String> = sliders(&catalog)
        .flat_map(|(section, category)| category.targets.iter().map(move |(_, name)| (section, name)))
        .map(|(section, name)| format!("{}/{name}.target", catalog.folder(&section.name)))
        .collect();
    // Without the macro settings nobody knows which names are composed of them.
    let lacks_parts = view.parts.as_ref().is_none_or(|parts| !parts.settings.is_whole());
    let may_be_of_macros = |file: &FileFacts| {
        lacks_parts && (file.rel.starts_with("targets/macrodetails/") || file.rel.starts_with("targets/breast/"))
    };
    let is_free = |file: &&FileFacts| {
        let is_target = file.rel.ends_with(".target.gz") || file.rel.ends_with(".target");
        is_target
            && !is_custom(&file.rel)
            && view.references.to_file(file).next().is_none()
            && !view.asks_for(file)
            && !may_be_of_macros(file)
            && !forgotten.contains(&file.rel)
            && !listed.contains(file.rel.trim_end_matches(".gz"))
    };
    let free = catalog.layer.below("targets").filter(is_free);
    for (folder, files) in grouped(free.map(|file| (parent(&file.rel), file))) {
        let Some(first) = files.first() else { continue };
        let section = catalog.sliders.sections.iter().find(|section| catalog.folder(&section.name) == folder);
        // Whether a slider that cannot be read has them is not known.
        if section.is_some_and(|section| !section.is_whole) {
            continue;
        }
        let is_section = section.is_some();
        let count = counted(files.len(), "target");
        let message = format!("{count} in `{folder}` {} no slider, first `{}`", has(files.len()), first.file_name());
        let finding = RULE.in_layer(catalog.layer, folder, message).key(folder);
        let finding = finding.parts_in(files.iter().map(|file| (file.file_name(), &file.path)));
        let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.file_name())));
        let help = "add sliders for them to `target.json`, or remove them";
        out.push(if is_section { finding.help(help) } else { finding.case(BY_NAME) });
    }
}

const fn has(count: usize) -> &'static str {
    if count == 1 { "has" } else { "have" }
}
