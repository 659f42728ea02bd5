//! What a list shows has names of its own, also where it is not known by the name alone.

use super::super::{Check, Rule, RuleCx, counted};
use super::{as_copy, makehuman1, shelves, side_by_side};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_repo::makehuman2::{Asset, View};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Makehuman2Library(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "lists both under one name, so that they cannot be told apart",
    )],
    docs: include_str!("library-duplicate-name.md").trim_ascii_end(),
    ..RuleInfo::new(
        "library-duplicate-name",
        Level::Warning,
        "two models or poses with the same name",
    )
});

pub(crate) static OF_WORN: Rule = Check::Libraries(run_worn, |view, _, out| {
    makehuman1::same_names(&OF_WORN, view, out);
})
.rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "lists both under one name; a model whose uuid matches neither may wear the wrong one",
        ),
        (Makehuman1, "lists both under one name"),
    ],
    docs: include_str!("proxy-duplicate-name.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-duplicate-name",
        Level::Warning,
        "two assets of one category with the same name",
    )
});

pub(crate) static OF_UUID: Rule =
    Check::LibrariesOfAll(run_uuid, run_uuid_makehuman1, |view, _, out| {
        shelves::same_uuids(&OF_UUID, view, out);
    })
    .rule(RuleInfo {
        breaks: &[
            (
                Makehuman2,
                "keeps the user's tags by uuid, so those of one asset change the \
                    other",
            ),
            (
                Makehuman1,
                "lists both, but cannot wear them together, and models may wear the \
                    other one",
            ),
            (
                Mpfb,
                "gives one of them the materials that were saved for the other, and models \
                        may wear the other one",
            ),
        ],
        levels: &[(Makehuman1, Level::Error)],
        docs: include_str!("proxy-duplicate-uuid.md").trim_ascii_end(),
        ..RuleInfo::new(
            "proxy-duplicate-uuid",
            Level::Warning,
            "two assets with the same uuid",
        )
    });

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let key = |asset: &Asset<'_>| {
        let is_listed =
            matches!(asset.category, "models" | "poses" | "expressions") && !asset.name.is_empty();
        is_listed.then(|| format!("{} {}", asset.category, asset.name))
    };
    find(
        &RULE,
        view,
        key,
        "name",
        "give the newer of the two a name of its own",
        out,
    );
}

fn run_worn(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let key = |asset: &Asset<'_>| {
        (asset.is_worn() && !asset.name.is_empty())
            .then(|| format!("{} {}", asset.category, asset.name))
    };
    find(
        &OF_WORN,
        view,
        key,
        "name",
        "give the newer of the two a name of its own",
        out,
    );
}

fn run_uuid(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Without a uuid all have the same: that has a finding of its own.
    let key =
        |asset: &Asset<'_>| (asset.is_worn() && asset.uuid != "0").then(|| asset.uuid.clone());
    find(
        &OF_UUID,
        view,
        key,
        "uuid",
        "give the newer of the two a uuid of its own, and load and save every model that wears it",
        out,
    );
}

fn run_uuid_makehuman1(
    view: &mhlint_repo::makehuman1::View<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    makehuman1::same_uuids(&OF_UUID, view, out);
    side_by_side::in_makehuman1(&OF_UUID, view, cx.beside, out);
}

/// Findings on the assets of the checked layer with a key in common that are not known by the same.
fn find(
    rule: &Rule,
    view: &View<'_>,
    key: impl Fn(&Asset<'_>) -> Option<String>,
    what: &str,
    help: &str,
    out: &mut Vec<Finding>,
) {
    for base in view.library.bases() {
        // Tags lie in one table for all that is listed.
        let is_meant = |asset: &&Asset<'_>| what == "uuid" || view.layers.is_checked(asset.file);
        let own = view.library.of_base(base).iter().filter(is_meant);
        for assets in grouped(own.filter_map(|asset| Some((key(asset)?, asset)))).into_values() {
            out.extend(finding(rule, view, &assets, what, help));
        }
    }
}

fn finding(
    rule: &Rule,
    view: &View<'_>,
    assets: &[&Asset<'_>],
    what: &str,
    help: &str,
) -> Option<Finding> {
    let mut assets = assets.to_vec();
    assets.sort_by_key(|one| (view.layers.is_checked(one.file), as_copy(one.file)));
    let (told, others) = assets
        .split_last()
        .filter(|(told, _)| view.layers.is_checked(told.file))?;
    let is_other = |one: &&&Asset<'_>| (&one.name, &one.uuid) != (&told.name, &told.uuid);
    let others: Vec<&&Asset<'_>> = others.iter().filter(is_other).collect();
    let first = others.first()?;
    let more = if others.len() > 1 {
        format!(" and {}", counted(others.len() - 1, "more file"))
    } else {
        String::new()
    };
    let value = if what == "uuid" {
        &told.uuid
    } else {
        &told.name
    };
    let whose = if view.layers.is_checked(first.file) {
        ""
    } else {
        "the system's "
    };
    let message = format!(
        "has the same {what} as {whose}`{}`{more}: `{value}`",
        first.file.shown()
    );
    let mut finding = rule
        .at(told.file, Place::File, message)
        .key(format!("{} {value}", parent(told.file.shown())));
    for other in &others {
        finding = finding.related(other.file.path.clone(), Place::File, "the other asset");
    }
    let files = others
        .iter()
        .map(|other| other.file.path.as_str())
        .chain([told.file.path.as_str()]);
    Some(finding.between(files).help(help))
}
