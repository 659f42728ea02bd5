//! Each modifier of a model is the pattern of a slider, with a value in the range of that slider.

use super::super::cause::overlay::has_sliders;
use super::super::cause::schema::is_faulty;
use super::super::{Check, Rule, RuleCx, counted, such};
use super::modifier_repeated::repeated;
use super::modifier_unknown::unknown;
use super::modifier_value::{Faulty, faulty};
use super::{makehuman1, mpfb_modifier, own, when};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Cases, Evidence, Finding, Level, Place, RuleInfo,
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
        out.extend(unknown(&RULE, view, base, cx));
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

fn patterns<'m>(modifiers: impl Iterator<Item = &'m Modifier>) -> Cases {
    Evidence::of_cases(modifiers.map(|one| one.pattern.text.to_string()))
}
