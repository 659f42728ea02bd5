//! Packs that MPFB refuses before it unpacks anything, and what its other modes do with them
//! (`docs/loaders/mpfb/libraries.md#check-of-a-zip`).

use super::super::{Rule, counted};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Place};
use mhlint_discover::{Refusal, extension, loss};
use mhlint_repo::{FileFacts, Layer};

/// What the other modes make of a zip that the usual one rejects.
const FIX_STRIPS: &str = "rejects the zip. The mode FIX leaves out the folder; INSTALL unpacks it \
    to where no list shows it";
const FIX_STRIPS_BOTH: &str = "rejects the zip. The mode FIX leaves out the folder, and \
    `__MACOSX`; INSTALL unpacks it to where no list shows it";
const FIX_FAILS: &str =
    "rejects the zip. The mode FIX cannot repair it; INSTALL unpacks it to where no list shows it";
const ELSEWHERE: &str = "rejects the zip. The mode INSTALL unpacks it to where no list shows it";
const CAPITALS: &str = "rejects the zip. The mode FIX cannot repair it; INSTALL unpacks it, and \
    on Linux no filter knows the pack";
const NO_FILTER: &str = "rejects the zip. The mode FIX cannot repair it; INSTALL unpacks it, but \
    no filter knows the pack";
const NOT_UNPACKED: &str = "rejects the zip. The mode FIX cannot repair it; INSTALL unpacks only \
    another zip, which no list shows";
const NOTHING: &str = "rejects the zip: there is no folder `packs` in it";

/// The finding on a pack that is refused.
pub(super) fn report(rule: &Rule, layer: &Layer, refusal: &Refusal) -> Option<Finding> {
    Some(match refusal {
        // The names have a finding of their own.
        Refusal::Backslashes => return None,
        Refusal::Around(folder) | Refusal::AroundBesideFile(folder) => {
            around(rule, layer, folder, FIX_STRIPS)
        }
        Refusal::AroundBesideMacos(folder) => around(rule, layer, folder, FIX_STRIPS_BOTH),
        Refusal::AroundBesideFolder(folder) => around(rule, layer, folder, ELSEWHERE),
        Refusal::Deep(folder) => around(rule, layer, folder, FIX_FAILS),
        Refusal::Capitals(folder) => {
            let message = format!("`{folder}` must be `packs`: capitals matter");
            of_whole(
                rule,
                layer,
                message,
                CAPITALS,
                "write the name of the folder in small letters",
            )
        }
        Refusal::Empty => {
            let help = "pack the folders of assets together with `packs`";
            of_whole(
                rule,
                layer,
                "there is nothing in the zip".to_owned(),
                NOTHING,
                help,
            )
        }
        Refusal::NoLists => without_lists(rule, layer, None),
        Refusal::NoListsInFolder(folder) => without_lists(rule, layer, Some(folder)),
    })
}

/// In the words that other applications have for it: it is one fault for all of them.
fn around(rule: &Rule, layer: &Layer, folder: &str, effect: &str) -> Finding {
    let assets = layer
        .files
        .keys()
        .filter(|rel| loss(&format!("{folder}/{rel}")).is_some())
        .count();
    let count = if assets == 0 {
        String::new()
    } else {
        format!(" ({})", counted(assets, "file"))
    };
    let message = format!("folder `{folder}` is around the folders that are imported{count}");
    let finding = rule
        .in_layer(layer, "", message)
        .key(format!("ignored {folder}"))
        .effect_in(Mpfb, effect);
    finding.help(format!(
        "pack what is in `{folder}`, so that `packs` is at the top of the zip"
    ))
}

fn of_whole(rule: &Rule, layer: &Layer, message: String, effect: &str, help: &str) -> Finding {
    rule.in_layer(layer, "", message)
        .key("packs")
        .effect_in(Mpfb, effect)
        .help(help)
}

fn without_lists(rule: &Rule, layer: &Layer, around: Option<&str>) -> Finding {
    let zips: Vec<&FileFacts> = layer
        .files
        .values()
        .filter(|file| is_zip(&file.rel))
        .collect();
    if let Some(first) = zips.first() {
        return of_zips(rule, first, &zips)
            .key("packs")
            .effect_in(Mpfb, NOT_UNPACKED);
    }
    let finding = rule
        .in_layer(
            layer,
            "",
            "there is no folder `packs` at the top of the zip",
        )
        .key("packs");
    let help = "add `packs/<pack>.json`, an object whose keys are the names of the assets, beside \
        the folders of assets";
    match around {
        Some(folder) => {
            let help = format!("pack what is in `{folder}`, not the folder itself; and {help}");
            finding.effect_in(Mpfb, FIX_FAILS).help(help)
        }
        None => finding.effect_in(Mpfb, NO_FILTER).help(help),
    }
}

pub(super) fn is_zip(rel: &str) -> bool {
    extension(rel).eq_ignore_ascii_case("zip")
}

/// A finding on zips in the zip.
pub(super) fn of_zips(rule: &Rule, first: &FileFacts, zips: &[&FileFacts]) -> Finding {
    let name = first.file_name();
    let message = format!("`{name}` is a zip in the zip: importing does not unpack it");
    let finding = rule
        .at(first, Place::File, message)
        .help(format!("pack what is in `{name}` itself"));
    finding.evidence(Evidence::of_cases(
        zips.iter().map(|file| file.rel.as_str()),
    ))
}
