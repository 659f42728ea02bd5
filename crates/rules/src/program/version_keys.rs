//! Keys of `makehuman2_version.json` that are taken without being asked for, each where something
//! else is opened (`docs/loaders/makehuman2/program.md#version-and-settings`). Those without which
//! nothing starts are told by the schema.

use super::super::{Rule, RuleCx, either, enumerated};
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place};
use mhlint_formats::program::Version;
use mhlint_repo::FileFacts;

const NO_PANEL: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `KeyError` when the download panel is opened",
)];
const NO_DOWNLOAD: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `KeyError` when an asset pack is chosen",
)];
const NO_VERSION: Case = &[(
    Makehuman2,
    Level::Warning,
    "ends `makehuman.py --version` with `KeyError`; nothing else needs the key",
)];

const TAKEN: [(&[&str], Case); 3] = [
    (
        &["url_assetlist", "url_assetpacklist", "url_assetpacks"],
        NO_PANEL,
    ),
    (&["url_fileserver"], NO_DOWNLOAD),
    (&["url_mhcommunity"], NO_VERSION),
];

/// Findings on keys that are missing.
pub(super) fn missing<'f>(
    rule: &'f Rule,
    file: &'f FileFacts,
    version: &'f Version,
    cx: &'f RuleCx<'_>,
) -> impl Iterator<Item = Finding> + use<'f> {
    let has = |key: &str| version.keys.iter().any(|known| known == key);
    // A file without it is of 2024, when there were other keys.
    let is_current = has("suffix");
    TAKEN
        .iter()
        .filter(move |_| is_current)
        .filter_map(move |(keys, case)| {
            let missing: Vec<&str> = keys.iter().copied().filter(|key| !has(key)).collect();
            let first = missing.first()?;
            let others: Vec<String> = missing
                .iter()
                .skip(1)
                .map(|key| format!("`{key}`"))
                .collect();
            let help = match (
                cx.suggestions.nearest(first, unknown(version)),
                others.is_empty(),
            ) {
                (None, true) => "add it with its address".to_owned(),
                (None, false) => "add them with their addresses".to_owned(),
                (Some(near), true) => format!("did you mean `{first}` instead of `{near}`?"),
                (Some(near), false) => {
                    format!(
                        "write `{first}` in place of `{near}`, and add {} with its address",
                        enumerated(&others)
                    )
                }
            };
            let names: Vec<String> = missing.iter().map(|key| format!("`{key}`")).collect();
            let finding = rule
                .at(
                    file,
                    Place::File,
                    format!("the file has no {}", either(&names)),
                )
                .key(*first);
            let finding = finding.help(help).case(case);
            Some(
                finding
                    .parts(missing.iter().copied())
                    .evidence(Evidence::of_cases(missing)),
            )
        })
}

/// Keys that nothing of the program takes, nor a menu of the file.
fn unknown(version: &Version) -> impl Iterator<Item = &str> {
    let is_taken = |key: &str| TAKEN.iter().any(|(keys, _)| keys.contains(&key));
    let is_in_menu = |key: &str| version.support.iter().any(|(_, target)| target == key);
    let keys = version.keys.iter().map(String::as_str);
    keys.filter(move |key| key.starts_with("url_") && !is_taken(key) && !is_in_menu(key))
}
