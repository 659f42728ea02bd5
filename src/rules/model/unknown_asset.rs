//! What a model names must exist: assets, skin, skeleton.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::own;
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use crate::formats::mhm::WornLine;
use crate::repo::makehuman2::{Asset, Base, SavedModel, View};
use crate::repo::{FileFacts, Reference, ReferenceKind, Resolution};

pub(in crate::rules) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "silently loads the model without it")],
    docs: "A model (`.mhm`) wears an asset, has a skin or a skeleton that does not exist.\n\n\
        MakeHuman 2 looks for an asset by name and uuid, then by its name alone, whatever the category. The uuid alone is \
        not enough: once an asset was renamed, models lose it. A skin is looked for in `skins/<base>/`, a skeleton \
        directly in `rigs/<base>/`, not in folders below.\n\n\
        Whatever is missing is left out; only a hidden log line says so.\n\n\
        Correct the line, or add what it names.",
    ..RuleInfo::new("model-unknown-asset", Level::Warning, "a model names an asset, skin or skeleton that does not exist")
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_open(base) {
        return;
    }
    for saved in own(view, base) {
        out.extend(saved.model.worn.iter().filter_map(|line| asset(view, base, saved, line, cx)));
        let missing = view.references.of_file(saved.file);
        let missing = missing.filter(|one| one.base == base.name && matches!(one.resolution, Resolution::Missing));
        out.extend(missing.filter_map(|reference| file(view, base, reference, cx)));
    }
}

fn asset(
    view: &View<'_>,
    base: &Base<'_>,
    saved: &SavedModel<'_>,
    line: &WornLine,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let (category, name) = (&line.category.text, &line.name.text);
    if view.library.worn(base.name, name, &line.uuid).is_some() || is_unread(view, base, name) {
        return None;
    }
    let worn = || view.library.of_base(base.name).iter().filter(|asset| asset.is_worn());
    let renamed = worn().find(|asset| asset.uuid == *line.uuid);
    let message = match renamed {
        Some(asset) => format!("no asset has the name `{name}`; the one with its uuid has the name `{}`", asset.name),
        None => format!("no asset has the name `{name}`"),
    };
    let help = match renamed {
        Some(asset) => format!("write `{category} {} {}`", asset.name, asset.uuid),
        None => {
            let near = cx.suggestions.nearest(name, worn().map(|asset| asset.name.as_str()));
            did_you_mean(near, "add the asset, or remove the line")
        }
    };
    let finding = RULE.at(saved.file, Place::Span(line.name.span.clone()), message);
    let finding = finding.key(format!("{category} {name}")).help(help);
    let near = |asset: &Asset<'_>| finding.clone().related(asset.file.path.clone(), Place::File, "this asset");
    Some(renamed.map_or_else(|| finding.clone(), near))
}

/// Whether an asset that could not be read may have the name: what keeps it from being read has a finding of its own.
fn is_unread(view: &View<'_>, base: &Base<'_>, name: &str) -> bool {
    view.worn_unread(base.name).any(|file| file.stem() == name || parent_name(file) == name)
}

fn parent_name(file: &FileFacts) -> &str {
    file.rel.rsplit('/').nth(1).unwrap_or_default()
}

fn file(view: &View<'_>, base: &Base<'_>, reference: &Reference<'_>, cx: &RuleCx<'_>) -> Option<Finding> {
    let (what, folder, suffix) = match reference.kind {
        ReferenceKind::Skin => ("skin", "skins", ".mhmat"),
        ReferenceKind::ModelSkeleton => ("skeleton", "rigs", ".mhskel"),
        _ => return None,
    };
    let rel = format!("{folder}/{}", base.name);
    let layers: Vec<_> = view.layers.strongest_first().collect();
    let files: Vec<&FileFacts> = layers.iter().flat_map(|layer| layer.below(&rel)).collect();
    let name = reference.text.rsplit('/').next().unwrap_or_default();
    let same = files.iter().find(|file| file.file_name() == name && file.rel.split('/').count() > 3);
    let help = match same.filter(|_| what == "skeleton") {
        Some(file) => format!("move `{}` to `{rel}`: a model finds skeletons only there", file.rel),
        None => {
            let below = files.iter().filter_map(|file| file.rel.strip_prefix(&rel)?.strip_prefix('/'));
            let own = reference.rel.strip_prefix(&rel).unwrap_or(reference.text).trim_start_matches('/');
            let near = cx.suggestions.nearest_file(own, below.filter(|below| below.ends_with(suffix)));
            did_you_mean(near, format!("add the file to `{rel}`, or name one that exists"))
        }
    };
    let message = format!("{what} `{}` does not exist", reference.rel);
    let finding = RULE.at(reference.from, reference.place.clone(), message).key(what).help(help);
    let effect = match what {
        "skin" => "silently shows the default skin",
        _ => "silently loads the model without a skeleton",
    };
    Some(finding.effect(effect))
}
