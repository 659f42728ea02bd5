//! Listed assets have pictures.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::outdated::is_outdated;
use super::super::{Check, Rule, RuleCx, counted};
use super::{is_exported, makehuman1, shelves, unpictured};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_discover::{extension, listed_in};
use mhlint_repo::makehuman2::{Asset, View};
use mhlint_repo::{FileFacts, Resolution};
use mhlint_source::{file_name, parent, without_extension};

pub(crate) static RULE: Rule = Check::LibrariesOfAll(run, of_makehuman1, |view, _, out| {
    shelves::without_pictures(&RULE, view, out);
})
.rule(RuleInfo {
    breaks: &[
        (Makehuman2, "shows the default picture in the list"),
        (Makehuman1, "shows the default picture in the list"),
        (Mpfb, "shows the default picture in the list"),
    ],
    docs: include_str!("missing_thumbnail.md").trim_ascii_end(),
    ..RuleInfo::new(
        "library-missing-thumbnail",
        Level::Info,
        "an asset without a picture for the list",
    )
});

const MISNAMED: Case = &[(
    Makehuman2,
    Level::Warning,
    "does not find the picture and shows a general one in the list",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let own = view
        .library
        .bases()
        .into_iter()
        .flat_map(|base| view.library.of_base(base));
    let own: Vec<&Asset<'_>> = own
        .filter(|asset| view.layers.is_checked(asset.file))
        .collect();
    // The picture of an asset that cannot be read belongs to that.
    let listed = layer
        .files
        .values()
        .filter(|file| listed_in(&file.rel).is_some());
    let stems: BTreeSet<&str> = listed.map(|file| without_extension(&file.rel)).collect();
    let clashes = view
        .library
        .bases()
        .into_iter()
        .flat_map(|base| view.library.clashes(base));
    let copies: BTreeSet<&str> = clashes
        .flatten()
        .map(|asset| asset.file.path.as_str())
        .collect();
    let bare = own.iter().filter(|asset| {
        let rel = format!("{}.thumb", without_extension(&asset.file.rel));
        // Of copies that are known by the same one has a picture.
        let is_read = asset.file.encoding.invalid_utf8_at.is_none()
            && !asset.file.file_name().starts_with('.');
        // One that something names in other capitals has got the wrong name, not its picture.
        let is_renamed = view
            .references
            .to_file(asset.file)
            .any(|one| matches!(one.resolution, Resolution::CaseOnly(_)));
        is_read
            && !is_outdated(asset.file)
            && layer.file(&rel).is_none()
            && !is_renamed
            && !copies.contains(asset.file.path.as_str())
            && !is_exported(asset.file)
    });
    let strays = layer
        .files
        .values()
        .filter(|file| is_thumb(file) && !is_of_one(&file.rel, &stems, layer));
    let mut strays: BTreeMap<&str, &FileFacts> =
        strays.map(|file| (parent(&file.rel), file)).collect();
    let by_folder = grouped(bare.map(|asset| ((asset.category, asset.base), *asset)));
    for ((category, base), assets) in by_folder {
        let mut plain: Vec<&Asset<'_>> = Vec::new();
        for asset in assets {
            let rel = format!("{}.thumb", without_extension(&asset.file.rel));
            match strays.remove(parent(&asset.file.rel)) {
                _ if layer.folders.binary_search(&rel).is_ok() => out.push(folder(asset, &rel)),
                Some(picture) => out.push(misnamed(asset, picture)),
                None => plain.push(asset),
            }
        }
        out.extend(without(category, base, &plain));
    }
}

fn of_makehuman1(view: &mhlint_repo::makehuman1::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    makehuman1::without_pictures(&RULE, view, out);
}

fn is_thumb(file: &FileFacts) -> bool {
    extension(&file.rel).eq_ignore_ascii_case("thumb")
}

/// Whether a picture belongs to an asset or a material.
fn is_of_one(rel: &str, stems: &BTreeSet<&str>, layer: &mhlint_repo::Layer) -> bool {
    let is_exact = extension(rel) == "thumb";
    is_exact
        && (stems.contains(without_extension(rel))
            || layer
                .file(&format!("{}.mhmat", without_extension(rel)))
                .is_some())
}

fn misnamed(asset: &Asset<'_>, picture: &FileFacts) -> Finding {
    let right = format!("{}.thumb", asset.file.stem());
    let message = format!(
        "`{}` belongs to no asset, and `{}` has no picture",
        picture.file_name(),
        asset.file.file_name()
    );
    let finding = RULE.at(picture, Place::File, message).case(MISNAMED);
    finding
        .related(asset.file.path.clone(), Place::File, "the asset")
        .help(format!("rename it to `{right}`"))
}

/// A folder has the name of the picture.
fn folder(asset: &Asset<'_>, rel: &str) -> Finding {
    let name = file_name(rel);
    let finding = RULE
        .at(
            asset.file,
            Place::File,
            format!("`{name}` is a folder, expected a picture"),
        )
        .key("folder");
    finding
        .case(MISNAMED)
        .help("replace the folder with the picture")
}

fn without(category: &str, base: &str, assets: &[&Asset<'_>]) -> Option<Finding> {
    let first = assets.first()?;
    let message = match assets.len() {
        1 => format!("`{}` has no picture", first.file.file_name()),
        count => unpictured(
            &counted(count, first.noun()),
            &format!("{category}/{base}"),
            first.file,
            &first.name,
        ),
    };
    let finding = RULE
        .at(first.file, Place::File, message)
        .key(format!("{category} {base}"));
    let parts = assets
        .iter()
        .map(|asset| (asset.file.shown(), &asset.file.path));
    let finding = finding.parts_in(parts).evidence(Evidence::of_cases(
        assets.iter().map(|asset| asset.file.shown()),
    ));
    Some(finding.help(
        "add a PNG of at most 128 by 128 pixels, with the name of the asset and the \
        suffix `.thumb`",
    ))
}
