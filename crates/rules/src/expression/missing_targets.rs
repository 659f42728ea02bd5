//! A face unit of an expression needs a target to move.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::face_expression::UNITS;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{NamedTarget, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "lists and stores the expression, but nothing moves for these units; only \
        the console says so",
    )],
    docs: include_str!("missing_targets.md").trim_ascii_end(),
    of_library: true,
    counts: "units",
    ..RuleInfo::new(
        "expression-missing-targets",
        Level::Warning,
        "a face unit without a target",
    )
});

/// The unit whose target shows MPFB that the pack of face units is installed
/// (`docs/loaders/mpfb/expressions.md#application`).
const SIGN: &str = "cheekPuff";
const NOT_INSTALLED: &str = "stores the expressions, but moves no face with them, also where the \
    targets of their units exist";

/// A file with its units that have no target.
type Still<'v> = (&'v FileFacts, Vec<&'v (String, String)>, usize);

fn run<'v>(view: &'v View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // The targets are in a user's folder.
    if !view.has_user() {
        return;
    }
    let is_still = |unit: &str| matches!(view.targets.find(unit), NamedTarget::Missing);
    let of_file = |file| -> Option<Still<'_>> {
        let own = FileFacts::face_expression(file)?.units.iter();
        let known: Vec<_> = own
            .filter(|(name, _)| UNITS.contains(&name.as_str()))
            .collect();
        let count = known.len();
        let still: Vec<_> = known
            .into_iter()
            .filter(|(name, _)| is_still(name))
            .collect();
        (!still.is_empty()).then_some((file, still, count))
    };
    let still: Vec<Still<'_>> = view.own(Kind::FaceExpression).filter_map(of_file).collect();
    if UNITS.into_iter().all(is_still) {
        out.extend(all_still(&still));
        return;
    }
    if is_still(SIGN) {
        out.extend(not_taken_for_installed(view));
    }
    let without_sign = |(file, mut units, count): Still<'v>| {
        units.retain(|(name, _)| name != SIGN);
        (file, units, count)
    };
    out.extend(
        still
            .into_iter()
            .map(without_sign)
            .filter_map(|one| some_still(&one)),
    );
}

/// The targets of all units go unused without this one.
fn not_taken_for_installed(view: &View<'_>) -> Option<Finding> {
    let moving = |file: &&FileFacts| {
        file.face_expression()
            .is_some_and(|expression| !expression.units.is_empty())
    };
    let files: Vec<&FileFacts> = view.own(Kind::FaceExpression).filter(moving).collect();
    let first = files.first()?;
    let message = format!(
        "target `{SIGN}` does not exist, by which MPFB sees that face units are installed; {} no \
            face",
        if files.len() == 1 {
            "the expression moves".to_owned()
        } else {
            format!("{} expressions move", files.len())
        }
    );
    let finding = RULE
        .at(first, Place::File, message)
        .key("sign")
        .effect(NOT_INSTALLED);
    let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
    let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())));
    Some(finding.help(format!(
        "add `{SIGN}.target.gz` below `targets`; the pack of face units has it"
    )))
}

fn some_still((file, units, count): &Still<'_>) -> Option<Finding> {
    let (name, pointer) = units.first()?;
    let message = match units.len() {
        1 => format!("face unit `{name}` has no target"),
        many => format!("{many} of {count} face units have no target, first `{name}`"),
    };
    let evidence = Evidence::of_cases(units.iter().map(|(name, _)| name.as_str())).out_of(*count);
    let finding = RULE
        .at(file, Place::Key(pointer.clone()), message)
        .evidence(evidence);
    Some(finding.help(format!(
        "add `{name}.target.gz` below `targets`, or remove the unit"
    )))
}

fn all_still(still: &[Still<'_>]) -> Option<Finding> {
    let (first, ..) = still.first()?;
    let message = format!(
        "no face unit has a target, but {} need them",
        counted(still.len(), "expression")
    );
    let message = if still.len() == 1 {
        "no face unit has a target".to_owned()
    } else {
        message
    };
    let finding = RULE.at(first, Place::File, message).key("none");
    let parts = still.iter().map(|(file, ..)| (file.shown(), &file.path));
    let finding = finding.parts_in(parts).evidence(Evidence::of_cases(
        still.iter().map(|(file, ..)| file.shown()),
    ));
    Some(finding.help(
        "install the pack with the targets of face units, or check the expressions \
        together with it",
    ))
}
