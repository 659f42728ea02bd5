//! Textures of a material must exist.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use super::advice::{Advice, file_name};
use crate::diag::{Application, Case, Evidence, Finding, Level, RuleInfo};
use crate::repo::{Layer, Reference, ReferenceKind, Resolution, View, parent};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "drops the keyword without a message and goes without this texture")],
        docs: "`diffuseTexture`, `normalmapTexture`, `aomapTexture`, `metallicRoughnessTexture` and `emissiveTexture` name a \
            picture. MakeHuman 2 drops a keyword whose picture it does not find, without a message: the surface has the colour \
            of the material where its texture should be, and exports go without it as well.\n\nA picture is looked for in the \
            folder of the material; in the folder above, if that one is called `materials`; without the first folder of its name, \
            again beside the material; and last in the folder of all such assets, `clothes/<base>/` say, of the system and of \
            the user (`skins/<base>/` for the material of a body). A name is one word: it ends at the first blank.\n\n\
            Where a keyword has several lines, the last with a picture wins.\n\nLooked at are materials of skins, of base meshes, and below \
            the folders of assets; the folder `clothes/<base>/materials/` is for assets without a material of their own. A topology wears \
            the skin. Other keywords, such as `specularmapTexture`, are not known to MakeHuman 2.\n\nCorrect the name, add the picture, or \
            remove the line. A folder that does not exist is one finding for all pictures that are looked for in it.",
        ..RuleInfo::new("material-missing-texture", Level::Warning, "a material names a texture that does not exist")
    },
    check: Check::Repository(run),
};

const KEPT: Case = &[(
    Application::Makehuman2,
    Level::Warning,
    "drops the line without a message and keeps the texture of a line above",
)];
const COLOUR: Case =
    &[(Application::Makehuman2, Level::Warning, "drops the keyword without a message and shows the colour instead")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let is_missing = |reference: &&Reference<'_>| {
        reference.kind == ReferenceKind::Texture
            && matches!(reference.resolution, Resolution::Missing)
            && layers.is_checked(reference.from)
    };
    // However many keywords and materials name it, or name pictures in it.
    let mut causes: BTreeMap<&str, Vec<&Reference<'_>>> = BTreeMap::new();
    for reference in view.references().iter().filter(is_missing) {
        causes.entry(cause(layers.checked, reference)).or_default().push(reference);
    }
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

/// What is not there: the picture, or a folder above it.
fn cause<'r>(layer: &Layer, reference: &'r Reference<'_>) -> &'r str {
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
    let texture = format!("the texture `{}` of `{}` does not exist", first.text, first.owner);
    match (pictures.len(), materials.len()) {
        (1, 1) => texture,
        (1, count) => format!("{texture} ({count} materials name it)"),
        (count, _) => format!("the folder `{}` of {count} textures does not exist", file_name(cause)),
    }
}
