//! A UV layer of MPFB gives loops of the base mesh their texture coordinates.

use super::super::{Check, Rule, RuleCx, such};
use super::stop::stopped;
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::uv_layer::{Found, UvLayer};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails with an exception when an ink layer with this `focus` is put on",
    )],
    docs: include_str!("layer.md").trim_ascii_end(),
    ..RuleInfo::new(
        "uv-layer",
        Level::Error,
        "a UV layer that MPFB does not take, or that lies elsewhere",
    )
});

const FROM_END: Case = &[(
    Mpfb,
    Level::Warning,
    "counts these loops from the end of the mesh",
)];
const TWICE: Case = &[(
    Mpfb,
    Level::Warning,
    "overwrites the coordinates of these loops, and paints fewer faces",
)];
const MIXED: Case = &[(
    Mpfb,
    Level::Warning,
    "tears the picture apart over several faces",
)];
const NAMES: Case = &[(
    Mpfb,
    Level::Info,
    "has no effect in MPFB, which does not read the names of faces",
)];
const OUTSIDE: Case = &[(
    Mpfb,
    Level::Warning,
    "paints these corners with what lies at another place of the picture",
)];
const NOTHING: Case = &[(Mpfb, Level::Warning, "paints nothing with this UV layer")];

/// Loops of the base mesh (`docs/loaders/mpfb/materials.md#grammar-of-uv-layers`).
const LOOPS: usize = 73_944;

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mesh = view
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0 && !mesh.faces.is_empty());
    let (loops, is_of_quads) = match mesh {
        Some((_, mesh)) => (
            Some(mesh.corners.len()),
            mesh.faces.iter().all(|face| face.len == 4),
        ),
        // Without the data of MPFB it is for the one base mesh that there is; a mesh with a fault
        // tells nothing.
        None => (view.layers.system.is_none().then_some(LOOPS), true),
    };
    let loops = loops.and_then(|loops| i64::try_from(loops).ok());
    for file in view.own(Kind::UvLayer) {
        let Some(layer) = file.uv_layer() else {
            continue;
        };
        if layer.fault.is_some() {
            let finding = RULE
                .at(file, Place::File, "what is packed in it is not valid JSON")
                .key("json");
            out.push(finding.help("save the UV layer again"));
            continue;
        }
        // Of what follows from one slip the first is told.
        let worst = layer
            .stop
            .as_ref()
            .map(|(stop, count)| stopped(&RULE, file, stop, *count));
        let worst = worst.or_else(|| loops.and_then(|loops| beyond(file, layer, loops)));
        let worst = worst.or_else(|| places(file, layer, is_of_quads));
        out.extend(worst);
        if layer.stop.is_none() {
            out.extend(values(file, layer));
        }
    }
}

/// Loops that the mesh does not have, or that count from its end.
fn beyond(file: &FileFacts, layer: &UvLayer, loops: i64) -> Option<Finding> {
    let (negative, beyond) = (layer.negative(), layer.beyond(loops));
    let is_low = layer
        .lowest
        .as_ref()
        .is_some_and(|(lowest, _)| *lowest < -loops);
    let end = if is_low || beyond == 0 {
        &layer.lowest
    } else {
        &layer.highest
    };
    let (number, face) = end.as_ref().filter(|_| negative + beyond > 0)?;
    let finding = |message: String, count: usize| {
        let message = format!("{message}{}", such(count, "loops"));
        RULE.at(file, Place::File, message)
            .key("loops")
            .evidence(Evidence::counted(count))
    };
    if beyond > 0 {
        let message =
            format!("loop {number} of face `{face}` does not exist: the mesh has {loops} loops");
        return Some(
            finding(message, beyond).help("save the UV layer again on the base mesh of MPFB"),
        );
    }
    let message = format!("loop {number} of face `{face}` is negative");
    Some(
        finding(message, negative)
            .case(FROM_END)
            .help("save the UV layer again on the base mesh of MPFB"),
    )
}

/// Loops that are not those of their face: the worst of what is wrong with them.
fn places(file: &FileFacts, layer: &UvLayer, is_of_quads: bool) -> Option<Finding> {
    let counted = |message: String, count: usize, key: &str, case: Case| {
        RULE.at(file, Place::File, message)
            .key(key)
            .case(case)
            .evidence(Evidence::counted(count))
    };
    if layer.faces == 0 {
        let finding = RULE
            .at(file, Place::File, "the UV layer has no faces")
            .key("faces")
            .case(NOTHING);
        return Some(finding.help("save the UV layer again, or remove it"));
    }
    if let Some((first, count)) = layer.repeated() {
        let message = format!("loop {first} occurs more than once{}", such(count, "loops"));
        let finding = counted(message, count, "again", TWICE);
        return Some(
            finding.help("count the loops over all faces: face `f` has `4 f` to `4 f + 3`"),
        );
    }
    let of_faces = |found: &Found, what: &str| {
        let first = found.first.as_ref().filter(|_| is_of_quads)?;
        Some(format!(
            "face `{}` {what}{}",
            first,
            such(found.count, "faces")
        ))
    };
    let mixed = of_faces(&layer.mixed, "has loops of several faces");
    let mixed = mixed.map(|message| counted(message, layer.mixed.count, "mixed", MIXED));
    let elsewhere = || {
        let message = of_faces(&layer.elsewhere, "has the loops of another face")?;
        Some(counted(message, layer.elsewhere.count, "names", NAMES))
    };
    mixed
        .or_else(elsewhere)
        .map(|finding| finding.help("save the UV layer again on the base mesh of MPFB"))
}

fn values(file: &FileFacts, layer: &UvLayer) -> Vec<Finding> {
    let of = |found: &Found, what: &str, key: &str| {
        let first = found.first.as_ref()?;
        let message = format!(
            "a loop of face `{}` {what}{}",
            first,
            such(found.count, "loops")
        );
        let finding = RULE.at(file, Place::File, message).key(key).case(OUTSIDE);
        Some(
            finding
                .evidence(Evidence::counted(found.count))
                .help("write two numbers from 0 to 1"),
        )
    };
    let non_finite = of(&layer.non_finite, "has NaN or infinity", "finite");
    let outside = of(&layer.outside, "has a coordinate outside 0 to 1", "outside");
    non_finite.into_iter().chain(outside).collect()
}
