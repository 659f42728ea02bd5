//! The assets that a model wears, as MPFB imports them
//! (`docs/loaders/mpfb/models.md#lines-of-a-model`).

use std::collections::BTreeMap;

use super::super::{Rule, RuleCx, did_you_mean, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, grouped};
use mhlint_discover::Kind;
use mhlint_formats::mhm::columns::Wearing;
use mhlint_repo::mpfb::View;
use mhlint_repo::{FileFacts, Worn};
use mhlint_source::{file_name, first_name};

const LEFT_OUT: Case = &[(
    Mpfb,
    Level::Error,
    "leaves the clothes out, with a message in the log",
)];
const REPLACED: Case = &[(
    Mpfb,
    Level::Warning,
    "puts on the first asset of the folder in its place",
)];
const NO_SKIN: Case = &[(
    Mpfb,
    Level::Warning,
    "shows the body without a material, with a message in the log",
)];

/// Findings on the models of the checked layer.
pub(super) fn faults(rule: &Rule, view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.is_complete() {
        return;
    }
    let assets: Vec<Asset<'_>> = view.worn_anywhere().map(Asset::of).collect();
    let known = Known::of(&assets);
    for file in view.own(Kind::Model) {
        let Some(model) = file.model() else { continue };
        let lost = model
            .columns
            .worn
            .iter()
            .filter(|line| is_lost(&known, line));
        for (category, lines) in grouped(lost.map(|line| (line.category, line))) {
            out.extend(finding(rule, &known, file, category, &lines, cx));
        }
        let skin = model
            .columns
            .skin
            .as_ref()
            .filter(|skin| !view.named.has("skins", &skin.text));
        out.extend(skin.map(|skin| {
            let message = format!("skin `{}` does not exist", skin.text);
            let name = file_name(&skin.text);
            let near = cx
                .suggestions
                .nearest_of_kind(name, view.named.names("skins"));
            let finding = rule
                .at(file, Place::Span(skin.span.clone()), message)
                .key("skin")
                .case(NO_SKIN);
            finding.help(did_you_mean(near, "correct the name, or add the skin"))
        }));
    }
}

fn folder(category: &str) -> &str {
    if category == "proxy" {
        "proxymeshes"
    } else {
        category
    }
}

fn uuid<'v>(worn: &Worn<'v>) -> Option<&'v str> {
    worn.clothes()?
        .all("uuid")
        .next_back()
        .map(|entry| &*entry.value)
}

/// A name in the form in which the lists of MPFB compare it with the name of a file.
fn plain(name: &str) -> String {
    name.chars()
        .filter(|one| !matches!(one, '_' | ' '))
        .flat_map(char::to_lowercase)
        .collect()
}

/// An asset that lines may mean.
struct Asset<'v> {
    worn: &'v Worn<'v>,
    folder: &'v str,
    /// The name of its file as a line has to have it, or a part of it.
    plain: String,
}

impl<'v> Asset<'v> {
    fn of(worn: &'v Worn<'v>) -> Self {
        Self {
            worn,
            folder: first_name(&worn.file.rel),
            plain: plain(worn.file.stem()),
        }
    }
}

/// Assets in their order, found by parts of their names.
struct Named<'k> {
    assets: Vec<&'k Asset<'k>>,
    /// What names end with, in order, each with the place of its asset: a part of a name is the
    /// beginning of an ending.
    endings: Vec<(&'k str, usize)>,
}

/// Assets with a part in their names that are looked at for the first: of more of them none is
/// meant more than another.
const ALIKE: usize = 1000;

impl<'k> Named<'k> {
    fn of(assets: Vec<&'k Asset<'k>>) -> Self {
        let places = assets.iter().enumerate();
        let endings = places.flat_map(|(place, asset)| {
            let starts = asset.plain.char_indices().map(|(start, _)| start);
            let starts = starts.chain([asset.plain.len()]);
            starts.filter_map(move |start| Some((asset.plain.get(start..)?, place)))
        });
        let mut endings: Vec<(&str, usize)> = endings.collect();
        endings.sort_unstable();
        Self { assets, endings }
    }

    /// The first asset with this in its name.
    fn first_with(&self, part: &str) -> Option<&'k Worn<'k>> {
        let start = self.endings.partition_point(|(ending, _)| *ending < part);
        let alike = self.endings.iter().skip(start).take(ALIKE);
        let alike = alike.take_while(|(ending, _)| ending.starts_with(part));
        let place = alike.map(|(_, place)| *place).min()?;
        self.assets.get(place).map(|asset| asset.worn)
    }
}

