//! Sliders and targets have names of their own.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, counted};
use super::{checked, place, sliders};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, RuleInfo, grouped};
use mhlint_formats::target_catalog::{Category, Section};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{Catalog, View, identifiers, is_custom};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "finds only one of the targets by this name, whichever folder the disk lists first",
    )],
    docs: include_str!("duplicate_target.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-duplicate-target",
        Level::Warning,
        "a name that two sliders or targets share",
    )
});

const ONE_LABEL: Case = &[(
    Mpfb,
    Level::Error,
    "shows the later slider twice and the earlier one never",
)];
const ONE_NAME: Case = &[(
    Mpfb,
    Level::Error,
    "moves both targets of the later slider by either of them",
)];
const TWO_SLOTS: Case = &[(Mpfb, Level::Warning, "moves the one target by both sliders")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    for section in &catalog.sliders.sections {
        let label = |category: &Category| category.label.iter().cloned().collect();
        let by_label = shared(&catalog, section, label, "label", ONE_LABEL);
        let by_name = shared(
            &catalog,
            section,
            |category| identifiers(section, category),
            "name",
            ONE_NAME,
        );
        // What has the same name mostly was copied with its label.
        out.extend(if by_name.is_empty() {
            by_label
        } else {
            by_name
        });
    }
    slots(&catalog, out);
    out.extend(stems(view));
}

/// Sliders of a section that have something in common.
fn shared(
    catalog: &Catalog<'_>,
    section: &Section,
    of: impl Fn(&Category) -> Vec<String>,
    what: &'static str,
    case: Case,
) -> Vec<Finding> {
    let named = section
        .categories
        .iter()
        .flat_map(|category| of(category).into_iter().map(move |name| (name, category)));
    let mut told: BTreeMap<(usize, usize), Finding> = BTreeMap::new();
    for (_, all) in grouped(named) {
        let [first, .., last] = all.as_slice() else {
            continue;
        };
        let message = format!(
            "`{}` has the {what} of an earlier slider, `{}`",
            last.name, first.name
        );
        let finding = RULE
            .at(catalog.file, place(section, Some(last), &[what]), message)
            .case(case);
        let finding = finding.key(format!("{} {what} {}", section.name, last.name));
        let finding = finding.related(
            catalog.file.path.clone(),
            place(section, Some(first), &[what]),
            "the other slider",
        );
        told.insert(
            (first.index, last.index),
            finding.help(format!("give one of them another {what}")),
        );
    }
    told.into_values().collect()
}

/// Targets in the slots of several sliders: one finding for two of these. Of those with one name
/// that is told.
fn slots(catalog: &Catalog<'_>, out: &mut Vec<Finding>) {
    let named = sliders(catalog).flat_map(|(section, category)| {
        let stems = category.slots_in_use().filter(|slot| !slot.stem.is_empty());
        stems.map(move |slot| {
            (
                (section.name.as_str(), slot.stem.as_str()),
                (section, category, slot.key),
            )
        })
    });
    let mut by_sliders: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for ((_, stem), all) in grouped(named) {
        let Some(((section, first, _), (_, last, slot))) = all.first().zip(all.last()) else {
            continue;
        };
        if !std::ptr::eq(*first, *last) && first.name != last.name {
            let sliders = (section.name.as_str(), first.index, last.index);
            by_sliders
                .entry(sliders)
                .or_default()
                .push((*section, *first, *last, *slot, stem));
        }
    }
    out.extend(by_sliders.values().filter_map(|shared| {
        let (section, one, other, slot, stem) = *shared.first()?;
        let message = match shared.len() {
            1 => format!(
                "`{stem}` is in the slots of `{}` and `{}`",
                one.name, other.name
            ),
            many => format!(
                "`{}` and `{}` have {many} targets in common, first `{stem}`",
                one.name, other.name
            ),
        };
        let finding = RULE.at(
            catalog.file,
            place(section, Some(other), &["opposites", slot]),
            message,
        );
        let finding = finding
            .key(format!("{} slot {stem}", section.name))
            .case(TWO_SLOTS);
        let related = place(section, Some(one), &["opposites"]);
        let finding = finding.related(catalog.file.path.clone(), related, "the other slider");
        let finding = finding.evidence(Evidence::of_cases(shared.iter().map(|(.., stem)| *stem)));
        Some(finding.help("name each target in one of them only"))
    }));
}

/// Targets of one name in several folders.
fn stems(view: &View<'_>) -> Option<Finding> {
    let system = view.layers.system?;
    let packed = |file: &&FileFacts| file.rel.ends_with(".target.gz") && !is_custom(&file.rel);
    let stem = |file: &FileFacts| {
        file.file_name()
            .trim_end_matches(".target.gz")
            .to_lowercase()
    };
    let by_stem = grouped(
        system
            .below("targets")
            .filter(packed)
            .map(|file| (stem(file), file)),
    );
    let several: Vec<(String, Vec<&FileFacts>)> = by_stem
        .into_iter()
        .filter(|(_, files)| files.len() > 1)
        .collect();
    let (name, files) = several.first()?;
    let (first, second) = (files.first()?, files.get(1)?);
    let message = match several.len() {
        1 => format!(
            "target `{name}` exists in `{}` and `{}`",
            parent(&first.rel),
            parent(&second.rel)
        ),
        many => format!(
            "{} exist in several folders, first `{name}` in `{}` and `{}`",
            counted(many, "target"),
            parent(&first.rel),
            parent(&second.rel)
        ),
    };
    let finding = RULE.in_layer(system, "targets", message).key("stems");
    let finding = finding.evidence(Evidence::of_cases(
        several.iter().map(|(name, _)| name.clone()),
    ));
    Some(finding.help("give each a name of its own, if saved characters are to find it"))
}
