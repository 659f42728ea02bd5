//! The header of a target names the base mesh it was made for.

use super::super::{Check, Rule, RuleCx};
use super::targets;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::{Body, FileFacts, Layer};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "ignores the header and moves the vertices that have these numbers in the mesh of the \
            folder",
    )],
    docs: include_str!("basemesh_mismatch.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "target-basemesh-mismatch",
        Level::Warning,
        "a target is in the folder of another base mesh than its header names",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // What a folder is called says nothing where that of the base mesh
    // (`overlay-base-folder-missing`) or the base mesh itself (`base-missing-file`) is missing.
    let found = grouped(targets(body).filter_map(|(_, file, facts)| {
        let (line, named) = facts.basemesh.as_ref()?;
        let is_other = !named.eq_ignore_ascii_case(file.base()?) && !body.is_without_base(file);
        is_other.then(|| ((body.folder_of(file), named.as_str()), (file, *line)))
    }));
    for ((folder, named), files) in found {
        out.extend(finding(body.layers.checked, folder, named, &files));
    }
}

fn finding(
    layer: &Layer,
    folder: &str,
    named: &str,
    files: &[(&FileFacts, u32)],
) -> Option<Finding> {
    let base = files.first()?.0.base()?;
    let finding = if let [(file, line)] = files {
        let message = format!("made for base mesh `{named}`, but is in the folder of `{base}`");
        RULE.at(file, Place::Line(*line), message)
    } else {
        let message = format!(
            "{} targets made for base mesh `{named}` are in the folder of `{base}`",
            files.len()
        );
        RULE.in_layer(layer, folder, message)
    };
    let evidence = Evidence::of_cases(files.iter().map(|(file, _)| file.shown()));
    let finding = finding.parts_at(
        files
            .iter()
            .map(|(file, line)| (file.shown(), &file.path, Place::Line(*line))),
    );
    let (them, fit) = if files.len() == 1 {
        ("it", "it fits")
    } else {
        ("them", "they fit")
    };
    let help = format!(
        "move {them} to the target folder of `{named}`, or correct the header if {fit} `{base}`"
    );
    Some(
        finding
            .asset(layer.display(folder))
            .key(named)
            .help(help)
            .evidence(evidence),
    )
}
