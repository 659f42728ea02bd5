//! Textures of a material must exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::advice::{Advice, is_quoted};
use super::blender;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, RuleInfo, grouped,
};
use mhlint_repo::{Layer, Reference, ReferenceKind, Resolution, View};
use mhlint_source::{file_name, parent};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "ignores the line and shows the material without this texture",
        ),
        (
            Makehuman1,
            "logs an error and shows a placeholder instead of the picture",
        ),
        (
            Mpfb,
            "makes the material without this picture, with a message in the log",
        ),
    ],
    docs: include_str!("missing_texture.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-missing-texture",
        Level::Warning,
        "a material names a texture that does not exist",
    )
});

const KEPT: Case = &[(
    Makehuman2,
    Level::Warning,
    "silently drops the line and keeps the texture of a line above",
)];
const COLOUR: Case = &[(
    Makehuman2,
    Level::Warning,
    "ignores the line and shows the plain colour",
)];

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
    let references = view
        .references()
        .iter()
        .filter(|one| one.kind == ReferenceKind::Texture && one.found().is_some());
    let kept: Kept<'_> = references
        .map(|one| (one.from.path.as_str(), one.owner))
        .collect();
    for (cause, references) in causes {
        let help = references.first().map(|first| advice.on(first));
        out.extend(
            finding(view, &kept, cause, &references)
                .zip(help)
                .map(|(one, help)| one.help(help)),
        );
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

fn finding(
    view: &View<'_>,
    kept: &Kept<'_>,
    cause: &str,
    references: &[&Reference<'_>],
) -> Option<Finding> {
    let first = references.first()?;
    let cases = references
        .iter()
        .map(|reference| format!("{} {}", reference.from.file_name(), reference.owner));
    let parts = references
        .iter()
        .map(|reference| (&reference.from.path, reference.place.clone()));
    let parts = cases
        .clone()
        .zip(parts)
        .map(|(case, (path, place))| (case, path, place));
    let asset = view.layers().checked.display(parent(cause));
    let finding = RULE.at(
        first.from,
        first.place.clone(),
        message(cause, first, references),
    );
    let finding = finding
        .key(file_name(cause))
        .asset(asset)
        .parts_at(parts)
        .evidence(Evidence::of_cases(cases));
    let is_kept = |reference: &&Reference<'_>| {
        kept.contains(&(reference.from.path.as_str(), reference.owner))
    };
    Some(if references.iter().all(is_kept) {
        finding.case(KEPT)
    } else if references
        .iter()
        .any(|reference| reference.owner == "diffuseTexture")
    {
        finding.case(COLOUR)
    } else {
        finding
    })
}

fn message(cause: &str, first: &Reference<'_>, references: &[&Reference<'_>]) -> String {
    let materials: BTreeSet<&str> = references
        .iter()
        .map(|reference| reference.from.path.as_str())
        .collect();
    let pictures: BTreeSet<&str> = references
        .iter()
        .map(|reference| reference.rel.as_str())
        .collect();
    let texture = format!(
        "texture `{}` of `{}` does not exist",
        first.text, first.owner
    );
    match (pictures.len(), materials.len()) {
        (1, 1) => texture,
        (1, count) => format!("{texture} ({count} materials name it)"),
        (count, _) => format!(
            "folder `{}` of {count} textures does not exist",
            file_name(cause)
        ),
    }
}
