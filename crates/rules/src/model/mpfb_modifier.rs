//! Modifiers of a model as MPFB imports them (`docs/loaders/mpfb/models.md#lines-of-a-model`): each
//! is a macro or the name of a target.

use std::collections::BTreeMap;

use super::super::cause::consequence::NO_PART;
use super::super::{Rule, RuleCx, did_you_mean, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_discover::Kind;
use mhlint_formats::macro_parts::RACES;
use mhlint_formats::mhm::columns::{MACROS, Setting, setting_of, without_folder};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{NamedTarget, View, ends};

const NOTHING_LOADED: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `ValueError` when the model is imported",
)];
const SKIPPED: Case = &[(Mpfb, Level::Warning, "skips it with a message in the log")];
const ANY: Case = &[(
    Mpfb,
    Level::Warning,
    "takes the first target that the disk lists of those whose names begin so",
)];
const LIMITED: Case = &[(
    Mpfb,
    Level::Warning,
    "limits the value: of a target to 0 to 1, one end of a pair to 1",
)];
const NO_EFFECT: Case = &[(
    Mpfb,
    Level::Warning,
    "does nothing: the value of a target with one direction ends at 0",
)];
const NO_MACRO: Case = &[(
    Mpfb,
    Level::Warning,
    "does not limit the value: the shape of this macro vanishes",
)];
const NOT_FINITE: Case = &[(
    Mpfb,
    Level::Warning,
    "takes the value as it is: the shape vanishes or breaks",
)];
const TWICE: Case = &[(
    Mpfb,
    Level::Warning,
    "applies a target once for each line, and a macro as the last line says",
)];

/// What the pattern of a modifier stands for.
enum Meant<'m> {
    /// A macro: the name of its setting, or of the race whose share the value is.
    Macro(&'static str),
    /// A pair of targets, of which the sign of the value picks this one.
    Pair(String),
    /// A target.
    Target(&'m str),
}

/// Findings on the models of the checked layer.
pub(super) fn faults(rule: &Rule, view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::Model) {
        let Some(model) = file.model() else { continue };
        let lines = &model.columns.modifiers;
        out.extend(broken(rule, file, lines));
        out.extend(values(rule, view, file, lines));
        out.extend(repeated(rule, file, lines));
        // Targets may lie in the system data or in the user's folder, so that both are needed to
        // say that one is missing.
        if view.is_complete() {
            out.extend(names(rule, view, file, lines, cx));
        }
    }
}

/// Lines with their values, for lines whose value can be read.
type Lines<'l> = Vec<(&'l Setting, f64)>;

fn meant(pattern: &str, value: f64) -> Meant<'_> {
    if let Some(setting) = setting_of(pattern) {
        return Meant::Macro(setting);
    }
    let name = pattern.split_once('/').map_or(pattern, |(_, name)| name);
    match ends(name, '|') {
        Some((stem, negative, positive)) => Meant::Pair(format!(
            "{stem}{}",
            if value < 0.0 { negative } else { positive }
        )),
        None => Meant::Target(name),
    }
}

/// The lines whose value can be read.
fn read(lines: &[Setting]) -> impl Iterator<Item = (&Setting, f64)> {
    lines
        .iter()
        .filter_map(|line| Some((line, *line.value.as_ref().ok()?)))
}

fn broken(rule: &Rule, file: &FileFacts, lines: &[Setting]) -> Option<Finding> {
    let broken: Vec<_> = lines
        .iter()
        .filter_map(|line| Some((line, line.value.as_ref().err()?)))
        .collect();
    let (first, text) = broken.first()?;
    let message = match &***text {
        "" => format!("`modifier {}` has no value", first.pattern.text),
        text => format!("`{text}` is not a number"),
    };
    let message = format!("{message}{}", such(broken.len(), "lines"));
    let help = "write the pattern without a blank, one blank, and one number; a remark needs a \
        line of its own";
    told(
        rule,
        file,
        broken.iter().map(|(line, _)| *line),
        message,
        NOTHING_LOADED,
    )
    .map(|one| one.help(help))
}

