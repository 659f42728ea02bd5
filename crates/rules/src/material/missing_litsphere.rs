//! A litsphere needs its picture.

use super::super::{Check, Rule, RuleCx, shown};
use super::advice::is_quoted;
use super::loader;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, RuleInfo, grouped,
};
use mhlint_repo::{Picture, Resolution, Surface, View};
use mhlint_source::file_name;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "silently draws the surface with the shader `phong`",
        ),
        (
            Makehuman1,
            "logs an error and draws the surface with a placeholder",
        ),
    ],
    docs: include_str!("missing_litsphere.md").trim_ascii_end(),
    of_whole: true,
    ..RuleInfo::new(
        "material-missing-litsphere",
        Level::Warning,
        "a litsphere without its picture",
    )
});

const STOPS: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `TypeError` when the material is used: without a `name` it cannot log the fault",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file));
    let mut missing = Vec::new();
    // What is blended stands in for the picture of the line.
    let is_blended = |surface: &Surface<'_>| {
        loader::is_1(surface.application) && surface.is_true("autoBlendSkin")
    };
    for surface in
        own.filter(|surface| loader::shader(surface) == "litsphere" && !is_blended(surface))
    {
        match &surface.litsphere {
            Some(picture) if is_told(view, surface, picture) => {}
            Some(picture)
                if picture.file.is_none() && !picture.is_open && !is_quoted(picture.text) =>
            {
                missing.push((file_name(picture.text), (surface, picture)));
            }
            Some(_) => {}
            None if loader::is_1(surface.application) => {}
            None => out.extend(unnamed(surface)),
        }
    }
    for (name, surfaces) in grouped(missing) {
        out.extend(finding(name, &surfaces));
    }
}

/// Whether the name leads to a file but for its capitals or backslashes, which is reported as such.
fn is_told(view: &View<'_>, surface: &Surface<'_>, picture: &Picture<'_>) -> bool {
    let mut references = view
        .references()
        .of_file(surface.file)
        .filter(|one| one.place == picture.place);
    references.any(|one| !matches!(one.resolution, Resolution::Missing | Resolution::Found(_)))
}

fn unnamed(surface: &Surface<'_>) -> Option<Finding> {
    // A parameter without a value stops the loader before that.
    let is_cut = surface
        .material
        .lines_of("shaderParam")
        .any(|line| line.count < 2);
    // The old keyword has a finding of its own.
    let is_old = surface.material.last("litsphereTexture").is_some();
    let line = surface
        .material
        .last("shader")
        .filter(|_| !is_cut && !is_old)?;
    let message = "shader `litsphere` has no `shaderParam litsphereTexture`";
    let finding = RULE
        .at(surface.file, Surface::place(line), message)
        .key("litsphereTexture");
    Some(finding.help("add a line `shaderParam litsphereTexture` with the name of the picture"))
}

/// However many materials name the picture.
fn finding(name: &str, surfaces: &[(&Surface<'_>, &Picture<'_>)]) -> Option<Finding> {
    let stops = |surface: &Surface<'_>| surface.material.last("name").is_none();
    let (first, picture) = surfaces
        .iter()
        .find(|(surface, _)| stops(surface))
        .or(surfaces.first())?;
    let text = shown(name);
    let more = if surfaces.len() > 1 {
        format!(" ({} materials name it)", surfaces.len())
    } else {
        String::new()
    };
    let message = format!("litsphere `{text}` does not exist{more}");
    let finding = RULE
        .at(first.file, picture.place.clone(), message)
        .key(text);
    let parts = surfaces
        .iter()
        .map(|(one, picture)| (one.file.file_name(), &one.file.path, picture.place.clone()));
    let names = surfaces.iter().map(|(surface, _)| surface.file.file_name());
    let finding = finding.parts_at(parts).evidence(Evidence::of_cases(names));
    let folder = if loader::is_1(first.application) {
        "litspheres/"
    } else {
        "shaders/litspheres/"
    };
    let finding = finding.help(format!(
        "use a picture of `{folder}`, or put this one there"
    ));
    Some(if stops(first) {
        finding.case(STOPS)
    } else {
        finding
    })
}
