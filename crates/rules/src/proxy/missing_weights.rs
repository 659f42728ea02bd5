//! The bone weights of an asset must be found.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::{blender, is_unwalked, lone_archives, neighbours, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{Body, ReferenceKind, Resolution};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "puts the asset on without bone weights: in a pose it collapses to the origin",
        ),
        (Makehuman1, "does not put the asset on"),
        (
            Mpfb,
            "never reads this file: it takes the weights of the body, or a file beside the asset",
        ),
    ],
    levels: &[(Makehuman1, Level::Error), (Mpfb, Level::Info)],
    docs: include_str!("missing_weights.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-missing-weights",
        Level::Warning,
        "the bone weights of an asset do not exist",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::companion::missing(&RULE, body, out);
    }
    for text in texts(body) {
        let Some(reference) = text.worn.reference(ReferenceKind::AssetWeights) else {
            continue;
        };
        let is_absent = matches!(
            reference.resolution,
            Resolution::Missing | Resolution::Unusable
        );
        if !is_absent || is_unwalked(body, reference) {
            continue;
        }
        let folder = body.layers.checked.shown(parent(&reference.rel));
        let message = format!(
            "bone weights `{}` do not exist in `{folder}`",
            reference.text
        );
        let near = cx
            .suggestions
            .nearest(reference.text, neighbours(body, &text, "mhw"));
        let help = did_you_mean(
            near,
            "correct the name, restore the file, or remove the line",
        );
        out.push(
            RULE.at(text.file, reference.place.clone(), message)
                .key(reference.text)
                .help(help),
        );
    }
    for archive in lone_archives(body).filter(|archive| !archive.has_moved()) {
        let reference = archive.worn.reference(ReferenceKind::AssetWeights);
        let Some(reference) = reference.filter(|one| matches!(one.resolution, Resolution::Missing))
        else {
            continue;
        };
        let message = format!(
            "bone weights `{}` of the archive do not exist",
            reference.text
        );
        let finding = RULE
            .at(archive.file, Place::File, message)
            .key(reference.text);
        out.push(finding.help(
            "add the weights where the archive looks for them, or get the asset \
                again from its source",
        ));
    }
}
