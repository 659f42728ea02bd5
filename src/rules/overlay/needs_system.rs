//! What cannot be checked because the system data was not given.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, counted};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::Content;
use crate::repo::makehuman2::{Base, View};
use crate::repo::{FileFacts, Reference, Resolution};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "finds the files if its system data has them, otherwise not")],
        docs: "User data lies over the data that comes with MakeHuman 2. Names in it may lead to files there, which \
            `mhlint` cannot know when it is given the user's folder alone. The same goes for vertices: whether the base mesh \
            has those that targets, skeletons and weights name, and whether a shape is sound, takes the mesh. Nothing is \
            wrong with such files, but this is not checked either.\n\nGive the system data: `mhlint my-data --system <MakeHuman 2>/data`. It is read and not \
            reported on.",
        ..RuleInfo::new(
            "overlay-needs-system",
            Level::Info,
            "what cannot be judged without the system data (`--system`)",
        )
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // With a macro.json that is refused, targets are searched in the wrong folder in the first place.
    if base.macros.contarget.is_refused() {
        return;
    }
    let open = open_references(view, base);
    let unmeasured = unmeasured(view, base);
    let what: Vec<String> = [references(open.len()), vertices(&unmeasured)].into_iter().flatten().collect();
    let (Some((file, place)), false) = (first(&open, &unmeasured), what.is_empty()) else { return };
    let message =
        format!("{} of base `{}` cannot be judged without the system data (`--system`)", what.join(" and "), base.name);
    let help = "add `--system` with the data folder of MakeHuman 2; it is read and not reported";
    let cases = open.iter().map(|open| &open.rel).chain(unmeasured.iter().map(|file| &file.rel));
    let of = view.references_of(base).count() + unmeasured.len();
    let finding = RULE.at(file, place, message).key(base.name).asset(&view.layers.checked.path);
    out.push(finding.help(help).evidence(Evidence::of_cases(cases).out_of(of)));
}

fn open_references<'r, 'a>(view: &'r View<'a>, base: &'r Base<'a>) -> Vec<&'r Reference<'a>> {
    let open = |reference: &&Reference<'_>| matches!(reference.resolution, Resolution::NeedsSystem);
    view.references_of(base).filter(open).collect()
}

/// Files whose vertices are those of a base mesh that only the system has.
fn unmeasured<'a>(view: &View<'a>, base: &Base<'a>) -> Vec<&'a FileFacts> {
    let checked = view.layers.checked;
    let meshes = ["base.obj", "base.mhbin"].map(|name| format!("base/{}/{name}", base.name));
    // A mesh that is there and broken has a finding of its own.
    if base.has_system || meshes.iter().any(|mesh| checked.file(mesh).is_some() || checked.has_unusable(mesh)) {
        return Vec::new();
    }
    let names_vertices = |file: &&FileFacts| match &*file.content {
        Content::Target(facts) => facts.rows > 0,
        Content::Skeleton(skeleton) => skeleton.joints.iter().any(|joint| joint.vertices.is_some()),
        Content::Weights(weights) => weights.bones.iter().any(|bone| bone.listed > 0),
        _ => false,
    };
    let own = checked.files.values().filter(|file| file.base() == Some(base.name));
    own.filter(names_vertices).collect()
}

/// Where it shows first: in the file with most names, else in the first file with vertices.
fn first<'a>(open: &[&Reference<'a>], unmeasured: &[&'a FileFacts]) -> Option<(&'a FileFacts, Place)> {
    let mut by_file: BTreeMap<&str, Vec<&Reference<'a>>> = BTreeMap::new();
    for reference in open {
        by_file.entry(&reference.from.path).or_default().push(reference);
    }
    let most = by_file.values().rev().max_by_key(|references| references.len());
    let named = most.and_then(|references| references.first()).map(|first| (first.from, first.place.clone()));
    named.or_else(|| unmeasured.first().map(|file| (*file, Place::File)))
}

fn references(count: usize) -> Option<String> {
    (count > 0).then(|| counted(count, "reference"))
}

/// `the vertices of 3 targets and 1 skeleton`.
fn vertices(files: &[&FileFacts]) -> Option<String> {
    let count = |kind: fn(&Content) -> bool| files.iter().filter(|file| kind(&file.content)).count();
    let kinds = [
        (count(|content| matches!(content, Content::Target(_))), "target"),
        (count(|content| matches!(content, Content::Skeleton(_))), "skeleton"),
        (count(|content| matches!(content, Content::Weights(_))), "weights file"),
    ];
    let kinds: Vec<String> =
        kinds.iter().filter(|(count, _)| *count > 0).map(|(count, what)| counted(*count, what)).collect();
    let (last, others) = kinds.split_last()?;
    let before = if others.is_empty() { String::new() } else { format!("{} and ", others.join(", ")) };
    Some(format!("the vertices in {before}{last}"))
}
