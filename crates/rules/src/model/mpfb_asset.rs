//! The assets that a model wears, as MPFB imports them
//! (`docs/loaders/mpfb/models.md#lines-of-a-model`).

use std::collections::BTreeMap;

use super::super::{Rule, RuleCx, did_you_mean, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, grouped};
use mhlint_discover::Kind;
use mhlint_formats::mhm::columns::Wearing;
use mhlint_repo::mpfb::View;
use mhlint_repo::{FileFacts, Worn};

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
    let mut known = Known::new();
    for worn in view.worn_anywhere() {
        let folder = worn.file.rel.split('/').next().unwrap_or_default();
        if let Some(uuid) = uuid(worn) {
            known.entry((folder, Some(uuid))).or_default().push(worn);
        }
        // The uuid is not known if an asset cannot be read, or has two uuids after a merge.
        if worn.clothes().is_none() || worn.file.encoding.is_unmerged() {
            known.entry((folder, None)).or_default().push(worn);
        }
    }
    for file in view.own(Kind::Model) {
        let Some(model) = file.model() else { continue };
        let lost = model
            .columns
            .worn
            .iter()
            .filter(|line| is_lost(view, &known, line));
        for (category, lines) in grouped(lost.map(|line| (line.category, line))) {
            out.extend(finding(rule, view, file, category, &lines, cx));
        }
        let skin = model
            .columns
            .skin
            .as_ref()
            .filter(|skin| !view.named.has("skins", &skin.text));
        out.extend(skin.map(|skin| {
            let message = format!("skin `{}` does not exist", skin.text);
            let name = skin.text.rsplit('/').next().unwrap_or_default();
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

/// The assets of a category.
fn assets<'v>(view: &'v View<'_>, category: &str) -> impl Iterator<Item = &'v Worn<'v>> {
    let folder = folder(category).to_owned();
    view.worn_anywhere()
        .filter(move |one| one.file.rel.split('/').next() == Some(&*folder))
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

fn is_named(worn: &Worn<'_>, line: &Wearing) -> bool {
    plain(worn.file.stem()).contains(&plain(&line.name.text))
}

/// Whether no asset fits a line. For clothes name and uuid must fit, for other assets the uuid is
/// enough. An asset that cannot be read may be the right one.
fn is_lost<'k>(view: &View<'_>, known: &'k Known<'k>, line: &'k Wearing) -> bool {
    let with_uuid = if line.uuid.is_empty() {
        &[][..]
    } else {
        of_uuid(known, line, Some(&line.uuid))
    };
    let is_unread = of_uuid(known, line, None)
        .iter()
        .any(|worn| is_named(worn, line));
    let is_there = match line.category {
        "clothes" => with_uuid.iter().any(|worn| is_named(worn, line)),
        // Without a uuid MPFB takes the first asset in the folder. That is not reported if an asset
        // of the name exists.
        category => {
            !with_uuid.is_empty()
                || line.uuid.is_empty() && assets(view, category).any(|worn| is_named(worn, line))
        }
    };
    !is_there && !is_unread
}

/// Assets by folder and uuid, since there may be thousands of assets and of lines. `None` in place
/// of the uuid is for assets whose uuid is not known.
type Known<'k> = BTreeMap<(&'k str, Option<&'k str>), Vec<&'k Worn<'k>>>;

fn of_uuid<'k>(
    known: &'k Known<'k>,
    line: &'k Wearing,
    uuid: Option<&'k str>,
) -> &'k [&'k Worn<'k>] {
    known
        .get(&(folder(line.category), uuid))
        .map_or(&[], Vec::as_slice)
}

fn finding(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    category: &str,
    lines: &[&Wearing],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let first = lines.first()?;
    let name = &*first.name.text;
    let more = such(lines.len(), "lines");
    let same = assets(view, category).find(|worn| is_named(worn, first));
    let renamed = assets(view, category)
        .find(|worn| uuid(worn) == Some(&*first.uuid) && !first.uuid.is_empty());
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
            let own = renamed.file.stem();
            (
                format!("no asset is named `{name}`; the one with its uuid is `{own}`{more}"),
                format!("write `{own}`"),
            )
        }
        (None, None) => {
            let near = cx
                .suggestions
                .nearest(name, assets(view, category).map(|worn| worn.file.stem()));
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
