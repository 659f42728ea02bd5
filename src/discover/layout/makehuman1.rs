//! MakeHuman 1: one base mesh, libraries without a folder for it (formats/makehuman1.md §1, §2.1).

use super::super::Kind;
use super::super::kind::extension;
use super::{HM08, LIBRARIES, Layout, Role, Sign, WORN};
use crate::diag::Application;

pub(super) static LAYOUT: Layout = Layout {
    application: Application::Makehuman1,
    shape: "modifiers/*_modifiers.json",
    depth: 3,
    folders: &[&["targets", "modifiers", "3dobjs", "custom"], &LIBRARIES, &WORN],
    sign,
    place,
    role: |below| Role::of_one(below, Application::Makehuman1, Kind::BaseMesh),
    ..Layout::PLAIN
};

fn sign(parts: &[&str]) -> Option<(Sign, usize)> {
    match parts {
        [.., "modifiers", name] if name.ends_with("_modifiers.json") => Some((Sign::Strong, 2)),
        [.., "3dobjs", "base.obj"] => Some((Sign::Weak, 2)),
        [.., "proxymeshes", _, name] if extension(name) == "proxy" => Some((Sign::Strong, 3)),
        [.., "rigs", name] if extension(name) == "mhskel" => Some((Sign::Strong, 2)),
        _ => None,
    }
}

fn place<'p>(parts: &[&'p str]) -> (Kind, Option<&'p str>) {
    let kind = match parts {
        ["3dobjs", "base.obj"] => Kind::BaseMesh,
        ["targets" | "custom", .., file] if extension(file) == "target" => Kind::Target,
        ["rigs", .., file] if extension(file) == "mhw" => Kind::Weights,
        [.., file] => Kind::by_extension(file),
        [] => Kind::Other,
    };
    (kind, (parts.len() > 1).then_some(HM08))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn place_decides_the_kind() {
        for (path, kind) in [
            ("3dobjs/base.obj", Kind::BaseMesh),
            ("3dobjs/base.mhclo", Kind::Clothes),
            ("targets/macrodetails/a.target", Kind::Target),
            ("custom/mine/a.target", Kind::Target),
            ("custom/a.TARGET", Kind::Other),
            ("targets/a.target.gz", Kind::Other),
            ("clothes/a/a.target", Kind::Other),
            ("modifiers/modeling_modifiers.json", Kind::Json),
            ("rigs/default.mhskel", Kind::Skeleton),
            ("rigs/default_weights.mhw", Kind::Weights),
            ("hair/a/a.mhw", Kind::AssetWeights),
            ("expressions/a.mhpose", Kind::Pose),
            ("poses/a.bvh", Kind::Motion),
            ("clothes/a/a.mhpxy", Kind::Packed),
            ("skins/a.mhmat", Kind::Material),
            ("skins/a.thumb", Kind::Image),
        ] {
            let found = LAYOUT.use_of(path);
            assert_eq!((found.kind, found.owner.as_deref()), (kind, Some(HM08)), "{path}");
        }
        assert_eq!(LAYOUT.use_of("targets.npz").owner, None);
    }

    #[test]
    fn a_path_in_a_library_knows_where_its_root_would_be() {
        assert_eq!(LAYOUT.root_above("v1py3/data/hair/bob01/bob01.mhclo"), Some("v1py3/data"));
        assert_eq!(LAYOUT.root_above("v1py3/data/proxymeshes/a"), Some("v1py3/data"));
        assert_eq!(LAYOUT.root_above("v1py3/data/proxy/a"), None);
    }
}