fn values(rule: &Rule, view: &View<'_>, file: &FileFacts, lines: &[Setting]) -> Vec<Finding> {
    let sort = |(line, value): &(&Setting, f64)| match meant(&line.pattern.text, *value) {
        _ if !value.is_finite() => Some(("non-finite", NOT_FINITE)),
        _ if (0.0..=1.0).contains(value) => None,
        Meant::Macro(setting) if view.leaves_no_shape(setting, *value) => {
            Some(("no-shape", NO_PART))
        }
        Meant::Macro(setting) if !RACES.contains(&setting) => Some(("macro-range", NO_MACRO)),
        Meant::Pair(_) if value.abs() > 1.0 => Some(("range", LIMITED)),
        // A pair of names that MPFB does not know is not a target.
        Meant::Target(name) if name.contains('|') => None,
        Meant::Target(_) if *value < 0.0 => Some(("negative", NO_EFFECT)),
        Meant::Target(_) | Meant::Macro(_) => Some(("range", LIMITED)),
        Meant::Pair(_) => None,
    };
    let mut by_sort: BTreeMap<&str, (Case, Lines<'_>)> = BTreeMap::new();
    for line in read(lines) {
        if let Some((key, case)) = sort(&line) {
            by_sort
                .entry(key)
                .or_insert_with(|| (case, Vec::new()))
                .1
                .push(line);
        }
    }
    let findings = by_sort.into_iter().filter_map(|(key, (case, lines))| {
        let (first, value) = lines.first()?;
        let range = if first.pattern.text.contains('|') {
            "-1 to 1"
        } else {
            "0 to 1"
        };
        let what = if value.is_finite() {
            format!("{value}, outside {range}")
        } else {
            "NaN or infinite".to_owned()
        };
        let message = format!(
            "`{}` is set to {what}{}",
            first.pattern.text,
            such(lines.len(), "lines")
        );
        let finding = told(
            rule,
            file,
            lines.iter().map(|(line, _)| *line),
            message,
            case,
        )?;
        Some(finding.key(key).help(format!("write a value from {range}")))
    });
    findings.collect()
}

fn repeated(rule: &Rule, file: &FileFacts, lines: &[Setting]) -> Option<Finding> {
    let mut known: BTreeMap<&str, f64> = BTreeMap::new();
    let mut again: Vec<&Setting> = Vec::new();
    for (line, value) in read(lines) {
        let before = known.insert(&line.pattern.text, value);
        let is_macro = matches!(meant(&line.pattern.text, value), Meant::Macro(_));
        // A second line with the same value changes nothing for a macro. A target is applied once
        // for each line.
        if before.is_some_and(|before| !is_macro || (before - value).abs() > 0.0) {
            again.push(line);
        }
    }
    let message = format!(
        "`{}` is set more than once{}",
        again.first()?.pattern.text,
        such(again.len(), "lines")
    );
    let finding = told(rule, file, again.iter().copied(), message, TWICE)?;
    Some(finding.key("repeated").help("keep one of the lines"))
}

/// Findings on names of targets that do not exist, and on names with which several targets begin.
fn names(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    lines: &[Setting],
    cx: &RuleCx<'_>,
) -> Vec<Finding> {
    let (mut unknown, mut ambiguous) = (Vec::new(), Vec::new());
    for (line, value) in read(lines) {
        let name = match meant(&line.pattern.text, value) {
            Meant::Macro(_) => continue,
            Meant::Pair(name) => name,
            Meant::Target(name) => name.to_owned(),
        };
        match view.targets.find(&name) {
            NamedTarget::Missing => unknown.push((line, name)),
            NamedTarget::AnyOf(..) => ambiguous.push(line),
            NamedTarget::Found => {}
        }
    }
    let mut findings = Vec::new();
    // If the missing target belongs to a slider, it is reported for the slider.
    let of_sliders = view.slot_targets();
    let unknown: Vec<&Setting> = unknown
        .into_iter()
        .filter(|(_, name)| !of_sliders.contains(&name.to_lowercase()))
        .map(|(line, _)| line)
        .collect();
    if let Some(first) = unknown.first() {
        let pattern = &first.pattern.text;
        let message = format!(
            "`{pattern}` is neither a macro nor a target{}",
            such(unknown.len(), "lines")
        );
        let own = without_folder(pattern);
        let meant = MACROS
            .iter()
            .find(|(name, _)| name.eq_ignore_ascii_case(own))
            .map(|(name, _)| *name);
        let near = meant.or_else(|| cx.suggestions.nearest(own, view.targets.names()));
        let help = did_you_mean(
            near,
            "write a macro or the name of a target, or remove the line",
        );
        let finding = told(rule, file, unknown.iter().copied(), message, SKIPPED);
        findings.extend(finding.map(|one| one.key("unknown").help(help)));
    }
    if let Some(first) = ambiguous.first() {
        let more = such(ambiguous.len(), "lines");
        let message = format!(
            "several targets begin with the name in `{}`{more}",
            first.pattern.text
        );
        let finding = told(rule, file, ambiguous.iter().copied(), message, ANY);
        findings.extend(finding.map(|one| {
            one.key("ambiguous")
                .help("write the whole name of a target")
        }));
    }
    findings
}

/// A finding on several lines, placed at the first.
fn told<'m>(
    rule: &Rule,
    file: &FileFacts,
    mut lines: impl Iterator<Item = &'m Setting> + Clone,
    message: String,
    case: Case,
) -> Option<Finding> {
    let evidence = Evidence::of_cases(lines.clone().map(|line| &*line.pattern.text));
    let place = Place::Span(lines.next()?.pattern.span.clone());
    Some(rule.at(file, place, message).evidence(evidence).case(case))
}
