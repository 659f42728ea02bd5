//! An archive of targets has what lies beside it.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, and_more, counted};
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::npz::targets::PackedTarget;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::{TargetArchive, View};
use mhlint_source::file_name;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "does not find the targets: an archive stands for all of them",
    )],
    docs: include_str!("undiscovered.md").trim_ascii_end(),
    counts: "targets",
    of_whole: true,
    ..RuleInfo::new(
        "archive-undiscovered",
        Level::Warning,
        "an archive hides targets or pictures that lie beside it",
    )
});

const REMOVED: Case = &[(
    Makehuman1,
    Level::Warning,
    "still finds the targets in the archive, until that is made again",
)];
const PICTURES: Case = &[(
    Makehuman1,
    Level::Warning,
    "shows these sliders without their pictures",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let known = view
        .targets
        .archive
        .as_ref()
        .filter(|archive| archive.unused.is_none() && !view.targets.is_foreign);
    let Some(archive) = known.filter(|_| view.layers.checks_system()) else {
        return;
    };
    let is_text = |file: &&FileFacts| file.kind_in(Makehuman1) == Kind::Target && !file.is_loose;
    let texts: Vec<&FileFacts> = view.layers.checked.files.values().filter(is_text).collect();
    let stems: BTreeSet<&str> = texts.iter().filter_map(|file| stem(file)).collect();
    let hidden: Vec<&FileFacts> = texts
        .into_iter()
        .filter(|file| is_hidden(archive, file))
        .collect();
    out.extend(hidden.first().map(|first| {
        let message = format!(
            "`{}` is not in `targets.npz`{}",
            first.rel,
            and_more(hidden.len(), "target")
        );
        let finding = RULE.at(first, Place::File, message).key("hidden");
        finding
            .evidence(Evidence::of_cases(hidden.iter().map(|file| &file.rel)))
            .help(AGAIN)
    }));
    // What cannot be used without its text has a finding of its own.
    let is_whole = |name: &&str| {
        archive
            .content
            .targets
            .get(*name)
            .is_some_and(PackedTarget::is_sound)
    };
    let removed: Vec<&str> = archive
        .names()
        .filter(|name| !stems.contains(name))
        .filter(is_whole)
        .collect();
    if let Some(first) = removed.first().filter(|_| !stems.is_empty()) {
        let message = format!(
            "`{first}` is in the archive and has no text{}",
            and_more(removed.len(), "target")
        );
        let finding = RULE
            .at(archive.file, Place::File, message)
            .key("removed")
            .case(REMOVED);
        let finding =
            finding.evidence(Evidence::of_cases(&removed).out_of(archive.content.targets.len()));
        out.push(finding.help("restore the texts, or make the archive again"));
    }
    out.extend(pictures(view, archive));
}

const AGAIN: &str =
    "make the archive again, or delete `targets.npz` and `images.list`: then the texts are read";

fn stem(file: &FileFacts) -> Option<&str> {
    file.rel.strip_suffix(".target")
}

/// What has but a part of its members in the archive has a finding there.
fn is_hidden(archive: &TargetArchive<'_>, file: &FileFacts) -> bool {
    stem(file).is_some_and(|stem| !archive.content.targets.contains_key(stem))
}

/// Pictures of sliders that are there and that the list does not name. A list without any picture
/// is empty, which has a finding of its own.
fn pictures(view: &View<'_>, archive: &TargetArchive<'_>) -> Option<Finding> {
    let (file, list) = archive
        .pictures
        .filter(|(file, _)| file.size > 0 && !file.encoding.lfs_pointer)?;
    let system = view.layers.checked;
    let exists = |path: &&str| {
        system
            .file(path.strip_prefix("data/").unwrap_or(path))
            .is_some()
    };
    let name = |path: &str| file_name(path).to_lowercase();
    let listed: BTreeSet<String> = list
        .pictures
        .iter()
        .map(|path| &**path)
        .filter(exists)
        .map(name)
        .collect();
    let there = system
        .files
        .values()
        .map(|file| file.file_name().to_lowercase())
        .filter(|name| name.ends_with(".png"));
    let there: BTreeSet<String> = there.collect();
    let of_slider =
        |slider: &str| format!("{}.png", file_name(slider).replace('|', "-").to_lowercase());
    let wanted: BTreeSet<String> = view
        .modifiers
        .names()
        .map(of_slider)
        .filter(|name| there.contains(name))
        .collect();
    let missing: Vec<&String> = wanted
        .iter()
        .filter(|name| !listed.contains(*name))
        .collect();
    let first = missing.first()?;
    let message = format!(
        "`{first}` is not listed where it lies{}",
        and_more(missing.len(), "picture")
    );
    let finding = RULE
        .at(file, Place::File, message)
        .key("pictures")
        .case(PICTURES);
    let finding =
        finding.evidence(Evidence::of_cases(missing.iter().copied()).out_of(wanted.len()));
    Some(finding.help(format!(
        "make the list again, or write one line for each of the {}: `data/` and the path below it",
        counted(wanted.len(), "picture")
    )))
}
