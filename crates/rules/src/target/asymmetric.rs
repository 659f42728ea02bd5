//! A target that names no side moves both sides alike.

use super::super::regions::regions;
use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::renumbered::Opposites;
use super::shown::with_setting;
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Evidence, Finding, Grows, Level, MeasureKind, OptionInfo, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::side;
use mhlint_eval::target_measure::TargetMeasure;
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "makes the figure asymmetric; symmetry cannot fix it",
        ),
        (Mpfb, "makes the figure asymmetric"),
    ],
    docs: include_str!("asymmetric.md").trim_ascii_end(),
    options: &[OptionInfo {
        name: "share",
        default: 0.1,
        docs: "share of the moved vertices (0 to 1) above which a target gets a finding of its own",
    }],
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "target-asymmetric",
        Level::Info,
        "a target without a side in its name is asymmetric",
    )
});

fn run(body: &Body<'_>, measures: &Measures, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(one_sided_endings) = body.one_sided_endings else {
        return;
    };
    let share = cx.option(&RULE, "share");
    let mut slight: Vec<(&FileFacts, &TargetMeasure)> = Vec::new();
    let mut checked = 0;
    let opposites = Opposites::of(body, measures);
    for target in measures
        .targets
        .iter()
        .filter(|target| !is_meant(one_sided_endings, &target.name))
    {
        let Some(file) = body.target(&target.path).map(|own| own.file) else {
            continue;
        };
        checked += 1;
        let mirror = &target.own_mirror;
        let different = mirror.different.len();
        if different == 0 || is_told_by_cubes(body, target) {
            continue;
        }
        if different as f64 > share * mirror.compared as f64 {
            let finding = one_sided(body, file, target);
            out.extend(finding.map(|finding| opposites.weigh(finding, file, target)));
        } else {
            slight.push((file, target));
        }
    }
    out.extend(uneven(body, &slight, checked));
}

/// Whether the name says that it is not symmetric.
fn is_meant(endings: &[String], name: &str) -> bool {
    endings.iter().any(|ending| name.ends_with(ending.as_str()))
        || name.split(['/', '-', '_']).any(side::is_word)
}

/// Whether all that differs are corners of joint cubes, no more than the torn ones have:
/// `target-splits-joint-cube` names the target, but for MPFB, whose targets keep no cube whole.
fn is_told_by_cubes(body: &Body<'_>, target: &TargetMeasure) -> bool {
    const CORNERS: usize = 8;
    let different = target.own_mirror.different.len();
    !body.is_mpfb() && target.differs_in_cubes && different <= CORNERS * target.torn.len()
}

const MIRROR: &str = "leave it if that is intended; otherwise make it symmetric";
const MIRROR_OR_LIST: &str = "leave it if that is intended, and add its ending to `nonsym` under \
    `random` of base.json; otherwise make it symmetric";

fn one_sided(body: &Body<'_>, file: &FileFacts, target: &TargetMeasure) -> Option<Finding> {
    let mirror = &target.own_mirror;
    let different = mirror.different.len();
    let (vertex, worst) = target.most_asymmetric()?;
    let message = match different {
        1 => format!(
            "{} differs from its mirror image by {}",
            body.vertex(vertex),
            length(worst)
        ),
        count => {
            let regions = regions(body, mirror.different.iter().copied());
            let regions = regions
                .map(|regions| format!(" ({regions})"))
                .unwrap_or_default();
            let (vertex, worst) = (body.vertex(vertex), length(worst));
            format!("{count} vertices{regions} are asymmetric, worst {vertex} by {worst}")
        }
    };
    let evidence = Evidence::counted(different).out_of(mirror.compared);
    let finding = RULE
        .at(file, Place::File, message)
        .parts(&mirror.different)
        .help(if body.is_mpfb() {
            MIRROR
        } else {
            MIRROR_OR_LIST
        })
        .evidence(evidence.with_worst(worst, format!("vertex {vertex}")));
    Some(with_setting(finding, body, file))
}

/// One line for all targets in which a few vertices were missed; it stands at their folder.
fn uneven(
    body: &Body<'_>,
    slight: &[(&FileFacts, &TargetMeasure)],
    checked: usize,
) -> Option<Finding> {
    let worst = |target: &TargetMeasure| target.most_asymmetric().map_or(0.0, |(_, worst)| worst);
    let (file, target) = slight
        .iter()
        .max_by(|a, b| worst(a.1).total_cmp(&worst(b.1)))?;
    let (vertex, distance) = target.most_asymmetric()?;
    let (name, by) = (
        &target.name,
        format!("{} by {}", body.vertex(vertex), length(distance)),
    );
    let message = match slight.len() {
        1 => format!("`{name}` is slightly asymmetric: {by}"),
        count => format!(
            "{count} of {checked} targets without a side are slightly asymmetric, worst `{name}`: \
                {by}"
        ),
    };
    let evidence = Evidence::of_cases(slight.iter().map(|(_, target)| {
        format!(
            "{} ({} of {} vertices)",
            target.name,
            target.own_mirror.different.len(),
            target.own_mirror.compared
        )
    }));
    let finding = match slight {
        [_] => RULE.at(file, Place::File, message),
        _ => RULE
            .in_layer(body.layers.checked, body.folder_of(file), message)
            .related(&file.path, Place::File, "the worst target"),
    };
    Some(
        finding
            .key(body.name)
            .asset(file.root())
            .parts_in(slight.iter().flat_map(|(file, target)| {
                let vertices = target.own_mirror.different.iter();
                vertices.map(|vertex| (format!("{} {vertex}", target.name), &file.path))
            }))
            .help("make these vertices symmetric")
            .evidence(
                evidence
                    .out_of(checked)
                    .with_worst(distance, format!("{} vertex {vertex}", target.name)),
            ),
    )
}
