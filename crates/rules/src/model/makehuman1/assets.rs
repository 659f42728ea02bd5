//! The assets and files that a model names exist.

use std::collections::{BTreeMap, BTreeSet};

use super::super::super::cause::library::{FIRST_EYES, FIRST_SKIN};
use super::super::super::{Rule, RuleCx, did_you_mean, such};
use super::own;
use mhlint_diag::{
    Application::Makehuman1, Case, Evidence, Finding, Grouped, Level, Place, grouped, nearest,
};
use mhlint_discover::{Kind, archive_library_of, extension, library_extension, library_of};
use mhlint_formats::mhm::CATEGORIES;
use mhlint_formats::mhm::lines::Line;
use mhlint_repo::makehuman1::{SavedModel, View, uuid_of};
use mhlint_repo::{FileFacts, Layer, Reference, ReferenceKind, Resolution, Worn};
use mhlint_source::{file_name, without_extension};

pub(in super::super) fn faults(
    rule: &Rule,
    view: &View<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    // Without the system data it is not known which assets there are.
    if view.layers.system.is_none() {
        return;
    }
    let lines = own(view).flat_map(|model| model.lines.all.iter().map(move |line| (model, line)));
    let worn = lines
        .filter(|(_, line)| CATEGORIES.contains(&&*line.keyword.text) && !line.values.is_empty());
    let known = Known::of(view);
    let lost = worn.filter(|(_, line)| known.is_lost(line));
    let by_asset =
        grouped(lost.map(|one| ((&*one.1.keyword.text, one.1.value(0), one.1.value(1)), one)));
    out.extend(
        by_asset
            .into_values()
            .filter_map(|lines| unknown(rule, &known, &lines, cx)),
    );
    let missing = own(view).flat_map(|model| view.references.of_file(model.file));
    let missing: Vec<&Reference<'_>> = missing.collect();
    out.extend(missing.iter().filter_map(|one| of_other_kind(rule, one)));
    let missing = missing
        .into_iter()
        .filter(|one| matches!(one.resolution, Resolution::Missing));
    let files = Files::of(view);
    // The first skin, which the program itself needs, and files that exist but are not listed are
    // reported by other rules.
    let missing = missing.filter(|one| {
        one.text.trim_start_matches("data/") != FIRST_SKIN && !files.has_unlisted(one)
    });
    let by_file = grouped(missing.map(|one| ((one.kind, one.text), one)));
    out.extend(
        by_file
            .into_values()
            .filter_map(|references| file(rule, &files, &references, cx)),
    );
}

/// The name of the library in which the program looks for assets of a category.
fn library(category: &str) -> &str {
    if category == "proxy" {
        "proxymeshes"
    } else {
        category
    }
}

/// The library that lists an asset, or that lists its packed copy if there is no text file.
fn shelf<'a>(worn: &Worn<'a>) -> Option<&'a str> {
    library_of(&worn.file.rel).or_else(|| archive_library_of(&worn.file.rel))
}

fn name_of<'a>(worn: &Worn<'a>) -> Option<&'a str> {
    match worn.packed_proxy() {
        Some(proxy) => proxy.identity.first().map(|name| &**name),
        None => worn
            .clothes()?
            .all("name")
            .next_back()
            .map(|entry| &*entry.value),
    }
}

/// Whether an asset cannot be read, so that its name and uuid are not known.
fn is_unread(worn: &Worn<'_>) -> bool {
    worn.clothes().is_none() && worn.packed_proxy().is_none()
}

/// The assets that lines may mean, by name and by uuid, since there may be thousands of assets and
/// of lines.
struct Known<'v> {
    /// Library and uuid of each listed asset.
    uuids: BTreeSet<(&'v str, &'v str)>,
    /// Library and name of each asset whose uuid is missing or not certain; also with the name of
    /// its file.
    names: BTreeSet<(&'v str, &'v str)>,
    /// Libraries with an asset that cannot be read.
    unread: BTreeSet<&'v str>,
    /// Names of files that are not among the assets, in small letters.
    unlisted: BTreeSet<String>,
    /// For each library and name the uuid of the first asset with that name.
    by_name: BTreeMap<(&'v str, &'v str), Option<&'v str>>,
    /// Names of the assets of each library.
    of_library: Grouped<&'v str, &'v str>,
    /// For each uuid how many assets have it, and the library of the first.
    by_uuid: BTreeMap<&'v str, (usize, Option<&'v str>)>,
}

