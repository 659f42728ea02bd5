//! A target changes something that is seen.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows no change: helpers are hidden and only carry clothes and joints",
        ),
        (
            Makehuman1,
            "shows no change: helpers are hidden and only carry clothes and joints",
        ),
    ],
    docs: include_str!("moves_helpers_only.md").trim_ascii_end(),
    counts: "targets",
    ..RuleInfo::new(
        "target-moves-helpers-only",
        Level::Info,
        "a target moves helpers but not the body",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Where nothing moves the body, the groups are the fault, not the targets.
    if measures.targets.iter().all(|target| target.body == 0) {
        return;
    }
    let hidden = measures
        .targets
        .iter()
        .filter(|target| target.body == 0 && target.joints + target.helpers > 0);
    let own = |path: &str| body.target(path).map(|own| own.file);
    let hidden: Vec<_> = hidden
        .filter_map(|target| Some((own(&target.path)?, target)))
        .collect();
    let Some((file, first)) = hidden.first() else {
        return;
    };
    let message = match hidden.as_slice() {
        [_] => format!(
            "`{}` moves {} but no body vertex",
            first.name,
            moved(first.joints, first.helpers)
        ),
        _ => format!(
            "{} targets move helpers but no body vertex, first `{}`",
            hidden.len(),
            first.name
        ),
    };
    let evidence = Evidence::of_cases(hidden.iter().map(|(_, target)| &target.name))
        .out_of(measures.targets.len());
    let mut finding = RULE
        .at(file, Place::File, message)
        .key(body.name)
        .asset(file.root())
        .evidence(evidence);
    finding = finding.parts_in(
        hidden
            .iter()
            .map(|(file, target)| (&target.name, &file.path)),
    );
    for (file, target) in hidden.iter().skip(1) {
        finding = finding.related(
            &file.path,
            Place::File,
            moved(target.joints, target.helpers),
        );
    }
    let help = "leave it if it is for something drawn at the helpers, such as genitals or clothes; \
        otherwise make the shape on the visible mesh";
    out.push(finding.help(help));
}

fn moved(joints: usize, helpers: usize) -> String {
    let vertices = |count: usize| if count == 1 { "vertex" } else { "vertices" };
    match (joints, helpers) {
        (0, helpers) => format!("{helpers} helper {}", vertices(helpers)),
        (joints, 0) => format!("{joints} joint-cube {}", vertices(joints)),
        _ => format!(
            "{helpers} helper and {joints} joint-cube {}",
            vertices(joints)
        ),
    }
}
