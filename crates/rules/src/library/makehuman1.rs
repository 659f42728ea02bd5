//! The libraries of MakeHuman 1: what lies in which, and by what it is known
//! (`docs/loaders/makehuman1/folders.md#libraries-and-their-places`,
//! `docs/loaders/makehuman1/libraries.md#identity`).

use std::collections::BTreeSet;

use super::super::cause::library::FIRST_SKIN;
use super::super::cause::outdated::is_outdated;
use super::super::{Rule, counted, did_you_mean};
use super::custom_targets::NO_SLIDER;
use super::{Contents, as_copy, aside, is_exported, of_folder, top, unpictured};
use mhlint_diag::{
    Application::Makehuman1, Case, Evidence, Finding, Level, Place, grouped, nearest,
};
use mhlint_discover::{
    Kind, archive_library_of, extension, libraries, library_extension, library_of,
};
use mhlint_formats::packed::asset::Packed;
use mhlint_repo::aside::OF_MAKEHUMAN1;
use mhlint_repo::makehuman1::{Asset, CUSTOM, Known, View};
use mhlint_repo::{FileFacts, Layer};
use mhlint_source::{Guess, first_name};

/// What is worn in a library that lists another extension.
pub(super) fn misplaced(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    // Models beside the data folder are in their place.
    let is_model = |file: &FileFacts| extension(&file.rel) == "mhm";
    // And beside the libraries of a pack they are somebody's examples.
    let is_aside = |file: &FileFacts| file.is_loose || layer.is_aside(Makehuman1, file);
    let files = layer
        .files
        .values()
        .filter(|file| !(is_outdated(file) || is_model(file) && is_aside(file)));
    let by_folder =
        grouped(files.map(|file| ((file.rel.split('/').next(), extension(&file.rel)), file)));
    for ((library, extension), files) in by_folder {
        let place = match extension {
            "proxy" => "`proxymeshes`",
            "mhclo" => "`clothes`, `hair` or another folder of its kind",
            "bvh" => "`poses`",
            "mhpose" => "`expressions`",
            "mhskel" => "`rigs`",
            "mhm" => "`models` beside the data folder of the user",
            _ => continue,
        };
        let library = library.unwrap_or_default();
        let is_model = extension == "mhm";
        let right = library_extension(library).filter(|right| *right != extension || is_model);
        let (Some(right), Some(first)) = (right.or(is_model.then_some("")), files.first()) else {
            continue;
        };
        let here = if is_model {
            "the data folder".to_owned()
        } else {
            format!("`{library}`")
        };
        let message = format!("a `.{extension}` in {here} is not listed, expected in {place}");
        let help = match right {
            "mhclo" | "proxy" => format!("move it to {place}, or rename it to end in `.{right}`"),
            _ => format!("move it to {place}"),
        };
        let finding = rule.at(first, Place::File, message).key("kind").help(help);
        let message = format!(
            "{} `.{extension}` in `{library}` are not listed, expected in {place}",
            files.len()
        );
        out.push(of_folder(layer, library, &files, finding, message));
    }
}

/// Targets of a user where the program has its own: it looks for those of users in `custom` alone.
pub(super) fn targets(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    // MPFB has targets of users there.
    let is_shared = layer
        .layouts
        .iter()
        .any(|layout| layout.application != Makehuman1);
    if view.layers.checks_system() || is_shared {
        return;
    }
    let (of_user, place) = if layer.is_pack_of(Makehuman1) {
        (
            "",
            "move them to `custom`, beside folders such as `clothes`",
        )
    } else {
        (
            " of the user",
            "move them to `custom` in the data folder of the user",
        )
    };
    let targets = |folder: &str, is_beside: bool| -> Vec<&FileFacts> {
        let files = layer
            .below(folder)
            .filter(|file| file.is_loose == is_beside || layer.is_loose);
        files
            .filter(|file| extension(&file.rel) == "target")
            .collect()
    };
    let beside = if layer.is_loose {
        Vec::new()
    } else {
        targets(CUSTOM, true)
    };
    let mut places = vec![(format!("`targets`{of_user}"), targets(TARGETS, false))];
    places.push(("`custom` beside `data`".to_owned(), beside));
    // Any other folder, such as `Custom`, `morphs` or that of a skirt; what else ends so there is
    // nobody's business.
    let is_lost = |file: &&FileFacts| {
        let is_target = extension(&file.rel) == "target" && !matches!(top(file), CUSTOM | TARGETS);
        is_target && !file.is_loose && has_rows(file) && !layer.is_aside(Makehuman1, file)
    };
    let top = |file: &FileFacts| file.rel.split_once('/').map(|(top, _)| top.to_owned());
    for (top, files) in grouped(
        layer
            .files
            .values()
            .filter(is_lost)
            .map(|file| (top(file), file)),
    ) {
        places.push((
            top.map_or_else(
                || "the data folder itself".to_owned(),
                |top| format!("`{top}`"),
            ),
            files,
        ));
    }
    for (folder, lost) in places {
        let Some(first) = lost.first() else { continue };
        let message = format!(
            "{} in {folder}, where none is looked for",
            counted(lost.len(), "target")
        );
        let finding = rule
            .at(first, Place::File, message)
            .key(format!("targets {folder}"))
            .case(NO_SLIDER);
        let finding = finding.parts_in(lost.iter().map(|file| (file.shown(), &file.path)));
        let finding = finding.evidence(Evidence::of_cases(lost.iter().map(|file| file.shown())));
        out.push(finding.help(place));
    }
}

