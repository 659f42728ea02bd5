//! The list of a pack of MPFB names assets that exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use crate::diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use crate::discover::{Kind, extension};
use crate::formats::unfit::NamedAt;
use crate::repo::FileFacts;
use crate::repo::mpfb::View;

pub(in crate::rules) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "finds no asset for it: the filter and the randomizer pass over the entry")],
    docs: "A key of `packs/<pack>.json` is the name of no file, without its suffix, in the data of the user or of MPFB. By \
        these names the filter of the library and the randomizer know which assets are of the pack.\n\n\
        Often an asset was renamed, or is not in the pack any more.\n\n\
        Correct the name, or remove the entry.",
    counts: "entries",
    ..RuleInfo::new("pack-manifest", Level::Warning, "the list of a pack names an asset that does not exist")
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let lists: Vec<&FileFacts> = view.own(Kind::PackMetadata).collect();
    if lists.is_empty() {
        return;
    }
    let layers = view.layers.strongest_first().chain(view.layers.beside);
    let assets: BTreeSet<&str> = layers.flat_map(|layer| layer.files.values()).filter_map(asset).collect();
    for file in lists {
        let Some(pack) = file.pack_metadata() else { continue };
        let missing: Vec<&NamedAt> = pack.assets.iter().filter(|one| !assets.contains(&*one.name)).collect();
        // Of a list alone, without any of its assets, nothing can be said.
        let Some(first) = missing.first().filter(|_| missing.len() < pack.assets.len()) else { continue };
        let message = format!("no asset is named `{}`{}", first.name, such(missing.len(), "entries"));
        let near = cx.suggestions.nearest(&first.name, assets.iter().copied());
        let finding = RULE.at(file, Place::Key(first.pointer.clone()), message).key("assets");
        let finding = finding.evidence(Evidence::of_cases(missing.iter().map(|one| one.name.as_str())));
        out.push(finding.help(did_you_mean(near, "correct the name, or remove the entry")));
    }
}

/// The name of an asset, as lists of packs have it.
fn asset(file: &FileFacts) -> Option<&str> {
    const SUFFIXES: [&str; 6] = ["mhclo", "proxy", "mhmat", "bvh", "json", "target"];
    let name = file.file_name().strip_suffix(".gz").unwrap_or(file.file_name());
    let is_asset = SUFFIXES.contains(&extension(name)) && !file.rel.starts_with("packs/");
    name.rsplit_once('.').filter(|_| is_asset).map(|(stem, _)| stem)
}
