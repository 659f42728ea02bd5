//! Files that nothing opens.

use super::super::{Check, Rule, RuleCx, cause::outdated::is_outdated};
use super::references::References;
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, RuleInfo, grouped};
use mhlint_discover::{Kind, Layout, extension};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "never opens it")],
    docs: include_str!("unreferenced.md").trim_ascii_end(),
    counts: "files",
    of_whole: true,
    ..RuleInfo::new(
        "file-unreferenced",
        Level::Info,
        "a file that nothing refers to and no loader opens",
    )
});

/// Folders of base meshes of which it is known what the loaders open.
const FOLDERS: [&str; 4] = ["target", "contarget", "rigs", "base"];

/// Of the user's targets every one that is called so becomes a slider.
const NO_SLIDER: Case = &[(
    Makehuman2,
    Level::Warning,
    "makes no slider for it: the extension must be `.target`",
)];

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let references = References::of(view, base);
    let files = FOLDERS.iter().flat_map(|folder| {
        view.layers
            .checked
            .below(&format!("{folder}/{}", base.name))
    });
    // One finding for a folder and reason: a folder of packed targets is one decision.
    let idle =
        grouped(files.filter_map(|file| {
            Some(((parent(&file.rel), reason(base, file, &references)?), file))
        }));
    for ((folder, reason), files) in idle {
        let names = files.iter().map(|file| file.file_name());
        let parts = files.iter().map(|file| (file.file_name(), &file.path));
        let finding = match files.as_slice() {
            [file] => {
                let message = format!("`{}` is not used: {}", file.file_name(), reason.1);
                RULE.in_layer(view.layers.checked, &file.rel, message)
            }
            [first, ..] => {
                let (count, first) = (files.len(), first.file_name());
                let message = format!("{count} files are not used, first `{first}`: {}", reason.1);
                RULE.in_layer(view.layers.checked, folder, message)
            }
            [] => continue,
        };
        let is_lost = reason.0.ends_with(".target")
            && base.user_targets.is_some()
            && folder.starts_with("target/");
        let finding = match files.len() {
            _ if is_lost => finding.case(NO_SLIDER),
            1 => finding,
            _ => finding.effect("never opens them"),
        };
        let finding = finding
            .help(help(&reason.0))
            .key(reason.0)
            .asset(view.layers.checked.display(folder));
        out.push(finding.parts_in(parts).evidence(Evidence::of_cases(names)));
    }
}

/// What to do about files that have a reason in common.
fn help(reason: &str) -> &'static str {
    match reason {
        "packed" => "unpack it with `gzip -d` and give it a slider, or keep it outside of the data",
        "icon" => {
            "write its name in the `icon` of a slider, rename it after the first target of a \
                slider, or keep it outside of the data"
        }
        "picture" => "if it is an icon, move it to `icons/`; otherwise keep it outside of the data",
        reason if reason.ends_with(".target") => {
            "rename it to end in `.target`; give it a slider if it has none"
        }
        reason if reason.starts_with("capitals") => {
            "rename it, with its extension in small letters"
        }
        _ => {
            "correct the name, or keep it outside of the data: backups and sources are not needed \
                there"
        }
    }
}

/// A word for the reason, and the reason in words.
type Reason = (String, String);

/// Why nothing uses the file, if nothing does.
fn reason(base: &Base<'_>, file: &FileFacts, references: &References<'_>) -> Option<Reason> {
    let (name, layer, layout) = (file.file_name(), references.layer(), Layout::of(Makehuman2));
    // A file `icons` is unreadable; a format that nobody reads is reported of the whole folder.
    let is_told = file.encoding.lfs_pointer || file.gzip_fault.is_some() || is_outdated(file);
    if is_told || name == "icons" || is_note(name) {
        return None;
    }
    if file.kind == Kind::TargetIcon {
        let is_idle = references.leave_icon(base, file);
        return is_idle.then(|| ("icon".to_owned(), "no slider uses this icon".to_owned()));
    }
    // `file-case-mismatch` names a file that takes the place of one that is needed.
    if (layout.misnamed)(&file.rel, &|rel| layer.file(rel).is_some()).is_some()
        || references.mean(file)
        || extension(&file.rel) == "thumb"
        || (layout.opens)(&file.rel)
    {
        return None;
    }
    Some(match (file.kind, name.to_lowercase()) {
        (Kind::PackedTarget, _) => (
            "packed".to_owned(),
            "MakeHuman 2 reads only plain `.target` files".to_owned(),
        ),
        (_, lower)
            if lower != name && (layout.opens)(&format!("{}/{lower}", parent(&file.rel))) =>
        {
            (
                format!("capitals {lower}"),
                format!("names are case-sensitive, expected `{lower}`"),
            )
        }
        (Kind::Image, _) => (
            "picture".to_owned(),
            "icons must be in `icons/` of the target folder".to_owned(),
        ),
        _ => (
            "name".to_owned(),
            "no program opens files with such names here".to_owned(),
        ),
    })
}

/// Texts for people, and programs: a plug-in may bring its skeleton along.
fn is_note(name: &str) -> bool {
    let lower = name.to_lowercase();
    let words = [
        "readme",
        "licen",
        "copying",
        "authors",
        "changelog",
        "changes",
        "credits",
        "notice",
        "copyright",
    ];
    let endings = [
        "txt", "md", "rst", "html", "pdf", "py", "pyc", "pyd", "pyi", "toml", "sh", "bat", "cfg",
    ];
    words.iter().any(|word| lower.starts_with(word)) || endings.contains(&extension(&lower))
}
