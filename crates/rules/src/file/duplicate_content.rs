//! The same content under several names.

use std::collections::BTreeSet;

use super::super::cause::copies::CopiedFolders;
use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Case, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_discover::Kind;
use mhlint_repo::{FileFacts, ReferenceKind, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "loads the same content more than once"),
        (Mpfb, "loads the same content more than once"),
    ],
    docs: include_str!("duplicate_content.md").trim_ascii_end(),
    counts: "files",
    ..RuleInfo::new(
        "file-duplicate-content",
        Level::Info,
        "several files with the same content",
    )
});

const ONE_END: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "moves the slider to the same shape in both directions",
    ),
    (
        Mpfb,
        Level::Warning,
        "moves the slider to the same shape in both directions",
    ),
];

/// Smaller files (a dot of an icon, a target of a few rows) are equal by chance.
const SMALLEST: u64 = 200;

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    // Through a link it is the same file, not another one.
    let is_link = |file: &FileFacts| {
        file.link_to
            .as_deref()
            .is_some_and(|real| layer.file(real).is_some())
    };
    // Where names are composed, or found by themselves, each must be there: only sliders could
    // share a target.
    let is_needed = |file: &FileFacts| {
        let is_target = matches!(file.kind, Kind::Target | Kind::PackedTarget);
        view.is_mpfb()
            && is_target
            && (view.composes_name_of(file) || view.references().to_file(file).next().is_none())
    };
    let files = view
        .files()
        .filter(|file| !is_link(file) && !is_needed(file));
    let twins = grouped(
        files.filter_map(|file| Some(((category(file), class(file)?, file.content_hash?), file))),
    );
    let copied = CopiedFolders::of(view);
    let ends = view.slider_ends();
    let ends = ends.iter().map(|pair| pair.map(|file| file.path.as_str()));
    let ends = grouped(ends.map(|[one, other]| (one, other)));
    for ((_, class, _), files) in twins {
        let [first, others @ ..] = files.as_slice() else {
            continue;
        };
        // A folder that was copied as a whole is one mistake: `library-identity-clash`.
        if others.is_empty() || copied.hold(&files) {
            continue;
        }
        let message = if let [other] = others {
            format!("has the same {class} as `{}`", other.shown())
        } else {
            let names: Vec<String> = files
                .iter()
                .take(EXAMPLES)
                .map(|file| format!("`{}`", file.shown()))
                .collect();
            let more = files.len() - names.len();
            let more = if more > 0 {
                format!(" and {more} more")
            } else {
                String::new()
            };
            format!(
                "{} files have the same {class}: {}{more}",
                files.len(),
                names.join(", ")
            )
        };
        let mut finding = RULE
            .at(first, Place::File, message)
            .help(advice(view, first, others));
        for other in others {
            finding = finding.related(other.path.clone(), Place::File, "the same content");
        }
        let own: BTreeSet<&str> = files.iter().map(|file| file.path.as_str()).collect();
        let mut opposites = own.iter().filter_map(|path| ends.get(*path)).flatten();
        let finding = if opposites.any(|path| own.contains(path)) {
            finding.case(ONE_END)
        } else {
            finding
        };
        let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
        let finding = finding.between(files.iter().map(|file| &file.path));
        out.push(finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown()))));
    }
}

/// What a file is compared with, if it is.
fn class(file: &FileFacts) -> Option<&'static str> {
    let extension = file.rel.rsplit('.').next().unwrap_or_default();
    match file.kind {
        _ if file.size < SMALLEST || file.encoding.lfs_pointer => None,
        Kind::Target | Kind::PackedTarget => file
            .target()
            .filter(|facts| facts.moving > 0)
            .map(|_| "displacements"),
        Kind::BaseMesh | Kind::AssetMesh => Some("mesh"),
        // Every asset has its own thumb, named after it.
        Kind::Image if extension == "thumb" => None,
        Kind::Image | Kind::TargetIcon => Some("picture"),
        _ => None,
    }
}

/// Folder and base mesh: within it one file can stand for another.
fn category(file: &FileFacts) -> (&str, &str) {
    let (folder, _) = file.rel.split_once('/').unwrap_or_default();
    file.base()
        .map_or((file.rel.as_str(), ""), |base| (folder, base))
}

fn is_of_slider(kind: ReferenceKind) -> bool {
    use ReferenceKind::{Decr, Incr, SliderName, Slot};
    matches!(kind, Incr | Decr | SliderName | Slot)
}

fn advice(view: &View<'_>, first: &FileFacts, others: &[&FileFacts]) -> String {
    let references = || {
        others
            .iter()
            .flat_map(|other| view.references().to_file(other))
    };
    let mut found = references().filter(|reference| reference.found().is_some());
    match (found.next(), found.count()) {
        // With another target the slider would have another name in saved models.
        (Some(reference), _) if is_of_slider(reference.kind) => format!(
            "keep the files if `{}` in {} is meant to have the same shape, because saved models \
             find a slider by the name of its target; otherwise give it its own shape",
            reference.owner,
            reference.from.file_name()
        ),
        (Some(reference), _) if reference.kind == ReferenceKind::AssetMesh => {
            "keep both if each asset is to have its own mesh; otherwise name one of the files in \
                both"
                .to_owned()
        }
        (Some(reference), 0) => format!(
            "use `{}` for `{}` in {}, then remove `{}` if nothing else names it",
            first.file_name(),
            reference.owner,
            reference.from.file_name(),
            reference.found().map_or("", FileFacts::file_name)
        ),
        (Some(reference), more) => format!(
            "use `{}` for `{}` and {} in {}, then remove the files that nothing uses any more",
            first.file_name(),
            reference.owner,
            counted(more, "other reference"),
            reference.from.file_name()
        ),
        (None, _) => {
            "leave them if each is in use, also by saved models; if a copy is a mistake, export \
                what was meant"
                .to_owned()
        }
    }
}
