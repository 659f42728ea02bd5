//! A user's target has a name under which it can be found again.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::mpfb::{UserTarget, View, identifiers};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "loads the target that it brings in its place when a saved character is loaded",
    )],
    docs: include_str!("unreachable_user_target.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-unreachable-user-target",
        Level::Warning,
        "a user's target that cannot be found again",
    )
});

const NOT_KNOWN_AGAIN: Case = &[(
    Mpfb,
    Level::Error,
    "does not find its shape key again: each move of the slider adds one, and effects add up",
)];
const EMPTY: Case = &[(
    Mpfb,
    Level::Error,
    "shows a slider without a name, and each of its moves adds a shape key",
)];
const AS_MACRO: Case = &[(
    Mpfb,
    Level::Error,
    "takes it for a macro: removes it as soon as another setting changes",
)];
const ONE_SLIDER: Case = &[(
    Mpfb,
    Level::Error,
    "shows one slider for both, with whichever target the disk lists last",
)];
const ONE_KEY: Case = &[(
    Mpfb,
    Level::Warning,
    "moves whichever of them was loaded first with both sliders; saved characters find one of them",
)];
const REPLACES: Case = &[(
    Mpfb,
    Level::Warning,
    "loads it by the slider of that name, which then goes from 0 to 1 only",
)];

const OWN_IN_ITS_PLACE: &str =
    "gives a saved character its own target of that name; both sliders move one shape key";
const OTHER_IN_ITS_PLACE: &str = "gives a saved character one of its own targets in its place";

/// Bytes of the name of a shape key: Blender cuts the rest.
const LONGEST_KEY: usize = 63;

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own: Vec<UserTarget<'_>> = view.user_targets().collect();
    let sections = view
        .catalog
        .iter()
        .flat_map(|catalog| &catalog.sliders.sections);
    let known: BTreeSet<String> = sections
        .flat_map(|section| {
            section
                .categories
                .iter()
                .flat_map(move |category| identifiers(section, category))
        })
        .collect();
    for target in &own {
        out.extend(unknown_again(target).or_else(|| of_shipped(view, target, &known)));
    }
    out.extend(of_one_name(&own));
    for (_, all) in grouped(own.iter().map(|target| (target.identifier(), target))) {
        let (Some(first), Some(last)) = (all.first(), all.last()) else {
            continue;
        };
        if !std::ptr::eq(first.file, last.file) {
            let message = format!("has the slider of `{}`, too", first.file.rel);
            let finding = RULE
                .at(last.file, Place::File, message)
                .key("identifier")
                .case(ONE_SLIDER);
            let finding = finding.related(first.file.path.clone(), Place::File, "the other target");
            out.push(
                finding
                    .between([first.file.path.as_str(), last.file.path.as_str()])
                    .help("rename one of them"),
            );
        }
    }
}

/// Targets of one name in several sections have a slider each, and one shape key.
fn of_one_name(own: &[UserTarget<'_>]) -> Vec<Finding> {
    let by_name = grouped(
        own.iter()
            .map(|target| (target.name.to_lowercase(), target)),
    );
    let finding = |all: Vec<&UserTarget<'_>>| {
        let (first, last) = (all.first()?, all.last()?);
        let message = format!("has the name of `{}`", first.file.rel);
        let finding = RULE
            .at(last.file, Place::File, message)
            .key("stem")
            .case(ONE_KEY);
        let finding = finding.related(first.file.path.clone(), Place::File, "the other target");
        let is_other = first.identifier() != last.identifier();
        is_other.then(|| {
            finding
                .between([first.file.path.as_str(), last.file.path.as_str()])
                .help("rename one of them")
        })
    };
    by_name.into_values().filter_map(finding).collect()
}

/// A name that shape keys must not have.
fn unknown_again(target: &UserTarget<'_>) -> Option<Finding> {
    let (message, case) = match target.name.as_str() {
        "" => ("the target has no name".to_owned(), EMPTY),
        name if name.len() > LONGEST_KEY => (
            format!(
                "the name has {} bytes, a shape key at most {LONGEST_KEY}",
                name.len()
            ),
            NOT_KNOWN_AGAIN,
        ),
        name if name.to_lowercase().contains("basis") => (
            "`basis` must not be in the name of a target".to_owned(),
            NOT_KNOWN_AGAIN,
        ),
        name if name.starts_with("$md") => (
            "the name of a target must not begin with `$md`".to_owned(),
            AS_MACRO,
        ),
        _ => return None,
    };
    Some(
        RULE.at(target.file, Place::File, message)
            .key("name")
            .case(case)
            .help("rename the file"),
    )
}

/// A name that leads to one of MPFB's own targets or sliders.
fn of_shipped(
    view: &View<'_>,
    target: &UserTarget<'_>,
    known: &BTreeSet<String>,
) -> Option<Finding> {
    let name = target.name.to_lowercase();
    let at = |message: String| RULE.at(target.file, Place::File, message).key("shipped");
    if known.contains(&target.identifier()) {
        let message = format!(
            "`{}` is a slider of MPFB in section `{}`",
            target.name, target.section
        );
        return Some(
            at(message)
                .case(REPLACES)
                .help("rename the file or its folder"),
        );
    }
    let shipped = view.targets.shipped(&name)?;
    let message = if shipped == name {
        format!("MPFB has a target `{}` of its own", target.name)
    } else {
        format!(
            "`{}` is the beginning of a target of MPFB, `{shipped}`",
            target.name
        )
    };
    let finding = at(message);
    let finding = if shipped == name {
        finding.effect(OWN_IN_ITS_PLACE)
    } else {
        finding.effect(OTHER_IN_ITS_PLACE)
    };
    Some(finding.help("give the target a longer name of its own"))
}
