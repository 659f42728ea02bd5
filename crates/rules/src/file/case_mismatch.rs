//! References that only a file system without regard to case resolves.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::differing;
use super::super::{Check, Rule, RuleCx};
use super::named::{Cause, causes, differs_in_form, written};
use super::spelling::{
    as_on_disk, differs_in_extension, folder_on_disk, found, plain, respelled,
    without_common_folders,
};
use super::{fixed_names, folders};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Change, EXAMPLES, Finding, Fix, FixKind, Level, Place, RuleInfo,
};
use mhlint_discover::extension;
use mhlint_repo::{Reference, ReferenceKind, Resolution, View};
use mhlint_source::file_name;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    fix: FixKind::Unsafe,
    breaks: &[
        (
            Makehuman2,
            "finds the file on Windows and macOS, but not on Linux",
        ),
        (
            Makehuman1,
            "finds the file on Windows and macOS, but not on Linux",
        ),
        (
            Mpfb,
            "finds the file on Windows and macOS, but not on Linux",
        ),
    ],
    docs: include_str!("case_mismatch.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-case-mismatch",
        Level::Error,
        "a reference that differs from its file only in case",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    fixed_names::findings(&RULE, view, out);
    let mut told = BTreeSet::new();
    for cause in causes(view, |reference| {
        found(reference).map(|found| differing(&plain(&reference.rel), found).0)
    }) {
        let Some(first) = cause.references.first() else {
            continue;
        };
        let Some(target) = found(first) else { continue };
        // A skin that is not listed for its extension is reported as such.
        if first.kind == ReferenceKind::Skin
            && extension(target) != "mhmat"
            && view.layers().checked.file(target).is_some()
        {
            continue;
        }
        let written = plain(&first.rel);
        let (name, on_disk) = differing(&written, target);
        let holder = view
            .layers()
            .strongest_first()
            .find(|layer| layer.file(target).is_some());
        let in_form = differs_in_form(first);
        told.insert(on_disk.clone());
        let finding = cause.finding(&RULE, |_| {
            if in_form {
                return format!(
                    "`{name}` differs from the name on disk only in Unicode normalisation"
                );
            }
            let (name, on_disk) = without_common_folders(&name, &on_disk);
            format!("`{name}` is named `{on_disk}` on disk")
        });
        let Some(finding) = finding else { continue };
        let systems = if in_form {
            "on Linux and Windows"
        } else {
            "on Linux"
        };
        let mut finding = cause.unfound(view, finding, systems);
        if matches!(first.resolution, Resolution::Backslash(_)) && folder_on_disk(first).is_none() {
            // The folder in front is at fault for its backslashes only.
            finding.place = first.place.clone();
        }
        if let Some(layer) = holder {
            finding = finding.related(layer.display(target), Place::File, "the file on disk");
        }
        let what = if on_disk == target { "file" } else { "folder" };
        if in_form {
            let help = format!(
                "name the {what} without accents here and on disk, or copy its name from the disk"
            );
            out.push(finding.help(help));
            continue;
        }
        let meant = meant(first, &name, &on_disk);
        if differs_in_extension(&written, target) {
            let right = file_name(&written);
            out.push(finding.help(format!(
                "rename the file to `{right}`: extensions are case-sensitive"
            )));
            continue;
        }
        let alike = holder.map(|layer| layer.alike(target)).unwrap_or_default();
        if let Some(others) = others(alike, target) {
            let help = format!(
                "write the name of one of these files, and remove what is not used: `{target}`, \
                    {others}"
            );
            out.push(finding.help(help));
            continue;
        }
        // A folder that the file does not name has the name of a base mesh, or of a library.
        let last = file_name(&name);
        if what == "folder" && folder_on_disk(first).is_none() && !first.text.contains(last) {
            out.push(finding.help(format!("rename the folder to `{last}`")));
            continue;
        }
        let fix = fix(view, &cause, &format!("write `{meant}`"));
        out.push(
            finding
                .fix(fix)
                .help(format!("write `{meant}`, or rename the {what}")),
        );
    }
    out.extend(folders::findings(&RULE, view, &told));
}

/// The other files that are called nearly so, a few of them by name.
fn others(alike: &[String], target: &str) -> Option<String> {
    let named = alike.iter().filter(|other| *other != target).take(EXAMPLES);
    let mut named: Vec<String> = named.map(|other| format!("`{other}`")).collect();
    if let Some(more @ 1..) = alike.len().checked_sub(named.len() + 1) {
        named.push(format!("and {more} more"));
    }
    (!named.is_empty()).then(|| named.join(", "))
}

/// What to write, as far as possible in the words of the file that is at fault.
fn meant(first: &Reference<'_>, name: &str, on_disk: &str) -> String {
    if matches!(first.kind, ReferenceKind::Slot | ReferenceKind::SliderName) {
        // A slot holds the name of the file without its suffix.
        let file = file_name(on_disk);
        return file.split(".target").next().unwrap_or(file).to_owned();
    }
    if let (ReferenceKind::Texture, Some(found)) = (first.kind, found(first)) {
        return respelled(first.text, found);
    }
    let is_whole = found(first).is_some_and(|found| found == on_disk);
    if let Some(text) = as_on_disk(first).filter(|_| is_whole) {
        return text;
    }
    match (name.rsplit_once('/'), on_disk.rsplit_once('/')) {
        (Some((above, _)), Some((same, last))) if above == same && !is_whole => last.to_owned(),
        _ => on_disk.to_owned(),
    }
}

/// Writes the folder that is at fault, or all names; nothing if one of them is known elsewhere as
/// it is.
fn fix(view: &View<'_>, cause: &Cause<'_, '_>, title: &str) -> Fix {
    let fix = Fix::new(RULE.info.fix, title);
    let folders: Option<BTreeMap<_, _>> = cause
        .references
        .iter()
        .map(|reference| folder_on_disk(reference))
        .collect();
    if let (Some(folders), Some(first)) = (folders, cause.references.first()) {
        return folders.into_iter().fold(fix, |fix, (pointer, text)| {
            fix.step(
                &first.from.path,
                Change::Value {
                    pointer,
                    text: Some(text),
                },
            )
        });
    }
    let names = cause.references.iter().map(|reference| {
        let text = as_on_disk(reference).filter(|_| !view.is_known_by(reference))?;
        Some((*reference, text))
    });
    let names: Vec<_> = names.collect::<Option<_>>().unwrap_or_default();
    names.into_iter().fold(fix, |fix, (reference, text)| {
        written(fix, reference, Some(text))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_many_files_that_are_alike_a_few_are_named() {
        let alike: Vec<String> = (0..1000).map(|number| format!("a{number}")).collect();
        assert_eq!(others(&alike[..1], "a0"), None);
        assert_eq!(others(&alike[..3], "a1").unwrap(), "`a0`, `a2`");
        assert_eq!(
            others(&alike[..6], "a5").unwrap(),
            "`a0`, `a1`, `a2`, `a3`, `a4`"
        );
        assert!(
            others(&alike, "a3")
                .unwrap()
                .ends_with("`a5`, and 994 more")
        );
    }
}
