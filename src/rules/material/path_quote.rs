//! Quotes belong to the name of a picture.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use crate::repo::{FileFacts, ReferenceKind, Resolution, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "takes the quotes for a part of the name, and silently drops the keyword")],
    docs: "A material names a picture in quotes. They are no marks around the name but a part of it: no file is called so. \
        A name ends at the first space, in quotes as well.\n\n\
        MakeHuman 2 does not find the picture and shows the colour of the material instead.\n\n\
        Remove the quotes. If the name has a space, rename the picture.",
    ..RuleInfo::new("material-path-quote", Level::Warning, "a name of a picture in quotes")
});

const QUOTES: [char; 8] = ['"', '\'', '`', '\u{201c}', '\u{201d}', '\u{201e}', '\u{2018}', '\u{2019}'];

/// Whether a name begins or ends with a quote.
pub(super) fn is_quoted(text: &str) -> bool {
    text.starts_with(QUOTES) || text.ends_with(QUOTES)
}

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let textures = view.references().iter().filter(|one| one.kind == ReferenceKind::Texture && one.meant().is_none());
    let textures = textures.filter(|one| !matches!(one.resolution, Resolution::NeedsSystem));
    for one in textures.filter(|one| is_quoted(one.text) && layers.is_checked(one.from)) {
        let texture = one
            .from
            .material()
            .and_then(|material| material.textures.iter().find(|own| is_at(&one.place, own.span.start)));
        let lost = texture.map_or("", |texture| &texture.lost);
        out.push(finding(one.from, &one.place, one.text, lost, one.owner));
    }
    for surface in view.surfaces().iter().filter(|surface| layers.is_checked(surface.file)) {
        let litsphere = surface.litsphere.iter().filter(|one| one.file.is_none() && is_quoted(one.text));
        out.extend(litsphere.map(|one| finding(surface.file, &one.place, one.text, "", "litsphereTexture")));
    }
}

fn is_at(place: &Place, start: usize) -> bool {
    matches!(place, Place::Span(span) if span.start == start)
}

fn finding(file: &FileFacts, place: &Place, text: &str, lost: &str, keyword: &str) -> Finding {
    let whole = if lost.is_empty() { text.to_owned() } else { format!("{text} {lost}") };
    let plain = whole.trim_matches(QUOTES);
    let shown: String = whole.chars().take(60).collect();
    let message = format!("`{keyword}` has its name in quotes: `{shown}`");
    let help = if plain.contains(' ') {
        format!("rename `{plain}` without spaces, and write that name without quotes")
    } else {
        format!("write `{plain}`")
    };
    RULE.at(file, place.clone(), message).key(keyword).help(help)
}