impl<'v> Known<'v> {
    fn of(view: &'v View<'_>) -> Self {
        let (mut uuids, mut names, mut unread) =
            (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        for (shelf, worn) in view
            .worn()
            .iter()
            .filter_map(|worn| Some((shelf(worn)?, worn)))
        {
            let own = name_of(worn).into_iter().chain([worn.file.stem()]);
            // After a merge an asset may have two uuids, of which either may stay.
            if worn.file.encoding.is_unmerged() {
                names.extend(own.clone().map(|name| (shelf, name)));
            }
            match uuid_of(worn) {
                Some(uuid) => drop(uuids.insert((shelf, uuid))),
                None if is_unread(worn) => drop(unread.insert(shelf)),
                None => names.extend(own.map(|name| (shelf, name))),
            }
        }
        let (mut by_name, mut by_uuid) = (BTreeMap::new(), BTreeMap::new());
        for worn in view.worn() {
            let (shelf, uuid) = (shelf(worn), uuid_of(worn));
            if let (Some(shelf), Some(name)) = (shelf, name_of(worn)) {
                by_name.entry((shelf, name)).or_insert(uuid);
            }
            if let Some(uuid) = uuid {
                by_uuid.entry(uuid).or_insert((0, shelf)).0 += 1;
            }
        }
        let of_library = view.worn().iter();
        let of_library = of_library.filter_map(|worn| Some((shelf(worn)?, name_of(worn)?)));
        let worn: BTreeSet<&str> = view
            .worn()
            .iter()
            .map(|worn| worn.file.path.as_str())
            .collect();
        let files = view
            .layers
            .strongest_first()
            .flat_map(|layer| layer.files.values());
        let others = files.filter(|file| !worn.contains(file.path.as_str()));
        let unlisted = others.map(|file| file.file_name().to_lowercase()).collect();
        Self {
            uuids,
            names,
            unread,
            unlisted,
            by_name,
            of_library: grouped(of_library),
            by_uuid,
        }
    }

    /// Whether no asset fits a line. Assets are known by their uuid; those that cannot be read or
    /// have no uuid are reported by other rules.
    fn is_lost(&self, line: &Line) -> bool {
        let (name, uuid, own) = (line.value(0), line.value(1), library(&line.keyword.text));
        let is_listed = self.uuids.contains(&(own, uuid))
            || self.names.contains(&(own, name))
            || self.unread.contains(own);
        let is_first = FIRST_EYES == format!("{own}/{name}/{name}.mhclo");
        !is_listed && !is_first && !self.is_unlisted(name)
    }

    /// Whether there is an asset with this file name that is not listed, because it lies in another
    /// folder or has another suffix.
    fn is_unlisted(&self, name: &str) -> bool {
        [".mhclo", ".proxy"].iter().any(|suffix| {
            let start = format!("{name}{suffix}").to_lowercase();
            self.unlisted
                .range(start.clone()..)
                .next()
                .is_some_and(|file| file.starts_with(&start))
        })
    }
}

/// The files that models may mean, since there may be thousands of files and of models.
struct Files<'v> {
    /// Their paths, strongest first, by the folder at the top.
    of_library: Grouped<&'v str, &'v str>,
    /// The first file of each name in a folder.
    by_name: BTreeMap<&'v str, &'v FileFacts>,
    /// Stems and extensions of those that are in no list.
    unlisted: BTreeSet<(&'v str, &'v str)>,
    /// Stems of those in no list that are taken for another sort of the same: pictured, or old.
    alike: BTreeSet<&'v str>,
    /// Paths in folders with a misspelt name that is meant for `skins`.
    of_misspelt: BTreeSet<&'v str>,
}

