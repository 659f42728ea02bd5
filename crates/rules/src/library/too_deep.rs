//! An asset lies where the list looks, under a name that it takes.

use super::super::cause::outdated::is_outdated;
use super::super::{Check, Rule, RuleCx};
use super::{Homes, SUFFIXES, custom_targets, homes, makehuman1 as library, mpfb, shelves, suffix};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_discover::{extension, in_place_of, library_extension};
use mhlint_repo::makehuman2::View;
use mhlint_repo::{FileFacts, Layer, makehuman1};
use mhlint_source::{depth, parent};

pub(crate) static RULE: Rule = Check::LibrariesOfAll(run, of_makehuman1, |view, _, out| {
    shelves::in_capitals(&RULE, view, out);
    mpfb::in_capitals(&RULE, view, out);
    let layer = view.layers.checked;
    let files = layer.files.values().filter(|file| !file.is_loose);
    let homes = homes(layer);
    let lost = files.filter(|file| {
        double(layer, &homes, file).is_some_and(|suffix| shelves::lists(file, suffix))
    });
    out.extend(lost.map(doubled));
})
.rule(RuleInfo {
    breaks: &[
        (Makehuman2, "does not list what is in deeper folders"),
        (Makehuman1, UNREAD),
        (
            Mpfb,
            "takes suffixes as they are written, and does not find it",
        ),
    ],
    docs: include_str!("too_deep.md").trim_ascii_end(),
    ..RuleInfo::new(
        "library-too-deep",
        Level::Error,
        "an asset that the list does not find",
    )
});

const UNREAD: &str = "does not list it";
const UNLISTED: Case = &[(Makehuman2, Level::Error, "does not list it")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let homes = homes(layer);
    let mut deep = Vec::new();
    for file in layer.files.values().filter(|file| !is_outdated(file)) {
        let parts: Vec<&str> = file.rel.split('/').collect();
        let [category, base, .., name] = parts.as_slice() else {
            continue;
        };
        let is_for = |suffix: &str| in_place_of(suffix).contains(category);
        let is_skin = *category == "skins" && extension(name) == "mhmat";
        let own = suffix(name).filter(|suffix| is_for(suffix));
        if *category == "skins" && !is_skin && extension(name).eq_ignore_ascii_case("mhmat") {
            out.push(capitals(file, "mhmat"));
            continue;
        }
        match own {
            Some(suffix) if extension(name) != suffix => out.push(capitals(file, suffix)),
            _ if parts.len() > 4
                && !file.is_loose
                && (is_skin || own.is_some() && !is_used_elsewhere(view, file))
                && !is_note(name) =>
            {
                let folder = parts.get(..3).map(|top| top.join("/")).unwrap_or_default();
                deep.push(((folder, *category, *base), file));
            }
            None if parts.len() <= 4 && double(layer, &homes, file).is_some_and(is_for) => {
                out.push(doubled(file));
            }
            _ => {}
        }
    }
    // What was moved with its folder is one mistake.
    out.extend(
        grouped(deep)
            .into_iter()
            .filter_map(|((folder, category, base), files)| {
                let mut beside = layer
                    .below(&folder)
                    .filter(|file| parent(&file.rel) == folder);
                let is_of_asset = beside.any(|file| suffix(&file.rel).is_some());
                let finding = too_deep(&folder, &format!("{category}/{base}"), &files)?;
                let finding = if is_of_asset {
                    finding.help(help_in_asset(&folder))
                } else {
                    finding
                };
                Some(finding.asset(layer.display(&folder)))
            }),
    );
}

fn of_makehuman1(view: &makehuman1::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let of_library = |file: &FileFacts, suffix: &str| {
        file.rel.split('/').next().and_then(library_extension) == Some(suffix)
    };
    let homes = homes(layer);
    let lost = layer
        .files
        .values()
        .filter(|file| double(layer, &homes, file).is_some_and(|suffix| of_library(file, suffix)));
    out.extend(lost.map(doubled));
    custom_targets::targets_in_capitals(&RULE, view, out);
    custom_targets::packed_targets(&RULE, view, out);
    library::misnamed(&RULE, view, out);
}

/// In the folder of another asset it is mostly an older version, or belongs there by mistake.
fn help_in_asset(folder: &str) -> String {
    format!(
        "move it to a folder of its own beside `{folder}`, or keep an older version outside of \
            the data"
    )
}

/// What macOS leaves beside each file of an archive.
fn is_note(name: &str) -> bool {
    name.starts_with("._")
}

fn capitals(file: &FileFacts, suffix: &str) -> Finding {
    let message = format!(
        "`{}` must end in `.{suffix}`: capitals matter",
        file.file_name()
    );
    RULE.at(file, Place::File, message)
        .key("suffix")
        .case(UNLISTED)
        .help(format!("rename it to end in `.{suffix}`"))
}

fn doubled(file: &FileFacts) -> Finding {
    let name = file.file_name();
    let (right, last) = name.rsplit_once('.').unwrap_or((name, ""));
    let message = format!("`{name}` ends in `.{last}`, which keeps it out of the list");
    RULE.at(file, Place::File, message)
        .key("suffix")
        .case(UNLISTED)
        .help(format!("rename it to `{right}`"))
}

fn too_deep(folder: &str, right: &str, files: &[&FileFacts]) -> Option<Finding> {
    let first = files.first()?;
    let message = match files.len() {
        1 => {
            let depth = depth(&first.rel).saturating_sub(3);
            format!(
                "`{}` lies {depth} folders below `{right}`, expected 1 at most",
                first.file_name()
            )
        }
        count => format!(
            "{count} assets lie too deep in `{folder}`, first `{}`",
            first.file_name()
        ),
    };
    let parts = files.iter().map(|file| (file.shown(), &file.path));
    let finding = RULE
        .at(first, Place::File, message)
        .key("deep")
        .parts_in(parts);
    let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())));
    Some(finding.help(format!("move what is in `{folder}` to `{right}`")))
}

/// The suffix of an asset in front of another one, where there is no asset of that name: then it
/// would be a copy.
fn double(layer: &Layer, homes: &Homes<'_>, file: &FileFacts) -> Option<&'static str> {
    let (right, last) = file.rel.rsplit_once('.')?;
    let suffix = SUFFIXES
        .into_iter()
        .find(|suffix| *suffix == extension(right))?;
    let is_text = matches!(last, "txt" | "text" | "json" | "html");
    // Beside the asset of a folder of its own it is an older version, or a note.
    let has_asset = || right.matches('/').count() > 1 && homes.contains(&(parent(right), suffix));
    (is_text
        && layer.file(right).is_none()
        && !(matches!(suffix, "mhclo" | "proxy") && has_asset()))
    .then_some(suffix)
}

/// Whether something names the file, such as `base.json` a skeleton.
fn is_used_elsewhere(view: &View<'_>, file: &FileFacts) -> bool {
    view.references
        .to_file(file)
        .any(|reference| reference.found().is_some())
}
