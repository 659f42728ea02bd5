//! The libraries of MakeHuman 1: what lies in which, and by what it is known (formats/makehuman1.md §2.1, §10.7).

use super::super::Rule;
use crate::diag::{Application::Makehuman1, Case, Finding, Level, Place, grouped};
use crate::discover::{extension, library_extension};
use crate::formats::mhclo::Entry;
use crate::repo::makehuman1::{Asset, View};

/// What is worn in a library that lists another extension.
pub(super) fn misplaced(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    for file in view.layers.checked.files.values() {
        let extension = extension(&file.rel);
        let Some(library) = file.rel.split('/').next().filter(|_| matches!(extension, "mhclo" | "proxy")) else {
            continue;
        };
        let Some(right) = library_extension(library).filter(|right| *right != extension) else { continue };
        let is_topology = extension == "proxy";
        let place = if is_topology { "`proxymeshes`" } else { "`clothes` to `tongue`" };
        let message = format!("a `.{extension}` in `{library}` is not listed, expected in {place}");
        let help = match right {
            "mhclo" | "proxy" => format!("move it to {place}, or rename it to end in `.{right}`"),
            _ => format!("move it to {place}"),
        };
        out.push(rule.at(file, Place::File, message).key("kind").help(help));
    }
}

/// Assets of one library with a name in common and different uuids.
pub(super) fn same_names(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let named = view.assets().filter_map(|asset| Some(((asset.library, &*asset.name?.value), asset)));
    for ((_, name), assets) in grouped(named) {
        let uuid = |asset: &Asset<'_>| asset.uuid.map(|entry| entry.value.to_string());
        let Some((told, others)) = told(view, &assets) else { continue };
        let Some(other) = others.iter().find(|other| uuid(other) != uuid(told)) else { continue };
        let finding = finding(rule, told, other, told.name, "name", name);
        out.push(finding.key(name).help("give it a name of its own"));
    }
}

const COPY: Case = &[(Makehuman1, Level::Warning, "lists both; while one is worn the other cannot be chosen")];
const APART: Case = &[(Makehuman1, Level::Warning, "lists it in both libraries")];

/// Assets with a uuid in common.
pub(super) fn same_uuids(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let known = view.assets().filter_map(|asset| Some((&*asset.uuid?.value, asset)));
    for (uuid, assets) in grouped(known) {
        let Some((told, others)) = told(view, &assets) else { continue };
        // A user's file in the place of one of the system is meant to replace it.
        let is_other = |other: &&&Asset<'_>| other.file.rel != told.file.rel;
        let in_library = others.iter().filter(is_other).find(|other| other.library == told.library);
        let Some(other) = in_library.or_else(|| others.iter().find(is_other)) else { continue };
        let finding = finding(rule, told, other, told.uuid, "uuid", uuid);
        let is_copy = told.file.content_hash.is_some() && told.file.content_hash == other.file.content_hash;
        let finding = finding
            .key(uuid)
            .help("give it a uuid of its own, and save models that wear it again; or remove one of the two");
        out.push(match is_copy {
            _ if other.library != told.library => finding.case(APART),
            true => finding.case(COPY),
            false => finding,
        });
    }
}

/// Of several assets one of the checked layer, and all others.
fn told<'t, 'a>(view: &View<'_>, assets: &'t [Asset<'a>]) -> Option<(&'t Asset<'a>, Vec<&'t Asset<'a>>)> {
    let told = assets.iter().filter(|asset| view.layers.is_checked(asset.file)).max_by_key(|asset| &asset.file.rel)?;
    let others: Vec<&Asset<'_>> = assets.iter().filter(|other| !std::ptr::eq(other.file, told.file)).collect();
    (!others.is_empty()).then_some((told, others))
}

/// The finding on something that two assets have in common.
fn finding(rule: &Rule, told: &Asset<'_>, other: &Asset<'_>, entry: Option<&Entry>, what: &str, text: &str) -> Finding {
    let place = entry.map_or(Place::File, |entry| Place::Span(entry.span.clone()));
    let finding = rule.at(told.file, place, format!("has the same {what} as `{}`: `{text}`", other.file.rel));
    let finding = finding.related(other.file.path.clone(), Place::File, "the other asset");
    finding.between([told.file.path.as_str(), other.file.path.as_str()])
}