/// The assets, since there may be thousands of them and of lines.
struct Known<'k> {
    by_folder: BTreeMap<&'k str, Named<'k>>,
    /// By folder and uuid; `None` in place of the uuid is for assets whose uuid is not known.
    by_uuid: BTreeMap<(&'k str, Option<&'k str>), Named<'k>>,
}

impl<'k> Known<'k> {
    fn of(assets: &'k [Asset<'k>]) -> Self {
        let by_folder = grouped(assets.iter().map(|asset| (asset.folder, asset)));
        let uuids = assets.iter().flat_map(|asset| {
            // The uuid is not known if an asset cannot be read, or has two uuids after a merge.
            let is_unsure =
                asset.worn.clothes().is_none() || asset.worn.file.encoding.is_unmerged();
            let unsure = is_unsure.then_some(None);
            let uuids = uuid(asset.worn).map(Some).into_iter().chain(unsure);
            uuids.map(move |uuid| ((asset.folder, uuid), asset))
        });
        let by_folder = by_folder.into_iter();
        let by_uuid = grouped(uuids).into_iter();
        Self {
            by_folder: by_folder
                .map(|(key, assets)| (key, Named::of(assets)))
                .collect(),
            by_uuid: by_uuid
                .map(|(key, assets)| (key, Named::of(assets)))
                .collect(),
        }
    }
}

/// Whether no asset fits a line. For clothes name and uuid must fit, for other assets the uuid is
/// enough. An asset that cannot be read may be the right one.
fn is_lost(known: &Known<'_>, line: &Wearing) -> bool {
    let (folder, name) = (folder(line.category), plain(&line.name.text));
    let has_name = |assets: Option<&Named<'_>>| {
        assets.is_some_and(|assets| assets.first_with(&name).is_some())
    };
    let is_unread = has_name(known.by_uuid.get(&(folder, None)));
    let with_uuid = known
        .by_uuid
        .get(&(folder, Some(&*line.uuid)))
        .filter(|_| !line.uuid.is_empty());
    let is_there = match line.category {
        "clothes" => has_name(with_uuid),
        // Without a uuid MPFB takes the first asset in the folder. That is not reported if an asset
        // of the name exists.
        _ => with_uuid.is_some() || line.uuid.is_empty() && has_name(known.by_folder.get(folder)),
    };
    !is_there && !is_unread
}

fn finding(
    rule: &Rule,
    known: &Known<'_>,
    file: &FileFacts,
    category: &str,
    lines: &[&Wearing],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let first = lines.first()?;
    let name = &*first.name.text;
    let more = such(lines.len(), "lines");
    let assets = known.by_folder.get(folder(category));
    let same = assets.and_then(|assets| assets.first_with(&plain(name)));
    let with_uuid = known
        .by_uuid
        .get(&(folder(category), Some(&*first.uuid)))
        .filter(|_| !first.uuid.is_empty());
    let renamed = with_uuid.and_then(|assets| assets.assets.first());
    let (message, help) = match (same, renamed) {
        (Some(_), _) if first.uuid.is_empty() => (
            format!("`{category} {name}` has no uuid{more}"),
            "write the uuid of the asset behind its name".to_owned(),
        ),
        (Some(same), _) => {
            let help = uuid(same).map_or_else(
                || "give the asset a uuid, and write it here".to_owned(),
                |uuid| format!("write `{category} {name} {uuid}`"),
            );
            (format!("the asset `{name}` has another uuid{more}"), help)
        }
        (None, Some(renamed)) => {
            let own = renamed.worn.file.stem();
            (
                format!("no asset is named `{name}`; the one with its uuid is `{own}`{more}"),
                format!("write `{own}`"),
            )
        }
        (None, None) => {
            let stems = assets
                .into_iter()
                .flat_map(|assets| &assets.assets)
                .map(|asset| asset.worn.file.stem());
            let near = cx.suggestions.nearest(name, stems);
            let help = "add the asset, or check it together with the pack that has it; otherwise \
                remove the line";
            (
                format!("no asset in `{}` is named `{name}`{more}", folder(category)),
                did_you_mean(near, help),
            )
        }
    };
    let case = if category == "clothes" {
        LEFT_OUT
    } else {
        REPLACED
    };
    let finding = rule
        .at(file, Place::Span(first.name.span.clone()), message)
        .key(category)
        .case(case);
    Some(
        finding
            .evidence(Evidence::of_cases(
                lines.iter().map(|line| &*line.name.text),
            ))
            .help(help),
    )
}
