//! A texture that gets other colours must be stored with 32 bits a pixel.

use super::super::{Check, Rule, RuleCx};
use super::loader;
use super::picture::is_readable;
use mhlint_diag::{Application::Makehuman2, Finding, Level, RuleInfo};
use mhlint_formats::picture::Pixels;
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `TypeError` when the material is used",
    )],
    docs: include_str!("coloration_texture.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-coloration-texture",
        Level::Error,
        "a texture that cannot be given other colours",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file));
    for surface in own.filter(|surface| loader::is_coloured(surface)) {
        let texture = surface.picture("diffuseTexture");
        let Some((picture, file)) =
            texture.and_then(|one| Some((one, one.file.filter(|file| is_readable(file))?)))
        else {
            continue;
        };
        let Some(stored) = file
            .picture()
            .and_then(|picture| picture.pixels)
            .and_then(unfit)
        else {
            continue;
        };
        let message = format!(
            "`colorationMethod` cannot colour `{}`: it is stored {stored}",
            file.file_name()
        );
        let finding = RULE
            .at(surface.file, picture.place.clone(), message)
            .key("diffuseTexture");
        let effect = format!(
            "crashes with `TypeError` {}; {}",
            loader::when(surface),
            loader::models(surface)
        );
        let help = "save the picture as RGB, or as RGBA if parts are transparent, with 8 bits per \
            channel; or write `colorationMethod 0`";
        out.push(finding.effect_in(view.application(), effect).help(help));
    }
}

/// How pixels are stored that have not 32 bits once they are read.
const fn unfit(pixels: Pixels) -> Option<&'static str> {
    match pixels {
        Pixels::Grey { bits: 16, .. } => Some("in grey of 16 bits"),
        Pixels::Grey { keyed: false, .. } => Some("in shades of grey"),
        Pixels::Palette => Some("with a palette"),
        Pixels::Channels {
            bits: 16,
            colour: true,
        } => Some("with 16 bits a channel"),
        Pixels::Grey { .. } | Pixels::Channels { .. } => None,
    }
}
