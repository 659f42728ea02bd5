//! User targets as MakeHuman 2 scans them, and the keys it makes of their names
//! (`docs/loaders/makehuman2/user-targets.md#scan-of-the-folder`).

use std::collections::BTreeSet;

use super::Base;
use crate::FileFacts;

/// A user target that is scanned.
pub struct UserTarget<'a> {
    pub file: &'a FileFacts,
    /// Its folder below the user's target folder, `None` at the top.
    pub folder: Option<&'a str>,
    /// File name without suffix.
    pub stem: &'a str,
}

/// A slider that will be generated.
pub struct Entry<'a> {
    pub key: String,
    pub file: &'a FileFacts,
}

/// The folder itself and one level of sub-folders; `icons` holds pictures.
pub fn targets<'a>(base: &Base<'a>) -> Vec<UserTarget<'a>> {
    let Some(folder) = base.user_targets else {
        return Vec::new();
    };
    let scanned = folder.targets().filter_map(|file| {
        let name = folder.name_of(file)?;
        match name.split('/').collect::<Vec<_>>().as_slice() {
            [_] => Some(UserTarget {
                file,
                folder: None,
                stem: file.stem(),
            }),
            ["icons", _] => None,
            [sub, _] => Some(UserTarget {
                file,
                folder: part_of(file, sub),
                stem: file.stem(),
            }),
            _ => None,
        }
    });
    scanned.collect()
}

/// The part of a file's path that spells `name`, with the life of the file.
fn part_of<'a>(file: &'a FileFacts, name: &str) -> Option<&'a str> {
    file.rel
        .split('/')
        .rev()
        .nth(1)
        .filter(|part| *part == name)
}

/// The entries that are generated, in order of the files. Of a pair `-incr`/`-decr` one entry.
pub fn entries<'a>(targets: &[UserTarget<'a>]) -> Vec<Entry<'a>> {
    let names: BTreeSet<(Option<&str>, &str)> = targets
        .iter()
        .map(|target| (target.folder, target.stem))
        .collect();
    let partners: BTreeSet<(Option<&str>, String)> = targets
        .iter()
        .filter_map(|target| partner(target, &names))
        .collect();
    let alone = targets
        .iter()
        .filter(|target| !partners.contains(&(target.folder, target.stem.to_owned())));
    alone
        .map(|target| Entry {
            key: key(target, partner(target, &names).is_some()),
            file: target.file,
        })
        .collect()
}

/// Pairs without a folder: the positive half, and the name of the other one.
pub fn pairs_at_top<'a>(targets: &[UserTarget<'a>]) -> Vec<(&'a FileFacts, String)> {
    let at_top = || targets.iter().filter(|target| target.folder.is_none());
    let names = at_top().map(|target| (None, target.stem)).collect();
    at_top()
        .filter_map(|target| Some((target.file, partner(target, &names)?.1)))
        .collect()
}

/// The negative half of a pair: the same stem with every `incr` replaced.
fn partner<'a>(
    target: &UserTarget<'a>,
    names: &BTreeSet<(Option<&str>, &str)>,
) -> Option<(Option<&'a str>, String)> {
    let decr = target
        .stem
        .ends_with("incr")
        .then(|| target.stem.replace("incr", "decr"))?;
    names
        .contains(&(target.folder, decr.as_str()))
        .then_some((target.folder, decr))
}

/// Folder and name, both capitalized as Python does it; a pair loses its last five characters.
fn key(target: &UserTarget<'_>, pair: bool) -> String {
    let name = target.stem.replace('-', " ");
    let key = format!(
        "{} {}",
        capitalized(target.folder.unwrap_or("user")),
        capitalized(&name)
    );
    let kept = if pair {
        key.chars().count().saturating_sub(5)
    } else {
        usize::MAX
    };
    key.chars().take(kept).collect()
}

fn capitalized(text: &str) -> String {
    let mut characters = text.chars();
    let first = characters.next().into_iter().flat_map(char::to_uppercase);
    first
        .chain(characters.flat_map(char::to_lowercase))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_capitalized_as_python_does_it() {
        assert_eq!(capitalized("neck HEIGHT"), "Neck height");
        assert_eq!(capitalized("éA"), "Éa");
        assert_eq!(capitalized(""), "");
    }
}
