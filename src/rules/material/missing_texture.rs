//! Textures of a material must exist.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, did_you_mean};
use crate::diag::{Application, Evidence, Extent, Finding, Level, Place, RuleInfo, Suggestions};
use crate::discover::{Kind, extension};
use crate::formats::mhmat::Texture;
use crate::repo::{FileFacts, Reference, ReferenceKind, Resolution, View, parent};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        extent: Some(Extent::Base),
        breaks: &[(Application::Makehuman2, "drops the keyword without a message and goes without this texture")],
        docs: "`diffuseTexture`, `normalmapTexture`, `aomapTexture`, `metallicRoughnessTexture` and `emissiveTexture` name a \
            picture. MakeHuman 2 drops a keyword whose picture it does not find, without a message: the surface has the colour \
            of the material where its texture should be, and exports go without it as well.\n\nA picture is looked for in the \
            folder of the material; in the folder above, if that one is called `materials`; without the first folder of its name, \
            again beside the material; and last in the folder of all such assets, `clothes/<base>/` say, of the system and of \
            the user (`skins/<base>/` for the material of a body). A name is one word: it ends at the first blank.\n\n\
            Looked at are materials of skins, of base meshes, and below folders with an asset in them. Other keywords, such as \
            `specularmapTexture`, are not known to MakeHuman 2.\n\nCorrect the name, add the picture, or remove the line.",
        ..RuleInfo::new("material-missing-texture", Level::Warning, "a material names a texture that does not exist")
    },
    check: Check::Repository(run),
};

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let suggestions = Suggestions::default();
    let is_missing = |reference: &&Reference<'_>| {
        reference.kind == ReferenceKind::Texture
            && matches!(reference.resolution, Resolution::Missing)
            && layers.is_checked(reference.from)
    };
    // A name is one cause, however many keywords have it.
    let mut causes: BTreeMap<(&str, &str), Vec<&Reference<'_>>> = BTreeMap::new();
    for reference in view.references().iter().filter(is_missing) {
        causes.entry((&reference.from.path, reference.text)).or_default().push(reference);
    }
    for references in causes.into_values() {
        let Some(first) = references.first() else { continue };
        let keywords = references.iter().map(|reference| reference.owner);
        let message = format!("the texture `{}` of `{}` does not exist", first.text, first.owner);
        let finding = RULE.at(first.from, first.place.clone(), message).key(first.text);
        let finding = finding.help(help(view, first, &suggestions)).evidence(Evidence::of_cases(keywords.clone()));
        let is_colour = keywords.into_iter().any(|keyword| keyword == "diffuseTexture");
        let effect = "drops the keyword without a message and shows the colour instead";
        out.push(if is_colour { finding.effect(effect) } else { finding });
    }
}

fn help(view: &View<'_>, reference: &Reference<'_>, suggestions: &Suggestions) -> String {
    if let Some(name) = with_blanks(reference) {
        return format!("a name ends at the first blank: rename `{name}` without any, and write that");
    }
    did_you_mean(nearest(view, reference, suggestions), "correct the name, add the picture, or remove the line")
}

/// The whole name, where the one that is looked for ends too early.
fn with_blanks(reference: &Reference<'_>) -> Option<String> {
    let is_it = |texture: &&Texture| reference.place == Place::Span(texture.span.clone());
    let texture = reference.from.material()?.textures.iter().find(is_it)?;
    let is_name = texture.lost.contains('.') && !extension(&texture.lost).contains(' ');
    (is_name && !texture.word.contains('.')).then(|| format!("{} {}", texture.word, texture.lost))
}

/// The picture below the folder of the material, or the one above, that is most like it and that no texture is yet.
fn nearest<'a>(view: &'a View<'_>, reference: &Reference<'_>, suggestions: &Suggestions) -> Option<&'a str> {
    let layer = view.layers().checked;
    let own = parent(&reference.from.rel);
    let folder = if own.ends_with("materials") { parent(own) } else { own };
    let is_free = |file: &&FileFacts| is_picture(file) && view.references().to_file(file).next().is_none();
    let free = layer.below(folder).filter(is_free);
    let names = free.filter_map(|file| {
        let below = |folder: &str| file.rel.strip_prefix(folder)?.strip_prefix('/');
        below(own).or_else(|| below(folder))
    });
    suggestions.nearest(reference.text, names)
}

fn is_picture(file: &FileFacts) -> bool {
    matches!(file.kind, Kind::Image | Kind::Other) && extension(&file.rel) != "thumb"
}
