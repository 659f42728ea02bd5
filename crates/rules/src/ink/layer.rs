//! An ink layer names a picture beside it and a UV layer that exists.

use super::super::pictures::blender_loads;
use super::super::unfit::findings;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use mhlint_diag::{Application::Mpfb, Finding, Grouped, Level, Place, RuleInfo, grouped};
use mhlint_discover::Kind;
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "fails with an exception when the layer is put on")],
    docs: include_str!("layer.md").trim_ascii_end(),
    ..RuleInfo::new(
        "ink-layer",
        Level::Error,
        "an ink layer without its picture or its UV layer",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let pictures = view
        .layers
        .checked
        .below("ink_layers")
        .filter(|file| blender_loads(file));
    let pictures = grouped(pictures.map(|file| (parent(&file.rel), file.file_name())));
    for file in view.own(Kind::InkLayer) {
        let Some(layer) = file.ink_layer() else {
            continue;
        };
        out.extend(findings(&RULE, file, &layer.stops, cx).map(|(_, finding)| finding));
        out.extend(
            layer
                .image
                .as_ref()
                .and_then(|image| picture(view, file, image, &pictures, cx)),
        );
        out.extend(
            layer
                .focus
                .as_ref()
                .and_then(|focus| uv_layer(view, file, focus, cx)),
        );
    }
}

fn picture(
    view: &View<'_>,
    file: &FileFacts,
    image: &NamedAt,
    pictures: &Grouped<&str, &str>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let (layer, folder) = (view.layers.checked, parent(&file.rel));
    let rel = format!("{folder}/{}", image.name);
    if layer.is_there(&rel) {
        return None;
    }
    let near = cx.suggestions.nearest(
        &image.name,
        pictures.get(folder).into_iter().flatten().copied(),
    );
    let message = format!(
        "picture `{}` does not exist beside the ink layer",
        image.name
    );
    let finding = RULE
        .at(file, Place::Pointer(image.pointer.clone()), message)
        .key("picture");
    Some(finding.help(did_you_mean(
        near,
        "correct the name, or add the picture beside this file",
    )))
}

fn uv_layer(
    view: &View<'_>,
    file: &FileFacts,
    focus: &NamedAt,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let stem = focus.name.replace(' ', "_");
    let rel = format!("uv_layers/{stem}.json.gz");
    let layers = || view.layers.strongest_first().chain(view.layers.beside);
    let is_there = layers().any(|layer| layer.is_there(&rel));
    // The ones that MPFB brings are in its data, those of the user in his.
    let shipped = view
        .layers
        .system
        .is_some_and(|system| system.below("uv_layers").next().is_some());
    if is_there || !view.is_complete() || !shipped {
        return None;
    }
    let known = layers().flat_map(|layer| layer.below("uv_layers"));
    let known = cx
        .suggestions
        .looked_through(known)
        .filter_map(|file| file.file_name().strip_suffix(".json.gz"));
    let near = cx.suggestions.nearest(&stem, known);
    let message = format!("UV layer `{}` of `focus` does not exist", focus.name);
    let finding = RULE
        .at(file, Place::Pointer(focus.pointer.clone()), message)
        .key("focus");
    Some(finding.help(did_you_mean(
        near,
        "correct the name, or add the UV layer to `uv_layers`",
    )))
}
