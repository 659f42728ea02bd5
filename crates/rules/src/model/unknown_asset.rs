//! The assets, the skin and the skeleton that a model names must exist.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::{makehuman1, mpfb_asset, own, renamed_line};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::mhm::WornLine;
use mhlint_repo::makehuman2::{Asset, Base, SavedModel, View};
use mhlint_repo::{FileFacts, Reference, ReferenceKind, Resolution};

pub(crate) static RULE: Rule = Check::EachBase(
    run,
    |view, cx, out| makehuman1::assets::faults(&RULE, view, cx, out),
    |view, cx, out| mpfb_asset::faults(&RULE, view, cx, out),
)
.rule(RuleInfo {
    breaks: &[
        (Makehuman2, "silently loads the model without it"),
        (
            Makehuman1,
            "loads the model without it, with a line in the log",
        ),
        (Mpfb, "imports the model without it"),
    ],
    docs: include_str!("unknown_asset.md").trim_ascii_end(),
    ..RuleInfo::new(
        "model-unknown-asset",
        Level::Warning,
        "a model names an asset, skin or skeleton that does not exist",
    )
});

/// A line of a model that puts an asset on.
type Line<'v> = (&'v SavedModel<'v>, &'v WornLine);

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_open(base) {
        return;
    }
    let lines =
        own(view, base).flat_map(|saved| saved.model.worn.iter().map(move |line| (saved, line)));
    let known = Known::of(view, base);
    let unknown = lines.filter(|(_, line)| is_unknown(view, base, line, &known));
    // A missing asset is one mistake, in however many models it is named.
    let by_asset = grouped(unknown.map(|one| {
        (
            (&*one.1.category.text, &*one.1.name.text, &*one.1.uuid),
            one,
        )
    }));
    out.extend(
        by_asset
            .into_values()
            .filter_map(|lines| asset(&lines, &known, cx)),
    );
    let files = own(view, base).flat_map(|saved| view.references.of_file(saved.file));
    // The skeleton for poses, if it is missing, is reported by `base-missing-file`.
    let is_told = |reference: &Reference<'_>| {
        let mut named = base
            .named
            .iter()
            .filter(|one| matches!(one.resolution, Resolution::Missing));
        named.any(|one| one.rel == reference.rel)
    };
    let files = files.filter(|one| !is_told(one));
    let missing =
        files.filter(|one| one.base == base.name && matches!(one.resolution, Resolution::Missing));
    let by_file = grouped(missing.map(|one| ((one.kind, one.rel.as_str()), one)));
    out.extend(
        by_file
            .into_values()
            .filter_map(|references| file(view, base, &references, cx)),
    );
}

/// What the rule knows about the assets of a base mesh.
struct Known<'v> {
    by_uuid: BTreeMap<&'v str, &'v Asset<'v>>,
    /// Possible names of assets whose name cannot be read, or which have two names after a merge.
    /// Other rules report why.
    unread: BTreeSet<&'v str>,
}

impl<'v> Known<'v> {
    fn of(view: &'v View<'_>, base: &Base<'_>) -> Self {
        let worn = || {
            view.library
                .of_base(base.name)
                .iter()
                .filter(|asset| asset.is_worn())
        };
        let nameless =
            worn().filter(|asset| asset.name.is_empty() || asset.file.encoding.is_unmerged());
        let names =
            |file: &'v FileFacts| [file.stem(), file.rel.rsplit('/').nth(1).unwrap_or_default()];
        Self {
            by_uuid: worn().map(|asset| (asset.uuid.as_str(), asset)).collect(),
            unread: view
                .worn_unread(base.name)
                .chain(nameless.map(|asset| asset.file))
                .flat_map(names)
                .collect(),
        }
    }
}

fn is_unknown(view: &View<'_>, base: &Base<'_>, line: &WornLine, known: &Known<'_>) -> bool {
    let name = &*line.name.text;
    // An asset that is not listed for a fault of its own, or that has no name, is reported by other
    // rules.
    let is_nameless = || {
        known
            .by_uuid
            .get(&*line.uuid)
            .is_some_and(|asset| asset.name.is_empty())
    };
    view.library.worn(base.name, name, &line.uuid).is_none()
        && view.library.unlisted(name).is_none()
        && !known.unread.contains(name)
        && !is_nameless()
}

