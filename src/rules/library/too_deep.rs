//! An asset lies where the list looks, under a name that it takes.

use super::super::{Check, Rule, RuleCx};
use super::{SUFFIXES, suffix};
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use crate::discover::{extension, in_place_of};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "does not list it")],
    docs: "MakeHuman 2 looks for assets in the folder of the base mesh (`clothes/<base>/`) and in the folders directly in it. It \
        takes suffixes as they are written: `.mhclo`, not `.MHCLO`.\n\n\
        An asset in a deeper folder, with a suffix in capitals or with another suffix behind its own (`vest.mhclo.txt`, which \
        Windows shows as `vest.mhclo`) is not listed, and models that wear it lose it. On all systems.\n\n\
        Move the folder of the asset up, or rename the file.",
    ..RuleInfo::new("library-too-deep", Level::Error, "an asset that the list does not find")
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let parts: Vec<&str> = file.rel.split('/').collect();
    let [category, base, .., name] = parts.as_slice() else { return };
    let is_for = |suffix: &str| in_place_of(suffix).contains(category);
    let is_skin = *category == "skins" && extension(name) == "mhmat";
    let finding = match suffix(name).filter(|suffix| is_for(suffix)) {
        _ if is_used_elsewhere(view, file) => return,
        Some(suffix) if extension(name) != suffix => {
            let message = format!("`{name}` must end in `.{suffix}`: capitals matter");
            RULE.at(file, Place::File, message).key("suffix").help(format!("rename it to end in `.{suffix}`"))
        }
        _ if parts.len() > 4 && (is_skin || suffix(name).is_some_and(is_for)) => {
            let message =
                format!("`{name}` lies {} folders below `{category}/{base}`, expected 1 at most", parts.len() - 3);
            let asset = parts.get(parts.len() - 2).copied().unwrap_or_default();
            let help = format!("move the folder `{asset}` to `{category}/{base}`");
            RULE.at(file, Place::File, message).key("deep").help(help)
        }
        None if parts.len() <= 4 => match double(view, file).filter(|suffix| is_for(suffix)) {
            Some(suffix) => {
                let (right, _) = name.rsplit_once('.').unwrap_or((name, ""));
                let message = format!("`{name}` has another suffix behind `.{suffix}`");
                RULE.at(file, Place::File, message).key("suffix").help(format!("rename it to `{right}`"))
            }
            None => return,
        },
        _ => return,
    };
    out.push(finding);
}

/// The suffix of an asset in front of another one, where there is no asset of that name: then it would be a copy.
fn double(view: &View<'_>, file: &FileFacts) -> Option<&'static str> {
    let (right, last) = file.rel.rsplit_once('.')?;
    let suffix = SUFFIXES.into_iter().find(|suffix| *suffix == extension(right))?;
    let is_text = matches!(last, "txt" | "text" | "json" | "html");
    (is_text && view.layers().checked.file(right).is_none()).then_some(suffix)
}

/// Whether something names the file, such as `base.json` a skeleton.
fn is_used_elsewhere(view: &View<'_>, file: &FileFacts) -> bool {
    view.references().to_file(file).any(|reference| reference.found().is_some())
}
