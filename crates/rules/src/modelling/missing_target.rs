//! `incr` and `decr` must name targets that exist.

use super::super::cause::is_generated_for;
use super::super::cause::overlay::lacks_folder;
use super::super::{Check, Rule, RuleCx};
use super::foreign;
use super::marks;
use super::missing::{self, Group};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, RuleInfo, Suggestions};
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Reference, ReferenceKind};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `AttributeError` when the slider moves, or at start if the start model sets \
            it",
    )],
    docs: include_str!("missing_target.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-missing-target",
        Level::Error,
        "`incr` or `decr` names a target \
        that does not exist",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_target = |kind| matches!(kind, ReferenceKind::Incr | ReferenceKind::Decr);
    // Without any folder to load from the program does not get as far as the targets
    // (`overlay-partial-override`).
    if lacks_folder(view, base) && base.user_modelling.file().is_some() {
        return;
    }
    if base.has_foreign_sliders() {
        out.extend(foreign::sliders(&RULE, view, base));
        return;
    }
    let mut marked: Vec<&Reference<'_>> = Vec::new();
    for group in missing::groups(view, base, is_target) {
        match group.references.first() {
            Some(first) if is_marked(base, first) => marked.extend(&group.references),
            _ => out.extend(finding(view, base, &group, &cx.suggestions)),
        }
    }
    out.extend(marks::needless(&RULE, &marked));
}

/// Whether the name stands in an entry of the system with the key `user`.
fn is_marked(base: &Base<'_>, reference: &Reference<'_>) -> bool {
    base.entry(reference.owner)
        .is_some_and(|bound| base.is_marked_as_users(bound))
}

fn finding(
    view: &View<'_>,
    base: &Base<'_>,
    group: &Group<'_, '_>,
    suggestions: &Suggestions,
) -> Option<Finding> {
    let first = group.references.first()?;
    let count = group.references.len();
    if let Some(finding) = marks::missing(&RULE, base, first, count) {
        return Some(finding);
    }
    let (message, key) = match &group.folder {
        Some(folder) => (
            format!("`{folder}` is missing or empty, but {count} targets are read from it"),
            folder.as_str(),
        ),
        None => (
            format!(
                "`{}` uses `{}`, which does not exist",
                first.owner, first.rel
            ),
            first.owner,
        ),
    };
    let mut finding = RULE
        .at(first.from, first.place.clone(), message)
        .key(
            format!(
                "{key} {}",
                if group.folder.is_some() {
                    ""
                } else {
                    side(first)
                }
            )
            .trim_end(),
        )
        .evidence(Evidence::of_cases(
            group.references.iter().map(|reference| reference.text),
        ));
    finding = finding.help(help(view, first, suggestions));
    if is_generated_for(base, first.from) {
        finding = finding.effect(marks::OF_GENERATED).help(marks::ANEW);
    } else if is_unused(base, first) {
        finding = finding.level(Level::Warning).effect(
            "only logs a line: it never applies the targets of an entry with `macro` or \
                `barycentric`",
        );
    }
    Some(finding)
}

fn side(reference: &Reference<'_>) -> &'static str {
    if reference.kind == ReferenceKind::Incr {
        "incr"
    } else {
        "decr"
    }
}

fn help(view: &View<'_>, reference: &Reference<'_>, suggestions: &Suggestions) -> String {
    if reference.text.is_empty() {
        "name a target, or remove the key; the name is empty".to_owned()
    } else if let Some(stem) = reference.text.strip_suffix(".target") {
        format!("write `{stem}`, without the suffix")
    } else if let Some(packed) = packed(view, reference) {
        format!("unpack `{packed}`; MakeHuman 2 does not read packed targets")
    } else if let Some(near) = missing::nearest(view, reference, suggestions) {
        let (folder, name) = reference
            .text
            .rsplit_once('/')
            .unwrap_or(("", reference.text));
        let Some(near) = near.strip_suffix(".target") else {
            return format!("rename `{near}` to `{name}.target`");
        };
        let slash = if folder.is_empty() { "" } else { "/" };
        format!("did you mean `{folder}{slash}{near}`?")
    } else {
        "correct the path, add the target, or remove the entry".to_owned()
    }
}

/// The packed target that lies where the plain one is looked for.
fn packed<'a>(view: &View<'a>, reference: &Reference<'_>) -> Option<&'a str> {
    let rel = format!("{}.gz", reference.rel);
    view.layers
        .strongest_first()
        .find_map(|layer| layer.file(&rel))
        .map(FileFacts::file_name)
}

fn is_unused(base: &Base<'_>, reference: &Reference<'_>) -> bool {
    base.entry(reference.owner)
        .is_some_and(|slider| slider.slider.is_macro())
}
