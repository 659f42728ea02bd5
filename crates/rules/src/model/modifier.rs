//! Each modifier of a model is the pattern of a slider, with a value in the range of that slider.

use std::collections::BTreeSet;

use super::super::cause::overlay::has_sliders;
use super::super::cause::schema::is_faulty;
use super::super::{Check, Rule, RuleCx, counted, did_you_mean, such};
use super::known_pattern::Known;
use super::modifier_repeated::repeated;
use super::modifier_value::{Faulty, faulty};
use super::{makehuman1, mpfb_modifier, own, when};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::mhm::{Modifier, ModifierFault};
use mhlint_repo::makehuman2::{Base, SavedModel, View};

pub(crate) static RULE: Rule = Check::EachBase(
    run,
    |view, cx, out| makehuman1::modifier::faults(&RULE, view, cx, out),
    |view, cx, out| mpfb_modifier::faults(&RULE, view, cx, out),
)
.rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `ValueError` when the model is loaded",
        ),
        (
            Makehuman1,
            "fails with `ValueError` at the line, and loads the model without it",
        ),
        (Mpfb, "fails with `ValueError` when the model is imported"),
    ],
    docs: include_str!("modifier.md").trim_ascii_end(),
    ..RuleInfo::new(
        "model-modifier",
        Level::Error,
        "a modifier that is not the pattern of a slider and a value",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let has_pairs = base
        .settings()
        .is_some_and(|(file, _)| !is_faulty(file, "target-opposites"));
    // Unknown patterns and wrong values can be reported only if all sliders are known.
    let can_tell = has_sliders(base) && has_pairs && !view.is_open(base);
    for saved in own(view, base) {
        out.extend(broken(saved));
        out.extend(non_finite(saved));
        out.extend(repeated(&RULE, saved));
        if can_tell {
            out.extend(out_of_range(base, saved));
        }
    }
    if can_tell {
        out.extend(unknown(view, base, cx));
    }
}

fn broken(saved: &SavedModel<'_>) -> Option<Finding> {
    let broken = saved
        .model
        .modifiers
        .iter()
        .filter_map(|one| Some((one, one.value.as_ref().err()?)));
    let broken: Vec<_> = broken.collect();
    let (first, fault) = broken.first()?;
    let more = more(broken.len());
    let (message, help) = match fault {
        ModifierFault::Words(count) => {
            let message = format!(
                "`modifier` has {}, expected 2{more}",
                counted(count.saturating_sub(1), "value")
            );
            (
                message,
                "write the pattern of the slider and one number".to_owned(),
            )
        }
        ModifierFault::NotANumber(word) => (
            format!("`{word}` is not a number{more}"),
            "write the number with a decimal point".to_owned(),
        ),
    };
    let finding = RULE
        .at(saved.file, Place::Span(first.pattern.span.clone()), message)
        .help(help);
    let finding = finding.evidence(patterns(broken.iter().map(|(one, _)| *one)));
    Some(finding.effect(format!(
        "crashes with `ValueError` {} and applies no modifier",
        when(saved)
    )))
}

fn non_finite(saved: &SavedModel<'_>) -> Option<Finding> {
    let is_bad = |one: &&Modifier| one.value.as_ref().is_ok_and(|value| !value.is_finite());
    let bad: Vec<&Modifier> = saved.model.modifiers.iter().filter(is_bad).collect();
    let first = bad.first()?;
    let message = format!(
        "the value of `{}` is NaN or infinite{}",
        first.pattern.text,
        more(bad.len())
    );
    let finding = RULE
        .at(saved.file, Place::Span(first.pattern.span.clone()), message)
        .key("non-finite");
    let finding = finding
        .evidence(patterns(bad.iter().copied()))
        .help("write a number, or remove the line");
    let crash = if saved.is_start {
        "ValueError"
    } else {
        "UnboundLocalError"
    };
    Some(finding.effect(format!("crashes with `{crash}` {}", when(saved))))
}

