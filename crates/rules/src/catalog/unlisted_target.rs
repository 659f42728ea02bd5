//! Targets that MPFB brings have a slider, or a place in the macro loops.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, counted};
use super::neighbours::Neighbours;
use super::{checked, forgotten_ends, sliders};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::mpfb::{View, is_custom};
use mhlint_repo::{FileFacts, Resolution};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "shows no slider for it")],
    docs: include_str!("unlisted_target.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "catalog-unlisted-target",
        Level::Warning,
        "a target that no slider uses",
    )
});

const NO_NAME: Case = &[(
    Mpfb,
    Level::Warning,
    "has no value of the setting at which it applies them",
)];
const BY_NAME: Case = &[(
    Mpfb,
    Level::Info,
    "shows no slider for them; saved characters find them by name",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    // A section that another one of its key takes away is told as such.
    if !catalog.file.json.duplicates.is_empty() {
        return;
    }
    // Their slider is there, and lacks the slots.
    let forgotten: BTreeSet<String> = sliders(&catalog)
        .filter_map(|(section, category)| {
            Some((section, forgotten_ends(&catalog, section, category)?))
        })
        .flat_map(|(section, ends)| {
            ends.map(|end| format!("{}/{end}.target.gz", catalog.folder(&section.name)))
        })
        .collect();
    // What its slider lists is missing in a slot.
    let listed: BTreeSet<String> = sliders(&catalog)
        .flat_map(|(section, category)| {
            category
                .targets
                .iter()
                .map(move |(_, name)| (section, name))
        })
        .map(|(section, name)| format!("{}/{name}.target", catalog.folder(&section.name)))
        .collect();
    // Without the macro settings nobody knows which names are composed of them.
    let lacks_parts = view
        .parts
        .as_ref()
        .is_none_or(|parts| !parts.settings.is_whole());
    let may_be_of_macros = |file: &FileFacts| {
        lacks_parts
            && (file.rel.starts_with("targets/macrodetails/")
                || file.rel.starts_with("targets/breast/"))
    };
    let neighbours = Neighbours::of(view, &catalog);
    let missing = view.references.iter().filter(|one| one.kind.is_target());
    let missing = missing.filter(|one| matches!(one.resolution, Resolution::Missing));
    let meant: BTreeSet<String> = missing.filter_map(|one| neighbours.meant(one)).collect();
    let is_free = |file: &&FileFacts| {
        let is_target = file.rel.ends_with(".target.gz") || file.rel.ends_with(".target");
        is_target
            && !is_custom(&file.rel)
            && view.references.to_file(file).next().is_none()
            && !view.asks_for(file)
            && !may_be_of_macros(file)
            && !view
                .parts
                .as_ref()
                .is_some_and(|parts| parts.may_be_meant(&file.rel))
            && !forgotten.contains(&file.rel)
            && !meant.contains(&file.rel)
            && !listed.contains(file.rel.trim_end_matches(".gz"))
    };
    let word = |file: &'_ FileFacts| {
        view.parts
            .as_ref()?
            .unknown_word(&file.rel)
            .map(|(place, word)| (place, word.to_owned()))
    };
    let mut by_word = grouped(
        catalog
            .layer
            .below("targets")
            .filter(is_free)
            .map(|file| (word(file), file)),
    );
    let others = by_word.remove(&None).unwrap_or_default();
    out.extend(
        by_word
            .iter()
            .filter_map(|(word, files)| without_name(view, word.as_ref()?, files)),
    );
    let sections = catalog.sliders.sections.iter().rev();
    let sections: BTreeMap<String, _> = sections
        .map(|section| (catalog.folder(&section.name), section))
        .collect();
    for (folder, files) in grouped(others.into_iter().map(|file| (parent(&file.rel), file))) {
        let Some(first) = files.first() else { continue };
        let section = sections.get(folder);
        // Whether a slider that cannot be read has them is not known.
        if section.is_some_and(|section| !section.is_whole) {
            continue;
        }
        let is_section = section.is_some();
        let count = counted(files.len(), "target");
        let message = format!(
            "{count} in `{folder}` {} no slider, first `{}`",
            has(files.len()),
            first.file_name()
        );
        let finding = RULE.in_layer(catalog.layer, folder, message).key(folder);
        let finding = finding.parts_in(files.iter().map(|file| (file.file_name(), &file.path)));
        let finding = finding.evidence(Evidence::of_cases(
            files.iter().map(|file| file.file_name()),
        ));
        let help = "add sliders for them to `target.json`, or remove them";
        out.push(if is_section {
            finding.help(help)
        } else {
            finding.case(BY_NAME)
        });
    }
}

/// Targets of the macro system whose names hold a word that `macro.json` does not have for a
/// setting.
fn without_name(
    view: &View<'_>,
    (place, word): &(usize, String),
    files: &[&FileFacts],
) -> Option<Finding> {
    let parts = view.parts.as_ref()?;
    let setting = parts
        .settings
        .settings
        .iter()
        .find(|setting| setting.place == *place)?;
    let message = format!(
        "no part of `{}` has the name `{word}`, which {} for",
        setting.name(),
        targets_are(files.len())
    );
    let place = Place::pointer(["macrotargets", setting.name(), "parts"]);
    let finding = RULE
        .at(parts.file, place, message)
        .key(format!("{} {word}", setting.name()))
        .case(NO_NAME);
    let finding = finding.parts_in(files.iter().map(|file| (file.file_name(), &file.path)));
    let finding = finding.evidence(Evidence::of_cases(
        files.iter().map(|file| file.file_name()),
    ));
    Some(finding.help(format!(
        "write `{word}` as `low` or `high` of the part that they are made for"
    )))
}

fn targets_are(count: usize) -> String {
    if count == 1 {
        "a target is".to_owned()
    } else {
        format!("{count} targets are")
    }
}

const fn has(count: usize) -> &'static str {
    if count == 1 { "has" } else { "have" }
}
