//! Where MPFB looks for a user's files (`docs/loaders/mpfb/folders.md#lookups`,
//! `docs/loaders/mpfb/sliders.md#where-user-targets-lie`,
//! `docs/loaders/mpfb/models.md#saved-characters`).

use super::super::cause::outdated::is_outdated;
use super::super::{Rule, counted, did_you_mean};
use super::makehuman1::REMOVE_COPY;
use super::{Contents, aside, top};
use mhlint_diag::{Application, Case, Evidence, Finding, Level, Place, grouped, nearest};
use mhlint_discover::{Kind, Layout, extension};
use mhlint_repo::FileFacts;
use mhlint_repo::aside::near_of_mpfb;
use mhlint_repo::mpfb::View;

const NOT_LISTED: Case = &[(
    Application::Mpfb,
    Level::Error,
    "does not list them: it looks for them in another folder",
)];
const NOT_FOUND: Case = &[(
    Application::Mpfb,
    Level::Error,
    "makes no sliders of them, and saved characters do not find them",
)];

const COPIED: Case = &[(
    Application::Mpfb,
    Level::Info,
    "lists the same files in their own folders",
)];

/// What lies in a folder of the user's data in which nobody looks for it.
pub(super) fn misplaced(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    // MPFB looks in its own data by names.
    if view.layers.checks_system() {
        return;
    }
    let files = || {
        view.layers
            .checked
            .files
            .values()
            .filter(|file| !file.is_loose)
    };
    let (own, other) = (
        Layout::of(Application::Mpfb),
        Layout::of(Application::Makehuman1),
    );
    let is_preset = |kind| kind == Kind::RandomizationPreset || (own.is_telling)(kind);
    let presets = files().filter(|file| is_preset(file.kind_in(Application::Mpfb)));
    for (folder, files) in grouped(presets.map(|file| (file.folder(), file))) {
        let message = format!(
            "{} of MPFB in `{}`, where it does not look for them",
            counted(files.len(), "preset"),
            folder
        );
        let help = "move them to the folder `config` beside the folder of data: `user/config` for \
            `user/data`";
        out.extend(finding(rule, &files, folder, message, NOT_LISTED, help));
    }
    let is_other = |top: &str| {
        own.folder_in_other_case(top).is_some() || matches!(top, "config" | "settings" | "models")
    };
    // Of a zip the import says where its files go.
    let is_zip = view.layers.checked.pack.is_some();
    let loose = files().filter(|file| !is_zip && !file.rel.contains('/') && is_worn(file));
    let loose: Vec<&FileFacts> = loose.collect();
    let message = format!("{} in no folder of a kind", counted(loose.len(), "asset"));
    out.extend(finding(rule, &loose, "", message, NOT_LISTED, TO_KIND));
    // A copy of what is listed is lost to nobody, and moved there it would be listed twice.
    let listed = Contents::of(files().filter(|file| own.has_at_top(top(file))));
    let are_copies = |files: &[&FileFacts]| files.iter().all(|file| listed.has(file));
    let tops = files().filter_map(|file| Some((file.rel.split_once('/')?.0, file)));
    let mut beside: Vec<&FileFacts> = Vec::new();
    for (top, files) in grouped(tops.filter(|(top, _)| !is_other(top))) {
        let of_targets: Vec<&FileFacts> = files
            .iter()
            .copied()
            .filter(|file| is_target(file))
            .collect();
        let is_known = own.has_at_top(top) || other.has_at_top(top);
        if !is_zip
            && files
                .iter()
                .any(|file| view.layers.checked.is_aside(Application::Mpfb, file))
        {
            beside.extend(
                files
                    .into_iter()
                    .filter(|file| is_worn(file) || is_target(file)),
            );
            continue;
        }
        if !of_targets.is_empty() && !matches!(top, "targets" | "custom") {
            let message = format!(
                "{} in `{top}`, where MPFB does not look for any",
                counted(of_targets.len(), "target")
            );
            let near = nearest(top, ["targets", "custom"]);
            let help = did_you_mean(
                near,
                "move them to `custom`, or to a folder below `targets`",
            );
            out.extend(finding(rule, &of_targets, top, message, NOT_FOUND, help));
        } else if !is_known && let Some(near) = near_of_mpfb(top) {
            let files: Vec<&FileFacts> = files.into_iter().filter(|file| is_asset(file)).collect();
            let message = format!(
                "folder `{top}` is not read ({})",
                counted(files.len(), "file")
            );
            let usual = (NOT_LISTED, did_you_mean(Some(near), ""));
            let (case, help) = if are_copies(&files) {
                (COPIED, REMOVE_COPY.to_owned())
            } else {
                usual
            };
            out.extend(finding(rule, &files, top, message, case, help));
        } else if !is_known && !is_zip && !view.layers.checked.has_folder(&format!("{top}/packs")) {
            let worn: Vec<&FileFacts> = files.into_iter().filter(|file| is_worn(file)).collect();
            let message = format!(
                "{} in `{top}`, where MPFB does not look for any",
                counted(worn.len(), "asset")
            );
            let (case, help) = if are_copies(&worn) {
                (COPIED, REMOVE_COPY)
            } else {
                (NOT_LISTED, TO_KIND)
            };
            out.extend(finding(rule, &worn, top, message, case, help));
        }
    }
    out.extend(aside(rule, &beside));
}

/// Expressions with a suffix that is not looked for.
pub(super) fn in_capitals(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    if view.layers.checks_system() {
        return;
    }
    let expressions = view
        .layers
        .checked
        .files
        .values()
        .filter(|file| !file.is_loose && file.rel.starts_with("expressions/"));
    out.extend(
        expressions
            .filter(|file| is_in_capitals(file, "json"))
            .map(|file| capitals(rule, file, "json")),
    );
}

/// Whether a file has the suffix in other capitals than it is looked for.
pub(super) fn is_in_capitals(file: &FileFacts, suffix: &str) -> bool {
    let own = extension(&file.rel);
    own != suffix && own.eq_ignore_ascii_case(suffix)
}

/// The suffix is not written as it is looked for.
pub(super) fn capitals(rule: &Rule, file: &FileFacts, suffix: &str) -> Finding {
    let finding = rule.at(
        file,
        Place::File,
        format!(
            "`{}` must end in `.{suffix}`: capitals matter",
            file.file_name()
        ),
    );
    finding
        .key("suffix")
        .help("write the suffix in small letters")
}

const TO_KIND: &str = "move them to the folder of their kind, such as `clothes` or `hair`";

fn is_worn(file: &FileFacts) -> bool {
    matches!(extension(&file.rel), "mhclo" | "proxy") && !is_outdated(file)
}

fn is_target(file: &FileFacts) -> bool {
    file.rel.ends_with(".target") || file.rel.ends_with(".target.gz")
}

fn is_asset(file: &FileFacts) -> bool {
    matches!(
        extension(&file.rel),
        "mhclo" | "proxy" | "mhmat" | "bvh" | "json"
    ) || file.rel.ends_with(".json.gz")
}

fn finding(
    rule: &Rule,
    files: &[&FileFacts],
    folder: &str,
    message: String,
    case: Case,
    help: impl Into<String>,
) -> Option<Finding> {
    let finding = rule
        .at(files.first()?, Place::File, message)
        .key(format!("folder {folder}"))
        .case(case);
    let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
    Some(
        finding
            .evidence(Evidence::of_cases(files.iter().map(|file| file.shown())))
            .help(help),
    )
}