/// Where the program has its targets, and MPFB those of users as well.
const TARGETS: &str = "targets";

/// Whether a file has a row of a target: other programs have files of this name.
fn has_rows(file: &FileFacts) -> bool {
    file.target().is_some_and(|facts| facts.rows > 0)
}

/// Languages of a user: the list has them, but texts are read from the program's folder alone
/// (`docs/loaders/makehuman1/folders.md#libraries-and-their-places`).
pub(super) fn languages(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let files = layer
        .files
        .values()
        .filter(|file| file.kind_in(Makehuman1) == Kind::Language && !file.is_loose);
    for file in files.filter(|_| !view.layers.checks_system()) {
        let message = format!(
            "the texts of language `{}` are read from the folder of the program alone",
            file.stem()
        );
        let finding = rule
            .at(file, Place::File, message)
            .key("language")
            .case(UNTRANSLATED);
        out.push(finding.help("move it to `languages` in the data folder of the program"));
    }
}

const UNTRANSLATED: Case = &[(
    Makehuman1,
    Level::Warning,
    "lists the language, and stays English when it is chosen",
)];
/// What stands beside assets under their names.
const COMPANIONS: [&str; 13] = [
    "thumb", "png", "jpg", "obj", "mhmat", "mhw", "jsonw", "mhpxy", "npz", "meta", "mhskel",
    "mhbin", "blend",
];

/// What older versions had beside such pictures. Under another suffix it is not what that says
/// (`docs/loaders/versions.md#versions-of-makehuman-1`).
const OLDER: [&str; 8] = ["mhp", "mhstx", "lmk", "hair", "rig", "dat", "rot", "mhuv"];

/// Files that are pictured as assets are, and end in something that is not listed.
pub(super) fn misnamed(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let stem = |file: &FileFacts| file.rel.rsplit_once('.').map(|(stem, _)| stem.to_owned());
    let thumbs = layer
        .files
        .values()
        .filter(|file| extension(&file.rel) == "thumb")
        .filter_map(stem);
    // The picture of a material or of an asset of another kind says nothing of a source beside it.
    let is_of_other = |stem: &str| {
        let mut suffixes = libraries().filter_map(library_extension).chain(["mhmat"]);
        suffixes.any(|suffix| {
            layer
                .file_ignoring_case(&format!("{stem}.{suffix}"))
                .is_some()
        })
    };
    let pictured: BTreeSet<String> = thumbs.filter(|stem| !is_of_other(stem)).collect();
    for file in layer
        .files
        .values()
        .filter(|file| !file.file_name().starts_with('.'))
    {
        let (own, library) = (extension(&file.rel), first_name(&file.rel));
        let (Some(right), Some(stem)) = (library_extension(library), stem(file)) else {
            continue;
        };
        // An asset of another kind lies in the wrong folder.
        let is_asset = libraries().any(|library| library_extension(library) == Some(own));
        let is_old = OLDER.contains(&own) || is_outdated(file);
        let is_other =
            !own.eq_ignore_ascii_case(right) && !is_asset && !is_old && !COMPANIONS.contains(&own);
        let is_meant = pictured.contains(&stem) || (library, own) == ("expressions", "mhupb");
        let is_there = |extension: &str| {
            layer
                .file_ignoring_case(&format!("{stem}.{extension}"))
                .is_some()
        };
        if is_other && is_meant && !is_there(right) && !is_there("mhpxy") {
            let message = format!(
                "`{}` must end in `.{right}`: nothing else is listed in `{library}`",
                file.file_name()
            );
            out.push(
                rule.at(file, Place::File, message)
                    .key("suffix")
                    .help(format!("rename it to end in `.{right}`")),
            );
        }
    }
}

