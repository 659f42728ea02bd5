//! Quotes belong to the name of a picture.

use super::super::{Check, Rule, RuleCx, shown};
use super::advice::{QUOTES, is_quoted};
use super::blender;
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{Reference, ReferenceKind, Resolution, Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "reads the quotes as part of the name, and ignores the line",
        ),
        (
            Makehuman1,
            "reads the quotes as part of the name and shows a placeholder",
        ),
        (Mpfb, "fails with an exception when it makes the material"),
    ],
    levels: &[(Mpfb, Level::Error)],
    docs: include_str!("path_quote.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-path-quote",
        Level::Warning,
        "a name of a picture in quotes",
    )
});

const LITSPHERE: &str = "litsphereTexture";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_mpfb() {
        return blender::quotes(&RULE, view, out);
    }
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let is_own = |one: &&Reference<'_>| one.owner != LITSPHERE && is_lost(one);
        let textures = view.references().of_file(surface.file).filter(is_own);
        let textures =
            textures.map(|one| fault(surface, &one.place, one.text, lost(one), one.owner));
        let litsphere = surface
            .litsphere
            .iter()
            .filter(|one| one.file.is_none() && is_quoted(one.text));
        let litsphere = litsphere.map(|one| fault(surface, &one.place, one.text, "", LITSPHERE));
        report(
            &RULE,
            surface,
            textures.chain(litsphere).collect(),
            "name pictures in quotes",
            out,
        );
    }
}

fn is_lost(one: &Reference<'_>) -> bool {
    let is_texture = one.kind == ReferenceKind::Texture && one.meant().is_none();
    is_texture && !matches!(one.resolution, Resolution::NeedsSystem) && is_quoted(one.text)
}

/// What stands behind the first word of the name.
fn lost<'a>(one: &Reference<'a>) -> &'a str {
    let (Some(material), Place::Span(span)) = (one.from.material(), &one.place) else {
        return "";
    };
    // They stand in the order of the file.
    let at = material
        .textures
        .partition_point(|texture| texture.span.start < span.start);
    material
        .textures
        .get(at)
        .filter(|texture| texture.span == *span)
        .map_or("", |texture| &texture.lost)
}

fn fault(surface: &Surface<'_>, place: &Place, text: &str, lost: &str, keyword: &str) -> Fault {
    let whole = if lost.is_empty() {
        text.to_owned()
    } else {
        format!("{text} {lost}")
    };
    let plain = whole.trim_matches(QUOTES);
    let shown = shown(&whole);
    Fault {
        key: keyword.to_owned(),
        place: place.clone(),
        level: Level::Warning,
        message: format!("`{keyword}` has its name in quotes: `{shown}`"),
        effect: match keyword {
            _ if loader::is_1(surface.application) => {
                "reads the quotes as part of the name and \
                shows a placeholder"
            }
            LITSPHERE => {
                "reads the quotes as part of the name, and silently draws the surface \
                with the shader `phong`"
            }
            _ => "reads the quotes as part of the name, and ignores the line",
        }
        .to_owned(),
        help: if plain.contains(' ') {
            format!("rename `{plain}` without spaces, and write that name without quotes")
        } else {
            format!("write `{plain}`")
        },
    }
}
