//! `compressedtargets.npz` and the text files it was made from say the same.

use super::super::{Check, Rule, RuleCx, and_more};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::npz::Archive;
use mhlint_formats::npz::targets::PackedTarget;
use mhlint_formats::target::TargetFacts;
use mhlint_repo::{FileFacts, Layer, makehuman1, makehuman2};
use mhlint_source::parent;

pub(crate) static RULE: Rule =
    Check::Libraries(run, |view, _, out| out.extend(of_makehuman1(view))).rule(RuleInfo {
        breaks: &[
            (
                Makehuman2,
                "applies the numbers in the archive and ignores the text file, whichever is newer",
            ),
            (
                Makehuman1,
                "applies the numbers in the archive and ignores the text file, whichever is newer",
            ),
        ],
        levels: &[(Makehuman1, Level::Warning)],
        docs: include_str!("stale_binary.md").trim_ascii_end(),
        counts: "targets",
        ..RuleInfo::new(
            "target-stale-binary",
            Level::Error,
            "an archive of targets differs from the text files",
        )
    });

/// The usual.
const DIFFERING: Case = &[];
const WITHOUT_TEXT: Case = &[(
    Makehuman2,
    Level::Warning,
    "loads the target from the archive; it disappears when the archive is rebuilt",
)];
const WITHOUT_MEMBER: Case = &[(
    Makehuman2,
    Level::Info,
    "reads these targets from their text files",
)];

/// Names of targets, sorted by what is wrong with them.
#[derive(Default)]
struct Stale<'a> {
    differing: Vec<&'a str>,
    without_text: Vec<&'a str>,
    without_member: Vec<&'a str>,
}

fn run(view: &makehuman2::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    for file in layer
        .files
        .values()
        .filter(|file| file.kind == Kind::TargetArchive)
    {
        // What cannot be read as a whole cannot be compared.
        if let Some(archive) = file.archive().filter(|archive| archive.is_sound()) {
            let stale = compare(layer, parent(&file.rel), archive);
            out.extend(finding(file, archive, &stale));
        }
    }
}

fn compare<'a>(layer: &'a Layer, folder: &str, archive: &'a Archive) -> Stale<'a> {
    let mut stale = Stale::default();
    for member in &archive.members {
        let text = layer.file(&format!("{folder}/{}.target", member.name));
        match (text, &member.rows) {
            (None, _) => stale.without_text.push(&member.name),
            (Some(text), Ok(rows)) if differs(text, rows.content) => {
                stale.differing.push(&member.name);
            }
            _ => {}
        }
    }
    let texts = layer.below(folder).filter(|file| file.kind == Kind::Target);
    for name in texts.filter_map(|file| {
        file.rel
            .strip_prefix(folder)?
            .strip_prefix('/')?
            .strip_suffix(".target")
    }) {
        if archive.member(name).is_none() {
            stale.without_member.push(name);
        }
    }
    stale
}

/// The targets of `targets.npz` with other numbers than their texts.
fn of_makehuman1(view: &makehuman1::View<'_>) -> Option<Finding> {
    let archive = view
        .targets
        .archive
        .as_ref()
        .filter(|archive| archive.unused.is_none())?;
    let text = |name: &str| {
        view.layers
            .checked
            .file(&format!("{name}.target"))
            .filter(|_| view.layers.checks_system())
    };
    let is_whole = |facts: &&TargetFacts| facts.unreadable_rows == 0 && facts.negative.count == 0;
    let differs = |(name, own): &(&String, &PackedTarget)| {
        let facts = text(name).and_then(FileFacts::target).filter(is_whole);
        own.is_sound() && facts.is_some_and(|facts| own.content != Some(facts.thousandths))
    };
    let stale: Vec<&String> = archive
        .content
        .targets
        .iter()
        .filter(differs)
        .map(|(name, _)| name)
        .collect();
    let first = stale.first()?;
    let message = format!(
        "`{first}` has other numbers than its text{}",
        and_more(stale.len(), "target")
    );
    let finding = RULE.at(archive.file, Place::File, message);
    let finding =
        finding.evidence(Evidence::of_cases(&stale).out_of(archive.content.targets.len()));
    Some(finding.help(
        "make the archive again, or delete `targets.npz` and `images.list`: then \
        the texts are read",
    ))
}

/// A text that cannot be read completely has a finding of its own.
fn differs(text: &FileFacts, content: u64) -> bool {
    let whole = text
        .target()
        .filter(|facts| facts.unreadable_rows == 0 && facts.negative.count == 0);
    whole.is_some_and(|facts| facts.content != content)
}

const REBUILD: &str = "delete the archive; MakeHuman 2 rebuilds it at the next start";
/// To delete the only copy of a target would be worse than the fault.
const REBUILD_LATER: &str = "restore the `.target` files that are still needed, then delete the \
    archive; MakeHuman 2 rebuilds it without the targets that have no text file";

fn finding(file: &FileFacts, archive: &Archive, stale: &Stale<'_>) -> Option<Finding> {
    let groups = [
        (
            &stale.differing,
            ["differs from its text file", "differ from their text files"],
            DIFFERING,
        ),
        (
            &stale.without_text,
            ["has no text file", "have no text file"],
            WITHOUT_TEXT,
        ),
        (
            &stale.without_member,
            ["is missing", "are missing"],
            WITHOUT_MEMBER,
        ),
    ];
    let found = groups.iter().filter(|(names, ..)| !names.is_empty());
    let parts = found
        .clone()
        .map(|(names, [one, several], _)| match names.as_slice() {
            [only] => format!("`{only}` {one}"),
            names => format!("{} targets {several}", names.len()),
        });
    let message = format!(
        "the archive is out of date: {}",
        parts.collect::<Vec<_>>().join(", ")
    );
    let (_, _, case) = found.clone().next()?;
    let names: Vec<&str> = found
        .flat_map(|(names, ..)| names.iter().copied())
        .collect();
    Some(
        RULE.at(file, Place::File, message)
            .case(case)
            .help(if stale.without_text.is_empty() {
                REBUILD
            } else {
                REBUILD_LATER
            })
            .evidence(
                Evidence::of_cases(names)
                    .out_of(archive.members.len() + stale.without_member.len()),
            ),
    )
}
