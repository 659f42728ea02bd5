//! Files that nothing opens.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use super::loader::{extension, fixed_name, opens};
use crate::diag::{Application, Evidence, Finding, Level, RuleInfo, nearest};
use crate::discover::Kind;
use crate::repo::{Base, FileFacts, ReferenceKind, Repository, Resolution, TargetFolder};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "never opens it")],
        docs: "Nothing in the repository refers to the file, and no loader looks for its name. It does no harm, but it is often the sign of a \
            slip: an icon whose slider is called differently, a target packed as `.target.gz` (MakeHuman 2 reads plain targets only), an \
            extension in capitals, a backup copy.\n\nLooked at are the icons of targets and the folders `target`, `contarget`, \
            `rigs` and `base` of each base mesh; notes and licences are left alone. Targets and weights have rules of their \
            own.\n\nGive the file the name that is looked for, refer to it, or remove it.",
        ..RuleInfo::new("file-unreferenced", Level::Info, "a file that nothing refers to and no loader opens")
    },
    check: Check::Repository(run),
};

fn run(repository: &Repository<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let used = icons_in_use(repository);
    // One finding for a folder and reason: a folder of packed targets is one decision.
    let mut idle: BTreeMap<(&str, Reason), Vec<&FileFacts>> = BTreeMap::new();
    for file in repository.judged.files.values() {
        let folder = file.rel.rsplit_once('/').map_or("", |(folder, _)| folder);
        if let Some(reason) = reason(repository, file, &used) {
            idle.entry((folder, reason)).or_default().push(file);
        }
    }
    for ((folder, reason), files) in idle {
        let names = files.iter().map(|file| file.file_name());
        let finding = match files.as_slice() {
            [file] => {
                RULE.in_layer(repository.judged, &file.rel, format!("`{}` is not used: {}", file.file_name(), reason.1))
            }
            [first, .., last] => {
                let (count, first, last) = (files.len(), first.file_name(), last.file_name());
                let message = format!("{count} files here (`{first}` to `{last}`) are not used: {}", reason.1);
                RULE.in_layer(repository.judged, folder, message)
            }
            [] => continue,
        };
        let help = "give it the name that is looked for, refer to it, or remove it";
        let asset = repository.judged.display(folder);
        out.push(finding.key(reason.0).asset(asset).evidence(Evidence::of_cases(names)).help(help));
    }
}

/// A word for the reason, and the reason in words.
type Reason = (String, String);

/// Why nothing uses the file, if nothing does.
fn reason(repository: &Repository<'_>, file: &FileFacts, used: &BTreeSet<String>) -> Option<Reason> {
    let name = file.file_name();
    // A file called `icons` stands in the place of a folder: unreadable.
    if file.encoding.lfs_pointer || file.gzip_fault.is_some() || name == "icons" || is_note(name) {
        return None;
    }
    if file.kind == Kind::TargetIcon {
        let idle = is_icon_store(repository, file) && !used.contains(&file.rel) && !is_misspelt(repository, name);
        return idle.then(|| ("icon".to_owned(), "no slider has this icon".to_owned()));
    }
    // `file-case-mismatch` names a file that takes the place of one that is needed.
    let misnamed = fixed_name(&file.rel).is_some_and(|right| repository.judged.file(&right).is_none());
    if misnamed || !is_judged_folder(&file.rel) || opens(&file.rel) {
        return None;
    }
    Some(match (file.kind, name.to_lowercase()) {
        (Kind::PackedTarget, _) => {
            ("packed".to_owned(), "MakeHuman 2 reads no packed targets, only `.target`".to_owned())
        }
        (_, lower) if lower != name && opens(&format!("{}{lower}", folder_of(&file.rel))) => (
            format!("capitals {lower}"),
            format!("extensions and names count with their capitals, `{lower}` is looked for"),
        ),
        (Kind::Image, _) => ("picture".to_owned(), "icons are looked for in `icons/` of the target folder".to_owned()),
        _ => ("name".to_owned(), "no loader opens a file of this name here".to_owned()),
    })
}

fn folder_of(rel: &str) -> &str {
    rel.rfind('/').and_then(|at| rel.get(..=at)).unwrap_or_default()
}

fn is_judged_folder(rel: &str) -> bool {
    let parts: Vec<&str> = rel.split('/').collect();
    matches!(parts.as_slice(), ["target" | "contarget" | "rigs" | "base", _, _, ..]) && extension(rel) != "thumb"
}

/// Texts for people.
fn is_note(name: &str) -> bool {
    let lower = name.to_lowercase();
    let words = ["readme", "licen", "copying", "authors", "changelog", "changes", "credits", "notice", "copyright"];
    let endings = ["txt", "md", "rst", "html", "pdf"];
    words.iter().any(|word| lower.starts_with(word)) || endings.contains(&extension(&lower))
}

/// Icons count as unused only where the sliders that could name them are known: in the folder in use.
fn is_icon_store(repository: &Repository<'_>, file: &FileFacts) -> bool {
    let inside = |folder: Option<TargetFolder<'_>>| {
        folder.is_some_and(|folder| {
            std::ptr::eq(folder.layer, repository.judged) && file.rel.starts_with(&format!("{}/icons/", folder.rel()))
        })
    };
    repository.bases.iter().any(|base| {
        let known =
            base.modelling.winner().is_some() && !base.modelling.contarget.is_refused() && !base.has_unreadable_icons();
        (known && inside(base.targets)) || inside(base.user_targets)
    })
}

/// Whether a slider asks for an icon that is not there and must mean this one: that name is the fault.
fn is_misspelt(repository: &Repository<'_>, name: &str) -> bool {
    let icons = repository.references.iter().filter(|reference| reference.kind == ReferenceKind::Icon);
    let mut lost = icons.filter(|reference| !matches!(reference.resolution, Resolution::Found(_)));
    let bases = repository.bases.iter();
    lost.any(|reference| {
        // With a wrong path in front of it, the name itself may be right.
        let last = reference.text.rsplit(['/', '\\']).next().unwrap_or_default();
        last == name || nearest(last, [name]).is_some()
    }) || bases.flat_map(|base| &base.sliders).any(|slider| slider.as_meant().icon.as_deref() == Some(name))
}

fn icons_in_use(repository: &Repository<'_>) -> BTreeSet<String> {
    let icons = repository.references.iter().filter(|reference| reference.kind == ReferenceKind::Icon);
    let mut used: BTreeSet<String> = icons
        .filter_map(|reference| match reference.resolution {
            Resolution::Found(file) | Resolution::CaseOnly(file) => Some(file.rel.clone()),
            _ => None,
        })
        .collect();
    repository.bases.iter().for_each(|base| used.extend(generated_icons(base)));
    used
}

/// Icons that the sliders get which MakeHuman 2 makes from user targets (formats/makehuman2.md §5.2).
fn generated_icons<'a>(base: &'a Base<'_>) -> impl Iterator<Item = String> + 'a {
    let folders = base.user_targets.into_iter();
    folders.flat_map(|folder| {
        let names = folder.targets().filter_map(move |file| folder.name_of(file));
        names.flat_map(move |name| {
            let flat = name.replacen('/', "-", 1);
            let pair = flat.strip_suffix("-incr").map(str::to_owned);
            [Some(flat), pair].into_iter().flatten().map(move |stem| format!("{}/icons/{stem}.png", folder.rel()))
        })
    })
}
