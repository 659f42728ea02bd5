//! Files outside any data root: where the application would keep them.
//!
//! A loose target, skeleton or weights file is judged as if its owner had already copied it into a user
//! folder; without a base mesh to copy it to, it is judged alone.

/// Folder of the files that are judged alone; no application has one of this name.
pub(super) const ALONE: &str = "(loose)";

/// The place below a user's data root that the file at `path` belongs to, for `base` if one is known.
/// `None` for files that are not judged outside a data root.
pub fn loose_place(path: &str, base: Option<&str>) -> Option<String> {
    let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
    let (_, extension) = file.rsplit_once('.')?;
    let place = match (extension, base) {
        // Targets are looked for one folder below the base; deeper ones would be out of sight.
        ("target", Some(base)) if folder.is_empty() => format!("target/{base}/loose/{file}"),
        ("target", Some(base)) => format!("target/{base}/{}/{file}", folder.replace('/', "_")),
        ("mhskel" | "mhw", Some(base)) => format!("rigs/{base}/{path}"),
        ("target" | "mhskel" | "mhw", None) => format!("{ALONE}/{path}"),
        _ => return None,
    };
    Some(place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discover::{Kind, kind_of};

    #[test]
    fn loose_files_are_of_the_kind_their_place_says() {
        for (path, base, kind) in [
            ("a/b/c.target", Some("figure"), Kind::Target),
            ("c.target", None, Kind::Target),
            ("a.mhskel", Some("figure"), Kind::Skeleton),
            ("a/a.mhw", None, Kind::Weights),
        ] {
            let place = loose_place(path, base).unwrap_or_default();
            assert_eq!(kind_of(&place), (kind, base), "{place}");
        }
        assert_eq!(loose_place("package.json", None), None);
        assert_eq!(loose_place("a/b/c.target", Some("figure")).as_deref(), Some("target/figure/a_b/c.target"));
    }
}
