//! Modifiers lie where the program opens them.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::{SETS, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "never opens the file: it has neither these modifiers nor their sliders",
    )],
    docs: include_str!("unread.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-unread",
        Level::Error,
        "a list of modifiers that the program does not open",
    )
});

const COPIES: Case = &[(
    Makehuman1,
    Level::Warning,
    "never opens the file, and opens its own: a change here does nothing",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let is_list = |file: &&FileFacts| {
        matches!(
            file.kind,
            Kind::ModifierFile | Kind::ModifierSliders | Kind::ModifierTexts
        ) && !file.is_loose
    };
    let names: BTreeSet<&str> = layer.below("modifiers").map(FileFacts::file_name).collect();
    let is_opened = |file: &FileFacts| {
        let (stem, ending) = file.file_name().split_once('_').unwrap_or_default();
        // One that a set lacks has a finding there: this may be it, under another name.
        let last = ending.rsplit('_').next().unwrap_or_default();
        let is_whole = |set: &str| {
            let own = [format!("{set}_{last}"), format!("{set}_modifiers_{last}")];
            own.iter().any(|name| names.contains(name.as_str()))
        };
        view.layers.checks_system()
            && (SETS.contains(&stem) || !SETS.iter().all(|set| is_whole(set)))
    };
    let lost = layer
        .files
        .values()
        .filter(is_list)
        .filter(|file| !is_opened(file));
    let (copies, lost): (Vec<&FileFacts>, Vec<&FileFacts>) =
        lost.partition(|file| is_copy(view, file));
    out.extend(of_copies(&copies));
    let Some(first) = lost.first() else { return };
    let whose = if view.layers.checks_system() {
        "of the program"
    } else {
        "of the user"
    };
    let message = format!(
        "{} in `modifiers` {whose} that nothing opens",
        counted(lost.len(), "file")
    );
    let finding = RULE
        .at(first, Place::File, message)
        .parts_in(lost.iter().map(|file| (file.shown(), &file.path)));
    let finding = finding.evidence(Evidence::of_cases(lost.iter().map(|file| file.shown())));
    out.push(finding.help(
        "move what is in them to `modeling_modifiers.json` and the files beside it, in the \
                program's own data",
    ));
}

/// Whether the program has the same under the same name.
fn is_copy(view: &View<'_>, file: &FileFacts) -> bool {
    let Some(own) = view
        .layers
        .system
        .filter(|_| !view.layers.checks_system())
        .and_then(|one| one.file(&file.rel))
    else {
        return false;
    };
    own.modifier_file() == file.modifier_file()
        && own.modifier_sliders() == file.modifier_sliders()
        && own.modifier_texts() == file.modifier_texts()
}

/// Copies of the program's lists, as long as nothing was changed in them.
fn of_copies(copies: &[&FileFacts]) -> Option<Finding> {
    let first = copies.first()?;
    let message = format!(
        "{} in `modifiers` of the user, as the program has them",
        counted(copies.len(), "file")
    );
    let finding = RULE
        .at(first, Place::File, message)
        .key("copies")
        .case(COPIES);
    let finding = finding.parts_in(copies.iter().map(|file| (file.shown(), &file.path)));
    let finding = finding.evidence(Evidence::of_cases(copies.iter().map(|file| file.shown())));
    Some(finding.help("remove them: the program opens its own alone"))
}
