//! Weights of a bone lie on its side.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_repo::{Body, FileFacts, WeightsUse};

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "rotates the skin of the left/right counterpart with the bone: the smallest bend \
                throws it far off",
        ),
        (
            Makehuman1,
            "rotates the skin of the left/right counterpart with the bone: the smallest bend \
                throws it far off",
        ),
    ],
    docs: include_str!("wrong_side.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "weights-wrong-side",
        Level::Warning,
        "weights are on the opposite half of \
        the mesh",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = measures.weights.as_ref().zip(body.default_weights());
    out.extend(own.and_then(|(weights, file)| finding(file, &weights.wrong_side, measures)));
    let worn = body
        .weights
        .iter()
        .filter(|weights| weights.name.is_none() && weights.used == WeightsUse::Applied);
    let worn = worn
        .filter_map(|weights| Some((weights.file, measures.exchanged.get(&weights.file.path)?)));
    out.extend(worn.filter_map(|(file, bones)| finding(file, bones, measures)));
}

fn finding(file: &FileFacts, bones: &[usize], measures: &Measures) -> Option<Finding> {
    let bones: Vec<&str> = bones
        .iter()
        .filter_map(|bone| measures.bones.get(*bone))
        .map(String::as_str)
        .collect();
    let first = bones.first()?;
    let message = match bones.len() {
        1 => format!("the weights of bone `{first}` are on the opposite half of the mesh"),
        count => format!(
            "the weights of {count} bones are on the opposite half of the mesh, first `{first}`"
        ),
    };
    let finding = RULE.at(file, Place::key(["weights", first]), message);
    let finding = finding.help("swap the weights of the left and right bones");
    Some(finding.evidence(Evidence::of_cases(&bones).out_of(measures.bones.len())))
}
