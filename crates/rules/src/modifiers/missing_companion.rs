//! The three files of a set of modifiers are there.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, RuleInfo};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::{SETS, View, has_most_of_program};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "logs a warning for each modifier and shows no descriptions",
    )],
    docs: include_str!("missing_companion.md").trim_ascii_end(),
    of_library: true,
    ..RuleInfo::new(
        "modifiers-missing-companion",
        Level::Warning,
        "a file of a set of modifiers is missing",
    )
});

const NO_TABS: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with `FileNotFoundError`: the tabs of this set are missing",
)];
const ENDINGS: [(&str, Option<Case>); 3] = [
    ("_modifiers.json", Some(NO_TABS)),
    ("_modifiers_desc.json", None),
    ("_sliders.json", Some(NO_TABS)),
];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    if !view.layers.checks_system() {
        return;
    }
    if !view.modifiers.is_there {
        return out.extend(no_folder(view));
    }
    let known: Vec<String> = SETS
        .iter()
        .flat_map(|stem| ENDINGS.map(|(ending, _)| format!("modifiers/{stem}{ending}")))
        .collect();
    // The shapes of bodies came with 1.3; without any of them the data are older.
    let is_later = |stem: &str| stem == "bodyshapes" && view.layers.are_before(Makehuman1, "1.3");
    for stem in SETS.into_iter().filter(|stem| !is_later(stem)) {
        for (ending, case) in ENDINGS {
            let rel = format!("modifiers/{stem}{ending}");
            if layer.is_there(&rel) {
                continue;
            }
            let others = layer
                .below("modifiers")
                .filter(|file| !known.contains(&file.rel));
            let names: Vec<&str> = others
                .map(FileFacts::file_name)
                .filter(|name| name.ends_with(".json"))
                .collect();
            let name = format!("{stem}{ending}");
            let in_capitals = names
                .iter()
                .find(|other| other.eq_ignore_ascii_case(&name))
                .copied();
            let near = in_capitals.or_else(|| cx.suggestions.nearest(&name, names.iter().copied()));
            let finding = RULE
                .in_layer(layer, &rel, format!("`{rel}` does not exist"))
                .key(&rel);
            let finding = finding.help(did_you_mean(near, "restore the file from the program"));
            out.push(case.map_or(finding.clone(), |case| finding.case(case)));
        }
    }
}

/// All of it is gone, where the base mesh and its targets show that it belongs there.
fn no_folder(view: &View<'_>) -> Option<Finding> {
    let layer = view.layers.checked;
    let is_of_mesh = || view.mesh.is_some() && layer.below("targets/macrodetails").next().is_some();
    let is_whole = has_most_of_program(layer) || is_of_mesh();
    let is_gone =
        is_whole && !layer.has_unusable("modifiers") && layer.below("modifiers").next().is_none();
    let finding = || {
        RULE.in_layer(layer, "modifiers", "folder `modifiers` does not exist")
            .key("modifiers")
    };
    is_gone.then(|| {
        finding()
            .case(NO_TABS)
            .help("restore the folder from the program")
    })
}
