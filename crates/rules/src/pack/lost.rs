//! Files of a pack that importing ignores, or puts where no list shows them.

use super::super::{Rule, counted};
use super::{Packed, top};
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, grouped};
use mhlint_discover::{
    Loss, extension, import, in_place_of, listed_in, loss, meant_for, top_folder,
};
use mhlint_source::{file_name, first_name, parent};

const PICTURES: Case = &[(Makehuman2, Level::Warning, "ignores the pictures on import")];
const UNLISTED: Case = &[(
    Makehuman2,
    Level::Error,
    "imports it to where it is not listed",
)];

pub(super) fn report(rule: &Rule, pack: &Packed<'_>, out: &mut Vec<Finding>) {
    let ignored = pack
        .import
        .places
        .iter()
        .filter(|(path, place)| place.is_none() && loss(path).is_some());
    let by_top = grouped(ignored.map(|(path, _)| (top_folder(path), path.as_str())));
    // What macOS adds to a zip is for macOS alone.
    let by_top = by_top.into_iter().filter(|(top, _)| *top != "__MACOSX");
    out.extend(by_top.map(|(top, paths)| ignored_folder(rule, pack, top, &paths)));
    let unlisted = pack
        .imported()
        .filter(|(path, _)| !is_below_base(pack, path))
        .filter_map(|(path, place)| {
            let fault = unlisted(place)?;
            Some(((folder_of(path), fault), path))
        });
    let unlisted = grouped(unlisted);
    out.extend(
        unlisted
            .into_iter()
            .map(|((folder, fault), paths)| of_unlisted(rule, pack, &folder, fault, &paths)),
    );
}

/// Whether a path has the folder of a base mesh, with more folders in it: one finding has them all.
pub(super) fn is_below_base(pack: &Packed<'_>, path: &str) -> bool {
    let parts: Vec<&str> = path.split('/').collect();
    match parts.as_slice() {
        ["base" | "models" | "themes", ..] => false,
        // This one keeps its name: nothing is split up.
        [_, _, "materials", _] => false,
        ["contarget", base, _, ..] | [_, base, _, _, ..] => {
            *base == pack.import.base || ["hm08", "mh2bot"].contains(base)
        }
        _ => false,
    }
}

fn ignored_folder(rule: &Rule, pack: &Packed<'_>, folder: &str, paths: &[&str]) -> Finding {
    let count = counted(paths.len(), "file");
    let first = paths.first().copied().unwrap_or_default();
    let around = around(pack, first);
    let (message, help) = match (&around, meant_for(folder)) {
        _ if folder.is_empty() => (
            format!("{count} at the top of the zip, first `{first}`: importing takes folders only"),
            "put each asset into a folder of its kind, such as `clothes/<asset>/`".to_owned(),
        ),
        (Some(around), _) => (
            format!("folder `{around}` is around the folders that are imported ({count})"),
            format!(
                "pack what is in `{around}`, so that the folders of assets are at the top of \
                the zip"
            ),
        ),
        (None, Some("contarget")) => (
            format!("folder `{folder}` is not imported ({count})"),
            "importing takes no targets of a user: have them copied to `target/<base mesh>/` in \
                the user's data"
                .to_owned(),
        ),
        (None, Some(right)) => (
            format!("folder `{folder}` is not imported ({count})"),
            format!(
                "rename it to \
                `{right}` in the zip"
            ),
        ),
        (None, None) => (
            format!("folder `{folder}` is not imported ({count})"),
            "put each asset into a folder of its kind at the top of the zip, such as \
                `clothes/<asset>/`"
                .to_owned(),
        ),
    };
    let finding = pack
        .at(rule, folder, message)
        .key(format!("ignored {folder}"))
        .help(help);
    let are_pictures = paths.iter().all(|path| loss(path) == Some(Loss::Picture));
    let finding = if are_pictures {
        finding.case(PICTURES)
    } else {
        finding
    };
    finding.evidence(Evidence::of_cases(paths.iter().copied()))
}

/// The folders in front of a path that are too many.
fn around(pack: &Packed<'_>, path: &str) -> Option<String> {
    let levels = path.matches('/').count();
    let is_wrapper = |level: &usize| {
        let below: Vec<&str> = path.split('/').skip(*level).collect();
        below.len() > 1 && import(&below.join("/"), &pack.import.base).is_some()
    };
    (1..levels).find(is_wrapper).map(|level| top(path, level))
}

/// Why no list shows an asset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Unlisted {
    Packed,
    Kind(&'static [&'static str]),
    Deep,
}

fn unlisted(place: &str) -> Option<Unlisted> {
    let folder = first_name(place);
    if extension(place).eq_ignore_ascii_case("zip") {
        return Some(Unlisted::Packed);
    }
    let right = match extension(place) {
        "mhmat" if folder == "skins" => &["skins"],
        suffix => in_place_of(suffix),
    };
    if right.is_empty() || listed_in(place).is_some() {
        None
    } else if right.contains(&folder) {
        Some(Unlisted::Deep)
    } else {
        // The model that a base mesh starts with lies beside it.
        (folder != "base").then_some(Unlisted::Kind(right))
    }
}

/// The folder to move: that of the asset, not of the kind.
fn folder_of(path: &str) -> String {
    parent(path).to_owned()
}

fn of_unlisted(
    rule: &Rule,
    pack: &Packed<'_>,
    folder: &str,
    fault: Unlisted,
    paths: &[&str],
) -> Finding {
    let first = paths.first().copied().unwrap_or_default();
    let (name, kind) = (file_name(first), top(first, 1));
    let (message, help) = match fault {
        Unlisted::Packed => (
            format!("`{name}` is a zip in the zip: importing does not unpack it"),
            format!("pack what is in `{name}` itself"),
        ),
        Unlisted::Deep => (
            format!(
                "`{name}` lies {} folders below `{kind}`, expected 1 at most",
                folder.matches('/').count()
            ),
            format!("move what is in `{folder}` to a folder of its own in `{kind}`"),
        ),
        Unlisted::Kind(right) => {
            let right = match right {
                ["proxy"] => "`proxymeshes`".to_owned(),
                [only] => format!("`{only}`"),
                [first, second, ..] => {
                    format!("`{first}`, `{second}` or another folder of its kind")
                }
                [] => String::new(),
            };
            let suffix = extension(first);
            (
                format!("a `.{suffix}` in `{kind}` is not listed, expected in {right}"),
                format!("move it to {right}"),
            )
        }
    };
    let finding = pack
        .at(rule, first, message)
        .key(format!("unlisted {folder}"))
        .case(UNLISTED)
        .help(help);
    finding.evidence(Evidence::of_cases(paths.iter().copied()))
}
