//! Joint cubes move as a whole.

use super::super::{Check, Rule, RuleCx};
use super::shown::shown_by;
use crate::diag::{Application, Evidence, Finding, Level, OptionInfo, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::eval::target_measure::TargetMeasure;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "takes the middle of a torn cube for the joint: the bone ends beside its limb",
        )],
        docs: "A target moves some vertices of a joint cube and others not, or by different amounts.\n\nA joint lies at the mean of \
            its cube. MakeHuman's own targets list all vertices of a cube with one displacement; a cube that was caught by a \
            brush puts the joint somewhere between. Displacements may differ by 0.002 units, which is rounding. Cubes that \
            the skeleton does not use may be torn.\n\nOnly judged where the targets of the base keep their cubes whole.\n\n\
            Move all vertices of the cube alike, or none.",
        options: &[OptionInfo {
            name: "share",
            default: 0.05,
            docs: "share of torn cubes (0 to 1) in all targets of a base above which tearing is taken for its habit",
        }],
        ..RuleInfo::new("target-splits-joint-cube", Level::Warning, "a target tears a joint cube")
    },
    check: Check::Numeric(run),
};

fn run(body: &Body<'_>, measures: &Measures, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let torn: usize = measures.targets.iter().map(|target| target.torn.len()).sum();
    let rigid: usize = measures.targets.iter().map(|target| target.rigid).sum();
    if torn as f64 > cx.option(&RULE, "share") * (torn + rigid) as f64 {
        return;
    }
    out.extend(measures.targets.iter().filter_map(|target| finding(body, measures, target, rigid)));
}

fn finding(body: &Body<'_>, measures: &Measures, target: &TargetMeasure, rigid: usize) -> Option<Finding> {
    let (cube, apart) = target.torn.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let file = body.target(&target.path)?.file;
    let name = |cube: usize| measures.cubes.get(cube).map_or("", String::as_str);
    let shown = shown_by(body, file).map(|setting| format!(" (seen at {setting})")).unwrap_or_default();
    let what = match target.torn.len() {
        1 => format!("tears joint cube `{}`", name(*cube)),
        count => format!("tears {count} joint cubes, most `{}`", name(*cube)),
    };
    let evidence = Evidence::of_cases(target.torn.iter().map(|(cube, _)| name(*cube)));
    Some(
        RULE.at(file, Place::File, format!("{what}: its vertices move apart by {apart:.3} units{shown}"))
            .help(format!("move all vertices of a cube alike; the targets of this base do so with {rigid} cubes"))
            .evidence(evidence.out_of(target.torn.len() + target.rigid).with_worst(*apart, name(*cube))),
    )
}
