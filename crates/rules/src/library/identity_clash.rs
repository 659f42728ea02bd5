//! Every asset of a base is known by a name and a uuid of its own.

use super::super::cause::copies::is_copy;
use super::super::{Check, Rule, RuleCx};
use super::{as_copy, side_by_side};
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Asset, View};

pub(crate) static RULE: Rule = Check::Makehuman2Library(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "lists only one of them, whichever the file system returns first; the others cannot be \
            chosen",
    )],
    docs: include_str!("identity_clash.md").trim_ascii_end(),
    ..RuleInfo::new(
        "library-identity-clash",
        Level::Error,
        "two assets with the same name and \
        uuid",
    )
});

const COPY: Case = &[(
    Makehuman2,
    Level::Warning,
    "lists only one of the copies and ignores the others",
)];
const LOOSE: Case = &[(
    Makehuman2,
    Level::Warning,
    "lists only one of them once both are in its library",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    side_by_side::in_makehuman2(&RULE, view, cx.beside, out);
    for base in view.library.bases() {
        for clash in view.library.clashes(base) {
            out.extend(finding(view, &clash));
        }
    }
}

fn finding(view: &View<'_>, clash: &[&Asset<'_>]) -> Option<Finding> {
    // What lies in the other layer is replaced on purpose.
    let mut own: Vec<&Asset<'_>> = clash
        .iter()
        .copied()
        .filter(|one| view.layers.is_checked(one.file))
        .collect();
    // An asset without a name is known by nothing: that has a finding of its own.
    let is_told = |one: &&Asset<'_>| one.category == "rigs" || one.name.is_empty();
    if own.len() < 2 || own.iter().all(is_told) {
        return None;
    }
    own.sort_by_key(|one| as_copy(one.file));
    let (told, others) = own.split_last()?;
    let first = others.first()?;
    let (what, help) = words(told, first);
    let more = if others.len() > 1 {
        format!(" and {} more", others.len() - 1)
    } else {
        String::new()
    };
    // A copy in the list of another kind: one of the lists loses it.
    let is_copy =
        |other: &&Asset<'_>| other.category == told.category && is_copy(view, told, other);
    let (are_copies, is_loose) = (others.iter().all(is_copy), view.layers.checked.is_loose);
    // Outside of a library an equal copy is a backup, or waits beside what it was made for.
    if are_copies && is_loose {
        return None;
    }
    let message = format!("`{}` has {what} `{}`{more}", told.name, first.file.shown());
    let mut finding = RULE
        .at(told.file, Place::File, message)
        .key(format!("{} {}", told.name, told.uuid));
    for other in others {
        finding = finding.related(other.file.path.clone(), Place::File, "the other asset");
    }
    let finding = finding.between(own.iter().map(|one| one.file.path.as_str()));
    Some(match () {
        () if are_copies => finding
            .case(COPY)
            .help(format!("remove the copy, or {help}")),
        () if is_loose => finding.case(LOOSE).help(help),
        () => finding.help(help),
    })
}

/// What both are known by, and what to change.
fn words(told: &Asset<'_>, other: &Asset<'_>) -> (&'static str, &'static str) {
    if (told.is_worn() || other.is_worn()) && (&told.name, &told.uuid) != (&other.name, &other.uuid)
    {
        return (
            "the same name and uuid, written one behind the other, as",
            "give the newer of the two another uuid: saved models find assets by these",
        );
    }
    if told.is_worn() || other.is_worn() {
        return (
            "the same name and uuid as",
            "give the newer of the two a name and a uuid of its own: saved models find assets by \
                these",
        );
    }
    match told.category {
        "models" => (
            "the same name and file name as",
            "give the newer of the two another name and file name",
        ),
        "skins" => (
            "the same file name as",
            "give the newer of the two another file name",
        ),
        "poses" if told.uuid.starts_with("bvh_") => (
            "the same name and file name as",
            "give the newer of the two another file name",
        ),
        _ => (
            "the same name as",
            "give the newer of the two a name of its own",
        ),
    }
}