const COPIED: Case = &[(
    Makehuman1,
    Level::Info,
    "lists the same assets in their own folders",
)];
pub(super) const REMOVE_COPY: &str = "keep the copy outside of the data, or remove it";

/// Folders with assets that are no library, such as `Clothes` or `hairs`.
pub(super) fn unread(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    // What a link leads to may be there on purpose; the link is reported.
    let linked = layer
        .linked_folders
        .iter()
        .flat_map(|folder| layer.below(folder));
    let linked = Contents::of(linked);
    let tops = layer
        .files
        .values()
        .filter_map(|file| Some((file.rel.split('/').next()?, file)));
    let lost = tops.filter(|(top, file)| {
        let is_lone =
            || extension(&file.rel) == "mhpxy" && layer.text_of_archive(&file.rel).is_none();
        let is_worn = matches!(
            extension(&file.rel),
            "mhclo" | "proxy" | "mhskel" | "mhpose"
        ) || is_lone();
        let is_near = |top: &str| {
            nearest(top, libraries()).and_then(library_extension) == Some(extension(&file.rel))
        };
        let of_other_case =
            library_extension(&top.to_lowercase()) == Some(extension(&file.rel)) || is_near(top);
        (file.rel.contains('/') || matches!(extension(&file.rel), "mhskel" | "mhpose"))
            && !file.is_loose
            && !is_outdated(file)
            && !linked.has(file)
            && *top != OF_MAKEHUMAN1
            && library_extension(top).is_none()
            && (is_worn || of_other_case)
    });
    let lost = lost.filter(|(_, file)| !layer.is_aside(Makehuman1, file));
    let listed = Contents::of(
        layer
            .files
            .values()
            .filter(|file| library_of(&file.rel).is_some()),
    );
    for (top, files) in grouped(lost) {
        let Some(first) = files.first() else { continue };
        let message = if first.rel.contains('/') {
            format!(
                "folder `{top}` is not read ({})",
                counted(files.len(), "asset")
            )
        } else {
            format!("`{top}` lies in no library, and is not listed")
        };
        let near = nearest(top, libraries());
        let finding = rule
            .at(first, Place::File, message)
            .key(format!("folder {top}"));
        let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
        let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())));
        // A copy of what is listed is lost to nobody, and moved there it would be listed twice.
        out.push(if files.iter().all(|file| listed.has(file)) {
            finding.case(COPIED).help(REMOVE_COPY)
        } else {
            finding.help(did_you_mean(
                near,
                "move the assets to the folder of their kind, such as `clothes`",
            ))
        });
    }
}

/// What lies beside the libraries of a pack.
pub(super) fn beside_libraries(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let is_asset = |file: &FileFacts| {
        matches!(
            extension(&file.rel),
            "mhclo" | "proxy" | "mhskel" | "mhpose" | "mhm"
        )
    };
    // Those in `targets` have a finding of their own.
    let is_target = |file: &FileFacts| {
        extension(&file.rel) == "target" && top(file) != TARGETS && has_rows(file)
    };
    let is_asset = |file: &FileFacts| is_asset(file) || is_target(file);
    let files = layer
        .files
        .values()
        .filter(|file| is_asset(file) && !is_outdated(file) && layer.is_aside(Makehuman1, file));
    out.extend(aside(rule, &files.collect::<Vec<_>>()));
}

const NO_PICTURE: &str =
    "add a PNG of at most 128 by 128 pixels, with the name of the asset and the suffix `.thumb`";
const OTHER_PICTURE: Case = &[(
    Makehuman1,
    Level::Warning,
    "shows the default picture in the list: it looks for `.thumb` alone",
)];

/// The library that lists a file, or an archive without its text.
fn shelf_of<'f>(layer: &Layer, file: &'f FileFacts) -> Option<&'f str> {
    let packed =
        || archive_library_of(&file.rel).filter(|_| layer.text_of_archive(&file.rel).is_none());
    library_of(&file.rel).or_else(packed)
}

