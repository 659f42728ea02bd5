//! Textures must have an effect.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, RuleInfo, nearest};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "multiplies the texture by 0: nothing glows, on screen and in exports",
    )],
    docs: include_str!("unused_texture.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-unused-texture",
        Level::Warning,
        "a texture without effect",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let glow = surface
            .picture("emissiveTexture")
            .filter(|picture| picture.file.is_some());
        let Some(glow) = glow.filter(|_| surface.material.last("emissiveFactor").is_none()) else {
            continue;
        };
        // One that is misspelt, or called as elsewhere, has a finding of its own.
        let is_meant = |word: &str| nearest(word, ["emissiveFactor"]).is_some();
        let misspelt = surface
            .material
            .unknown
            .iter()
            .any(|one| is_meant(&one.word.text));
        if misspelt || surface.material.last("emissionIntensity").is_some() {
            continue;
        }
        let message = "`emissiveTexture` has no effect without `emissiveFactor`";
        let finding = RULE
            .at(surface.file, glow.place.clone(), message)
            .key("emissiveTexture");
        out.push(finding.help("add `emissiveFactor 1.0`, or remove the line; keep the picture"));
    }
}
