//! A file that is there and not read, because another one replaces it.

use super::super::{Check, Rule, RuleCx, counted, enumerated};
use super::{Override, SystemFolder, is_complete, overrides, system_folder};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "reads the files in contarget instead of those in the system data",
    )],
    docs: include_str!("shadowed.md").trim_ascii_end(),
    ..RuleInfo::new(
        "overlay-shadowed",
        Level::Info,
        "a file that is replaced or never read",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let all = overrides(base);
    let replaced: Vec<&Override<'_>> = all
        .iter()
        .filter(|each| each.active && each.system.is_some())
        .collect();
    // An override with gaps is told by its gap.
    if is_complete(view, base) {
        out.extend(replaced_by_contarget(base, &replaced));
    }
    out.extend(contarget_of_system(view, base));
    // Where the system has no such folder the program stops before that, and
    // `overlay-partial-override` says why.
    let is_asked_for = system_folder(view, base) != SystemFolder::Absent;
    let layer = base
        .user_targets
        .map(|folder| folder.layer)
        .filter(|_| is_asked_for);
    if let Some(file) =
        layer.and_then(|layer| layer.file(&format!("target/{}/macro.json", base.name)))
    {
        let message = format!("`{}` in the user's folder is never read", file.rel);
        out.push(
            RULE.at(file, BEGINNING, message)
                .key("never read")
                .level(Level::Warning)
                .help(format!(
                    "remove it, or copy it to `contarget/{}` together with all targets of the base",
                    base.name
                ))
                .effect("ignores the file: it does not look for macros there"),
        );
    }
}

/// The opening bracket: the file as a whole, where editors find it.
const BEGINNING: Place = Place::Span(0..1);

/// A contarget folder in the system's data, beside a user's folder, which alone may have one.
fn contarget_of_system(view: &View<'_>, base: &Base<'_>) -> Option<Finding> {
    let folder = format!("contarget/{}", base.name);
    let first = view
        .layers
        .checked
        .below(&folder)
        .next()
        .filter(|_| view.layers.user.is_none())?;
    let files = view.layers.checked.below(&folder).count();
    let message = format!(
        "`{folder}` in the system data is never read ({})",
        counted(files, "file")
    );
    Some(
        RULE.at(first, Place::File, message)
            .key("contarget of the system")
            .level(Level::Warning)
            .help("move the folder to the user's data folder, or its files to `target` in this one")
            .effect("looks for overrides only in the user's folder"),
    )
}

/// One finding for all files that a base overrides, at the most consequential one.
fn replaced_by_contarget(base: &Base<'_>, replaced: &[&Override<'_>]) -> Option<Finding> {
    let file = replaced.first()?.file?;
    let names: Vec<&str> = replaced.iter().map(|each| each.name).collect();
    let (what, lost) = unreachable(base);
    let message = format!(
        "contarget replaces {} of base `{}` in the system data{what}",
        enumerated(&names),
        base.name
    );
    let finding = RULE
        .at(file, BEGINNING, message)
        .key(base.name)
        .asset(file.folder());
    let mut finding = finding.parts(&names);
    for system in replaced.iter().filter_map(|each| each.system) {
        finding = finding.related(system.path.clone(), BEGINNING, "the replaced file");
    }
    Some(finding.evidence(Evidence::of_cases(lost)))
}

/// What of the loser is no longer reachable: sliders that the winner does not have, and target
/// files.
fn unreachable(base: &Base<'_>) -> (String, Vec<String>) {
    let loser = base
        .modelling
        .system
        .accepted()
        .filter(|_| base.modelling.is_overridden());
    let keys = loser
        .map(|(_, model)| model.sliders.as_slice())
        .unwrap_or_default()
        .iter()
        .map(|slider| &slider.key);
    let mut lost: Vec<String> = keys
        .filter(|key| base.entry(key).is_none())
        .cloned()
        .collect();
    let sliders = lost.len();
    if let Some(folder) = base.other_targets.filter(|_| base.macros.is_overridden()) {
        lost.extend(
            folder
                .targets()
                .filter_map(|file| folder.name_of(file))
                .map(str::to_owned),
        );
    }
    let parts = [(sliders, "slider"), (lost.len() - sliders, "target")];
    let parts = parts
        .iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, what)| counted(*count, what));
    let parts: Vec<String> = parts.collect();
    let text = if parts.is_empty() {
        String::new()
    } else {
        format!("; no longer reachable: {}", parts.join(", "))
    };
    (text, lost)
}
