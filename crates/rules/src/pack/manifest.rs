//! The list of a pack of MPFB names assets that exist; that in a zip names all of them.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::{Kind, Layout, extension};
use mhlint_formats::pack_metadata::PackMetadata;
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "finds no asset for it: the filter and the randomizer pass over the entry",
    )],
    docs: include_str!("manifest.md").trim_ascii_end(),
    counts: "entries",
    ..RuleInfo::new(
        "pack-manifest",
        Level::Warning,
        "the list of a pack names an asset that does not exist, or misses one",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let lists: Vec<&FileFacts> = view.own(Kind::PackMetadata).collect();
    if lists.is_empty() {
        return;
    }
    let layers = view.layers.strongest_first().chain(view.layers.beside);
    let assets: BTreeSet<&str> = layers
        .flat_map(|layer| layer.files.values())
        .filter_map(asset)
        .collect();
    for file in &lists {
        let Some(pack) = file.pack_metadata() else {
            continue;
        };
        let missing: Vec<&NamedAt> = pack
            .assets
            .iter()
            .filter(|one| !assets.contains(&*one.name))
            .collect();
        // Of a list alone, without any of its assets, nothing can be said.
        let Some(first) = missing
            .first()
            .filter(|_| missing.len() < pack.assets.len())
        else {
            continue;
        };
        let message = format!(
            "no asset is named `{}`{}",
            first.name,
            such(missing.len(), "entries")
        );
        let near = cx.suggestions.nearest(&first.name, assets.iter().copied());
        let finding = RULE
            .at(file, Place::Key(first.pointer.clone()), message)
            .key("assets");
        let finding = finding.evidence(Evidence::of_cases(
            missing.iter().map(|one| one.name.as_str()),
        ));
        out.push(finding.help(did_you_mean(near, "correct the name, or remove the entry")));
    }
    out.extend(unlisted(view, &lists));
}

const HIDDEN: Case = &[(
    Mpfb,
    Level::Warning,
    "hides it when the pack is chosen in the filter of the library",
)];

/// What can be worn in a zip and is in none of its lists. In the folder of a user there are assets
/// of no pack.
fn unlisted(view: &View<'_>, lists: &[&FileFacts]) -> Option<Finding> {
    let layer = view.layers.checked;
    layer.pack.as_ref()?;
    // What cannot be read may name anything.
    let read: Vec<&PackMetadata> = lists
        .iter()
        .map(|file| file.pack_metadata())
        .collect::<Option<_>>()?;
    let named: BTreeSet<&str> = read
        .iter()
        .flat_map(|pack| &pack.assets)
        .map(|one| &*one.name)
        .collect();
    let is_listed = |file: &FileFacts| {
        file.rel
            .split_once('/')
            .is_some_and(|(top, _)| Layout::of(Mpfb).has_at_top(top))
    };
    let worn = view
        .worn()
        .iter()
        .map(|worn| worn.file)
        .filter(|file| view.layers.is_checked(file) && is_listed(file));
    let (known, unlisted): (Vec<&FileFacts>, Vec<&FileFacts>) =
        worn.partition(|file| named.contains(file.stem()));
    // A list of other things does not mean these.
    let first = unlisted.first().filter(|_| !known.is_empty())?;
    let message = format!(
        "`{}` is in no list of the pack{}",
        first.stem(),
        such(unlisted.len(), "assets")
    );
    let finding = RULE
        .at(first, Place::File, message)
        .key("unlisted")
        .case(HIDDEN);
    let finding = finding.evidence(Evidence::of_cases(unlisted.iter().map(|file| file.stem())));
    Some(finding.help("add its name, without the suffix, to `packs/<pack>.json`"))
}

/// The name of an asset, as lists of packs have it.
fn asset(file: &FileFacts) -> Option<&str> {
    const SUFFIXES: [&str; 6] = ["mhclo", "proxy", "mhmat", "bvh", "json", "target"];
    let name = file
        .file_name()
        .strip_suffix(".gz")
        .unwrap_or(file.file_name());
    let is_asset = SUFFIXES.contains(&extension(name)) && !file.rel.starts_with("packs/");
    name.rsplit_once('.')
        .filter(|_| is_asset)
        .map(|(stem, _)| stem)
}
