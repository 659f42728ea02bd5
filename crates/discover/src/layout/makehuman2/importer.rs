//! Where MakeHuman 2 puts the files of an asset pack when it imports one
//! (`docs/loaders/makehuman2/libraries.md#asset-packs`).

use super::super::super::Kind;
use super::super::super::kind::is_asset_anywhere;
use super::super::WORN;
use mhlint_source::extension;

/// Folders of assets besides those of what is worn; topologies have another name in packs.
const OTHERS: [&str; 4] = ["skins", "rigs", "poses", "expressions"];

/// What the folder of topologies is called in packs.
pub(crate) const PACKED_TOPOLOGIES: &str = "proxymeshes";

/// Beginning of the names of folders that are a folder below `shaders`.
const SHADERS: &str = "shader_";

/// The third folder of assets gets this name, whatever it is called.
pub(crate) const THIRD_FOLDER: &str = "materials";

/// Where the file at a path of a pack is put below the user's data, for a base mesh; `None` if it
/// is ignored.
pub fn import(path: &str, base: &str) -> Option<String> {
    let parts: Vec<&str> = path.split('/').collect();
    let (category, below) = parts.split_first()?;
    let file = below.last()?;
    match *category {
        PACKED_TOPOLOGIES => Some(format!("proxy/{base}/{}", renamed(below))),
        "base" | "models" => Some(format!("{category}/{base}/{file}")),
        "contarget" => Some(format!("contarget/{base}/{}", below.join("/"))),
        "themes" => Some(format!("themes/{file}")),
        "shader_floor" | "shader_litspheres" | "shader_skybox" => Some(format!(
            "shaders/{}/{}",
            category.trim_start_matches(SHADERS),
            below.join("/")
        )),
        _ if takes(category) => Some(format!("{category}/{base}/{}", renamed(below))),
        _ => None,
    }
}

/// Whether a folder at the top of a pack is one of assets, sorted by base mesh in the user's data.
pub(crate) fn takes(folder: &str) -> bool {
    WORN.contains(&folder) || OTHERS.contains(&folder)
}

/// What is lost with a file that is ignored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Loss {
    /// An asset, or a part of one.
    Asset,
    /// A picture in a folder that is nearly one that is taken.
    Picture,
}

/// What is lost with the file at a path of a pack, if it is ignored.
pub fn loss(path: &str) -> Option<Loss> {
    let top = top_folder(path);
    let is_asset = matches!(
        extension(path),
        "mhskel" | "mhw" | "bvh" | "proxy" | "target"
    );
    if is_asset || is_asset_anywhere(path) {
        return Some(Loss::Asset);
    }
    (Kind::by_extension(path) == Kind::Image && meant_for(top).is_some()).then_some(Loss::Picture)
}

/// What lies below the folder of a category.
fn renamed(below: &[&str]) -> String {
    let mut below = below.to_vec();
    if let [_, third, _, ..] = below.as_mut_slice() {
        *third = THIRD_FOLDER;
    }
    below.join("/")
}

/// The base mesh that a pack brings with it, by the name of the zip.
pub fn new_base(file: &str) -> Option<&str> {
    let (stem, extension) = file.rsplit_once('.')?;
    stem.strip_prefix("newbase_")
        .filter(|base| !base.is_empty() && extension.eq_ignore_ascii_case("zip"))
}

/// The folder of a pack that a path is in as the importer sees it: of `shaders` each folder in it
/// is one of its own.
pub fn top_folder(path: &str) -> &str {
    let mut ends = path.match_indices('/').map(|(at, _)| at);
    let Some(first) = ends.next() else { return "" };
    let is_shaders = path
        .get(..first)
        .is_some_and(|top| top.eq_ignore_ascii_case("shaders"));
    path.get(..ends.next().filter(|_| is_shaders).unwrap_or(first))
        .unwrap_or_default()
}

/// A folder that would be read if it had the name behind it.
pub fn meant_for(folder: &str) -> Option<&'static str> {
    let known = [
        ("shaders", "shader_litspheres"),
        ("shaders/litspheres", "shader_litspheres"),
        ("shaders/skybox", "shader_skybox"),
        ("shaders/floor", "shader_floor"),
        ("proxy", PACKED_TOPOLOGIES),
        ("target", "contarget"),
        ("targets", "contarget"),
        ("custom", "contarget"),
        ("litspheres", "shader_litspheres"),
        ("skyboxes", "shader_skybox"),
        ("floor", "shader_floor"),
    ];
    let lower = folder.to_lowercase();
    let row = known
        .iter()
        .find(|(name, _)| *name == lower)
        .map(|(_, right)| *right);
    let right = |name: &&&str| name.eq_ignore_ascii_case(folder);
    row.or_else(|| {
        WORN.iter()
            .chain(&OTHERS)
            .chain(&[PACKED_TOPOLOGIES, "contarget", "base", "models"])
            .find(right)
            .copied()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_go_where_the_importer_puts_them() {
        for (path, put) in [
            ("clothes/x.mhclo", Some("clothes/b/x.mhclo")),
            ("clothes/x/x.mhclo", Some("clothes/b/x/x.mhclo")),
            (
                "clothes/x/textures/x.png",
                Some("clothes/b/x/materials/x.png"),
            ),
            (
                "clothes/x/textures/deep/x.png",
                Some("clothes/b/x/materials/deep/x.png"),
            ),
            (
                "clothes/hm08/x/x.mhclo",
                Some("clothes/b/hm08/materials/x.mhclo"),
            ),
            ("proxymeshes/p/p.proxy", Some("proxy/b/p/p.proxy")),
            ("proxy/p/p.proxy", None),
            ("base/deep/base.obj", Some("base/b/base.obj")),
            ("models/m/m.mhm", Some("models/b/m.mhm")),
            ("contarget/a/b/c.target", Some("contarget/b/a/b/c.target")),
            ("target/a/c.target", None),
            ("shader_litspheres/a.png", Some("shaders/litspheres/a.png")),
            ("themes/a/b.qss", Some("themes/b.qss")),
            ("pack/clothes/x/x.mhclo", None),
            ("x.mhclo", None),
        ] {
            assert_eq!(import(path, "b").as_deref(), put, "{path}");
        }
    }

    #[test]
    fn a_new_base_stands_in_the_name() {
        let names = [
            "newbase_imp.zip",
            "newbase_.zip",
            "imp.zip",
            "newbase_imp.ZIP",
        ];
        assert_eq!(names.map(new_base), [Some("imp"), None, None, Some("imp")]);
    }
}
