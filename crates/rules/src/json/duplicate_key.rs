//! A key once in an object.

use super::super::{Check, Rule, RuleCx, such};
use super::left_out;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo, grouped, steps, structural,
};
use mhlint_discover::Kind;
use mhlint_json::Duplicate;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "silently keeps only the last value"),
        (Makehuman1, "silently keeps only the last value"),
        (Mpfb, "silently keeps only the last value"),
    ],
    docs: include_str!("duplicate_key.md").trim_ascii_end(),
    ..RuleInfo::new(
        "json-duplicate-key",
        Level::Warning,
        "a key that appears more than once in an object",
    )
});

/// What has a slider once is reached by saved characters alone.
const NO_SLIDERS: Case = &[(
    Mpfb,
    Level::Error,
    "keeps only the last value: the sliders of the others are missing",
)];

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let by_member = grouped(
        file.json
            .duplicates
            .iter()
            .map(|duplicate| (duplicate.pointer.as_str(), duplicate)),
    );
    let (equal, other): (Vec<_>, Vec<_>) = by_member
        .into_iter()
        .partition(|(_, all)| all.iter().all(|duplicate| duplicate.equal));
    out.extend(
        other
            .into_iter()
            .filter_map(|(pointer, all)| finding(file, pointer, &all)),
    );
    // Where nothing is lost, one habit of whoever wrote the file is one finding.
    for members in grouped(
        equal
            .into_iter()
            .map(|one| (steps(one.0).last().unwrap_or_default(), one)),
    )
    .into_values()
    {
        out.extend(of_equal(file, &members));
    }
    out.extend(left_out(
        &RULE,
        file,
        file.json.duplicates_left_out,
        "duplicate key",
    ));
}

/// One finding for all objects of a file that have a key more than once, each time with the same
/// value.
fn of_equal(file: &FileFacts, members: &[(&str, Vec<&Duplicate>)]) -> Option<Finding> {
    let (pointer, all) = members.first()?;
    let mut finding = finding(file, pointer, all)?;
    if members.len() > 1 {
        finding.message = format!("{}{}", finding.message, such(members.len(), "objects"));
        let objects = members.iter().map(|(pointer, _)| structural(pointer));
        return Some(finding.evidence(Evidence::of_cases(objects)));
    }
    Some(finding)
}

/// One finding for a key, however often it occurs: at the first one that is lost, with the one that
/// wins.
fn finding(file: &FileFacts, pointer: &str, all: &[&Duplicate]) -> Option<Finding> {
    let (first, last) = (all.first()?, all.last()?);
    let key = steps(pointer).last().unwrap_or_default();
    let equal = all.iter().all(|duplicate| duplicate.equal);
    let times = if all.len() == 1 {
        "twice".to_owned()
    } else {
        format!("{} times", all.len() + 1)
    };
    let loss = if equal {
        " with the same value"
    } else {
        "; only the last value counts"
    };
    let finding = RULE.at(
        file,
        Place::Span(first.lost.clone()),
        format!("key `{key}` appears {times}{loss}"),
    );
    let related = Place::Span(last.kept.clone());
    let holds_sliders = key == "categories" || steps(pointer).count() == 1;
    let is_slider_lost = file.kind == Kind::TargetCatalog && holds_sliders && !equal;
    let finding = if is_slider_lost {
        finding.case(NO_SLIDERS)
    } else {
        finding
    };
    let finding = if equal {
        finding.at_most(Level::Info)
    } else {
        finding
    };
    Some(
        finding
            .key(structural(pointer))
            .help(match file.kind {
                _ if equal => "keep one of them",
                Kind::Weights | Kind::AssetWeights => "join the lists of weights under one key",
                _ => "rename or remove all but one",
            })
            .related(file.path.clone(), related, format!("this `{key}` is used")),
    )
}