/// A modifier, with the model that sets it.
type Line<'v> = (&'v SavedModel<'v>, &'v Modifier);

/// Findings on patterns that no slider has. Patterns that the same models set are one finding.
fn unknown(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>) -> Vec<Finding> {
    let known = Known::of(view, base);
    // A pattern that a component of the macros names is reported there.
    let macros = base
        .macro_file()
        .into_iter()
        .flat_map(|(_, file)| &file.components);
    let told: BTreeSet<&str> = macros
        .filter_map(|component| component.pattern.as_deref())
        .collect();
    let is_lost = |(_, one): &Line<'_>| known.lacks(one) && !told.contains(&*one.pattern.text);
    let lines =
        own(view, base).flat_map(|saved| saved.model.modifiers.iter().map(move |one| (saved, one)));
    let by_pattern = grouped(
        lines
            .filter(is_lost)
            .map(|line| (&*line.1.pattern.text, line)),
    );
    let models = |lines: &[Line<'_>]| {
        lines
            .iter()
            .map(|(saved, _)| saved.file.path.clone())
            .collect::<Vec<_>>()
    };
    let by_models = grouped(
        by_pattern
            .into_values()
            .map(|lines| (models(&lines), lines)),
    );
    let told = by_models
        .into_values()
        .filter_map(|patterns| unknown_in(base, &patterns, cx));
    told.collect()
}

fn unknown_in(base: &Base<'_>, patterns: &[Vec<Line<'_>>], cx: &RuleCx<'_>) -> Option<Finding> {
    let lines = patterns.first()?;
    let (saved, first) = lines.first()?;
    let models = if lines.len() > 1 {
        format!(" ({} models)", lines.len())
    } else {
        String::new()
    };
    let message = match patterns.len() {
        1 => format!("no slider has the pattern `{}`{models}", first.pattern.text),
        count => format!(
            "no slider has the pattern of {count} modifiers, first `{}`{models}",
            first.pattern.text
        ),
    };
    let known = base
        .sliders
        .iter()
        .flat_map(|slider| slider.pattern.names());
    let near = cx
        .suggestions
        .nearest(&first.pattern.text, known.map(String::as_str));
    let place = |one: &Modifier| Place::Span(one.pattern.span.clone());
    let mut finding = RULE
        .at(saved.file, place(first), message)
        .key("unknown")
        .level(Level::Warning);
    for (other, one) in lines.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(other.file.path.clone(), place(one), "also here");
    }
    let all = patterns
        .iter()
        .flatten()
        .map(|(saved, one)| (&*one.pattern.text, &saved.file.path, place(one)));
    let finding = finding.parts_at(all).evidence(self::patterns(
        patterns.iter().flatten().map(|(_, one)| *one),
    ));
    let help = did_you_mean(
        near,
        "write the pattern of a slider, or check the model together with the pack that has it",
    );
    Some(
        finding
            .effect("lists it as missing and does not apply it")
            .help(help),
    )
}

fn out_of_range(base: &Base<'_>, saved: &SavedModel<'_>) -> Option<Finding> {
    let faulty: Vec<Faulty<'_>> = saved
        .model
        .modifiers
        .iter()
        .filter_map(|one| faulty(base, one))
        .collect();
    let first = faulty.first()?;
    let message = format!(
        "`{}` is set to {}, outside {}{}",
        first.modifier.pattern.text,
        first.value,
        first.range(),
        more(faulty.len())
    );
    let finding = RULE
        .at(
            saved.file,
            Place::Span(first.modifier.pattern.span.clone()),
            message,
        )
        .key("range");
    let finding = finding
        .evidence(patterns(faulty.iter().map(|one| one.modifier)))
        .level(Level::Warning);
    Some(finding.effect(first.effect()).help(first.help()))
}

fn more(count: usize) -> String {
    such(count, "lines")
}

fn patterns<'m>(modifiers: impl Iterator<Item = &'m Modifier>) -> mhlint_diag::Cases {
    Evidence::of_cases(modifiers.map(|one| one.pattern.text.to_string()))
}
