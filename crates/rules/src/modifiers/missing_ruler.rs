//! A slider for a measure has a ruler in the program.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails with `KeyError` when the tab is opened, and at each change of the human from then \
            on",
    )],
    docs: include_str!("missing_ruler.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-missing-ruler",
        Level::Error,
        "a measure for which the program has \
        no ruler",
    )
});

/// What is measured (`docs/loaders/makehuman1/modifiers.md#rulers`).
const RULERS: [&str; 20] = [
    "neck-circ",
    "neck-height",
    "upperarm-circ",
    "upperarm-length",
    "lowerarm-length",
    "wrist-circ",
    "frontchest-dist",
    "bust-circ",
    "underbust-circ",
    "waist-circ",
    "napetowaist-dist",
    "waisttohip-dist",
    "shoulder-dist",
    "hips-circ",
    "upperleg-height",
    "thigh-circ",
    "lowerleg-height",
    "calf-circ",
    "knee-circ",
    "ankle-circ",
];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    let Some((file, sliders)) = view
        .modifiers
        .sets
        .iter()
        .find(|set| set.stem == "measurement")
        .and_then(|set| set.sliders)
    else {
        return;
    };
    let measure_of = |name: &'_ str| {
        name.strip_prefix("measure/measure-")
            .and_then(|name| name.strip_suffix("-decr|incr"))
            .map(str::to_owned)
    };
    let is_known = |name: &str| measure_of(name).is_some_and(|measure| RULERS.contains(&&*measure));
    // What no modifier has is told as that.
    let unknown: Vec<_> = sliders
        .modifiers()
        .filter(|named| {
            !is_known(&named.name) && view.modifiers.called(&named.name).next().is_some()
        })
        .collect();
    // With other names throughout, the folder is of another version.
    if let [first, _, ..] = unknown.as_slice()
        && !sliders.modifiers().any(|named| is_known(&named.name))
    {
        let message = format!(
            "the program has a ruler for none of the {} measures",
            unknown.len()
        );
        let finding = RULE
            .at(file, Place::Pointer(first.pointer.clone()), message)
            .key("all");
        let names = Evidence::of_cases(unknown.iter().map(|named| &named.name));
        return out.push(
            finding
                .evidence(names)
                .help("compare the names with those of the version of MakeHuman 1 that is used"),
        );
    }
    for named in unknown {
        let near =
            measure_of(&named.name).and_then(|measure| cx.suggestions.nearest(&measure, RULERS));
        let message = format!("the program has no ruler for `{}`", named.name);
        let finding = RULE
            .at(file, Place::Pointer(named.pointer.clone()), message)
            .key(&named.name);
        out.push(finding.help(did_you_mean(near, "move the slider to another file")));
    }
}
