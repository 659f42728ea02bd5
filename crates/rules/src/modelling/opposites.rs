//! A pair of targets makes a slider with two directions only if `base.json` declares its endings.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::schema::is_faulty;
use super::super::{Check, Rule, RuleCx};
use super::with_patterns;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, BoundSlider, Pattern, Undeclared, View, as_undeclared};
use mhlint_source::file_name;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "shows a slider that can only increase; the other target cannot be reached",
    )],
    docs: include_str!("opposites.md").trim_ascii_end(),
    counts: "sliders",
    ..RuleInfo::new(
        "modelling-opposites",
        Level::Warning,
        "`target-opposites` does not cover a pair of targets",
    )
});

/// Who makes a random character looks the partner up by its pattern.
const HAS_PARTNERS: &str =
    "crashes with `KeyError` when it makes a random character; the sliders have only one direction";

type Pairs<'r, 'a> = Vec<&'r BoundSlider<'a>>;

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings() else {
        return;
    };
    if is_faulty(file, "target-opposites") {
        return;
    }
    let sliders = with_patterns(base).unwrap_or_default();
    let undeclared: Pairs<'_, '_> = sliders
        .iter()
        .filter(|slider| slider.is_undeclared_pair() && !base.lacks_target(slider))
        .collect();
    let by_endings = grouped(undeclared.iter().map(|slider| {
        let endings = (
            ending(slider.slider.decr.as_deref()),
            ending(slider.slider.incr.as_deref()),
        );
        (endings, *slider)
    }));
    let is_one_cause = if settings.opposites.is_empty() {
        undeclared.len() > 1
    } else {
        by_endings.len() > 1
            && !sliders
                .iter()
                .any(|slider| matches!(slider.pattern, Pattern::Pair(_)))
    };
    let asked = asked(base);
    if is_one_cause && view.layers.is_checked(file) {
        let finding = without_pairs(file, &settings.opposites, &undeclared);
        out.push(weigh(&asked, &undeclared, finding));
        return;
    }
    let opposites = settings.opposites.iter();
    let opposites = opposites
        .map(|(decr, incr)| (decr.as_str(), incr.as_str()))
        .collect();
    for (endings, sliders) in by_endings {
        let found = of_endings(&opposites, endings, &sliders);
        let found = found.map(|finding| weigh(&asked, &sliders, finding));
        out.extend(found.map(|finding| finding.against(&file.path)));
    }
}

/// No slider at all has two directions: one thing to say, of `base.json`.
fn without_pairs(
    file: &FileFacts,
    opposites: &[(String, String)],
    sliders: &[&BoundSlider<'_>],
) -> Finding {
    let count = sliders.len();
    let covers = |flipped: bool| {
        let first = sliders.first().map(|bound| bound.slider);
        let ends = |path: Option<&String>, end: &str| {
            path.is_some_and(|path| path.ends_with(end.trim_matches('-')))
        };
        first.is_some_and(|slider| {
            let (decr, incr) = (slider.decr.as_ref(), slider.incr.as_ref());
            let (one, other) = if flipped { (incr, decr) } else { (decr, incr) };
            opposites
                .iter()
                .any(|(d, i)| ends(one, d) && ends(other, i))
        })
    };
    let (place, message, help) = match opposites {
        [] => (
            Place::File,
            format!("`target-opposites` is missing, so {count} sliders have only one direction"),
            "add `\"target-opposites\": {\"decr\": \"incr\"}` with the endings of the target names",
        ),
        _ => (
            Place::key(["target-opposites"]),
            format!(
                "`target-opposites` covers none of the {count} pairs of targets, so their sliders \
                    have only one direction"
            ),
            match (covers(false), covers(true)) {
                (_, true) => "write the decreasing ending first: `\"decr\": \"incr\"`",
                (true, _) => "write the endings without `-`: `\"decr\": \"incr\"`",
                _ => "write the endings of the target names: `\"decr\": \"incr\"`",
            },
        ),
    };
    let evidence = Evidence::of_cases(sliders.iter().map(|slider| &slider.slider.key));
    RULE.at(file, place, message).help(help).evidence(evidence)
}

/// A slider is saved under the names of its targets.
const MODELS: &str = "; saved models then find these sliders by new names";

fn of_endings(
    opposites: &BTreeMap<&str, &str>,
    (decr, incr): (&str, &str),
    sliders: &[&BoundSlider<'_>],
) -> Option<Finding> {
    let first = sliders.first()?;
    let key = first.slider.key.as_str();
    let message = match sliders {
        [_] => format!(
            "`{key}` has only one direction: `target-opposites` has no pair `{decr}`/`{incr}`"
        ),
        more => {
            format!(
                "{} sliders have only one direction: `target-opposites` has no pair \
                    `{decr}`/`{incr}`",
                more.len()
            )
        }
    };
    let help = if opposites.get(incr) == Some(&decr) {
        format!("swap `incr` and `decr`{MODELS}")
    } else if let Some(known) = opposites.get(decr) {
        // A second pair for the ending would take the place of the first.
        format!("use targets that belong together: `{decr}` goes with `{known}`")
    } else {
        format!(
            "add `\"{decr}\": \"{incr}\"` to `target-opposites` of base.json, or correct the \
                names{MODELS}"
        )
    };
    let finding = RULE
        .at(first.file, Place::pointer([key, "decr"]), message)
        .key(format!("{decr}/{incr}"))
        .help(help);
    let keys = sliders.iter().map(|slider| &slider.slider.key);
    Some(finding.evidence(Evidence::of_cases(keys)))
}

/// The patterns of left sliders that are looked up and not there, which stops the randomizer
/// (`docs/loaders/makehuman2/sliders.md#faults-of-sliders`). A right one is left out without a
/// word.
fn asked<'b>(base: &'b Base<'_>) -> BTreeSet<Undeclared<'b>> {
    let sliders = base.sliders.iter().map(|bound| bound.slider);
    let lefts = sliders
        .filter(|slider| slider.rsym.is_none())
        .filter_map(|slider| slider.lsym.as_deref());
    let lost = lefts.filter(|left| base.slider(left).is_none());
    lost.flat_map(as_undeclared).collect()
}

/// Raises a finding where the pattern that one of these would have is asked for.
fn weigh(
    asked: &BTreeSet<Undeclared<'_>>,
    sliders: &[&BoundSlider<'_>],
    finding: Finding,
) -> Finding {
    let mut patterns = sliders.iter().flat_map(|slider| slider.undeclared());
    if patterns.any(|pattern| asked.contains(&pattern)) {
        finding.level(Level::Error).effect(HAS_PARTNERS)
    } else {
        finding
    }
}

/// The part of a target's name behind its last `-`.
fn ending(path: Option<&str>) -> &str {
    let name = file_name(path.unwrap_or_default());
    name.rsplit('-').next().unwrap_or(name)
}