impl<'v> Files<'v> {
    fn of(view: &'v View<'_>) -> Self {
        let (mut of_library, mut by_name) = (Vec::new(), BTreeMap::new());
        let (mut unlisted, mut alike) = (BTreeSet::new(), BTreeSet::new());
        let mut of_misspelt = BTreeSet::new();
        let layers = view.layers.strongest_first();
        for (layer, file) in
            layers.flat_map(|layer| layer.files.values().map(move |file| (layer, file)))
        {
            if let Some((top, rest)) = file.rel.split_once('/') {
                of_library.push((top, file.rel.as_str()));
                by_name.entry(file.file_name()).or_insert(file);
                if library_extension(top).is_none() && nearest(top, ["skins"]).is_some() {
                    of_misspelt.insert(rest);
                }
            }
            if library_of(&file.rel).is_none() {
                unlisted.insert((file.stem(), extension(&file.rel)));
                if is_alike(layer, file) {
                    alike.insert(file.stem());
                }
            }
        }
        Self {
            of_library: grouped(of_library),
            by_name,
            unlisted,
            alike,
            of_misspelt,
        }
    }

    /// Whether the file that a model names exists but is not listed. A material is in no list and
    /// may lie anywhere, but for one in a folder with a misspelt name, which another rule reports.
    fn has_unlisted(&self, reference: &Reference<'_>) -> bool {
        if reference.kind == ReferenceKind::Skin {
            let text = reference.text.trim_start_matches("data/");
            let meant = text.strip_prefix("skins/");
            return meant.is_some_and(|meant| self.of_misspelt.contains(meant));
        }
        let name = file_name(reference.text);
        let stem = without_extension(name);
        self.unlisted.contains(&(stem, extension(name))) || self.alike.contains(stem)
    }
}

/// Whether a file that is in no list is old, or has a picture as those in lists have.
fn is_alike(layer: &Layer, file: &FileFacts) -> bool {
    let end = extension(&file.rel);
    let is_pictured = || {
        let stem = file.rel.trim_end_matches(end).trim_end_matches('.');
        layer.file(&format!("{stem}.thumb")).is_some()
    };
    (end == "mhupb" || is_pictured()) && !matches!(file.kind, Kind::Image | Kind::MotionMeta)
}