/// What is listed without a picture: skins may have a `.png`.
pub(super) fn without_pictures(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let beside = |file: &FileFacts, extension: &str| {
        let stem = file
            .rel
            .rsplit_once('.')
            .map_or(&*file.rel, |(stem, _)| stem);
        layer.file(&format!("{stem}.{extension}"))
    };
    let listed = layer
        .files
        .values()
        .filter_map(|file| Some((shelf_of(layer, file)?, file)));
    // Of copies with one uuid one has a picture.
    let known = grouped(
        view.assets()
            .filter_map(|asset| Some((asset.uuid?.text, asset.file.path.as_str()))),
    );
    let copies: BTreeSet<&str> = known
        .into_values()
        .filter(|files| files.len() > 1)
        .flatten()
        .collect();
    let bare = listed.filter(|(library, file)| {
        // What cannot be read or walked has a finding of its own, and what is behind a link is not
        // listed.
        let is_text = file
            .encoding
            .guess
            .is_none_or(|guess| guess == Guess::SingleByte)
            && !file.encoding.lfs_pointer;
        let is_sound = is_text || Packed::proxy_of(file.packed()).is_some();
        let is_listed = !layer.is_behind_link(&file.rel);
        let has = |extension| beside(file, extension).is_some();
        let is_pictured = has("thumb") || *library == "skins" && has("png");
        // What the program opens by its name is missing under that (`program-missing-file`).
        let is_misnamed = file.rel != FIRST_SKIN && file.rel.eq_ignore_ascii_case(FIRST_SKIN);
        let is_own = !copies.contains(file.path.as_str())
            && !file.file_name().starts_with('.')
            && !is_misnamed;
        is_sound && is_listed && is_own && !is_pictured && !is_outdated(file) && !is_exported(file)
    });
    for (library, files) in grouped(bare) {
        let unused = |file: &&&FileFacts| {
            beside(file, "png")
                .is_some_and(|picture| view.references.to_file(picture).next().is_none())
        };
        let (other, none): (Vec<&FileFacts>, Vec<&FileFacts>) =
            files.into_iter().partition(|file| unused(&file));
        for (files, case, key) in [(other, OTHER_PICTURE, "png"), (none, &[][..], "none")] {
            let Some(first) = files.first() else { continue };
            let message = match (files.len(), key) {
                (1, "png") => format!(
                    "`{}.png` is not used as the picture of `{}`",
                    first.stem(),
                    first.file_name()
                ),
                (1, _) => format!("`{}` has no picture", first.file_name()),
                (count, _) => {
                    unpictured(&counted(count, "asset"), library, first, first.file_name())
                }
            };
            let help = if key == "png" {
                "save it as PNG of at most 128 by 128 pixels with the suffix `.thumb`"
            } else {
                NO_PICTURE
            };
            let finding = rule
                .at(first, Place::File, message)
                .key(format!("{library} {key}"))
                .case(case);
            let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
            out.push(
                finding
                    .evidence(Evidence::of_cases(files.iter().map(|file| file.shown())))
                    .help(help),
            );
        }
    }
}

/// Assets of one library with a name in common and different uuids.
pub(super) fn same_names(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let named = view
        .assets()
        .filter_map(|asset| Some(((asset.library, asset.name?.text), asset)));
    for ((_, name), assets) in grouped(named) {
        let uuid = |asset: &Asset<'_>| asset.uuid.map(|uuid| uuid.text.to_owned());
        let Some((told, others)) = told(view, &assets) else {
            continue;
        };
        let Some(other) = others.iter().find(|other| uuid(other) != uuid(told)) else {
            continue;
        };
        let finding = finding(rule, view, told, other, told.name, "name", name);
        let is_packed = told.name.is_some_and(|name| name.entry.is_none());
        let help = if is_packed {
            "pack it again from a text with a name of its own"
        } else {
            "give it a name of its own"
        };
        out.push(finding.key(name).help(help));
    }
}

