//! The assets, the skin and the skeleton that a model names must exist.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::{makehuman1, missing_file, mpfb_asset, own, renamed_line};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    EXAMPLES, Evidence, Finding, Grouped, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::mhm::WornLine;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Asset, Base, SavedModel, View};

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
    missing_file::faults(&RULE, view, base, cx, out);
}

/// What the rule knows about the assets of a base mesh.
struct Known<'v> {
    by_uuid: BTreeMap<&'v str, &'v Asset<'v>>,
    /// Their names by category.
    names: Grouped<&'v str, &'v str>,
    /// Models with the names of the assets that they have material lines for.
    with_material: BTreeSet<(&'v str, &'v str)>,
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
        let by_uuid: BTreeMap<&str, &Asset<'_>> =
            worn().map(|asset| (asset.uuid.as_str(), asset)).collect();
        let by_category = by_uuid.values().map(|one| (one.category, &*one.name));
        let materials = own(view, base).flat_map(|saved| {
            let lines = saved.model.materials.iter();
            lines.map(|line| (&*saved.file.path, &*line.name.text))
        });
        Self {
            names: grouped(by_category),
            with_material: materials.collect(),
            by_uuid,
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
        let own = (saved.file.path.as_str(), &**name);
        renamed_line(line, asset, known.with_material.contains(&own))
    } else {
        let alike = known.names.get(&**category).into_iter().flatten().copied();
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
