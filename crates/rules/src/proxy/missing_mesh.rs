//! The mesh of an asset must be found.

use super::super::{Check, Rule, RuleCx, did_you_mean, meant_beside};
use super::{
    Text, blender, is_unwalked, lone_archives, missing::missing, neighbours, packed_proxy, texts,
};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::{Body, Reference, ReferenceKind, Resolution};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "refuses the asset with a message: it cannot be put on",
        ),
        (Makehuman1, "does not put the asset on"),
        (Mpfb, "fails with `OSError` when the asset is loaded"),
    ],
    docs: include_str!("missing_mesh.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-missing-mesh",
        Level::Error,
        "the mesh of an asset does not exist",
    )
});

const NO_LINE: Case = &[
    (
        Makehuman2,
        Level::Error,
        "crashes with `AttributeError` when the asset is put on; models that wear it load only in \
            part",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: `TypeError`, as there is no name to open",
    ),
];
const PACKED: Case = &[(
    Makehuman2,
    Level::Info,
    "loads the `.mhbin` beside it, as long as the text is not newer",
)];

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::names::mesh(&RULE, body, cx, out);
    }
    out.extend(lone_archives(body).filter_map(|archive| packed_proxy::mesh(&RULE, body, &archive)));
    // MakeHuman 1 reads the archive of a mesh, be the OBJ there or not.
    for text in texts(body).filter(|text| text.worn.packed_mesh.is_none()) {
        let finding = match text.worn.reference(ReferenceKind::AssetMesh) {
            Some(reference) => absent(body, &text, reference, cx),
            None => {
                missing(&text, "obj_file", "file name of the mesh").map(|(place, message, help)| {
                    RULE.at(text.file, place, message).case(NO_LINE).help(help)
                })
            }
        };
        let finding = finding.map(|finding| {
            if text.worn.binary.is_some() {
                finding.case(PACKED)
            } else {
                finding
            }
        });
        out.extend(finding);
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
        _ => return None,
    };
    if let Some(finding) = packed_proxy::without_room(&RULE, body, text.worn, reference) {
        return Some(finding);
    }
    let message = format!("mesh `{}` {what}", reference.text);
    let names = neighbours(body, text, "obj");
    let whole = text.reading.last("obj_file").map(|entry| &*entry.value);
    let help = meant_beside(body.layers.checked, &reference.rel, whole).unwrap_or_else(|| {
        did_you_mean(
            cx.suggestions.nearest(reference.text, names),
            "correct the name, or restore the mesh",
        )
    });
    Some(
        RULE.at(text.file, reference.place.clone(), message)
            .key(reference.text)
            .help(help),
    )
}
