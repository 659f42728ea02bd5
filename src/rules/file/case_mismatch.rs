//! References that only a file system without regard to case resolves.

use super::super::{Check, Rule, RuleCx};
use super::loader::{is_generated, misnamed};
use super::named::{causes, effect, is_known_by, written};
use crate::diag::{Application, Finding, Fix, FixKind, Level, Place, RuleInfo};
use crate::repo::{Reference, Repository, Resolution};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        fix: FixKind::Unsafe,
        breaks: &[(Application::Makehuman2, "finds it on Windows and macOS, on Linux it does not exist")],
        docs: "The name is written with other capitals than the file has. On Windows and on most Macs that makes no difference, on Linux it \
            does, and inside `compressedtargets.npz` everywhere.\n\nWhat follows is what follows from a missing file: an exception when \
            the slider moves, a refused skeleton, an empty button.\n\nThe same goes for base.json, base.obj, macro.json, modelling.json and target_cat.json, which are looked for by these names alone.\n\nWrite the name exactly as the file is called, or rename \
            the file. A folder whose name differs is reported once for the file that refers into it.",
        ..RuleInfo::new("file-case-mismatch", Level::Error, "a reference that differs from its file in case")
    },
    check: Check::Repository(run),
};

fn run(repository: &Repository<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    fixed_names(repository, out);
    for cause in causes(repository, |reference| found(reference).map(|found| differing(&reference.rel, found).0)) {
        let Some(first) = cause.references.first() else { continue };
        let Some(target) = found(first) else { continue };
        let (name, on_disk) = differing(&first.rel, target);
        let holder = repository.strongest_first().find(|layer| layer.file(target).is_some());
        let finding = cause.finding(&RULE, |_| format!("`{name}` is called `{on_disk}` on disk"));
        let Some(mut finding) = finding else { continue };
        finding = finding.breaks(Application::Makehuman2, format!("on Linux: {}", effect(first.kind)));
        if let Some(layer) = holder {
            finding = finding.related(layer.display(target), Place::File, "the file that is meant");
        }
        let names = cause.references.iter().map(|reference| {
            let text = as_on_disk(reference).filter(|_| !is_known_by(repository, reference))?;
            Some((*reference, text))
        });
        let mut wanted = on_disk;
        if let Some(names) = names.collect::<Option<Vec<_>>>() {
            if let [(_, text)] = names.as_slice() {
                wanted.clone_from(text);
            }
            let fix = Fix::new(RULE.info.fix, format!("write `{wanted}`"));
            let fix = names.into_iter().fold(fix, |fix, (reference, text)| written(fix, reference, Some(text)));
            finding = finding.fix(fix);
        }
        out.push(finding.help(format!("write `{wanted}`, or rename the file")));
    }
}

/// A file that MakeHuman 2 looks for by a fixed name.
fn fixed_names(repository: &Repository<'_>, out: &mut Vec<Finding>) {
    let layer = repository.judged;
    for file in layer.files.values().filter(|file| !is_generated(repository, file)) {
        let Some(right) = misnamed(layer, &file.rel) else { continue };
        let (name, wanted) = (file.file_name(), right.rsplit('/').next().unwrap_or_default());
        let message = format!("`{name}` is looked for as `{wanted}`");
        let effect = if right.starts_with("base/") {
            "on Linux: does not load the base mesh".to_owned()
        } else {
            format!("on Linux: takes `{wanted}` as missing, without a word")
        };
        let finding = RULE.at(file, Place::File, message).key("name").help(format!("rename it to `{wanted}`"));
        out.push(finding.breaks(Application::Makehuman2, effect));
    }
}

fn found<'a>(reference: &Reference<'a>) -> Option<&'a str> {
    if let Resolution::CaseOnly(file) = reference.resolution { Some(&file.rel) } else { None }
}

/// The name as it has to be written; nothing where the difference is not in the name itself but around it.
fn as_on_disk(reference: &Reference<'_>) -> Option<String> {
    let found = found(reference)?;
    // Targets are named without their suffix.
    let stems = [Some(reference.rel.as_str()), reference.rel.strip_suffix(".target")];
    let start = stems.into_iter().flatten().find_map(|stem| stem.strip_suffix(reference.text))?.len();
    let end = start + reference.text.len();
    let around = |rel: &str| Some((rel.get(..start)?.to_owned(), rel.get(end..)?.to_owned()));
    (around(&reference.rel)? == around(found)?).then(|| found.get(start..end).map(str::to_owned))?
}

/// The shortest beginnings of both paths that hold the whole difference: a folder, where one differs.
fn differing(written: &str, real: &str) -> (String, String) {
    let (mut a, mut b) = (Vec::new(), Vec::new());
    let mut differ = 0;
    for (index, (left, right)) in written.split('/').zip(real.split('/')).enumerate() {
        a.push(left);
        b.push(right);
        if left != right {
            differ = index + 1;
        }
    }
    a.truncate(differ);
    b.truncate(differ);
    (a.join("/"), b.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_named_without_what_is_in_it() {
        let both = |a: &str, b: &str| (a.to_owned(), b.to_owned());
        assert_eq!(differing("t/Head/a.target", "t/head/a.target"), both("t/Head", "t/head"));
        assert_eq!(differing("t/Head/A.target", "t/head/a.target"), both("t/Head/A.target", "t/head/a.target"));
    }
}
