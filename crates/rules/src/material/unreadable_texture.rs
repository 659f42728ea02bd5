//! Pictures that materials name must be pictures.

use std::collections::BTreeMap;

use super::super::cause::consequence::NO_FRAME;
use super::super::{Check, Rule, RuleCx};
use super::blender;
use super::picture::{fault, is_something_else};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Single;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows the surface without this picture, and copies the broken file into exports",
        ),
        (
            Makehuman1,
            "logs an error and shows a placeholder instead of the picture",
        ),
        (Mpfb, "loads it as a broken picture, without a message"),
    ],
    docs: include_str!("unreadable_texture.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-unreadable-texture",
        Level::Warning,
        "a texture that is not a picture",
    )
});

const BLENDED: Case = &[(Makehuman1, Level::Error, NO_FRAME)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_mpfb() {
        return blender::unreadable(&RULE, view, out);
    }
    let mut named: BTreeMap<&str, (&FileFacts, Vec<String>)> = BTreeMap::new();
    let is_blended =
        |file: &FileFacts| (view.layout().single)(&file.rel) == Some(Single::SkinPicture);
    for file in view.files().filter(|file| is_blended(file)) {
        named.insert(&file.path, (file, vec!["the default skin".to_owned()]));
    }
    for surface in view.surfaces() {
        for (keyword, _, file) in surface
            .found()
            .filter(|(_, _, file)| view.layers().is_checked(file))
        {
            let cases = &mut named.entry(&file.path).or_insert((file, Vec::new())).1;
            cases.push(format!("{} {keyword}", surface.file.file_name()));
        }
    }
    for (file, cases) in named.into_values() {
        let Some(message) = fault(file) else { continue };
        let finding = RULE
            .at(file, Place::File, message)
            .evidence(Evidence::of_unnamed(cases));
        let finding = if is_blended(file) {
            finding.case(BLENDED)
        } else {
            finding
        };
        out.push(finding.help(if is_something_else(file.kind) {
            "name a picture in the material"
        } else {
            "export it again as PNG, or restore it"
        }));
    }
}
