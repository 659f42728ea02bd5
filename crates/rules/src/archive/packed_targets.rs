//! What is wrong with the archive of all targets of MakeHuman 1
//! (`docs/loaders/makehuman1/target-archive.md#faults-of-the-archive`).

use std::collections::BTreeMap;

use super::super::{Rule, and_more, counted};
use super::{Sort, words};
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place};
use mhlint_discover::Kind;
use mhlint_formats::npz::targets::PackedTarget;
use mhlint_formats::npz::{ArchiveFault, NpyFault};
use mhlint_formats::target::name::Clash;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::{TargetArchive, Unused, View};

const TEXTS: Case = &[(
    Makehuman1,
    Level::Info,
    "takes its targets from the texts: the archive has no effect",
)];
const NOTHING: Case = &[(
    Makehuman1,
    Level::Error,
    "finds no target, and fails at start: none of the tabs of `modeling_sliders.json` is shown",
)];
const TEXT: Case = &[(
    Makehuman1,
    Level::Info,
    "reads these targets from their texts",
)];
const INERT: Case = &[(
    Makehuman1,
    Level::Error,
    "logs \"Unable to open\", and these targets move nothing",
)];
const STOPS: Case = &[(
    Makehuman1,
    Level::Error,
    "stops each update of the figure at these targets, as soon as one is used",
)];
const UNFOUND: Case = &[(
    Makehuman1,
    Level::Warning,
    "does not find these targets: their sliders move nothing",
)];

/// What is wrong of this sort.
pub(super) fn report(
    rule: &Rule,
    sort: Sort,
    view: &View<'_>,
    file: &FileFacts,
    out: &mut Vec<Finding>,
) {
    let archive = view
        .targets
        .archive
        .as_ref()
        .filter(|archive| std::ptr::eq(archive.file, file));
    let Some(archive) = archive else { return };
    let is_malformed = sort == Sort::Malformed;
    match &archive.unused {
        Some(unused) => out.extend(of_unused(rule, view, archive, unused).filter(|_| is_malformed)),
        None if view.targets.is_foreign => {
            out.extend(Some(of_foreign(rule, archive)).filter(|_| is_malformed));
        }
        None => members(rule, sort, view, archive, out),
    }
}

fn has_texts(view: &View<'_>) -> bool {
    let mut files = view
        .layers
        .system
        .into_iter()
        .flat_map(|system| system.files.values());
    files.any(|file| file.kind_in(Makehuman1) == Kind::Target && !file.is_loose)
}

fn of_unused(
    rule: &Rule,
    view: &View<'_>,
    archive: &TargetArchive<'_>,
    unused: &Unused<'_>,
) -> Option<Finding> {
    let has_texts = has_texts(view);
    // An empty file, a pointer and one that fills the memory have a finding of their own; without
    // texts that is not all.
    if archive.file.gzip_fault.is_some() || archive.is_blank() && has_texts {
        return None;
    }
    let clash = |what: &str, path: &str, clash: &Clash| {
        let Clash {
            category,
            first,
            second,
        } = clash;
        format!("{what} `{path}` has two values of {category}, `{first}` and `{second}`")
    };
    let message = match unused {
        Unused::Closed => match &archive.content.fault {
            Some(ArchiveFault::NotZip(reason)) => words::not_zip(reason),
            Some(ArchiveFault::Empty) => {
                "the archive is empty, and there is no text of a target".to_owned()
            }
            None => "unpacks to more data than any archive of its size".to_owned(),
        },
        Unused::NoPictures => {
            "there is no `images.list` beside the archive that can be read".to_owned()
        }
        Unused::Backslashes(path) => format!("member `{path}` has backslashes in its path"),
        Unused::Member(path, own) => clash("member", path, own),
        Unused::Picture(path, own) => clash("the picture", path, own),
    };
    let help = if has_texts {
        "make the archive and `images.list` again, or delete them"
    } else {
        "restore the archive with its `images.list`, or the texts of the targets"
    };
    let file = match (unused, archive.pictures) {
        (Unused::Picture(..), Some((list, _))) => list,
        _ => archive.file,
    };
    let finding = rule.at(file, Place::File, message).key("unused");
    Some(
        finding
            .case(if has_texts { TEXTS } else { NOTHING })
            .help(help),
    )
}

