//! The material of an asset must be found.

use super::super::{Check, Rule, RuleCx, did_you_mean, meant_beside};
use super::{Text, blender, is_unwalked, lone_archives, neighbours, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_repo::{Body, Reference, ReferenceKind, Resolution};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "silently shows the asset in plain white"),
        (
            Makehuman1,
            "draws the asset with the default white material",
        ),
        (
            Mpfb,
            "fails with `FileNotFoundError` when it puts the asset on with a material",
        ),
    ],
    levels: &[(Mpfb, Level::Error)],
    docs: include_str!("missing_material.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-missing-material",
        Level::Warning,
        "the material of an asset does not exist",
    )
});

/// It is read as a text, whatever it is.
const PICTURE: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "shows the asset in plain white until a material is chosen",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: it cannot read the file as a material",
    ),
];
const NONE: Case = &[(
    Makehuman2,
    Level::Warning,
    "shows the asset in plain white until a material is chosen",
)];

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::names::material(&RULE, body, cx, out);
    }
    for text in texts(body).filter(|text| !text.worn.is_topology()) {
        out.extend(match text.worn.reference(ReferenceKind::AssetMaterial) {
            Some(reference) => absent(body, &text, reference, cx),
            None => unnamed(body, &text),
        });
    }
    for archive in
        lone_archives(body).filter(|archive| !archive.worn.is_topology() && !archive.has_moved())
    {
        let reference = archive.worn.reference(ReferenceKind::AssetMaterial);
        let Some(reference) = reference.filter(|one| matches!(one.resolution, Resolution::Missing))
        else {
            continue;
        };
        let message = format!(
            "material `{}` of the archive does not exist",
            reference.text
        );
        let finding = RULE
            .at(archive.file, Place::File, message)
            .key(reference.text);
        out.push(finding.help(
            "add the material where the archive looks for it, or get the asset again \
                from its source",
        ));
    }
}

fn absent(
    body: &Body<'_>,
    text: &Text<'_, '_>,
    reference: &Reference<'_>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let what = match reference.resolution {
        Resolution::Missing => "does not exist",
        Resolution::Unusable if !is_unwalked(body, reference) => "cannot be opened as a file",
        Resolution::Found(file) if file.kind != Kind::Material => "is not a `.mhmat` file",
        _ => return None,
    };
    let message = format!("material `{}` {what}", reference.text);
    let near = cx
        .suggestions
        .nearest(reference.text, neighbours(body, text, "mhmat"));
    let whole = text.reading.last("material").map(|entry| &*entry.value);
    let help = meant_beside(body.layers.checked, &reference.rel, whole);
    let help = help.unwrap_or_else(|| did_you_mean(near, "correct the name, or add the material"));
    let finding = RULE
        .at(text.file, reference.place.clone(), message)
        .key(reference.text)
        .help(help);
    let is_picture =
        matches!(reference.resolution, Resolution::Found(file) if file.kind == Kind::Image);
    Some(if is_picture {
        finding.case(PICTURE)
    } else {
        finding
    })
}

/// A misspelt keyword has a finding of its own, and one in front of which a mark stands.
fn unnamed(body: &Body<'_>, text: &Text<'_, '_>) -> Option<Finding> {
    if text.misspelt("material").is_some() || text.has_hidden("material") {
        return None;
    }
    // MakeHuman 1 stops at a line without a value (`proxy-syntax`).
    if text.is_makehuman1() && text.reading.stops() {
        return None;
    }
    let help = match neighbours(body, text, "mhmat").first() {
        Some(name) => format!("add a line `material {name}`"),
        None => "add a line `material` with the name of a material".to_owned(),
    };
    Some(
        RULE.at(text.file, Place::File, "no `material` is named")
            .key("material")
            .case(NONE)
            .help(help),
    )
}