fn asset(lines: &[Line<'_>], known: &Known<'_>, cx: &RuleCx<'_>) -> Option<Finding> {
    let (saved, line) = lines.first()?;
    let (category, name) = (&line.category.text, &line.name.text);
    let renamed = known.by_uuid.get(&*line.uuid);
    let more = if lines.len() > 1 {
        format!(" ({} models)", lines.len())
    } else {
        String::new()
    };
    let message = match renamed {
        Some(asset) => format!(
            "no asset is named `{name}`; the one with its uuid is named `{}`{more}",
            asset.name
        ),
        None => format!("no asset is named `{name}`{more}"),
    };
    let help = if let Some(asset) = renamed {
        renamed_line(saved, line, asset)
    } else {
        let alike = known
            .by_uuid
            .values()
            .filter(|asset| *asset.category == **category)
            .map(|asset| &*asset.name);
        let near = cx.suggestions.nearest(name, alike);
        did_you_mean(
            near,
            "add the asset, or check it together with the pack that has it; otherwise remove the \
                line",
        )
    };
    let place = |line: &WornLine| Place::Span(line.name.span.clone());
    let mut finding = RULE
        .at(saved.file, place(line), message)
        .key(format!("{category} {name}"))
        .help(help);
    for (other, line) in lines.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(other.file.path.clone(), place(line), "also here");
    }
    if let Some(asset) = renamed {
        finding = finding.related(asset.file.path.clone(), Place::File, "this asset");
    }
    let parts = lines
        .iter()
        .map(|(saved, line)| (saved.file.shown(), &saved.file.path, place(line)));
    Some(finding.parts_at(parts).evidence(Evidence::of_cases(
        lines.iter().map(|(saved, _)| saved.file.shown()),
    )))
}

fn file(
    view: &View<'_>,
    base: &Base<'_>,
    references: &[&Reference<'_>],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let reference = references.first()?;
    let (what, folder, suffix) = match reference.kind {
        ReferenceKind::Skin => ("skin", "skins", ".mhmat"),
        ReferenceKind::ModelSkeleton => ("skeleton", "rigs", ".mhskel"),
        _ => return None,
    };
    let rel = format!("{folder}/{}", base.name);
    let layers: Vec<_> = view.layers.strongest_first().collect();
    let files: Vec<&FileFacts> = layers.iter().flat_map(|layer| layer.below(&rel)).collect();
    let name = reference.text.rsplit('/').next().unwrap_or_default();
    let same = files
        .iter()
        .find(|file| file.file_name() == name && file.rel.split('/').count() > 3);
    let help = if let Some(file) = same.filter(|_| what == "skeleton") {
        format!(
            "move `{}` to `{rel}`: a model finds skeletons only there",
            file.rel
        )
    } else {
        let below = files
            .iter()
            .filter_map(|file| file.rel.strip_prefix(&rel)?.strip_prefix('/'));
        let own = reference
            .rel
            .strip_prefix(&rel)
            .unwrap_or(reference.text)
            .trim_start_matches('/');
        let near = cx
            .suggestions
            .nearest_file(own, below.filter(|below| below.ends_with(suffix)));
        did_you_mean(
            near,
            format!("add the file to `{rel}`, or name one that exists"),
        )
    };
    let more = if references.len() > 1 {
        format!(" ({} models)", references.len())
    } else {
        String::new()
    };
    let message = format!("{what} `{}` does not exist{more}", reference.rel);
    let mut finding = RULE
        .at(reference.from, reference.place.clone(), message)
        .key(reference.text)
        .help(help);
    for other in references.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(other.from.path.clone(), other.place.clone(), "also here");
    }
    let parts = references
        .iter()
        .map(|one| (one.from.shown(), &one.from.path, one.place.clone()));
    let finding = finding.parts_at(parts);
    let finding = finding.evidence(Evidence::of_cases(
        references.iter().map(|one| one.from.shown()),
    ));
    Some(finding.effect(match what {
        "skin" => "silently shows the default skin",
        _ => "silently loads the model without a skeleton",
    }))
}
