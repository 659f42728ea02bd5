//! What MPFB makes of a pack that it takes: all of it is unpacked as it is over the data of the
//! user (`docs/loaders/mpfb/libraries.md#folders-of-a-pack`).

use super::super::{Rule, and_more};
use super::{misread, named, refused};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_discover::Layout;
use mhlint_repo::mpfb::View;
use mhlint_repo::{FileFacts, Layer, Resolution};

const NOT_LISTED: Case = &[(
    Mpfb,
    Level::Error,
    "unpacks the zip as it is: no list shows what is in it",
)];
const REPLACED: Case = &[(
    Mpfb,
    Level::Warning,
    "overwrites the files of the user without asking",
)];

/// All that is said of a zip, whether it is taken or not.
pub(super) fn report(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let Some(pack) = &layer.pack else { return };
    let refusal = pack.refusal.as_ref();
    out.extend(refusal.and_then(|refusal| refused::report(rule, layer, refusal)));
    named::report(rule, layer, pack, out);
    let is_misread = |file: &FileFacts| pack.names.misread.contains_key(&file.rel);
    let references = view
        .references
        .iter()
        .filter(|one| matches!(one.resolution, Resolution::Found(file) if is_misread(file)));
    let references: Vec<_> = references.collect();
    out.extend(misread::finding(rule, &references, |one| {
        pack.names.misread.get_key_value(&one.found()?.rel)
    }));
    if refusal.is_none() {
        out.extend(nested(rule, layer));
        out.extend(overwritten(rule, view));
    }
}

/// Zips where there should be assets. What lies in other folders is nobody's business.
fn nested(rule: &Rule, layer: &Layer) -> Option<Finding> {
    let is_asset = |file: &&FileFacts| {
        let top = file.rel.split_once('/').map_or("", |(top, _)| top);
        refused::is_zip(&file.rel) && Layout::of(Mpfb).has_at_top(top)
    };
    let zips: Vec<&FileFacts> = layer.files.values().filter(is_asset).collect();
    Some(
        refused::of_zips(rule, zips.first()?, &zips)
            .key("zips")
            .case(NOT_LISTED),
    )
}

/// Files of the user that others of the pack replace, where his folder is given, too.
fn overwritten(rule: &Rule, view: &View<'_>) -> Option<Finding> {
    let user = view.layers.beside.filter(|user| user.pack.is_none())?;
    let counterpart = |file: &FileFacts| user.file(&file.rel).filter(|other| differ(file, other));
    let files = view.layers.checked.files.values();
    let pairs: Vec<(&FileFacts, &FileFacts)> = files
        .filter_map(|file| Some((file, counterpart(file)?)))
        .collect();
    let (first, other) = pairs.first()?;
    let more = and_more(pairs.len(), "file");
    let message = format!("replaces `{}`, which is another file{more}", other.path);
    let finding = rule
        .at(first, Place::File, message)
        .key("overwritten")
        .case(REPLACED);
    let finding = finding.related(other.path.clone(), Place::File, "the file that is lost");
    let finding = finding.evidence(Evidence::of_cases(
        pairs.iter().map(|(file, _)| file.rel.as_str()),
    ));
    Some(finding.help(
        "keep a copy, or give what is in the pack a folder of its own, unless it is a \
                new version of that",
    ))
}

/// Whether two files are not the same, as far as that is known.
fn differ(file: &FileFacts, other: &FileFacts) -> bool {
    let are_known = file.content_hash.is_some() && other.content_hash.is_some();
    file.size != other.size || are_known && file.content_hash != other.content_hash
}
