//! Targets that no slider and no macro uses.

use super::super::{Check, Rule, RuleCx};
use super::unused_pairs::Pairing;
use super::{meant::meant_by_missing, parent, shipped_unused};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Layer};

pub(crate) static RULE: Rule = Check::Libraries(run, |view, cx, out| {
    shipped_unused::unused(&RULE, view, cx, out);
})
.rule(RuleInfo {
    told_apart: true,
    breaks: &[
        (
            Makehuman2,
            "packs it whenever it builds the archive, but never applies it",
        ),
        (
            Makehuman1,
            "never applies it: no modifier asks for its group",
        ),
    ],
    docs: include_str!("unreferenced.md").trim_ascii_end(),
    counts: "targets",
    of_whole: true,
    ..RuleInfo::new(
        "target-unreferenced",
        Level::Warning,
        "no slider and no macro uses a target",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    view.bases
        .iter()
        .for_each(|base| of_base(view, base, cx, out));
}

fn of_base(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(folder) = base.targets else { return };
    let named = |file: &&FileFacts| {
        folder
            .name_of(file)
            .is_some_and(|name| !base.keeps_for_macros(name))
    };
    let own = |file: &&FileFacts| {
        folder
            .layer
            .file(&file.rel)
            .is_some_and(|own| std::ptr::eq(own, *file))
    };
    let unused: Vec<&FileFacts> = view
        .unused(base)
        .iter()
        .copied()
        .filter(own)
        .filter(named)
        .collect();
    let meant = meant_by_missing(view, base, &unused, &cx.suggestions);
    let idle = unused
        .into_iter()
        .filter(|file| !meant.contains(file.rel.as_str()) && !breaks_start(file));
    let folders = grouped(idle.map(|file| (parent(&file.rel), file)));
    let pairing = Pairing::of(base);
    let is_lost = lost_macrodefs(base) || base.lacks_macrodef();
    for (path, files) in folders {
        let all = folder
            .layer
            .below(path)
            .filter(|file| file.target().is_some())
            .count();
        if files.len() > 1 && files.len() == all {
            // Probably the folder of a definition that cannot be read.
            if is_lost {
                continue;
            }
            out.push(whole_folder(folder.layer, path, &files));
        } else {
            out.extend(pairing.of_files(&files).into_iter().map(|(file, decr)| {
                let name = folder.name_of(file).unwrap_or_default();
                let finding = decr.and_then(|decr| folder.name_of(decr)).map_or_else(
                    || single(&pairing, file, name),
                    |decr| pair(file, name, decr),
                );
                part_of(
                    finding,
                    folder.layer,
                    path,
                    std::iter::once(file).chain(decr),
                )
            }));
        }
    }
}

/// Whether `macro.json` has no definition at all, or one that is not read: that finding speaks for
/// its folder, too.
fn lost_macrodefs(base: &Base<'_>) -> bool {
    let Some((file, macros)) = base.macro_file() else {
        return false;
    };
    let whole = |pointer: &str| {
        pointer
            .strip_prefix("/macrodef")
            .is_some_and(|rest| rest.matches('/').count() <= 1)
    };
    let is_lost = |fault: &mhlint_json::SchemaFault| {
        let number = fault
            .pointer
            .strip_prefix("/macrodef/")
            .and_then(|number| number.parse::<usize>().ok());
        let own = number.and_then(|number| macros.macrodefs.get(number));
        whole(&fault.pointer)
            && own.is_none_or(|own| own.effective_folder.is_none() || own.links.is_empty())
    };
    macros.macrodefs.is_empty() && !macros.components.is_empty()
        || file.schema.faults.iter().any(is_lost)
}

/// What cannot be parsed is worse than unused.
fn breaks_start(file: &FileFacts) -> bool {
    let is_no_text = file.encoding.invalid_utf8_at.is_some();
    is_no_text || file.target().is_some_and(|facts| facts.unreadable_rows > 0)
}

fn pair(file: &FileFacts, incr: &str, decr: &str) -> Finding {
    RULE.at(
        file,
        Place::File,
        format!("no slider and no macro uses `{incr}` or `{decr}`"),
    )
    .help(format!(
        "add a slider with `\"incr\": \"{incr}\"` and `\"decr\": \"{decr}\"` to modelling.json, \
            or keep the files outside of the data"
    ))
}

fn whole_folder(layer: &Layer, path: &str, files: &[&FileFacts]) -> Finding {
    let message = format!(
        "no slider and no macro uses any of the {} targets in this folder",
        files.len()
    );
    let evidence =
        Evidence::of_cases(files.iter().map(|file| file.file_name())).out_of(files.len());
    let finding = part_of(
        RULE.in_layer(layer, path, message),
        layer,
        path,
        files.iter().copied(),
    );
    finding
        .help("add sliders to modelling.json, or keep the folder outside of the data")
        .evidence(evidence)
}

/// Files of a folder are told one by one or all together, as it comes.
fn part_of<'f>(
    finding: Finding,
    layer: &Layer,
    folder: &str,
    files: impl Iterator<Item = &'f FileFacts>,
) -> Finding {
    finding
        .asset(layer.display(folder))
        .parts_in(files.map(|file| (file.file_name(), &file.path)))
}

fn single(pairing: &Pairing<'_>, file: &FileFacts, name: &str) -> Finding {
    let finding = RULE.at(
        file,
        Place::File,
        format!("no slider and no macro uses `{name}`"),
    );
    finding.help(match pairing.slider_without(name) {
        // A slider with a space in its name cannot be saved.
        _ if name.contains(char::is_whitespace) => "remove the file, or remove the spaces from \
            its name"
            .to_owned(),
        Some(key) => format!(
            "add `\"decr\": \"{name}\"` to the slider `{key}` in modelling.json, or keep the file \
                outside of the data"
        ),
        None => format!(
            "add a slider with `\"incr\": \"{name}\"` to modelling.json, or keep the file \
                outside of the data"
        ),
    })
}
