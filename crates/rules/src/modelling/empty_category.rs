//! An item of `target_cat.json` should have a slider to show.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::groups::{self, Groups, USER_CATEGORY};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::target_cat::Category;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "shows an entry without sliders in the tree")],
    docs: include_str!("empty_category.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-empty-category",
        Level::Info,
        "a category item has no slider",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(without_user(base));
    let (Some((file, model)), Some(groups)) =
        (base.categories.winner(), groups::of(base, &cx.suggestions))
    else {
        return;
    };
    let renamed: BTreeSet<&str> = groups.renamed.iter().map(|one| one.name).collect();
    let mut used = None;
    for category in &model.categories {
        if category.name == USER_CATEGORY {
            // One root may be a user's folder; the file is then the generated one.
            if !view.layers.is_one_root() {
                out.push(replaced(file, base, &groups));
            }
        } else if category.items.is_empty() {
            // Sliders that are hidden by it are the worse news.
            let hides_all = groups.offered.is_empty() && !groups.unknown.is_empty();
            if hides_all
                || category
                    .group
                    .as_deref()
                    .is_some_and(|group| groups.has_unknown_in(group))
            {
                continue;
            }
            let message = format!("category `{}` has no items", category.name);
            let help = "add items, or remove the category";
            out.push(
                RULE.at(file, Place::key([&category.name]), message)
                    .key(&category.name)
                    .help(help),
            );
        } else if base.modelling.winner().is_some() && !base.has_unreadable_sliders() {
            let used = used.get_or_insert_with(|| Used::of(view, base));
            if !renamed.contains(category.name.as_str()) {
                empty_items(file, used, &groups, category, out);
            }
        }
    }
}

/// The generated file must hold the category that MakeHuman 2 takes from it.
fn without_user(base: &Base<'_>) -> Option<Finding> {
    let (file, model) = base.user_categories.accepted()?;
    let there = model
        .categories
        .iter()
        .any(|category| category.name == USER_CATEGORY);
    (!file.is_misshapen() && !there).then(|| {
        RULE.at(
            file,
            Place::File,
            "the generated target_cat.json has no category `User`",
        )
        .key("generated")
        .level(Level::Error)
        .effect("crashes at start with `KeyError`")
        .help(
            "save your own changes elsewhere, then delete modelling.json and target_cat.json \
                    in this folder: MakeHuman 2 writes them again",
        )
    })
}

fn empty_items(
    file: &FileFacts,
    used: &Used<'_>,
    groups: &Groups<'_, '_>,
    category: &Category,
    out: &mut Vec<Finding>,
) {
    for (index, item) in category.items.iter().enumerate() {
        let Some(group) = category.group_of(item) else {
            continue;
        };
        if used.groups.contains(group.as_str())
            || groups.is_excused(&group)
            || item
                .cat
                .as_deref()
                .is_some_and(|cat| words(cat).any(|word| used.idle_words.contains(word)))
        {
            continue;
        }
        let message = format!("no slider has the group `{group}`");
        let place = Place::pointer([&category.name, "items", &index.to_string(), "cat"]);
        out.push(
            RULE.at(file, place, message)
                .key(&group)
                .help("remove the item, or give a slider this group"),
        );
    }
}

/// What sliders use.
struct Used<'b> {
    groups: BTreeSet<&'b str>,
    /// Words of the names of targets that no slider uses: their slider is gone, and
    /// `target-unreferenced` says so.
    idle_words: BTreeSet<&'b str>,
}

impl<'b> Used<'b> {
    fn of(view: &'b View<'_>, base: &'b Base<'_>) -> Self {
        let groups = base
            .sliders
            .iter()
            .filter_map(|slider| slider.as_meant().group.as_deref())
            .collect();
        Self {
            groups,
            idle_words: idle_words(view, base),
        }
    }
}

fn idle_words<'a>(view: &View<'a>, base: &Base<'a>) -> BTreeSet<&'a str> {
    let is_used = |file: &FileFacts| {
        view.references
            .to_file(file)
            .any(|reference| reference.base == base.name)
    };
    let targets = base.targets.into_iter().flat_map(|folder| folder.targets());
    targets
        .filter(|file| !is_used(file))
        .flat_map(|file| words(file.stem()))
        .collect()
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|letter: char| !letter.is_alphanumeric())
        .filter(|word| word.len() > 2)
}

fn replaced(file: &FileFacts, base: &Base<'_>, groups: &Groups<'_, '_>) -> Finding {
    let lost = base.sliders.iter().filter(|slider| {
        let group = slider.slider.group.as_deref();
        group
            .is_some_and(|group| groups.replaced.contains(group) && !groups.offered.contains(group))
    });
    RULE.at(
        file,
        Place::key([USER_CATEGORY]),
        "category `User` is always replaced by the generated one",
    )
    .key(USER_CATEGORY)
    .level(Level::Warning)
    .effect("replaces the category and never shows its sliders")
    .help("rename the category")
    .evidence(Evidence::of_cases(lost.map(|slider| &slider.slider.key)))
}
