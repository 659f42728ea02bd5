//! Files without which MakeHuman 2 does not start (`docs/loaders/makehuman2/base.md#keys`).

use super::super::Rule;
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level};
use mhlint_repo::makehuman2::{PROGRAM_FILES, has_shaders, holds_program, lacks_bases};
use mhlint_repo::{Layer, View};

/// The codes with which the program exits where one of them does not exist.
const CODES: [u8; 2] = [20, 21];

/// Findings on what does not exist.
pub(super) fn missing(rule: &Rule, view: &View<'_>, system: &Layer, out: &mut Vec<Finding>) {
    out.extend(no_base(rule, system));
    if !holds_program(system) {
        return;
    }
    // It came at the end of 2024.
    let is_later = |rel: &str| rel == PROGRAM_FILES[1] && view.is_before("2025");
    for (rel, code) in PROGRAM_FILES
        .into_iter()
        .zip(CODES)
        .filter(|(rel, _)| !system.is_there(rel) && !is_later(rel))
    {
        let message = format!("`{rel}` does not exist");
        let finding = rule.in_layer(system, rel, message).effect_in(
            view.application(),
            format!("exits at start with code {code}"),
        );
        out.push(finding.help("restore the file from the download of the program"));
    }
    if has_shaders(system) && !system.is_there(LAMP) {
        let finding = rule
            .in_layer(system, LAMP, format!("`{LAMP}` does not exist"))
            .case(NO_LAMP);
        out.push(finding.help("restore the file from the download of the program"));
    }
}

/// No base mesh at all, where there are other parts of the program.
fn no_base(rule: &Rule, system: &Layer) -> Option<Finding> {
    let is_gone = lacks_bases(system) && !system.has_unusable("base");
    let finding = || {
        rule.in_layer(system, "base", "folder `base` does not exist")
            .case(NO_BASE)
    };
    is_gone.then(|| finding().help("restore the folder from the download of the program"))
}

/// The mesh that is shown for a lamp (`docs/loaders/makehuman2/program.md#lamp-symbol`).
const LAMP: &str = "shaders/meshes/lampsymbol.obj";
const NO_BASE: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `TypeError` when it loads the base",
)];
const NO_LAMP: Case = &[(
    Makehuman2,
    Level::Warning,
    "logs a line at start and shows no symbol for lamps",
)];
