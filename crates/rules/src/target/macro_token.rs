//! The name of a macro target has a value of each category, and nothing else.

use super::super::{Check, Rule, RuleCx, did_you_mean, enumerated, such};
use super::macro_group::{MacroGroup, categories, macro_groups};
use mhlint_diag::{
    Application::Makehuman1, Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::target::name::CATEGORIES;
use mhlint_repo::makehuman1::{NamedTarget, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "never reads it: no macro asks for this name")],
    docs: include_str!("macro_token.md").trim_ascii_end(),
    ..RuleInfo::new(
        "target-macro-token",
        Level::Warning,
        "a macro target whose name does not fit its group",
    )
});

const AT_EVERY: Case = &[(
    Makehuman1,
    Level::Warning,
    "applies it at every value of the missing category: the neutral figure changes, too",
)];
const SELDOM: Case = &[(
    Makehuman1,
    Level::Warning,
    "applies it at fewer settings than the other targets of the group",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for group in macro_groups(view) {
        out.extend(group.odd().map(|target| odd(&group, target)));
        let by_words = grouped(
            group
                .strays
                .iter()
                .map(|(target, words)| (words.as_str(), *target)),
        );
        out.extend(
            by_words
                .into_iter()
                .filter_map(|(words, targets)| stray(&group, &targets, words, cx)),
        );
    }
}

fn odd(group: &MacroGroup<'_>, target: &NamedTarget<'_>) -> Finding {
    let own = categories(target);
    let quoted = |all: Vec<&'static str>| enumerated(&all);
    let lacking: Vec<&'static str> = group
        .categories
        .iter()
        .copied()
        .filter(|one| !own.contains(one))
        .collect();
    let more: Vec<&'static str> = own
        .into_iter()
        .filter(|one| !group.categories.contains(one))
        .collect();
    let told = |message: String| RULE.at(target.file, Place::File, message).key("categories");
    if lacking.is_empty() {
        let message = format!(
            "has a value of {}, unlike the other targets of `{}`",
            quoted(more),
            group.name
        );
        return told(message)
            .case(SELDOM)
            .help("remove the word from the name, unless another target has that name already");
    }
    let message = format!(
        "has no value of {}, unlike the other targets of `{}`",
        quoted(lacking.clone()),
        group.name
    );
    let words = lacking
        .first()
        .and_then(|first| CATEGORIES.iter().find(|(own, _)| own == first));
    let words: Vec<String> = words
        .iter()
        .flat_map(|(_, words)| *words)
        .map(|word| format!("`{word}`"))
        .collect();
    told(message)
        .case(AT_EVERY)
        .help(format!("add one of {}", words.join(", ")))
}

fn stray(
    group: &MacroGroup<'_>,
    targets: &[&NamedTarget<'_>],
    words: &str,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let target = targets.first()?;
    let own = categories(target);
    let missing = CATEGORIES
        .iter()
        .filter(|(category, _)| group.categories.contains(category) && !own.contains(category));
    let known: Vec<&'static str> = missing.flat_map(|(_, words)| *words).copied().collect();
    let in_capitals = known
        .iter()
        .find(|word| word.eq_ignore_ascii_case(words))
        .copied();
    let near = in_capitals.or_else(|| cx.suggestions.nearest(words, known.iter().copied()));
    let message = format!(
        "`{words}` is not a value of a macro: nothing reads group `{}-{words}`{}",
        group.name,
        such(targets.len(), "targets")
    );
    let finding = RULE
        .at(target.file, Place::File, message)
        .key(format!("{} {words}", group.name));
    let finding = finding.parts_in(
        targets
            .iter()
            .map(|target| (target.file.rel.as_str(), &target.file.path)),
    );
    let finding = finding.evidence(Evidence::of_cases(
        targets.iter().map(|target| target.file.rel.as_str()),
    ));
    Some(finding.help(did_you_mean(
        near,
        "correct the name, or keep the files outside of the data",
    )))
}
