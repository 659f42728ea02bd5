//! Textures of a material must exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::advice::{Advice, file_name, is_quoted};
use super::blender;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, RuleInfo, grouped,
};
use mhlint_repo::{Layer, Reference, ReferenceKind, Resolution, View, parent};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "ignores the line and shows the material without this texture"), (Makehuman1, "logs an error and shows a placeholder instead of the picture"), (Mpfb, "makes the material without this picture, with a message in the log")],
    docs: "A material names a picture that does not exist, in `diffuseTexture`, `normalmapTexture`, \
        `aomapTexture`, `metallicRoughnessTexture` or `emissiveTexture`. MakeHuman 2 does not know other keywords, \
        such as `specularmapTexture`. A name is one word: it ends at the first space.\n\n\
        MakeHuman 2 silently drops a keyword whose picture it does not find: the surface shows the colour of the \
        material instead, and exports have no texture either. If a keyword has several lines, the last one with a \
        picture wins.\n\n\
        It looks for a picture in the folder of the material; if that ends in `materials`, in the folder above it; \
        then next to the material without the first folder of the name; and finally in the folder of all assets of \
        this kind, such as `clothes/<base>/`, of the system and of the user (`skins/<base>/` for the material of a \
        body).\n\n\
        Materials of skins, of base meshes and below the folders of assets are checked. The folder \
        `clothes/<base>/materials/` is for assets without their own material. A topology uses the skin instead of \
        its own material.\n\nMakeHuman 1 looks for a picture in the folder of the material, then below the data of the user and of the system, and shows a placeholder if it finds none.\n\nMPFB looks in the folder of the material alone; all that is behind the keyword is the name, with spaces and comments. A skin without its picture cannot be used as a layered one (an error).\n\n\
        Correct the name, add the picture, or remove the line. A folder that does not exist is one finding for all \
        pictures in it.",
    ..RuleInfo::new("material-missing-texture", Level::Warning, "a material names a texture that does not exist")
});

const KEPT: Case = &[(Makehuman2, Level::Warning, "silently drops the line and keeps the texture of a line above")];
const COLOUR: Case = &[(Makehuman2, Level::Warning, "ignores the line and shows the plain colour")];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_mpfb() {
        return blender::missing(&RULE, view, cx, out);
    }
    let layers = view.layers();
    let is_missing = |reference: &&Reference<'_>| {
        // The picture of a litsphere has a rule of its own.
        reference.kind == ReferenceKind::Texture
            && reference.owner != "litsphereTexture"
            && matches!(reference.resolution, Resolution::Missing)
            && layers.is_checked(reference.from)
            && !is_quoted(reference.text)
    };
    // However many keywords and materials name it, or name pictures in it.
    let missing = view.references().iter().filter(is_missing);
    let causes = grouped(missing.map(|reference| (cause(layers.checked, reference), reference)));
    if causes.is_empty() {
        return;
    }
    let advice = Advice::of(view);
    let references = view.references().iter().filter(|one| one.kind == ReferenceKind::Texture && one.found().is_some());
    let kept: Kept<'_> = references.map(|one| (one.from.path.as_str(), one.owner)).collect();
    for (cause, references) in causes {
        let help = references.first().map(|first| advice.on(first));
        out.extend(finding(view, &kept, cause, &references).zip(help).map(|(one, help)| one.help(help)));
    }
}

/// The files and their keywords that have a picture in some line.
type Kept<'r> = BTreeSet<(&'r str, &'r str)>;

/// Bytes of the longest path of any system.
const LONGEST_PATH: usize = 4096;

/// What is not there: the picture, or a folder above it.
fn cause<'r>(layer: &Layer, reference: &'r Reference<'_>) -> &'r str {
    // No system has such a path, and going up it takes long.
    if reference.rel.len() > LONGEST_PATH {
        return &reference.rel;
    }
    let path = std::iter::successors(Some(reference.rel.as_str()), |path| Some(parent(path)));
    let absent = path.take_while(|path| !path.is_empty() && layer.below(path).next().is_none());
    absent.last().unwrap_or(&reference.rel)
}

fn finding(view: &View<'_>, kept: &Kept<'_>, cause: &str, references: &[&Reference<'_>]) -> Option<Finding> {
    let first = references.first()?;
    let cases = references.iter().map(|reference| format!("{} {}", reference.from.file_name(), reference.owner));
    let parts = references.iter().map(|reference| (&reference.from.path, reference.place.clone()));
    let parts = cases.clone().zip(parts).map(|(case, (path, place))| (case, path, place));
    let asset = view.layers().checked.display(parent(cause));
    let finding = RULE.at(first.from, first.place.clone(), message(cause, first, references));
    let finding = finding.key(file_name(cause)).asset(asset).parts_at(parts).evidence(Evidence::of_cases(cases));
    let is_kept = |reference: &&Reference<'_>| kept.contains(&(reference.from.path.as_str(), reference.owner));
    Some(if references.iter().all(is_kept) {
        finding.case(KEPT)
    } else if references.iter().any(|reference| reference.owner == "diffuseTexture") {
        finding.case(COLOUR)
    } else {
        finding
    })
}

fn message(cause: &str, first: &Reference<'_>, references: &[&Reference<'_>]) -> String {
    let materials: BTreeSet<&str> = references.iter().map(|reference| reference.from.path.as_str()).collect();
    let pictures: BTreeSet<&str> = references.iter().map(|reference| reference.rel.as_str()).collect();
    let texture = format!("texture `{}` of `{}` does not exist", first.text, first.owner);
    match (pictures.len(), materials.len()) {
        (1, 1) => texture,
        (1, count) => format!("{texture} ({count} materials name it)"),
        (count, _) => format!("folder `{}` of {count} textures does not exist", file_name(cause)),
    }
}
