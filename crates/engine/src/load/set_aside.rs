//! What looks like assets and is none is left out, and said, unless a PATH names it.

use std::collections::{BTreeMap, BTreeSet};

use super::found::{listing, look_into};
use super::input::Input;
use super::roots::Found;
use mhlint_diag::{NotChecked, Outcome, Unchecked};
use mhlint_discover::{Aside, aside, is_asset_anywhere, is_fitting_table};
use mhlint_source::{EntryKind, folders_above};

/// Takes out the data roots in such folders; gives the files of each input that are left out.
pub(super) fn set_aside(found: &mut [Found<'_>], outcome: &mut Outcome) -> Vec<BTreeSet<String>> {
    let mut all = Vec::new();
    let mut noted: BTreeMap<Aside, BTreeSet<String>> = BTreeMap::new();
    for (input, roots) in found {
        let folders = folders(input);
        roots.retain(|path, _| !folders_above(path).any(|above| folders.contains_key(above)));
        let is_in_root = |path: &str| folders_above(path).any(|above| roots.contains_key(above));
        let mut left = BTreeSet::new();
        for entry in input
            .tree
            .entries()
            .iter()
            .filter(|entry| entry.kind == EntryKind::File)
        {
            let path = &entry.path;
            if is_in_root(path) || is_named(input, path) {
                continue;
            }
            // Of folders in one another the outer one says why.
            let around = folders_above(path).filter_map(|above| folders.get(above));
            let of_folder = around.last().copied();
            if let Some(why) = of_folder.or_else(|| is_table(input, path).then_some(Aside::Helpers))
            {
                left.insert(path.clone());
                if is_asset_anywhere(path) {
                    noted.entry(why).or_default().insert(input.tree.shown(path));
                }
            }
        }
        all.push(left);
    }
    for (why, paths) in noted {
        let what = match why {
            Aside::Helpers => Unchecked::Helpers,
            Aside::Tests => Unchecked::Tests,
        };
        outcome.not_checked.push(NotChecked::of(None, what, paths));
    }
    all
}

/// The folders to leave out. Who names one, or something in it, wants it checked.
pub(super) fn folders(input: &Input) -> BTreeMap<String, Aside> {
    let mut folders = aside(&listing(&input.tree));
    folders.retain(|folder, _| {
        let shown = input.tree.shown(folder);
        !folder.is_empty() && !input.narrow.leads_into(&shown)
    });
    folders
}

fn is_named(input: &Input, path: &str) -> bool {
    input.named.contains(&input.tree.shown(path))
}

/// Whether it is a table for fitting others. An asset that lost its header has its mesh beside it.
fn is_table(input: &Input, path: &str) -> bool {
    let Some(stem) = path.strip_suffix("mhclo") else {
        return false;
    };
    let has = |extension: &str| input.tree.entry(&format!("{stem}{extension}")).is_some();
    let is_alone = || !["obj", "mhmat", "thumb"].into_iter().any(has);
    stem.ends_with('.')
        && is_alone()
        && look_into(&input.tree, path).is_some_and(|text| is_fitting_table(&text))
}
