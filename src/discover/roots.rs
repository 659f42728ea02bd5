//! Finds data roots by their shape (design.md, "Data roots, layers, applications").

use std::collections::BTreeMap;

use crate::diag::Application;

/// A folder that an application would call its data folder.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct DataRoot {
    /// Path from the top of the tree, empty for the top itself.
    pub path: String,
    /// Whose data folder it looks like.
    pub application: Application,
}

/// Folders of MakeHuman 2 that its asset scan visits, with one level of folders below the base mesh.
pub const SCANNED: [&str; 12] = [
    "clothes",
    "hair",
    "eyes",
    "eyebrows",
    "eyelashes",
    "teeth",
    "tongue",
    "proxy",
    "rigs",
    "poses",
    "expressions",
    "models",
];

/// Folders of MakeHuman 2 with a folder for each base mesh that the scan leaves out.
const NOT_SCANNED: [&str; 4] = ["target", "contarget", "base", "skins"];

/// How telling a path is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Sign {
    /// Could stand elsewhere, too; counts only where nothing better is near.
    Weak,
    /// Only this application has such a file.
    Strong,
}

/// All data roots in a listing of file paths, sorted by path.
pub fn find_roots<'a>(files: impl IntoIterator<Item = &'a str>) -> Vec<DataRoot> {
    let mut signs: BTreeMap<DataRoot, Sign> = BTreeMap::new();
    for file in files {
        if let Some((path, application, sign)) = sign_of(file) {
            let root = DataRoot { path: path.to_owned(), application };
            let known = signs.entry(root).or_insert(sign);
            *known = sign.max(*known);
        }
    }
    let strong: Vec<DataRoot> =
        signs.iter().filter(|(_, sign)| **sign == Sign::Strong).map(|(root, _)| root.clone()).collect();
    let far_from_strong = |root: &DataRoot| !strong.iter().any(|other| nested(&other.path, &root.path));
    signs
        .iter()
        .filter(|(root, sign)| **sign == Sign::Strong || far_from_strong(root))
        .map(|(root, _)| root.clone())
        .collect()
}

/// The part of `path` above the first folder name that belongs to a data root: where a data root would
/// be that `path` lies inside of.
pub fn root_above(path: &str) -> Option<&str> {
    let mut end = path.len();
    for part in path.rsplit('/') {
        let start = end - part.len();
        if NOT_SCANNED.contains(&part) || SCANNED.contains(&part) {
            return Some(path.get(..start).unwrap_or_default().trim_end_matches('/'));
        }
        end = start.saturating_sub(1);
    }
    None
}

fn nested(a: &str, b: &str) -> bool {
    let inside = |outer: &str, inner: &str| {
        outer.is_empty() || inner == outer || inner.strip_prefix(outer).is_some_and(|rest| rest.starts_with('/'))
    };
    inside(a, b) || inside(b, a)
}

fn sign_of(file: &str) -> Option<(&str, Application, Sign)> {
    use Application::{Makehuman1, Makehuman2, Mpfb};
    let parts: Vec<&str> = file.split('/').collect();
    let above = |levels: usize| ancestor(file, levels);
    match parts.as_slice() {
        [.., "base", _, "base.json" | "base.obj"] => Some((above(3)?, Makehuman2, Sign::Strong)),
        [
            ..,
            "target" | "contarget",
            _,
            "macro.json" | "modelling.json" | "target_cat.json" | "compressedtargets.npz",
        ] => Some((above(3)?, Makehuman2, Sign::Strong)),
        [.., "targets", "target.json"] => Some((above(2)?, Mpfb, Sign::Strong)),
        [.., "targets", "macrodetails", "macro.json"] => Some((above(3)?, Mpfb, Sign::Strong)),
        [.., "mesh_metadata", _] => Some((above(2)?, Mpfb, Sign::Strong)),
        [.., "rigs", "standard" | "rigify", name] if name.starts_with("rig.") => Some((above(3)?, Mpfb, Sign::Strong)),
        [.., "modifiers", name] if name.ends_with("_modifiers.json") => Some((above(2)?, Makehuman1, Sign::Strong)),
        [.., "3dobjs", "base.obj"] => Some((above(2)?, Makehuman1, Sign::Weak)),
        [.., "proxymeshes", _, name] if name.ends_with(".proxy") => Some((above(3)?, Makehuman1, Sign::Strong)),
        [.., "rigs", name] if name.ends_with(".mhskel") => Some((above(2)?, Makehuman1, Sign::Strong)),
        [.., "rigs", _, name] if name.ends_with(".mhskel") => Some((above(3)?, Makehuman2, Sign::Weak)),
        [.., name] if name.ends_with(".target") => target_below(&parts, file),
        _ => None,
    }
}

/// A target somewhere below `target/<base>/` or `contarget/<base>/`.
fn target_below<'a>(parts: &[&str], file: &'a str) -> Option<(&'a str, Application, Sign)> {
    let at = parts.iter().rposition(|part| matches!(*part, "target" | "contarget"))?;
    let levels = parts.len() - at;
    (levels >= 3).then(|| ancestor(file, levels))?.map(|root| (root, Application::Makehuman2, Sign::Weak))
}

/// The path without its last `levels` parts.
fn ancestor(path: &str, levels: usize) -> Option<&str> {
    let mut rest = path;
    for _ in 0..levels {
        match rest.rsplit_once('/') {
            Some((parent, _)) => rest = parent,
            None if rest.is_empty() => return None,
            None => rest = "",
        }
    }
    Some(rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(files: &[&str]) -> Vec<(String, Application)> {
        find_roots(files.iter().copied()).into_iter().map(|root| (root.path, root.application)).collect()
    }

    #[test]
    fn shapes_of_the_three_applications() {
        assert_eq!(
            found(&["data/base/hm08/base.json", "data/target/hm08/a/b.target"]),
            [("data".to_owned(), Application::Makehuman2)]
        );
        assert_eq!(found(&["base/hm08/base.obj"]), [(String::new(), Application::Makehuman2)]);
        assert_eq!(found(&["x/targets/target.json", "x/mesh_metadata/a.json"]), [("x".to_owned(), Application::Mpfb)]);
        assert_eq!(
            found(&["data/modifiers/modeling_modifiers.json", "data/3dobjs/base.obj"]),
            [("data".to_owned(), Application::Makehuman1)]
        );
    }

    #[test]
    fn a_build_folder_called_target_is_no_root() {
        assert_eq!(
            found(&["target/corpora/mh/data/base/hm08/base.json", "target/corpora/mh/data/target/hm08/x.target"]),
            [("target/corpora/mh/data".to_owned(), Application::Makehuman2)]
        );
    }

    #[test]
    fn targets_alone_are_a_weak_sign() {
        assert_eq!(found(&["user/target/hm08/mine/x.target"]), [("user".to_owned(), Application::Makehuman2)]);
    }

    #[test]
    fn a_path_inside_knows_where_its_root_would_be() {
        assert_eq!(root_above("data/target/hm08"), Some("data"));
        assert_eq!(root_above("target"), Some(""));
        assert_eq!(root_above("src/formats"), None);
    }
}
