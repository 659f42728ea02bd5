//! Each line of a model has all the words that its keyword needs.

use super::super::{Check, Rule, RuleCx, such};
use super::short_lines::finding;
use super::{makehuman1, own, when};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::mpfb;

pub(crate) static RULE: Rule = Check::EachBase(
    run,
    |view, _, out| makehuman1::arity::faults(&RULE, view, out),
    of_mpfb,
)
.rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` when the model is loaded",
        ),
        (
            Makehuman1,
            "fails with `IndexError` at the line, and loads the model without it",
        ),
        (Mpfb, "fails with `IndexError` when the model is imported"),
    ],
    docs: include_str!("arity.md").trim_ascii_end(),
    ..RuleInfo::new(
        "model-arity",
        Level::Error,
        "a line of a model has too few words",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(own(view, base).filter_map(|saved| {
        let finding = finding(&RULE, saved.file, &saved.model.short)?;
        Some(finding.effect(format!("crashes with `IndexError` {}", when(saved))))
    }));
}

/// Reports lines with nothing but `clothes`. Other lines with too few words do no harm in MPFB.
fn of_mpfb(view: &mpfb::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, model) in view
        .own(Kind::Model)
        .filter_map(|file| Some((file, file.model()?)))
    {
        let bare = &model.columns.bare;
        let Some(first) = bare.first() else { continue };
        let message = format!("`clothes` has no value{}", such(bare.len(), "lines"));
        let finding = RULE.at(file, Place::Span(first.span.clone()), message);
        let finding = finding.evidence(Evidence::counted(bare.len()));
        out.push(
            finding.help("write `clothes`, then name and uuid of the asset, or remove the line"),
        );
    }
}
