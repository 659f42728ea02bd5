//! An expression of MPFB has units that exist, with strengths from 0 to 1.

use super::super::unfit::{findings, is_misspelt};
use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::face_expression::{FaceExpression, UNITS};
use mhlint_formats::unfit::Unfits;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "lists no expression at all, and a saved character that uses this one stops half-built \
            when it is loaded",
    )],
    docs: include_str!("schema.md").trim_ascii_end(),
    ..RuleInfo::new(
        "expression-schema",
        Level::Error,
        "an expression with values that its loader \
        does not take",
    )
});

const NO_UNIT: &str = "skips the unit, with a message on the console alone";

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::FaceExpression) {
        let Some(expression) = file.face_expression() else {
            continue;
        };
        out.extend(findings(&RULE, file, &expression.empties, cx).map(|(_, finding)| finding));
        for (faults, effect) in [
            (
                &expression.refused,
                "skips the file: the expression is not listed",
            ),
            (&expression.no_numbers, NO_UNIT),
            (
                &expression.out_of_range,
                "does not limit the strength: above 1 the unit is at its full strength and \
                 outweighs other expressions, below 0 it does nothing",
            ),
        ] {
            let own = findings(&RULE, file, faults, cx).map(|(_, finding)| finding);
            out.extend(own.map(|finding| finding.level(Level::Warning).effect(effect)));
        }
        let unread = findings(&RULE, file, &expression.unread, cx)
            .filter(|(first, _)| is_misspelt(first, cx));
        let misspelt: Vec<Finding> = unread.map(|(_, finding)| finding).collect();
        let has_fault = |faults: &Unfits| !faults.all().is_empty();
        if misspelt.is_empty() && !has_fault(&expression.empties) && !has_fault(&expression.refused)
        {
            out.extend(without_units(file, expression));
        }
        let effect = "finds no units: the expression does nothing";
        out.extend(
            misspelt
                .into_iter()
                .map(|finding| finding.level(Level::Warning).effect(effect)),
        );
        out.extend(unknown(file, expression, cx));
        out.extend(letters(file, expression));
    }
}

/// Any file in the folder is listed, also one that is something else.
fn without_units(file: &FileFacts, expression: &FaceExpression) -> Option<Finding> {
    let is_other = expression.units.is_empty() && !expression.unread.all().is_empty();
    let finding = is_other.then(|| RULE.at(file, Place::File, "the file has no face unit"))?;
    let finding = finding
        .key("none")
        .level(Level::Info)
        .effect("lists an expression that does nothing");
    Some(
        finding.help("add face units; if the file is something else, move it out of `expressions`"),
    )
}

fn unknown(file: &FileFacts, expression: &FaceExpression, cx: &RuleCx<'_>) -> Option<Finding> {
    let unknown: Vec<_> = expression
        .units
        .iter()
        .filter(|(name, _)| !UNITS.contains(&name.as_str()))
        .collect();
    let (name, pointer) = unknown.first()?;
    let in_other_case = UNITS
        .into_iter()
        .find(|unit| unit.eq_ignore_ascii_case(name));
    let near = in_other_case.or_else(|| cx.suggestions.nearest(name, UNITS));
    let message = format!(
        "`{name}` is not a face unit{}",
        such(unknown.len(), "units")
    );
    let finding = RULE
        .at(file, Place::Key(pointer.clone()), message)
        .key("units")
        .level(Level::Warning);
    let finding = finding.evidence(Evidence::of_cases(
        unknown.iter().map(|(name, _)| name.as_str()),
    ));
    let finding = finding.effect(NO_UNIT);
    Some(finding.help(did_you_mean(
        near,
        "write the name of a unit of ARKit, or remove the unit",
    )))
}

fn letters(file: &FileFacts, expression: &FaceExpression) -> Option<Finding> {
    let finding = expression.has_letters_for_tags.then(|| {
        RULE.at(
            file,
            Place::pointer(["tags"]),
            "`tags` is a string, expected a list",
        )
        .key("letters")
        .level(Level::Warning)
    });
    Some(
        finding?
            .effect("makes a tag of each letter")
            .help("write a list of strings"),
    )
}
