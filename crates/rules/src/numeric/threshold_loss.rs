//! What the cut-off of small factors throws away.

use super::super::cause::component::too_many_at_once;
use super::super::{Check, Rule, RuleCx};
use super::{percent, title, to_see};
use mhlint_diag::{
    Application::Makehuman2, Evidence, Finding, Grows, Level, MeasureKind, OptionInfo, Place,
    RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "applies that much less of the shape between the steps; no other combination makes up for \
            it",
    )],
    docs: include_str!("threshold_loss.md").trim_ascii_end(),
    options: &[OptionInfo {
        name: "percent",
        default: 5.0,
        docs: "how much weight may be lost, in \
        per cent",
    }],
    counts: "macrodefs",
    grows: Grows::more(MeasureKind::Share),
    ..RuleInfo::new(
        "numeric-threshold-loss",
        Level::Info,
        "a macrodef loses much weight to the cut-off of small factors",
    )
});

/// Above this share nobody takes it for a rounding.
const LARGE: f64 = 0.2;

fn run(body: &Body<'_>, measures: &Measures, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = body.macros else {
        return;
    };
    let limit = cx.option(&RULE, "percent") / 100.0;
    // Where all combinations are too weak, `macro-too-many-active` says so.
    let is_told = |number: usize| {
        let macrodef = macros.macrodefs.get(number);
        macrodef.is_some_and(|macrodef| too_many_at_once(macros, macrodef).is_some())
    };
    let over = || {
        measures
            .macros
            .losses
            .iter()
            .filter(|(number, lost, _)| *lost > limit && !is_told(*number))
    };
    let Some((number, lost, at)) = over().max_by(|a, b| a.1.total_cmp(&b.1)) else {
        return;
    };
    let Some(macrodef) = macros.macrodefs.get(*number) else {
        return;
    };
    let (title, share) = (title(macrodef), percent(*lost));
    let message = format!(
        "macrodef `{title}` loses {share} of its weight because factors up to 0.01 are dropped"
    );
    let named = |number: &usize| {
        macros
            .macrodefs
            .get(*number)
            .map(super::title)
            .unwrap_or_default()
    };
    let cases = over().map(|(number, lost, _)| format!("{}: {}", named(number), percent(*lost)));
    out.push(
        RULE.at(
            file,
            Place::pointer(["macrodef", &macrodef.index.to_string(), "comp"]),
            message,
        )
        .key("loss")
        .related(&file.path, Place::File, to_see(at))
        .parts(over().map(|(number, ..)| named(number)))
        .help(if *lost > LARGE {
            "use fewer components in this macrodef, or split it"
        } else {
            "leave it if the loss is too small to see; otherwise use fewer components in this \
                    macrodef"
        })
        .evidence(
            Evidence::of_cases(cases)
                .out_of(macros.macrodefs.len())
                .with_worst(*lost, title),
        ),
    );
}
