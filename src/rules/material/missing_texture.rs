//! Textures of a material must exist.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, did_you_mean};
use crate::diag::{Application, Case, Evidence, Extent, Finding, Level, Place, RuleInfo, Suggestions};
use crate::discover::extension;
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
            Looked at are materials of skins, of base meshes, and below folders with an asset in them; a topology wears the skin. Other keywords, such as \
            `specularmapTexture`, are not known to MakeHuman 2.\n\nCorrect the name, add the picture, or remove the line.",
        ..RuleInfo::new("material-missing-texture", Level::Warning, "a material names a texture that does not exist")
    },
    check: Check::Repository(run),
};

const COLOUR: Case =
    &[(Application::Makehuman2, Level::Warning, "drops the keyword without a message and shows the colour instead")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let suggestions = Suggestions::default();
    let is_missing = |reference: &&Reference<'_>| {
        reference.kind == ReferenceKind::Texture
            && matches!(reference.resolution, Resolution::Missing)
            && layers.is_checked(reference.from)
    };
    // A name is one cause, however many keywords and materials of a folder have it.
    let mut causes: BTreeMap<(&str, &str), Vec<&Reference<'_>>> = BTreeMap::new();
    for reference in view.references().iter().filter(is_missing) {
        causes.entry((parent(&reference.from.rel), reference.text)).or_default().push(reference);
    }
    for ((folder, _), references) in causes {
        let help = references.first().map(|first| help(view, first, &suggestions));
        out.extend(finding(&references, &layers.checked.display(folder)).zip(help).map(|(one, help)| one.help(help)));
    }
}

fn finding(references: &[&Reference<'_>], folder: &str) -> Option<Finding> {
    let first = references.first()?;
    let materials: BTreeSet<&str> = references.iter().map(|reference| reference.from.path.as_str()).collect();
    let more = match materials.len() {
        1 => String::new(),
        count => format!(" ({count} materials here name it)"),
    };
    let message = format!("the texture `{}` of `{}` does not exist{more}", first.text, first.owner);
    let cases = references.iter().map(|reference| format!("{} {}", reference.from.file_name(), reference.owner));
    let parts = cases.clone().zip(references.iter().map(|reference| &reference.from.path));
    let finding = RULE.at(first.from, first.place.clone(), message).key(first.text).asset(folder).parts_in(parts);
    let finding = finding.evidence(Evidence::of_cases(cases));
    let is_colour = references.iter().any(|reference| reference.owner == "diffuseTexture");
    Some(if is_colour { finding.case(COLOUR) } else { finding })
}

fn help(view: &View<'_>, reference: &Reference<'_>, suggestions: &Suggestions) -> String {
    let pictures = pictures(view, reference);
    if let Some(name) = with_blanks(reference).filter(|name| pictures.iter().any(|(other, _)| other == name)) {
        return format!("a name ends at the first blank: rename `{name}` without any, and write that");
    }
    let is_free = |file: &FileFacts| view.references().to_file(file).next().is_none();
    // What cannot be written as a name, or is no picture, is not what is meant.
    let is_name = |name: &str| !name.contains([' ', char::REPLACEMENT_CHARACTER]);
    let names = pictures.iter().filter(|(name, file)| is_name(name) && is_free(file)).map(|(name, _)| *name);
    did_you_mean(suggestions.nearest(reference.text, names), "correct the name, add the picture, or remove the line")
}

/// The whole name, where the one that is looked for may end too early.
fn with_blanks(reference: &Reference<'_>) -> Option<String> {
    let is_it = |texture: &&Texture| reference.place == Place::Span(texture.span.clone());
    let texture = reference.from.material()?.textures.iter().find(is_it)?;
    (!texture.lost.is_empty()).then(|| format!("{} {}", texture.word, texture.lost).replace('"', ""))
}

/// The pictures below the folder of the material, or the one above, by the names that the material would write.
fn pictures<'a>(view: &View<'a>, reference: &Reference<'_>) -> Vec<(&'a str, &'a FileFacts)> {
    let own = parent(&reference.from.rel);
    let folder = if own.ends_with("materials") { parent(own) } else { own };
    let pictures = view.layers().checked.below(folder).filter(|file| is_picture(file));
    let named = pictures.filter_map(|file| {
        let below = |folder: &str| file.rel.strip_prefix(folder)?.strip_prefix('/');
        Some((below(own).or_else(|| below(folder))?, file))
    });
    named.collect()
}

/// Extensions of pictures that MakeHuman 2 can show, in small letters.
const PICTURES: [&str; 10] = ["bmp", "gif", "jpeg", "jpg", "png", "svg", "tga", "tif", "tiff", "webp"];

fn is_picture(file: &FileFacts) -> bool {
    PICTURES.contains(&extension(&file.rel).to_lowercase().as_str())
}
