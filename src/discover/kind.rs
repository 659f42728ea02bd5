//! What a file is for, judged by its place below a MakeHuman 2 data root.

use super::loose::ALONE;

/// Kinds of files in a MakeHuman 2 data root.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// `base/<b>/base.json`.
    BaseJson,
    /// `base/<b>/base.obj`.
    BaseMesh,
    /// `base/<b>/geometry.json`.
    Geometry,
    /// `macro.json` of a target folder.
    MacroJson,
    /// `modelling.json` of a target folder.
    ModellingJson,
    /// `target_cat.json` of a target folder.
    TargetCategories,
    /// `*.target` below a target folder.
    Target,
    /// `*.target.gz`: MakeHuman 2 does not read it.
    PackedTarget,
    /// `compressedtargets.npz` of a target folder.
    TargetArchive,
    /// A picture in `icons/` of a target folder.
    TargetIcon,
    /// `*.mhskel` below `rigs/<b>/`.
    Skeleton,
    /// `*.mhw`.
    Weights,
    /// Any other JSON that a loader reads.
    OtherJson,
    /// Text formats of families that are judged elsewhere.
    Text,
    /// Pictures.
    Image,
    /// Anything else.
    Other,
}

/// Folders whose files are sorted by base mesh.
const TARGET_FOLDERS: [&str; 2] = ["target", "contarget"];

/// The kind of the file at `path` (relative to its data root) and the base mesh it belongs to.
pub fn kind_of(path: &str) -> (Kind, Option<&str>) {
    let parts: Vec<&str> = path.split('/').collect();
    match parts.as_slice() {
        [ALONE, .., file] if has_extension(file, "target") => (Kind::Target, None),
        [ALONE, .., file] => (by_extension(file), None),
        [folder, base, rest @ ..] if !rest.is_empty() => (kind_in(folder, rest), Some(base)),
        [file] => (by_extension(file), None),
        _ => (by_extension(parts.last().copied().unwrap_or_default()), None),
    }
}

fn kind_in(folder: &str, rest: &[&str]) -> Kind {
    match (folder, rest) {
        ("base", ["base.json"]) => Kind::BaseJson,
        ("base", ["base.obj"]) => Kind::BaseMesh,
        ("base", ["geometry.json"]) => Kind::Geometry,
        (folder, rest) if TARGET_FOLDERS.contains(&folder) => kind_of_target_file(rest),
        (_, [.., file]) => by_extension(file),
        (_, []) => Kind::Other,
    }
}

fn kind_of_target_file(rest: &[&str]) -> Kind {
    match rest {
        ["macro.json"] => Kind::MacroJson,
        ["modelling.json"] => Kind::ModellingJson,
        ["target_cat.json"] => Kind::TargetCategories,
        ["compressedtargets.npz"] => Kind::TargetArchive,
        ["icons", .., file] if has_extension(file, "png") => Kind::TargetIcon,
        [.., file] if has_extension(file, "target") => Kind::Target,
        [.., file] if file.ends_with(".target.gz") => Kind::PackedTarget,
        [.., file] => by_extension(file),
        [] => Kind::Other,
    }
}

/// Kinds by extension, wherever the file lies. The hooks for pre-commit start on these.
const BY_EXTENSION: [(Kind, &[&str]); 5] = [
    (Kind::Skeleton, &["mhskel"]),
    (Kind::Weights, &["mhw"]),
    (Kind::OtherJson, &["json", "mhpose"]),
    (Kind::Text, &["mhclo", "proxy", "mhmat", "mhm", "bvh", "meta", "obj"]),
    (Kind::Image, &["png", "jpg", "jpeg", "tif", "tiff", "thumb"]),
];

/// Extensions are compared as the applications do: `X.TARGET` is no target.
fn by_extension(file: &str) -> Kind {
    let extension = file.rsplit_once('.').map_or("", |(_, extension)| extension);
    let row = BY_EXTENSION.iter().find(|(_, extensions)| extensions.contains(&extension));
    row.map_or(Kind::Other, |(kind, _)| *kind)
}

fn has_extension(file: &str, extension: &str) -> bool {
    file.rsplit_once('.').is_some_and(|(_, found)| found == extension)
}

/// Folders that tools keep beside the data; nothing of the family is in them.
const VERSION_CONTROL: [&str; 3] = [".git", ".svn", ".hg"];

