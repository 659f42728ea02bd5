//! A modifier of a model is the pattern of a slider and a value that the slider has.

use super::super::cause::overlay::has_sliders;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::modifier_value::{Faulty, faulty};
use super::{own, when};
use crate::diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::mhm::{Modifier, ModifierFault};
use crate::repo::makehuman2::{Base, SavedModel, View};

pub(in crate::rules) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes with `ValueError` when the model is loaded")],
    docs: "A line `modifier` of a model (`.mhm`) needs exactly the pattern of a slider and a number.\n\n\
        With other words MakeHuman 2 crashes: no modifier is applied. Patterns with a blank, as of a user target with a \
        blank in its name, are saved in this form. NaN stops the shape half way.\n\n\
        A pattern that no slider has is listed as missing and not applied (a warning). Values are not limited: outside \
        0 to 1 (-1 to 1 for a slider with two sides) a shape is exaggerated, and a macro vanishes above 1 (a \
        warning). A negative value of a slider with one side is ignored.\n\n\
        Write the pattern as the slider has it, and a value between 0 and 1.",
    ..RuleInfo::new("model-modifier", Level::Error, "a modifier that is not the pattern of a slider and a value")
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for saved in own(view, base) {
        out.extend(broken(saved));
        out.extend(non_finite(saved));
        // Of a slider nobody knows nothing can be said where not all sliders are at hand.
        if has_sliders(base) && !view.is_open(base) {
            out.extend(unknown(view, base, saved, cx));
            out.extend(out_of_range(base, saved));
        }
    }
}

fn broken(saved: &SavedModel<'_>) -> Option<Finding> {
    let broken = saved.model.modifiers.iter().filter_map(|one| Some((one, one.value.as_ref().err()?)));
    let broken: Vec<_> = broken.collect();
    let (first, fault) = broken.first()?;
    let more = more(broken.len());
    let (message, help) = match fault {
        ModifierFault::Words(count) => {
            let message = format!("`modifier` has {} words behind it, expected 2{more}", count.saturating_sub(1));
            (message, "write the pattern of the slider and one number".to_owned())
        }
        ModifierFault::NotANumber(word) => {
            (format!("`{word}` is not a number{more}"), "write the number with a decimal point".to_owned())
        }
    };
    let finding = RULE.at(saved.file, Place::Span(first.pattern.span.clone()), message).help(help);
    let finding = finding.evidence(patterns(broken.iter().map(|(one, _)| *one)));
    Some(finding.effect(format!("crashes with `ValueError` {} and applies no modifier", when(saved))))
}

fn non_finite(saved: &SavedModel<'_>) -> Option<Finding> {
    let is_bad = |one: &&Modifier| one.value.as_ref().is_ok_and(|value| !value.is_finite());
    let bad: Vec<&Modifier> = saved.model.modifiers.iter().filter(is_bad).collect();
    let first = bad.first()?;
    let message = format!("the value of `{}` is NaN or infinity{}", first.pattern.text, more(bad.len()));
    let finding = RULE.at(saved.file, Place::Span(first.pattern.span.clone()), message).key("non-finite");
    let finding = finding.evidence(patterns(bad.iter().copied())).help("write a number, or remove the line");
    Some(finding.effect(format!("crashes with `UnboundLocalError` {}", when(saved))))
}

fn unknown(view: &View<'_>, base: &Base<'_>, saved: &SavedModel<'_>, cx: &RuleCx<'_>) -> Option<Finding> {
    // Sliders of user targets are made when the program starts.
    let is_users = |pattern: &str| {
        let Some(name) = pattern.strip_prefix("custom/") else { return false };
        let name = name.split('|').next().unwrap_or(name);
        view.layers.user.is_none() || base.user_targets.is_none_or(|folder| folder.target(name).is_some())
    };
    let is_unknown = |one: &&Modifier| {
        let pattern = &*one.pattern.text;
        one.value.is_ok() && base.slider(pattern).is_none() && !is_users(pattern)
    };
    let unknown: Vec<&Modifier> = saved.model.modifiers.iter().filter(is_unknown).collect();
    let first = unknown.first()?;
    let message = match unknown.len() {
        1 => format!("no slider has the pattern `{}`", first.pattern.text),
        count => format!("no slider has the pattern of {count} modifiers, first `{}`", first.pattern.text),
    };
    let known = base.sliders.iter().flat_map(|slider| slider.pattern.names());
    let near = cx.suggestions.nearest(&first.pattern.text, known.map(String::as_str));
    let finding = RULE.at(saved.file, Place::Span(first.pattern.span.clone()), message).key("unknown");
    let finding = finding.level(Level::Warning).effect("lists it as missing and does not apply it");
    let help = did_you_mean(near, "write the pattern of a slider, or remove the line");
    Some(finding.evidence(patterns(unknown.iter().copied()).out_of(saved.model.modifiers.len())).help(help))
}

fn out_of_range(base: &Base<'_>, saved: &SavedModel<'_>) -> Option<Finding> {
    let faulty: Vec<Faulty<'_>> = saved.model.modifiers.iter().filter_map(|one| faulty(base, one)).collect();
    let first = faulty.first()?;
    let message = format!(
        "`{}` is set to {}, outside {}{}",
        first.modifier.pattern.text,
        first.value,
        first.range(),
        more(faulty.len())
    );
    let finding = RULE.at(saved.file, Place::Span(first.modifier.pattern.span.clone()), message).key("range");
    let finding = finding.evidence(patterns(faulty.iter().map(|one| one.modifier))).level(Level::Warning);
    Some(finding.effect(first.effect()).help(first.help()))
}

fn more(count: usize) -> String {
    if count > 1 { format!(" ({count} such lines)") } else { String::new() }
}

fn patterns<'m>(modifiers: impl Iterator<Item = &'m Modifier>) -> crate::diag::Cases {
    Evidence::of_cases(modifiers.map(|one| one.pattern.text.to_string()))
}
