//! Files that nothing opens.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, cause::outdated::is_outdated};
use super::icons;
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, RuleInfo, grouped};
use mhlint_discover::{Kind, Layout, extension};
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Reference, ReferenceKind, Resolution};
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

/// What the references of a repository say about its files.
struct References<'r> {
    view: &'r View<'r>,
    used_icons: BTreeSet<String>,
    icons: icons::Icons<'r>,
    /// Names of files that are not there, of which one may be there packed.
    missing: BTreeSet<&'r str>,
}

impl<'r> References<'r> {
    fn of(view: &'r View<'_>, base: &'r Base<'_>) -> Self {
        let missing = view
            .references_of(base)
            .filter(|one| matches!(one.resolution, Resolution::Missing));
        let missing = missing.map(|reference| reference.rel.as_str()).collect();
        Self {
            view,
            used_icons: icons::in_use(view, base),
            icons: icons::Icons::of(view, base),
            missing,
        }
    }

    /// Whether a texture, or what something names but for capitals: the finding on that reference
    /// names the file.
    fn mean(&self, file: &FileFacts) -> bool {
        let means = |reference: &Reference<'_>| match reference.resolution {
            // A texture may be called anything.
            Resolution::Found(_) => reference.kind == ReferenceKind::Texture,
            _ => true,
        };
        self.view.references.to_file(file).any(means)
            || file
                .rel
                .strip_suffix(".gz")
                .is_some_and(|unpacked| self.missing.contains(unpacked))
    }
}

/// Why nothing uses the file, if nothing does.
fn reason(base: &Base<'_>, file: &FileFacts, references: &References<'_>) -> Option<Reason> {
    let (name, layer, layout) = (
        file.file_name(),
        references.view.layers.checked,
        Layout::of(Makehuman2),
    );
    // A file `icons` is unreadable; a format that nobody reads is reported of the whole folder.
    let is_told = file.encoding.lfs_pointer || file.gzip_fault.is_some() || is_outdated(file);
    if is_told || name == "icons" || is_note(name) {
        return None;
    }
    if file.kind == Kind::TargetIcon {
        let idle = icons::is_store(layer, base, file) && !references.used_icons.contains(&file.rel);
        let icons = &references.icons;
        let idle = idle && !icons.is_misspelt(name) && !icons.is_of_unused_target(file.stem());
        return idle.then(|| ("icon".to_owned(), "no slider uses this icon".to_owned()));
    }
    // `file-case-mismatch` names a file that takes the place of one that is needed.
    if (layout.misnamed)(&file.rel, &|rel| layer.file(rel).is_some()).is_some()
        || references.used_icons.contains(&file.rel)
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
            if lower != name && (layout.opens)(&format!("{}{lower}", folder_of(&file.rel))) =>
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

fn folder_of(rel: &str) -> &str {
    rel.rfind('/')
        .and_then(|at| rel.get(..=at))
        .unwrap_or_default()
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
