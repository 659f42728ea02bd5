//! Files of a pack that importing puts where what names them does not find them.

use std::collections::BTreeSet;

use super::super::{Rule, and_more, counted};
use super::lost::is_below_base;
use super::{Packed, misread, top};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, grouped};
use mhlint_repo::makehuman2::View;
use mhlint_repo::{Reference, Resolution};
use mhlint_source::{depth, parent};

pub(super) fn report(rule: &Rule, pack: &Packed<'_>, view: &View<'_>, out: &mut Vec<Finding>) {
    out.extend(below_base(rule, pack));
    out.extend(unfound(rule, pack, view));
    out.extend(
        pack.import
            .overwritten
            .iter()
            .map(|(place, paths)| overwritten(rule, pack, place, paths)),
    );
}

/// The layout of a data folder: importing adds the folder of the base mesh once more.
fn below_base(rule: &Rule, pack: &Packed<'_>) -> Option<Finding> {
    let paths: Vec<&str> = pack
        .imported()
        .map(|(path, _)| path)
        .filter(|path| is_below_base(pack, path))
        .collect();
    let folders: BTreeSet<String> = paths.iter().map(|path| top(path, 2)).collect();
    let first = folders.first()?;
    let (_, base) = first.split_once('/')?;
    let place = paths
        .first()
        .and_then(|path| pack.import.places.get(*path)?.as_deref())?;
    let more = and_more(folders.len(), "folder");
    let message =
        format!("`{first}` is the folder of a base mesh, which importing adds itself{more}");
    let effect = format!("splits the assets up: puts files into `{}`", parent(place));
    let finding = pack
        .at(rule, "", message)
        .key("base")
        .effect_in(Makehuman2, effect);
    let help = format!(
        "leave out the folders `{base}`: `{}/<asset>/`",
        top(first, 1)
    );
    Some(finding.help(help).evidence(Evidence::of_cases(folders)))
}

/// Names that lead to a file of the pack, and to nothing once it is imported: one finding for each
/// folder.
fn unfound(rule: &Rule, pack: &Packed<'_>, view: &View<'_>) -> Vec<Finding> {
    let moved = view
        .references
        .iter()
        .filter(|one| matches!(one.resolution, Resolution::Moved));
    let by_cause = grouped(moved.filter_map(|one| Some((cause(pack, one)?, one))));
    by_cause
        .into_iter()
        .filter_map(|(cause, references)| of_unfound(rule, pack, &cause, &references))
        .collect()
}

/// Why a file is not found where it is named.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Cause {
    /// The folder is ignored.
    Ignored(String),
    /// The folder gets another name, or all of its files another folder.
    Renamed(String),
    /// The names of files get other letters.
    Misread,
}

fn cause(pack: &Packed<'_>, one: &Reference<'_>) -> Option<Cause> {
    let from = pack.path(one.from);
    let path = pack.import.meant(from, one.text)?;
    if is_below_base(pack, path) || is_below_base(pack, from) {
        return None;
    }
    Some(match pack.import.places.get(path)? {
        _ if [path, from]
            .iter()
            .any(|path| pack.pack.names.misread.contains_key(*path)) =>
        {
            Cause::Misread
        }
        None => Cause::Ignored(top(path, 1)),
        Some(_) if depth(path) > 3 => Cause::Renamed(top(path, 3)),
        // The material is what has moved.
        Some(_) => Cause::Renamed(top(from, 3)),
    })
}

fn of_unfound(
    rule: &Rule,
    pack: &Packed<'_>,
    cause: &Cause,
    references: &[&Reference<'_>],
) -> Option<Finding> {
    let first = references.first()?;
    let named = format!("`{}` names `{}`", first.from.file_name(), first.text);
    let more = and_more(references.len(), "name");
    let (message, key, help) = match cause {
        Cause::Ignored(folder) => (
            format!("`{folder}` is not imported, but {named}{more}"),
            format!("unfound {folder}"),
            "put the files into the folder of the asset that names them",
        ),
        Cause::Renamed(folder) => (
            format!("importing renames the folder `{folder}`, but {named}{more}"),
            format!("renamed {folder}"),
            "put the files beside the file that names them, or in a folder called `materials`, \
                and correct the names",
        ),
        Cause::Misread => {
            let letters = &pack.pack.names.misread;
            let meant = |one: &Reference<'_>| {
                letters.get_key_value(pack.import.meant(pack.path(one.from), one.text)?)
            };
            return misread::finding(rule, references, meant);
        }
    };
    let finding = rule
        .at(first.from, first.place.clone(), message)
        .key(key)
        .help(help);
    Some(misread::told(finding, references))
}

fn overwritten(rule: &Rule, pack: &Packed<'_>, place: &str, paths: &BTreeSet<String>) -> Finding {
    let first = paths.first().map_or("", String::as_str);
    let message = format!(
        "{} become one file, `{place}`",
        counted(paths.len(), "different file")
    );
    let finding = pack
        .at(rule, first, message)
        .key(format!("overwritten {place}"));
    let finding = finding.effect_in(
        Makehuman2,
        "keeps the one that it copies last; the others are lost",
    );
    finding
        .help("give each of them a name of its own")
        .evidence(Evidence::of_cases(paths.iter()))
}
