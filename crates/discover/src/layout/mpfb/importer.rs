//! Which asset packs MPFB refuses: it checks a zip by the names in it before it unpacks anything
//! (`docs/loaders/mpfb/libraries.md#check-of-a-zip`).

use super::LAYOUT;
use mhlint_source::first_name;

/// Where the list of a pack lies: no zip without it is taken.
const LISTS: &str = "packs/";

/// What macOS adds to a zip.
const OF_MACOS: &str = "__MACOSX";

/// Why a zip is refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refusal {
    /// A folder is around everything.
    Around(String),
    /// A folder is around everything but what macOS adds.
    AroundBesideMacos(String),
    /// A folder is around the pack, and a file lies beside it.
    AroundBesideFile(String),
    /// A folder is around the pack, and another folder lies beside it.
    AroundBesideFolder(String),
    /// Several folders are around the pack.
    Deep(String),
    /// The folder of the list has this name, in other capitals.
    Capitals(String),
    /// Folders are parted by `\`.
    Backslashes,
    /// There is no folder for the list.
    NoLists,
    /// There is none either in the folder that is around everything.
    NoListsInFolder(String),
    /// There is nothing in it.
    Empty,
}

/// Why a zip with members of these names is refused, as they are stored.
pub(crate) fn refusal(names: &[String]) -> Option<Refusal> {
    if names.iter().any(|name| name.starts_with(LISTS)) {
        return None;
    }
    let meant: Vec<String> = names.iter().map(|name| meant(name)).collect();
    if let Some(at) = meant.iter().position(|name| name.starts_with(LISTS)) {
        // A name that leads out of the zip has a finding of its own.
        return names
            .get(at)
            .filter(|name| name.contains('\\'))
            .map(|_| Refusal::Backslashes);
    }
    Some(of_place(&meant))
}

/// A name with `/` between its folders, and without what would lead out of the zip.
fn meant(name: &str) -> String {
    let slashed = name.replace('\\', "/");
    let parts: Vec<&str> = slashed.split('/').collect();
    let is_folder = slashed.ends_with('/');
    let kept: Vec<&str> = parts
        .into_iter()
        .filter(|part| !matches!(*part, "" | "." | ".."))
        .collect();
    format!("{}{}", kept.join("/"), if is_folder { "/" } else { "" })
}

/// Where the list of the pack lies instead.
fn of_place(names: &[String]) -> Refusal {
    let visible = || {
        names
            .iter()
            .map(String::as_str)
            .filter(|name| !name.starts_with('.') && top(name) != OF_MACOS)
    };
    let is_around = |name: &&str| {
        name.split_once('/')
            .is_some_and(|(_, below)| below.starts_with(LISTS))
    };
    if let Some(folder) = visible().find(is_around).map(top) {
        return around(
            folder,
            visible(),
            names.iter().any(|name| top(name) == OF_MACOS),
        );
    }
    let deep = |name: &str| {
        name.find("/packs/")
            .and_then(|end| name.get(..end).map(str::to_owned))
    };
    let in_capitals = |name: &&str| top(name).eq_ignore_ascii_case("packs") && name.contains('/');
    if let Some(folder) = visible().find_map(deep) {
        Refusal::Deep(folder)
    } else if let Some(name) = visible().find(in_capitals) {
        Refusal::Capitals(top(name).to_owned())
    } else if names.is_empty() {
        Refusal::Empty
    } else {
        let mut tops = visible().filter(|name| name.contains('/')).map(top);
        let first = tops.next().filter(|first| !LAYOUT.has_at_top(first));
        first
            .filter(|first| tops.all(|other| other == *first))
            .map_or(Refusal::NoLists, |folder| {
                Refusal::NoListsInFolder(folder.to_owned())
            })
    }
}

fn around<'n>(folder: &str, mut names: impl Iterator<Item = &'n str>, has_macos: bool) -> Refusal {
    let own = folder.to_owned();
    match names.find(|name| top(name) != folder) {
        Some(other) if other.contains('/') => Refusal::AroundBesideFolder(own),
        Some(_) => Refusal::AroundBesideFile(own),
        None if has_macos => Refusal::AroundBesideMacos(own),
        None => Refusal::Around(own),
    }
}

fn top(name: &str) -> &str {
    first_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(names: &[&str]) -> Option<Refusal> {
        refusal(
            &names
                .iter()
                .map(|name| (*name).to_owned())
                .collect::<Vec<_>>(),
        )
    }

    #[test]
    fn a_zip_with_a_list_at_its_top_is_taken() {
        assert_eq!(of(&["clothes/a/a.mhclo", "packs/a.json"]), None);
        assert_eq!(
            of(&[
                "packs/",
                "x/packs/a.json",
                "__MACOSX/packs/._a.json",
                "README.txt"
            ]),
            None
        );
        // That is a finding of its own.
        assert_eq!(of(&["../packs/a.json"]), None);
        assert_eq!(of(&["/packs/a.json"]), None);
    }

    #[test]
    fn one_folder_around_a_pack_is_told_by_what_lies_beside_it() {
        let x = || "x".to_owned();
        assert_eq!(
            of(&["x/", "x/packs/a.json", ".DS_Store", ".git/config"]),
            Some(Refusal::Around(x()))
        );
        assert_eq!(
            of(&["__MACOSX/x/packs/._a.json", "x/packs/a.json"]),
            Some(Refusal::AroundBesideMacos(x()))
        );
        assert_eq!(
            of(&["README.txt", "x/packs/a.json"]),
            Some(Refusal::AroundBesideFile(x()))
        );
        assert_eq!(
            of(&["x/packs/a.json", "y/b"]),
            Some(Refusal::AroundBesideFolder(x()))
        );
    }

    #[test]
    fn anything_else_has_no_list() {
        assert_eq!(
            of(&["x/y/packs/a.json"]),
            Some(Refusal::Deep("x/y".to_owned()))
        );
        assert_eq!(
            of(&["Packs/a.json"]),
            Some(Refusal::Capitals("Packs".to_owned()))
        );
        assert_eq!(of(&[r"packs\a.json"]), Some(Refusal::Backslashes));
        assert_eq!(of(&["clothes/a/a.mhclo"]), Some(Refusal::NoLists));
        assert_eq!(of(&["packs"]), Some(Refusal::NoLists));
        let wrapped = Some(Refusal::NoListsInFolder("repo-master".to_owned()));
        assert_eq!(
            of(&[
                "repo-master/",
                "repo-master/clothes/a/a.mhclo",
                "repo-master/README.md"
            ]),
            wrapped
        );
        assert_eq!(of(&[]), Some(Refusal::Empty));
    }
}
