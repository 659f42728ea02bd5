//! Where `mhlint.toml` is: at or above the first PATH.

use std::path::{Component, Path, PathBuf};

use super::{Config, Error, read};
use mhlint_diag::RuleInfo;
use mhlint_source::{
    Folder, Limits, ReadFault, canonical, holds, link_targets, read_file, slashed,
};

/// Name of the configuration file.
pub const FILE_NAME: &str = "mhlint.toml";

/// No configuration written by people comes near.
const LARGEST: u64 = 1 << 20;

/// The configuration file for `path`: in its folder or the nearest one above. The search ends at
/// the top of the repository, the folder that holds `.git`, or else at the root of the file system.
pub fn find(path: &Path) -> Option<PathBuf> {
    let place = canonical(path)?;
    for (up, folder) in place.ancestors().enumerate() {
        // A link that leads nowhere was meant to be settings, too.
        if holds(folder, FILE_NAME) || is_link(&folder.join(FILE_NAME)) {
            let shown = shown(path, up).join(FILE_NAME);
            // A link in PATH leads elsewhere than the names say.
            let same = canonical(&shown).is_some_and(|found| found.parent() == Some(folder));
            return Some(if same { shown } else { folder.join(FILE_NAME) });
        }
        if holds(folder, ".git") {
            return None;
        }
    }
    None
}

fn is_link(path: &Path) -> bool {
    !link_targets(path).is_empty()
}

/// The folder `up` levels above `path`, written as short as `path` was.
fn shown(path: &Path, up: usize) -> PathBuf {
    let parts: Vec<Component<'_>> = path
        .components()
        .filter(|part| !matches!(part, Component::CurDir))
        .collect();
    let climbs = parts
        .iter()
        .any(|part| matches!(part, Component::ParentDir));
    let kept = if climbs {
        None
    } else {
        parts.len().checked_sub(up)
    };
    match kept {
        Some(kept) => parts.into_iter().take(kept).collect(),
        None if climbs && up == 0 => path.to_owned(),
        None if climbs => path.join(vec![".."; up].join("/")),
        None => PathBuf::from(vec![".."; up - parts.len()].join("/")),
    }
}

pub(super) fn load(path: &Path, rules: &[&'static RuleInfo]) -> Result<Config, Error> {
    let shown = slashed(path);
    let limits = Limits {
        file_bytes: LARGEST,
        ..Limits::default()
    };
    let bytes = read_file(path, &limits)
        .map_err(|fault| Error::unreadable(&shown, &reason(path, fault)))?;
    let text =
        String::from_utf8(bytes).map_err(|_| Error::unreadable(&shown, "it is not UTF-8"))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    read::read(&text, &shown, folder, Folder::of(folder), rules)
}

fn reason(path: &Path, fault: ReadFault) -> String {
    match fault {
        ReadFault::Unreadable(_) if is_link(path) && canonical(path).is_none() => {
            "it is a broken link; fix or remove it".to_owned()
        }
        ReadFault::Unreadable(reason) => reason,
        ReadFault::TooLarge { size, limit } => {
            format!("it has {size} bytes, more than the limit of {limit}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_above_is_shown_as_the_path_was_written() {
        let at = |path: &str, up| shown(Path::new(path), up).to_string_lossy().into_owned();
        assert_eq!(
            [
                at("data/target", 1),
                at("data", 1),
                at(".", 0),
                at(".", 1),
                at("data", 3)
            ],
            ["data", "", "", "..", "../.."]
        );
        assert_eq!(
            [at("../x", 0), at("../x", 1), at("/a/b", 1)],
            ["../x", "../x/..", "/a"]
        );
    }
}
