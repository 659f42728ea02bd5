//! Presets, settings and node trees of MPFB, as far as their loaders do not take them
//! (`docs/loaders/mpfb/models.md#presets-of-the-importer`,
//! `docs/loaders/mpfb/models.md#presets-of-the-randomizer`,
//! `docs/loaders/mpfb/materials.md#settings-of-skins`,
//! `docs/loaders/mpfb/materials.md#node-trees`).

use super::super::unfit::{findings, is_misspelt};
use super::super::{Rule, RuleCx, did_you_mean, such};
use super::mpfb_files::{OWN_SKIN_SETTINGS, SKIN_SETTINGS, has_own_skin_settings};
use super::randomization;
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_discover::Kind;
use mhlint_formats::Content;
use mhlint_formats::unfit::{NamedAt, Why};
use mhlint_repo::{FileFacts, View, mpfb};

const STOPPED_IMPORTER: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `TypeError` when the preset is loaded",
)];
const IGNORED_PRESET: Case = &[(Mpfb, Level::Warning, "ignores the preset")];
const UNSET: Case = &[(
    Mpfb,
    Level::Warning,
    "silently ignores the key: the setting keeps its value",
)];
const STOPPED_EYES: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when it makes eyes with these settings",
)];
const STOPPED_SKIN: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception at the skin: this zone and all later ones keep the defaults of the \
        shader",
)];
const UNREAD_KEY: Case = &[(
    Mpfb,
    Level::Warning,
    "silently ignores the key: the default of the shader stays",
)];
const UNREAD_PART: Case = &[(
    Mpfb,
    Level::Warning,
    "silently leaves the defaults of the shader for this part of the skin",
)];
const STOPPED_NODES: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when it makes a material of this kind",
)];
const NO_LINK: Case = &[(Mpfb, Level::Warning, "leaves the link out")];
const STOPPED_MAKEUP: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when the makeup is put on",
)];

/// Findings on a file.
pub(super) fn faults(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    let View::Mpfb(own) = view else { return };
    if let Some(makeup) = file.makeup() {
        let stops = findings(rule, file, &makeup.stops, cx);
        out.extend(stops.map(|(_, finding)| finding.case(STOPPED_MAKEUP)));
        out.extend(missing_layers(rule, own, file, &makeup.layers, cx));
    }
    if let Content::Randomization(preset) = &*file.content {
        randomization::faults(rule, own, file, preset, cx, out);
    }
    let Some(faults) = file.loader_faults() else {
        return;
    };
    // Of the skin the user's copy is read, once there is one.
    if file.kind == Kind::SkinSettings
        && file.rel.starts_with("settings/")
        && has_own_skin_settings(view)
    {
        return;
    }
    let (stopped, passed_over) = match file.kind {
        Kind::ImporterPreset => (STOPPED_IMPORTER, UNSET),
        Kind::EyeSettings => (STOPPED_EYES, UNREAD_KEY),
        Kind::SkinSettings => (STOPPED_SKIN, UNREAD_KEY),
        _ => (STOPPED_NODES, NO_LINK),
    };
    out.extend(findings(rule, file, &faults.stops, cx).map(|(_, finding)| finding.case(stopped)));
    out.extend(absent(rule, file, &faults.absent));
    let ignored =
        findings(rule, file, &faults.ignored, cx).filter(|(first, _)| is_misspelt(first, cx));
    out.extend(ignored.map(|(first, finding)| {
        let is_whole = matches!(first.why, Why::Type { .. });
        finding.case(if is_whole && file.kind == Kind::ImporterPreset {
            IGNORED_PRESET
        } else {
            passed_over
        })
    }));
}

/// Parts that the settings lack which are read without being asked for; settings of a user are
/// often about a few.
fn absent(rule: &Rule, file: &FileFacts, absent: &[&str]) -> Option<Finding> {
    let first = absent
        .first()
        .filter(|_| [SKIN_SETTINGS, OWN_SKIN_SETTINGS].contains(&file.rel.as_str()))?;
    let message = format!(
        "the settings have no `{first}`{}",
        such(absent.len(), "parts")
    );
    let finding = rule
        .at(file, Place::File, message)
        .key("absent")
        .case(UNREAD_PART);
    let help = "restore them from the download of the add-on; MPFB makes the user's copy again \
        once it is deleted";
    Some(
        finding
            .help(help)
            .evidence(Evidence::of_cases(absent.iter().copied())),
    )
}

/// Ink layers that no file is.
fn missing_layers(
    rule: &Rule,
    view: &mpfb::View<'_>,
    file: &FileFacts,
    layers: &[NamedAt],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    if !view.is_complete() {
        return None;
    }
    let missing: Vec<&NamedAt> = layers
        .iter()
        .filter(|one| !view.named.has("ink_layers", &one.name))
        .collect();
    let first = missing.first()?;
    let message = format!(
        "ink layer `{}` does not exist{}",
        first.name,
        such(missing.len(), "names")
    );
    let near = cx
        .suggestions
        .nearest(&first.name, view.named.names("ink_layers"));
    let finding = rule
        .at(file, Place::Pointer(first.pointer.clone()), message)
        .key("layers")
        .case(STOPPED_MAKEUP);
    let finding = finding.evidence(Evidence::of_cases(
        missing.iter().map(|one| one.name.as_str()),
    ));
    Some(finding.help(did_you_mean(near, "correct the name, or add the ink layer")))
}
