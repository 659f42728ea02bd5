//! A texture and a colour beside it.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, RuleInfo,
};
use mhlint_formats::mhmat::Line;
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows the texture without the colour, on screen and in glTF; the OBJ export \
            writes both",
        ),
        (
            Makehuman1,
            "hands both to the shader, which may tint the texture with the colour",
        ),
    ],
    docs: include_str!("tinted_texture.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-tinted-texture",
        Level::Info,
        "a texture beside a diffuse colour \
        that is not white",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file));
    let tinted: Vec<(&Surface<'_>, &Line)> = own
        .filter_map(|surface| Some((surface, tint(view, surface)?)))
        .collect();
    let Some((first, line)) = tinted.first() else {
        return;
    };
    let message = match tinted.len() {
        1 => "`diffuseColor` is not white beside `diffuseTexture`".to_owned(),
        count => format!(
            "{} have a `diffuseColor` beside `diffuseTexture`",
            counted(count, "material")
        ),
    };
    let finding = RULE.at(first.file, Surface::place(line), message);
    let parts = tinted.iter().map(|(surface, line)| {
        (
            surface.file.shown(),
            &surface.file.path,
            Surface::place(line),
        )
    });
    let finding = finding.parts_at(parts).evidence(Evidence::of_cases(
        tinted.iter().map(|(one, _)| one.file.shown()),
    ));
    out.push(finding.help(if view.is_makehuman1() {
        "write `diffuseColor 1.0 1.0 1.0` to show the texture as it is; if the tint is wanted, \
            put it into the picture"
    } else {
        "write `diffuseColor 1.0 1.0 1.0` to keep the look that MakeHuman 2 shows; there only \
            exported OBJ files change"
    }));
}

/// The line of the colour, if the texture is there and it is not white.
fn tint<'s>(view: &View<'_>, surface: &'s Surface<'_>) -> Option<&'s Line> {
    let line = surface
        .material
        .last("diffuseColor")
        .filter(|line| line.count == 3)?;
    let is_white = (0..3).all(|at| {
        line.number_at(at)
            .is_none_or(|part| (part - 1.0).abs() < 1e-3)
    });
    // What is outside that has a finding of its own.
    let is_colour = (0..3).all(|at| {
        line.number_at(at)
            .is_some_and(|part| (0.0..=1.0).contains(&part))
    });
    let asks = || {
        surface
            .shader
            .as_ref()
            .is_some_and(|shader| shader.uniform("diffuse").is_some())
    };
    let is_used = !view.is_makehuman1() || asks();
    (surface.has("diffuseTexture") == Some(true) && is_colour && !is_white && is_used)
        .then_some(line)
}
