//! A line of a model has all its words.

use super::super::{Check, Rule, RuleCx, counted, such};
use super::{own, when};
use crate::diag::{
    Application::{Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use crate::discover::Kind;
use crate::repo::makehuman2::{Base, SavedModel, View};
use crate::repo::mpfb;

pub(in crate::rules) static RULE: Rule = Check::Models(run, of_mpfb).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "crashes with `IndexError` when the model is loaded"),
        (Mpfb, "fails with `IndexError` when the model is imported"),
    ],
    docs: "A line of a model (`.mhm`) has too few words: `version`, `uuid`, `skinMaterial` and `skeleton` need a value, \
        `clothes`, `hair` and the other categories name and uuid of an asset, `material` name, uuid and file.\n\n\
        MakeHuman 2 crashes at the line. The figure that was shown before is gone: it has neither assets nor \
        modifiers. The start model of a base crashes it at start.\n\n\
        Models that were saved while they wore an asset without uuid have such lines. Complete the line, or remove it.",
    ..RuleInfo::new("model-arity", Level::Error, "a line of a model has too few words")
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(own(view, base).filter_map(finding));
}

/// A line `clothes` alone; what is short of the others has no consequence.
fn of_mpfb(view: &mpfb::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, model) in view.own(Kind::Model).filter_map(|file| Some((file, file.model()?))) {
        let bare = &model.columns.bare;
        let Some(first) = bare.first() else { continue };
        let message = format!("`clothes` has no value{}", such(bare.len(), "lines"));
        let finding = RULE.at(file, Place::Span(first.span.clone()), message);
        let finding = finding.evidence(Evidence::counted(bare.len()));
        out.push(finding.help("write `clothes`, then name and uuid of the asset, or remove the line"));
    }
}

fn finding(saved: &SavedModel<'_>) -> Option<Finding> {
    let short = &saved.model.short;
    let first = short.first()?;
    let keyword = &first.keyword.text;
    let more = such(short.len(), "lines");
    let message = match (first.found, first.needed) {
        (1, 2) => format!("`{keyword}` has no value{more}"),
        (found, needed) => format!("`{keyword}` has {}, expected {}{more}", counted(found - 1, "value"), needed - 1),
    };
    let help = match first.needed {
        2 => format!("add the value of `{keyword}`, or remove the line"),
        3 => format!("write `{keyword}`, then name and uuid of the asset, or remove the line"),
        _ => "write `material`, then name and uuid of the asset and the file, or remove the line".to_owned(),
    };
    let finding = RULE.at(saved.file, Place::Span(first.keyword.span.clone()), message).help(help);
    let evidence = Evidence::of_cases(short.iter().map(|line| line.keyword.text.to_string()));
    Some(finding.evidence(evidence).effect(format!("crashes with `IndexError` {}", when(saved))))
}