fn of_foreign(rule: &Rule, archive: &TargetArchive<'_>) -> Finding {
    let count = archive.names().count();
    let message = match archive.names().next() {
        Some(first) => format!(
            "none of the {} in the archive is one that a macro moves, first `{first}`",
            counted(count, "target")
        ),
        None => "there is no target in the archive".to_owned(),
    };
    let finding = rule
        .at(archive.file, Place::File, message)
        .key("foreign")
        .case(NOTHING);
    finding.help("make the archive again, or delete it")
}

/// The members that cannot be used, one finding for what comes of them.
fn members(
    rule: &Rule,
    sort: Sort,
    view: &View<'_>,
    archive: &TargetArchive<'_>,
    out: &mut Vec<Finding>,
) {
    let system = view.layers.system;
    let vertices = view.mesh.map(|(_, mesh)| mesh.facts.vertices);
    let mut found: BTreeMap<Level, (Case, Vec<&str>, String)> = BTreeMap::new();
    for (name, own) in &archive.content.targets {
        let has_text =
            system.is_some_and(|system| system.file(&format!("{name}.target")).is_some());
        let Some((own_sort, case, words)) = judge(own, has_text, vertices) else {
            continue;
        };
        let level = case.first().map_or(Level::Error, |(_, level, _)| *level);
        if own_sort == sort {
            let (_, names, _) = found
                .entry(level)
                .or_insert_with(|| (case, Vec::new(), words));
            names.push(name);
        }
    }
    for (level, (case, names, words)) in found {
        let Some(first) = names.first() else { continue };
        let message = format!(
            "target `{first}` {words}{}",
            and_more(names.len(), "unusable target")
        );
        let evidence = Evidence::of_cases(names.iter()).out_of(archive.content.targets.len());
        let finding = rule
            .at(archive.file, Place::File, message)
            .key(format!("members {level:?}"))
            .case(case);
        out.push(
            finding
                .evidence(evidence)
                .help("make the archive again, or delete it"),
        );
    }
}

/// What is wrong with the members of a target.
fn judge(
    own: &PackedTarget,
    has_text: bool,
    vertices: Option<usize>,
) -> Option<(Sort, Case, String)> {
    let read = if has_text { TEXT } else { INERT };
    if own.index.is_none() {
        let is_there = own.vector.is_some();
        return is_there.then(|| {
            (
                Sort::MissingMember,
                UNFOUND,
                "has no member `.index`".to_owned(),
            )
        });
    }
    if own.vector.is_none() {
        return Some((
            Sort::MissingMember,
            read,
            "has no member `.vector`".to_owned(),
        ));
    }
    if let Some(fault) = own.fault() {
        let case = match fault {
            NpyFault::Object => &[],
            NpyFault::Header | NpyFault::Truncated | NpyFault::Damaged(_) => read,
            _ => STOPS,
        };
        return Some((Sort::of(fault), case, words::of_member(fault)));
    }
    if own.has_license {
        return Some((
            Sort::ObjectArray,
            read,
            "has a licence, which is an array of Python objects".to_owned(),
        ));
    }
    match (own.rows(), own.max_index.zip(vertices)) {
        (Some((index, vector)), _) if index != vector => Some((
            Sort::Malformed,
            STOPS,
            format!(
                "has {} and {}",
                if index == 1 {
                    "1 vertex".to_owned()
                } else {
                    format!("{index} vertices")
                },
                counted(vector, "displacement")
            ),
        )),
        (_, Some((most, vertices))) if usize::try_from(most).is_ok_and(|most| most >= vertices) => {
            Some((
                Sort::Malformed,
                STOPS,
                format!("moves vertex {most}, and the base mesh has {vertices}"),
            ))
        }
        _ => None,
    }
}
