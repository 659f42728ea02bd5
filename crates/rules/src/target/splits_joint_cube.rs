//! Joint cubes move as a whole.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx, counted};
use super::shown::with_setting;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Grows, Level, MeasureKind, OptionInfo, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::target_measure::TargetMeasure;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "puts the joint at the mean of the torn cube: the bone ends beside its limb",
        ),
        (
            Makehuman1,
            "puts the joint at the mean of the torn cube: the bone ends beside its limb",
        ),
    ],
    docs: include_str!("splits_joint_cube.md").trim_ascii_end(),
    options: &[OptionInfo {
        name: "share",
        default: 0.05,
        docs: "share of torn cubes (0 to 1) in all targets of a base above which nothing is \
            reported",
    }],
    counts: "joint cubes",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "target-splits-joint-cube",
        Level::Warning,
        "a target tears a joint cube",
    )
});

fn run(body: &Body<'_>, measures: &Measures, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let torn: usize = measures
        .targets
        .iter()
        .map(|target| target.torn.len())
        .sum();
    let rigid: usize = measures.targets.iter().map(|target| target.rigid).sum();
    if torn as f64 > cx.option(&RULE, "share") * (torn + rigid) as f64 {
        return;
    }
    out.extend(
        measures
            .targets
            .iter()
            .filter_map(|target| finding(body, measures, target, rigid)),
    );
}

fn finding(
    body: &Body<'_>,
    measures: &Measures,
    target: &TargetMeasure,
    rigid: usize,
) -> Option<Finding> {
    let (cube, apart) = target.torn.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let file = body.target(&target.path)?.file;
    let name = |cube: usize| measures.cubes.get(cube).map_or("", String::as_str);
    let what = match target.torn.len() {
        1 => format!("tears joint cube `{}`", name(*cube)),
        count => format!("tears {count} joint cubes, worst `{}`", name(*cube)),
    };
    let message = format!("{what}: its vertices move apart by {}", length(*apart));
    let rigid = counted(rigid, "cube");
    let evidence = Evidence::of_cases(target.torn.iter().map(|(cube, _)| name(*cube)));
    let finding = RULE
        .at(file, Place::File, message)
        .help(format!(
            "move all vertices of a cube by the same amount; the targets of this base \
            do so for {rigid}"
        ))
        .evidence(
            evidence
                .out_of(target.torn.len() + target.rigid)
                .with_worst(*apart, name(*cube)),
        );
    Some(with_setting(finding, body, file))
}
