//! Backslashes between folders work on Windows only.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::named::{causes, written};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Change, Finding, Fix, FixKind, Level, Place, RuleInfo,
};
use mhlint_repo::{Reference, ReferenceKind, Resolution, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    fix: FixKind::Safe,
    breaks: &[
        (
            Makehuman2,
            "finds the file only on Windows, and never in compressedtargets.npz",
        ),
        (Makehuman1, "finds the file only on Windows"),
    ],
    docs: include_str!("backslash_path.md").trim_ascii_end(),
    counts: "references",
    ..RuleInfo::new(
        "file-backslash-path",
        Level::Warning,
        "a backslash in the path of a file",
    )
});

const IN_ASSET: Case = &[(Makehuman1, Level::Info, "finds the file all the same")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let key = |exists: bool| if exists { "found" } else { "missing" };
    for cause in causes(view, |reference| match reference.resolution {
        Resolution::Backslash(file) => Some(key(file.is_some()).to_owned()),
        _ => None,
    }) {
        let exists = cause.key.starts_with(key(true));
        // A picture may be found with `/` where no system looks for it with a backslash.
        let has_backslash = cause
            .references
            .first()
            .is_some_and(|first| first.rel.contains('\\'));
        let finding = cause.finding(&RULE, |text| {
            let also = match (exists, has_backslash) {
                (false, _) => " and does not exist with `/` either",
                (true, true) => ", which fail on Linux and macOS",
                (true, false) => "",
            };
            format!("`{text}` uses backslashes{also}")
        });
        let Some(finding) = finding else { continue };
        let slashed = cause.text().replace('\\', "/");
        let is_fixable = |reference: &Reference<'_>| {
            exists && reference.text.contains('\\') && !view.is_known_by(reference)
        };
        let mut fix = Fix::new(RULE.info.fix, "replace `\\` with `/`");
        // Where nobody finds the file, its name has to be found out first.
        for reference in cause
            .references
            .iter()
            .filter(|reference| is_fixable(reference))
        {
            let text = Some(reference.text.replace('\\', "/"));
            fix = written(fix, reference, text);
        }
        // A folder that is at fault is written once for all that is looked for in it.
        let mut folders = BTreeMap::new();
        for reference in cause.references.iter().filter(|_| exists) {
            if let Some((Place::Pointer(pointer), folder)) = &reference.folder_at_fault {
                folders.insert((&reference.from.path, pointer), folder.replace('\\', "/"));
            }
        }
        for ((path, pointer), text) in folders {
            fix = fix.step(
                path,
                Change::Value {
                    pointer: pointer.clone(),
                    text: Some(text),
                },
            );
        }
        // It splits the name of a file beside an asset at both
        // (`docs/loaders/makehuman1/folders.md#search-for-named-files`).
        let is_of_asset = |one: &&Reference<'_>| {
            matches!(
                one.kind,
                ReferenceKind::AssetMesh
                    | ReferenceKind::AssetMaterial
                    | ReferenceKind::AssetWeights
            )
        };
        let in_asset = exists && cause.references.iter().all(is_of_asset);
        let systems = if exists && has_backslash {
            "on Linux and macOS"
        } else {
            ""
        };
        let help = if exists {
            format!("write `{}`", slashed.trim_start_matches("./"))
        } else {
            format!("correct the name: `{slashed}` does not exist; write `/` between folders")
        };
        let finding = cause.unfound(view, finding.fix(fix), systems).help(help);
        out.push(if in_asset {
            finding.case(IN_ASSET)
        } else {
            finding
        });
    }
}
