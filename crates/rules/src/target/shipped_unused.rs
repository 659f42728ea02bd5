//! Targets of MakeHuman 1 that no modifier moves.

use std::collections::BTreeSet;

use super::super::{Rule, RuleCx, such};
use super::macro_group::macro_groups;
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, grouped};
use mhlint_discover::Kind;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::View;

const UNUSED: Case = &[(
    Makehuman1,
    Level::Info,
    "never applies it: no modifier asks for its group",
)];

/// One finding for all in a folder of `targets`; what another rule says of a name is not told
/// again.
pub(super) fn unused(rule: &Rule, view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_found = !view.targets.is_packed
        && view.targets.clashes.is_empty()
        && view.targets.renamed_folder().is_none();
    let is_known = view.modifiers.is_whole() && is_found;
    if !view.layers.checks_system() || !is_known {
        return;
    }
    let used = &view.modifiers.uses;
    let strays: BTreeSet<&str> = macro_groups(view)
        .iter()
        .flat_map(|group| &group.strays)
        .map(|(target, _)| target.file.rel.as_str())
        .collect();
    let (meant, lacking) = (meant(view, cx), lacking(view));
    let idle = view
        .targets
        .shipped
        .iter()
        .enumerate()
        .filter(|(place, target)| {
            let group = target.name.group();
            let is_of_side = group
                .rsplit_once('-')
                .is_some_and(|(stem, _)| lacking.contains(stem));
            let is_told =
                strays.contains(target.file.rel.as_str()) || meant.contains(&group) || is_of_side;
            // What only an archive has is no file that could be kept elsewhere, and a user's has a
            // slider of its own.
            let is_users = view.layers.is_one_root() && target.file.rel.starts_with("custom/");
            let is_file = target.file.kind_in(Makehuman1) == Kind::Target;
            is_file
                && !is_users
                && !used.contains_key(place)
                && !is_told
                && !target.name.key.is_empty()
        });
    let folders = grouped(idle.map(|(_, target)| (folder(target.file), target.file)));
    for (folder, files) in folders {
        let Some(first) = files.first() else { continue };
        let message = format!(
            "no modifier moves `{}`{}",
            first.rel,
            such(files.len(), "targets")
        );
        let finding = rule
            .at(first, Place::File, message)
            .key("unused")
            .asset(view.layers.checked.display(folder));
        let finding = finding
            .parts_in(files.iter().map(|file| (file.rel.as_str(), &file.path)))
            .case(UNUSED);
        let finding = finding.evidence(Evidence::of_cases(
            files.iter().map(|file| file.rel.as_str()),
        ));
        out.push(finding.help("add modifiers for them, or keep them outside of the data"));
    }
}

/// The folder directly in `targets`, or whatever else a target lies in.
fn folder(file: &FileFacts) -> &str {
    let mut ends = file.rel.match_indices('/').map(|(end, _)| end);
    let first = ends.next().unwrap_or(0);
    let end = if file.rel.starts_with("targets/") {
        ends.next().unwrap_or(first)
    } else {
        first
    };
    file.rel.get(..end).unwrap_or_default()
}

/// The groups of modifiers that lack a side: neither of their targets is asked for.
fn lacking(view: &View<'_>) -> BTreeSet<String> {
    let unpaired = view
        .modifiers
        .all
        .iter()
        .filter(|one| one.modifier.tails.unpaired().is_some());
    unpaired
        .flat_map(|one| &one.parts)
        .map(|part| part.group.clone())
        .collect()
}

/// Groups that seem to be meant by modifiers without targets: the modifiers are told.
fn meant(view: &View<'_>, cx: &RuleCx<'_>) -> BTreeSet<String> {
    let missing = view
        .modifiers
        .all
        .iter()
        .flat_map(|one| &one.parts)
        .filter(|part| part.targets.is_empty());
    let used: BTreeSet<&str> = view
        .modifiers
        .all
        .iter()
        .flat_map(|one| &one.parts)
        .filter(|part| !part.targets.is_empty())
        .map(|part| part.group.as_str())
        .collect();
    let free: Vec<&str> = view
        .targets
        .groups()
        .filter(|group| !used.contains(group))
        .collect();
    missing
        .filter_map(|part| {
            cx.suggestions
                .nearest(&part.group, free.iter().copied())
                .map(str::to_owned)
        })
        .collect()
}
