//! `visible groups` and `equipment` must name what exists.

use std::collections::BTreeSet;

use super::super::cause::schema::is_faulty;
use super::super::{Check, Rule, RuleCx, counted, did_you_mean};
use super::visible_text::{self, INVISIBLE, MEMBER};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo, nearest};
use mhlint_formats::base_json::BaseJson;
use mhlint_formats::obj::Mesh;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Asset, Base, View};

/// Kinds of assets that a base can wear.
const EQUIPMENT: [&str; 8] = [
    "clothes",
    "hair",
    "eyes",
    "eyebrows",
    "eyelashes",
    "teeth",
    "tongue",
    "proxy",
];
const ONLY_CLOTHES: &str = "offers only clothes: hair, eyes, teeth and topologies cannot be chosen";

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes with `KeyError` at start")],
    docs: include_str!("unknown_equipment.md").trim_ascii_end(),
    counts: "groups",
    ..RuleInfo::new(
        "base-unknown-equipment",
        Level::Error,
        "an unknown kind of equipment, or a visible group that does not exist",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings() else {
        return;
    };
    // It came with the programs of 2025.
    if settings.equipment.is_some() || !view.layers.are_before(Makehuman2, "2025") {
        equipment(file, settings, out);
    }
    not_offered(view, base, file, settings, out);
    if !settings.has_visible_groups {
        let misspelt = file
            .schema
            .unknown
            .iter()
            .find(|key| key.nearest.as_deref() == Some(MEMBER));
        let help = match misspelt {
            Some(key) => format!("did you mean `{MEMBER}` instead of `{}`?", key.key),
            None => "add `\"visible groups\": [\"body\"]`, with the groups to draw".to_owned(),
        };
        out.push(
            RULE.at(file, Place::File, "`visible groups` is missing")
                .key(MEMBER)
                .help(help),
        );
        return;
    }
    let Some((mesh_file, mesh)) = base
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0)
    else {
        return;
    };
    let earlier = out.len();
    if let Some(text) = &settings.visible_text {
        out.push(visible_text::finding(&RULE, file, text, drawn(mesh)));
    }
    if let Some(groups) = &settings.visible_groups {
        visible(file, groups, mesh, out);
    }
    out.iter_mut()
        .skip(earlier)
        .for_each(|finding| finding.against.push(mesh_file.path.clone()));
}

fn equipment(file: &FileFacts, settings: &BaseJson, out: &mut Vec<Finding>) {
    // A value of another type, or a misspelt key, has a finding of its own.
    if settings.equipment.is_none() && !is_faulty(file, "equipment") {
        let finding = RULE.at(file, Place::File, "`equipment` is missing");
        let help = "add `\"equipment\": [\"clothes\", \"hair\", \"eyes\", \"teeth\", \"proxy\"]`";
        out.push(finding.key("equipment").effect(ONLY_CLOTHES).help(help));
    }
    for (index, name) in settings.equipment.iter().flatten().enumerate() {
        if EQUIPMENT.contains(&name.as_str()) {
            continue;
        }
        let help = did_you_mean(
            nearest(name, EQUIPMENT),
            format!("use one of: {}", EQUIPMENT.join(", ")),
        );
        out.push(
            RULE.at(
                file,
                Place::pointer(["equipment", &index.to_string()]),
                format!("unknown equipment `{name}`"),
            )
            .key(name)
            .level(Level::Warning)
            .effect("ignores it and offers no assets of this kind")
            .help(help),
        );
    }
}

/// Kinds of which there are assets that nobody can choose. A misspelt kind is told.
fn not_offered(
    view: &View<'_>,
    base: &Base<'_>,
    file: &FileFacts,
    settings: &BaseJson,
    out: &mut Vec<Finding>,
) {
    // What an unknown kind was meant for is told.
    let is_known = |offered: &&Vec<String>| {
        offered
            .iter()
            .all(|name| EQUIPMENT.contains(&name.as_str()))
    };
    let Some(offered) = settings.equipment.as_ref().filter(is_known) else {
        return;
    };
    let offered: BTreeSet<&str> = offered.iter().map(String::as_str).collect();
    let is_lost = |asset: &&Asset<'_>| asset.is_worn() && !offered.contains(asset.category);
    let assets = view.library.of_base(base.name).iter();
    let lost: Vec<&Asset<'_>> = assets.filter(is_lost).collect();
    let kinds: BTreeSet<&str> = lost.iter().map(|asset| asset.category).collect();
    let Some(first) = kinds.first() else { return };
    let message = match kinds.len() {
        1 => format!(
            "`equipment` lacks `{first}`, but the base has {}",
            counted(lost.len(), "asset")
        ),
        count => {
            format!("`equipment` lacks {count} kinds but the base has assets, first `{first}`")
        }
    };
    let finding = RULE
        .at(file, Place::pointer(["equipment"]), message)
        .key("lacking")
        .parts(kinds.iter().copied());
    let finding = finding
        .level(Level::Warning)
        .effect("does not offer these assets; only saved models wear them");
    let names = Evidence::of_cases(lost.iter().map(|asset| asset.file.shown()));
    out.push(
        finding
            .evidence(names)
            .help(format!("add `\"{first}\"` to the list")),
    );
}

/// Groups that the application draws faces of.
fn drawn(mesh: &Mesh) -> impl Iterator<Item = &str> {
    mesh.groups
        .iter()
        .filter(|group| group.faces > 0)
        .map(|group| group.name.as_str())
}

fn visible(file: &FileFacts, groups: &[String], mesh: &Mesh, out: &mut Vec<Finding>) {
    let drawn: BTreeSet<&str> = drawn(mesh).collect();
    let unknown: Vec<&String> = groups
        .iter()
        .filter(|name| !drawn.contains(name.as_str()))
        .collect();
    let nothing_left = unknown.len() == groups.len();
    let message = match unknown.as_slice() {
        [] if nothing_left => "`visible groups` is empty".to_owned(),
        [] => return,
        [only] => format!("visible group `{only}` is not in the mesh"),
        [first, ..] => format!(
            "{} visible groups are not in the mesh, such as `{first}`",
            unknown.len()
        ),
    };
    let near = unknown.first().and_then(|name| nearest(name, drawn));
    let help = did_you_mean(near, "use the names of mesh groups (`g`) that have faces");
    let finding = RULE
        .at(file, Place::pointer([MEMBER]), message)
        .key(MEMBER)
        .help(help);
    let finding = finding.evidence(Evidence::of_cases(&unknown).out_of(groups.len()));
    out.push(if nothing_left {
        finding.effect(INVISIBLE)
    } else {
        finding
            .level(Level::Warning)
            .effect("silently does not draw the group")
    });
}
