//! An asset lies in the folder of its kind.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::outdated::is_outdated;
use super::super::cause::unfiled::{CATEGORIES, is_of_no_base};
use super::super::{Check, Rule, RuleCx};
use super::{makehuman1, makehuman2, mpfb, of_folder, shelves, suffix};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_discover::{extension, in_place_of};
use mhlint_repo::makehuman2::View;
use mhlint_repo::{FileFacts, Layer};

pub(crate) static RULE: Rule = Check::LibrariesOfAll(
    run,
    |view, _, out| {
        makehuman1::misplaced(&RULE, view, out);
        makehuman1::unread(&RULE, view, out);
        makehuman1::beside_libraries(&RULE, view, out);
        makehuman1::languages(&RULE, view, out);
        makehuman1::targets(&RULE, view, out);
    },
    |view, _, out| {
        mpfb::misplaced(&RULE, view, out);
        shelves::of_other_kind(&RULE, view, out);
    },
)
.rule(RuleInfo {
    breaks: &[
        (Makehuman2, "does not list it"),
        (Makehuman1, "does not list it"),
        (Mpfb, "does not find it"),
    ],
    docs: include_str!("wrong_folder.md").trim_ascii_end(),
    of_library: true,
    ..RuleInfo::new(
        "library-wrong-folder",
        Level::Error,
        "an asset in a folder where its kind is not looked for",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let bases: BTreeSet<&str> = view.bases.iter().map(|base| base.name).collect();
    let layer = view.layers.checked;
    let is_no_base = |file: &FileFacts| is_of_no_base(view.layers, &bases, file);
    let mut unknown: BTreeMap<&str, Vec<&FileFacts>> = BTreeMap::new();
    let mut of_other_kind: BTreeMap<(&str, &'static str), Vec<&FileFacts>> = BTreeMap::new();
    for file in layer
        .files
        .values()
        .filter(|file| !file.is_loose && !is_outdated(file))
    {
        match *file.rel.split('/').collect::<Vec<_>>() {
            [category, FILTER] if CATEGORIES.contains(&category) => {
                out.push(filter(file, category, &bases));
            }
            ["skins", name] if extension(name) == "mhmat" => {
                out.push(without_base(file, "skins", name, &bases));
            }
            ["skins", folder, name] if extension(name) == "mhmat" && is_no_base(file) => {
                out.push(without_base(
                    file,
                    "skins",
                    &format!("{folder}/{name}"),
                    &bases,
                ));
            }
            _ => {}
        }
        let Some(suffix) = suffix(&file.rel).filter(|suffix| extension(&file.rel) == *suffix)
        else {
            continue;
        };
        let parts: Vec<&str> = file.rel.split('/').collect();
        let Some(category) = parts.first().filter(|first| CATEGORIES.contains(first)) else {
            // The name of any other folder is its owner's business, unless it is nearly one of
            // these.
            unknown
                .entry(parts.first().copied().unwrap_or_default())
                .or_default()
                .push(file);
            continue;
        };
        let right = in_place_of(suffix);
        match parts.as_slice() {
            _ if !right.contains(category) => of_other_kind
                .entry((category, suffix))
                .or_default()
                .push(file),
            [_, name] => out.push(without_base(file, category, name, &bases)),
            [_, folder, name] if is_no_base(file) => {
                out.push(without_base(
                    file,
                    category,
                    &format!("{folder}/{name}"),
                    &bases,
                ));
            }
            _ => {}
        }
    }
    out.extend(
        of_other_kind
            .iter()
            .filter_map(|((category, suffix), files)| misplaced(layer, files, suffix, category)),
    );
    makehuman2::in_folders_of_others(&RULE, view, out);
    if unknown.is_empty() {
        return;
    }
    let listed = makehuman2::Listed::of(view);
    out.extend(unknown.into_iter().filter_map(|(folder, files)| {
        makehuman2::unread(&RULE, view, &listed, folder, &files, &bases)
    }));
}

const FILTER: &str = "selection_filter.json";

/// Labels beside the folders of the base meshes instead of in one.
fn filter(file: &FileFacts, category: &str, bases: &BTreeSet<&str>) -> Finding {
    let finding = without_base(file, category, FILTER, bases).level(Level::Warning);
    finding.effect("never reads it: the list has no filters")
}

fn misplaced(layer: &Layer, files: &[&FileFacts], suffix: &str, category: &str) -> Option<Finding> {
    let first = files.first()?;
    let shown: Vec<String> = in_place_of(suffix)
        .iter()
        .map(|folder| format!("`{folder}`"))
        .collect();
    let shown = match shown.as_slice() {
        [first, second, _, ..] => format!("{first}, {second} or another folder of its kind"),
        _ => shown.join(" or "),
    };
    let message = format!("a `.{suffix}` in `{category}` is not listed, expected in {shown}");
    let help = match suffix {
        "mhclo" if category == "proxy" => {
            "move it to the folder of its kind if it is worn over the skin; rename it to end in \
                `.proxy` if it replaces it"
                .to_owned()
        }
        "proxy" => "move it to `proxy` if it replaces the skin; rename it to end in `.mhclo` if \
            it is worn over it"
            .to_owned(),
        _ => format!("move it to {shown}"),
    };
    let finding = RULE.at(first, Place::File, message).key("kind").help(help);
    let message = format!(
        "{} `.{suffix}` in `{category}` are not listed, expected in {shown}",
        files.len()
    );
    Some(of_folder(layer, category, files, finding, message))
}

fn without_base(file: &FileFacts, category: &str, below: &str, bases: &BTreeSet<&str>) -> Finding {
    let base = bases
        .first()
        .filter(|_| bases.len() == 1)
        .copied()
        .unwrap_or("<base>");
    let message = format!("`{}` is not in the folder of a base mesh", file.rel);
    let finding = RULE.at(file, Place::File, message).key("base");
    let help = match below.split_once('/') {
        Some((folder, _)) => format!("move the folder `{folder}` to `{category}/{base}`"),
        None => format!("move it to `{category}/{base}`, with the files that it names"),
    };
    finding.help(help)
}