fn unknown(
    rule: &Rule,
    known: &Known<'_>,
    lines: &[(&SavedModel<'_>, &Line)],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let (model, line) = lines.first()?;
    let (category, name, uuid) = (&*line.keyword.text, line.value(0), line.value(1));
    let own = library(category);
    let more = such(lines.len(), "models");
    let same = known.by_name.get(&(own, name)).copied().flatten();
    let elsewhere = known
        .by_uuid
        .get(uuid)
        .filter(|_| !uuid.is_empty())
        .and_then(|(_, shelf)| *shelf);
    let last = line.values.last().map_or("", |word| &word.text);
    let is_cut = line.values.len() > 2 && known.by_uuid.contains_key(last);
    let (message, help) = match (same, elsewhere) {
        _ if is_cut => (
            format!("the name of the asset has a blank, so `{uuid}` is read as its uuid{more}"),
            "name the asset without a blank, here and in its own file".to_owned(),
        ),
        _ if uuid.is_empty() => (
            format!("`{category} {name}` has no uuid{more}"),
            same.map_or_else(
                || "write the uuid of the asset behind its name".to_owned(),
                |uuid| format!("write `{category} {name} {uuid}`"),
            ),
        ),
        // If several assets have this uuid the program may wear any of them, which another rule
        // reports.
        (Some(same), _) if known.by_uuid.get(same).is_some_and(|(count, _)| *count > 1) => {
            let help = format!("give `{name}` a uuid of its own again: `{uuid}`");
            (format!("the asset `{name}` has another uuid{more}"), help)
        }
        (Some(same), _) => (
            format!("the asset `{name}` has another uuid{more}"),
            format!("write `{category} {name} {same}`"),
        ),
        (None, Some(other)) => {
            let right = if other == "proxymeshes" {
                "proxy"
            } else {
                other
            };
            (
                format!("`{name}` is not listed in `{own}`, but in `{other}`{more}"),
                format!("write `{right}`"),
            )
        }
        (None, None) => {
            let near = cx.suggestions.nearest(
                name,
                known.of_library.get(own).into_iter().flatten().copied(),
            );
            let otherwise = "add the asset, or check it together with the pack that has it; \
                otherwise remove the line";
            (
                format!("no asset in `{own}` has uuid `{uuid}` (`{name}`){more}"),
                did_you_mean(near, otherwise),
            )
        }
    };
    let place = |line: &Line| {
        Place::Span(
            line.values
                .first()
                .map_or(line.keyword.span.clone(), |one| one.span.clone()),
        )
    };
    let finding = rule
        .at(model.file, place(line), message)
        .key(format!("{category} {name}"))
        .help(help);
    let parts = lines
        .iter()
        .map(|(model, line)| (model.file.shown(), &model.file.path, place(line)));
    let finding = finding.parts_at(parts);
    let finding = finding.evidence(Evidence::of_cases(
        lines.iter().map(|(model, _)| model.file.shown()),
    ));
    Some(finding.effect("loads the model without it, with a line in the log"))
}

const UNFIT: Case = &[(
    Makehuman1,
    Level::Error,
    "fails when it reads the file, and loads the model without it",
)];

/// A finding on a file that exists, but is of another kind than the line asks for.
fn of_other_kind(rule: &Rule, reference: &Reference<'_>) -> Option<Finding> {
    let (what, suffix) = match reference.kind {
        ReferenceKind::Skin => ("a skin", "mhmat"),
        ReferenceKind::ModelSkeleton => ("a skeleton", "mhskel"),
        ReferenceKind::ModelPose => ("a pose", "bvh"),
        ReferenceKind::ModelExpression => ("an expression", "mhpose"),
        _ => return None,
    };
    let file = reference
        .found()
        .filter(|file| !extension(&file.rel).eq_ignore_ascii_case(suffix))?;
    let message = format!("`{}` is not {what}", reference.text);
    let finding = rule
        .at(reference.from, reference.place.clone(), message)
        .key(reference.text)
        .case(UNFIT);
    Some(
        finding
            .related(file.path.clone(), Place::File, "this file")
            .help(format!("name a file that ends in `.{suffix}`")),
    )
}

/// A finding on a file that models name and that does not exist.
fn file(
    rule: &Rule,
    files: &Files<'_>,
    references: &[&Reference<'_>],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let reference = references.first()?;
    let (what, folder, suffix, effect) = match reference.kind {
        ReferenceKind::Skin => (
            "skin",
            "skins",
            ".mhmat",
            "loads the model with the default skin",
        ),
        ReferenceKind::ModelSkeleton => (
            "skeleton",
            "rigs",
            ".mhskel",
            "loads the model without a skeleton",
        ),
        ReferenceKind::ModelPose => (
            "pose",
            "poses",
            ".bvh",
            "logs an error, and loads the model without its pose and in another shape",
        ),
        ReferenceKind::ModelExpression => (
            "expression",
            "expressions",
            ".mhpose",
            "loads the model without it",
        ),
        _ => return None,
    };
    let is_skin = reference.kind == ReferenceKind::Skin;
    // A skin is named with its folder.
    let start = if is_skin { 0 } else { folder.len() + 1 };
    let below = files.of_library.get(folder).into_iter().flatten();
    let names = below
        .filter(|rel| rel.ends_with(suffix))
        .filter_map(|rel| rel.get(start..));
    let near = cx.suggestions.nearest_file(reference.text, names);
    let name = file_name(reference.text);
    let elsewhere = files.by_name.get(name).filter(|_| is_skin);
    let help = match elsewhere.filter(|_| near.is_none()) {
        Some(file) => format!(
            "move `{}` with its pictures to `{folder}`, or name one that exists",
            file.rel
        ),
        None => did_you_mean(
            near,
            format!("add the file to `{folder}`, or name one that exists"),
        ),
    };
    let message = format!(
        "{what} `{}` does not exist{}",
        reference.text,
        such(references.len(), "models")
    );
    let finding = rule
        .at(reference.from, reference.place.clone(), message)
        .key(reference.text)
        .help(help);
    let parts = references
        .iter()
        .map(|one| (one.from.shown(), &one.from.path, one.place.clone()));
    let finding = finding.parts_at(parts);
    Some(
        finding
            .evidence(Evidence::of_cases(
                references.iter().map(|one| one.from.shown()),
            ))
            .effect(effect),
    )
}
