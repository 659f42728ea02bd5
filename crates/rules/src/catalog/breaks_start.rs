//! Names that Blender refuses keep the add-on from starting.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::{checked, place, twin_pictures};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::extension;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{
    LONGEST, LONGEST_SECTION, LONGEST_SECTION_WITH_SLIDERS, UserTarget, View, identifiers,
};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails while the add-on is imported: MPFB cannot be enabled",
    )],
    docs: include_str!("breaks_start.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-breaks-start",
        Level::Error,
        "a name that keeps the add-on from starting",
    )
});

/// Letters of the path of an expression, below its folder.
const LONGEST_EXPRESSION: usize = 58;

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    sections(view, out);
    let mut folders: BTreeMap<String, Vec<UserTarget<'_>>> = BTreeMap::new();
    for target in view.user_targets() {
        if refusal(&target.section, LONGEST_SECTION).is_some() {
            folders
                .entry(parent(&target.file.rel).to_owned())
                .or_default()
                .push(target);
        } else if target.identifier().chars().count() > LONGEST {
            out.push(too_long(&target));
        }
    }
    out.extend(
        folders
            .iter()
            .filter_map(|(folder, targets)| of_folder(view, folder, targets)),
    );
    twin_pictures::findings(&RULE, view, out);
    let files = view
        .layers
        .checked
        .below("expressions")
        .filter(|file| extension(&file.rel) == "json");
    let is_long =
        |file: &&FileFacts| file.rel.chars().count() > LONGEST_EXPRESSION + "expressions/".len();
    out.extend(files.filter(is_long).map(|file| {
        let length = file.rel.chars().count() - "expressions/".len();
        let message = format!(
            "the path below `expressions` has {length} letters, at most {LONGEST_EXPRESSION} fit"
        );
        RULE.at(file, Place::File, message)
            .key("length")
            .help("shorten the name of the file or of its folders")
    }));
}

/// Why Blender takes no panel of this name.
fn refusal(section: &str, longest: usize) -> Option<String> {
    let length = section.chars().count();
    let first = section.chars().next();
    if first.is_none_or(|first| !first.is_ascii_alphanumeric()) {
        let first = first.map_or_else(String::new, |first| first.to_string());
        return Some(format!(
            "begins with `{first}`, expected a letter from a to z or a digit"
        ));
    }
    (length > longest).then(|| format!("has {length} letters, at most {longest} fit"))
}

/// The names in the catalogue.
fn sections(view: &View<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    for section in &catalog.sliders.sections {
        let longest = if section.categories.is_empty() {
            LONGEST_SECTION
        } else {
            LONGEST_SECTION_WITH_SLIDERS
        };
        if let Some(why) = refusal(&section.name, longest) {
            let message = format!("section `{}` {why}", section.name);
            let finding = RULE
                .at(catalog.file, place(section, None, &[]), message)
                .key(&section.name);
            out.push(finding.help("rename the section and its folder"));
            continue;
        }
        for category in &section.categories {
            let longest = identifiers(section, category)
                .into_iter()
                .map(|name| name.chars().count())
                .max();
            if let Some(length) = longest.filter(|length| *length > LONGEST) {
                let message = format!(
                    "`{}` has {length} letters together with its section, at most {LONGEST} fit",
                    category.name
                );
                let finding = RULE.at(
                    catalog.file,
                    place(section, Some(category), &["name"]),
                    message,
                );
                out.push(
                    finding
                        .key(format!("{} {}", section.name, category.name))
                        .help("shorten the name"),
                );
            }
        }
    }
}

fn too_long(target: &UserTarget<'_>) -> Finding {
    let fits = LONGEST.saturating_sub(target.section.chars().count() + 1);
    let length = target.name.chars().count();
    let message = format!(
        "the name has {length} letters, at most {fits} fit for a target in `{}`",
        target.section
    );
    RULE.at(target.file, Place::File, message)
        .key("length")
        .help("shorten the name of the file")
}

fn of_folder(view: &View<'_>, folder: &str, targets: &[UserTarget<'_>]) -> Option<Finding> {
    let first = targets.first()?;
    let why = refusal(&first.section, LONGEST_SECTION)?;
    let message = format!(
        "folder `{}` with targets {why}",
        view.layers.checked.shown(folder)
    );
    let finding = RULE
        .at(first.file, Place::File, message)
        .key(format!("folder {folder}"));
    let finding = finding.parts_in(targets.iter().map(|one| (one.file.shown(), &one.file.path)));
    let finding = finding.evidence(Evidence::of_cases(
        targets.iter().map(|one| one.file.shown()),
    ));
    Some(finding.help("rename the folder, or remove it if it was left by another program"))
}
