//! No scene imports or calls anything.

use super::super::{Check, Rule, RuleCx, and_more};
use super::FIRST;
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::pickle::Danger;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "runs the code in the file when the scene is chosen",
    )],
    docs: include_str!("unsafe_pickle.md").trim_ascii_end(),
    counts: "instructions",
    cannot_be_ignored: true,
    ..RuleInfo::new(
        "scene-unsafe-pickle",
        Level::Error,
        "a scene, or the list of a library, runs code when it is loaded",
    )
});

const AT_START: Case = &[(
    Makehuman1,
    Level::Error,
    "runs the code in the file at start",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.is_makehuman1() {
        return;
    }
    for file in view.files() {
        let scene = file.scene().map(|scene| scene.dangers.as_slice());
        let dangers = scene.or_else(|| file.library_cache()).unwrap_or_default();
        out.extend(finding(file, dangers));
    }
}

fn finding(file: &FileFacts, dangers: &[Danger]) -> Option<Finding> {
    let first = dangers.first()?;
    let what = match &first.import {
        Some(import) if first.opcode == "STACK_GLOBAL" => {
            format!("imports `{import}` by `STACK_GLOBAL`")
        }
        Some(import) => format!("imports `{import}`"),
        None => format!("has the instruction `{}`", first.opcode),
    };
    let message = format!(
        "{what} at byte {}{}",
        first.offset,
        and_more(dangers.len(), "instruction")
    );
    let words = |danger: &Danger| {
        danger
            .import
            .clone()
            .unwrap_or_else(|| danger.opcode.to_owned())
    };
    let finding = RULE
        .at(file, Place::File, message)
        .evidence(Evidence::of_cases(dangers.iter().map(words)));
    let is_list = file.kind == Kind::LibraryCache;
    let finding = if is_list || file.rel == FIRST {
        finding.case(AT_START)
    } else {
        finding
    };
    Some(finding.help(if is_list {
        "do not start the program with it; delete it, and the program makes it again"
    } else {
        "do not open it; delete it, or save the scene again from a program that you trust"
    }))
}