const COPY: Case = &[(
    Makehuman1,
    Level::Warning,
    "lists both; while one is worn the other cannot be chosen",
)];
/// A copy in the folder of another kind.
const TWICE: Case = &[(
    Makehuman1,
    Level::Warning,
    "lists it in both libraries, with its name and tags",
)];
const APART: Case = &[(Makehuman1, Level::Info, "lists each in its own library")];
/// One of them may be an older state that is in no library.
const LOOSE: Case = &[(
    Makehuman1,
    Level::Warning,
    "cannot wear both together once they are in its library, and models may wear the other one",
)];
const REPLACED: Case = &[(
    Makehuman1,
    Level::Info,
    "lists both; while one is worn the other cannot be chosen",
)];

const OWN: &str = "give the newer of the two a uuid of its own, and load and save every model \
    that wears it; or remove one of them";
const PACKED: &str =
    "pack the newer of the two again from a text with a uuid of its own, or remove one of them";

/// Assets with a uuid in common.
pub(super) fn same_uuids(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let known = view
        .assets()
        .filter_map(|asset| Some((asset.uuid?.text, asset)));
    for (uuid, assets) in grouped(known) {
        let Some((told, others)) = told(view, &assets) else {
            continue;
        };
        let is_elsewhere = |other: &&&Asset<'_>| place(other) != place(told);
        let in_library = others
            .iter()
            .filter(is_elsewhere)
            .find(|other| other.library == told.library);
        let Some(other) = in_library
            .or_else(|| others.iter().find(is_elsewhere))
            .or_else(|| others.first())
        else {
            continue;
        };
        let finding = finding(rule, view, told, other, told.uuid, "uuid", uuid);
        let is_copy =
            told.file.content_hash.is_some() && told.file.content_hash == other.file.content_hash;
        let finding =
            finding
                .key(uuid)
                .help(if told.uuid.is_some_and(|uuid| uuid.entry.is_none()) {
                    PACKED
                } else {
                    OWN
                });
        let is_loose = view.layers.checked.is_loose && view.layers.is_checked(other.file);
        out.push(match is_copy {
            true if is_loose => continue,
            false if is_loose => finding.case(LOOSE),
            true if other.library != told.library => finding.case(TWICE),
            false if other.library != told.library => finding.case(APART),
            true => finding.case(COPY),
            // A user's file in the place of one of the system is meant to replace it.
            false if place(other) == place(told) => finding.case(REPLACED),
            false => finding,
        });
    }
}

/// Where an asset is, be it a text or an archive.
fn place<'a>(asset: &Asset<'a>) -> &'a str {
    asset
        .file
        .rel
        .rsplit_once('.')
        .map_or(&asset.file.rel, |(stem, _)| stem)
}

/// Of several assets one of the checked layer, and all others.
fn told<'t, 'a>(
    view: &View<'_>,
    assets: &'t [Asset<'a>],
) -> Option<(&'t Asset<'a>, Vec<&'t Asset<'a>>)> {
    // What is behind a link is not listed.
    let layer = view.layers.checked;
    let is_listed = |asset: &&Asset<'_>| !layer.is_behind_link(&asset.file.rel);
    let own = assets
        .iter()
        .filter(|asset| view.layers.is_checked(asset.file));
    let told = own
        .filter(is_listed)
        .max_by_key(|asset| as_copy(asset.file))?;
    // What lies in no library yet may be the next state of what the system has.
    let is_next = |other: &&Asset<'_>| {
        let name = |asset: &Asset<'_>| asset.name.map(|name| name.text.to_owned());
        view.layers.checked.is_loose
            && !view.layers.is_checked(other.file)
            && name(other) == name(told)
    };
    let is_other = |other: &&Asset<'_>| !std::ptr::eq(other.file, told.file) && !is_next(other);
    let others: Vec<&Asset<'_>> = assets.iter().filter(is_listed).filter(is_other).collect();
    (!others.is_empty()).then_some((told, others))
}

/// The finding on something that two assets have in common.
fn finding(
    rule: &Rule,
    view: &View<'_>,
    told: &Asset<'_>,
    other: &Asset<'_>,
    known: Option<Known<'_>>,
    what: &str,
    text: &str,
) -> Finding {
    let entry = known.and_then(|known| known.entry);
    let place = entry.map_or(Place::File, |entry| Place::Span(entry.span.clone()));
    let named = view.layers.named(other.file);
    let finding = rule.at(
        told.file,
        place,
        format!("has the same {what} as {named}: `{text}`"),
    );
    let finding = finding.related(other.file.path.clone(), Place::File, "the other asset");
    finding.between([told.file.path.as_str(), other.file.path.as_str()])
}