/// Whether an application reads a file whose name, or that of a folder above it, begins with a point; of a folder,
/// whether such a file could be in it. `path` may begin above the data root.
///
/// MakeHuman 2 opens every `*.target` below a target folder, whatever it is called (formats/makehuman2.md §1.3).
pub fn is_read_though_hidden(path: &str, is_folder: bool) -> bool {
    let parts: Vec<&str> = path.split('/').collect();
    let hidden = parts.iter().position(|part| part.starts_with('.')).unwrap_or(parts.len());
    // A name for the base mesh stands between.
    let visible = parts.get(..hidden.saturating_sub(1)).unwrap_or_default();
    let name = parts.last().copied().unwrap_or_default();
    visible.iter().any(|part| TARGET_FOLDERS.contains(part))
        && !parts.iter().any(|part| VERSION_CONTROL.contains(part))
        && (is_folder || has_extension(name, "target"))
}

impl Kind {
    /// Whether the file is JSON.
    pub const fn is_json(self) -> bool {
        matches!(
            self,
            Self::BaseJson
                | Self::Geometry
                | Self::MacroJson
                | Self::ModellingJson
                | Self::TargetCategories
                | Self::Skeleton
                | Self::Weights
                | Self::OtherJson
        )
    }

    /// Whether the file is text in which an encoding matters.
    pub const fn is_text(self) -> bool {
        self.is_json() || matches!(self, Self::BaseMesh | Self::Target | Self::Text)
    }

    /// What people call it.
    pub const fn title(self) -> &'static str {
        match self {
            Self::BaseJson => "base.json",
            Self::BaseMesh => "base mesh",
            Self::Geometry => "geometry.json",
            Self::MacroJson => "macro.json",
            Self::ModellingJson => "modelling.json",
            Self::TargetCategories => "target_cat.json",
            Self::Target => "target",
            Self::PackedTarget => "packed target",
            Self::TargetArchive => "target archive",
            Self::TargetIcon => "icon",
            Self::Skeleton => "skeleton",
            Self::Weights => "weights",
            Self::OtherJson => "JSON",
            Self::Text => "text asset",
            Self::Image => "picture",
            Self::Other => "file",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn place_decides_the_kind() {
        for (path, kind, base) in [
            ("base/hm08/base.json", Kind::BaseJson, Some("hm08")),
            ("target/hm08/macro.json", Kind::MacroJson, Some("hm08")),
            ("contarget/x/a/b/c.target", Kind::Target, Some("x")),
            ("target/hm08/icons/a.png", Kind::TargetIcon, Some("hm08")),
            ("target/hm08/a/X.TARGET", Kind::Other, Some("hm08")),
            ("rigs/hm08/sub/a.mhskel", Kind::Skeleton, Some("hm08")),
            ("clothes/hm08/x/macro.json", Kind::OtherJson, Some("hm08")),
            ("makehuman2_version.json", Kind::OtherJson, None),
        ] {
            assert_eq!(kind_of(path), (kind, base), "{path}");
        }
    }

    #[test]
    fn hidden_targets_are_read_and_nothing_else_that_is_hidden() {
        for (path, is_folder, read) in [
            ("target/b/._a.target", false, true),
            ("data/contarget/b/a/.hidden/c.target", false, true),
            ("data/target/b/.hidden", true, true),
            ("target/b/.DS_Store", false, false),
            ("target/b/.git", true, false),
            ("target/b/.git/a.target", false, false),
            ("target/.cache", true, false),
            (".venv", true, false),
            (".venv/target/b/a.target", false, false),
            ("rigs/b/._a.mhskel", false, false),
        ] {
            assert_eq!(is_read_though_hidden(path, is_folder), read, "{path}");
        }
    }

    /// What changes a verdict besides `BY_EXTENSION`: targets, archives, and the configuration.
    const FURTHER: [&str; 7] = ["target", "gz", "npz", "mhbin", "mhpxy", "zip", "toml"];

    #[test]
    fn hooks_start_on_every_extension_that_is_judged() {
        let mut judged: Vec<&str> = BY_EXTENSION.iter().flat_map(|(_, extensions)| *extensions).copied().collect();
        judged.extend(FURTHER);
        judged.sort_unstable();
        let files = format!("files: '(?i)\\.({})$'", judged.join("|"));
        for (file, hooks, text) in [
            (".pre-commit-hooks.yaml", 3, include_str!("../../.pre-commit-hooks.yaml")),
            ("mirror", 1, include_str!("../../packaging/pre-commit-mirror/.pre-commit-hooks.yaml")),
        ] {
            let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| line.starts_with("files:")).collect();
            assert_eq!(lines, vec![files.as_str(); hooks], "{file}");
        }
    }
}
