//! A component of a triangle slider has three values and three entries in `sum`.

use super::super::{Check, Rule, RuleCx};
use super::component::sound_components;
use super::component::weigh;
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::formats::macro_json::Component;
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops with an IndexError when `sum` is shorter than `values`, or at a fourth value; with fewer than three it never reads the remaining corners",
        )],
        docs: "A triangle slider has three corners. `sum` names them in the order of `values`, and both need three \
            entries.\n\nMakeHuman 2 reads for every value the entry of `sum` at the same place, and then that \
            number of the three weights. An entry that is missing, or a fourth value, is read beyond a list: the \
            program stops. With two values the third corner is never read, and the shape fades towards it; \
            surplus entries of `sum` are never read either (both a warning).\n\nGive `values` and `sum` three \
            entries each.",
        ..RuleInfo::new(
            "macro-sum-arity",
            Level::Error,
            "`sum` of a component has not three entries, or not as many as `values`",
        )
    },
    check: Check::Makehuman2(run),
};

/// Corners of a triangle slider.
const CORNERS: usize = 3;

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    for component in sound_components(file, macros) {
        let (None, Some(sum)) = (&component.steps, &component.sum) else { continue };
        let (values, ends) = (component.values.len(), sum.len());
        // Two values of two corners work, but for the weight of the third corner: `numeric-weights-sum` says how much.
        if values == ends && (CORNERS - 1..=CORNERS).contains(&ends) {
            continue;
        }
        let name = &component.name;
        let message =
            format!("component `{name}` has {values} values and {ends} entries in `sum`; a triangle has three corners");
        let mut finding = RULE.at(file, Place::pointer(["components", name, "sum"]), message).key(name);
        finding =
            finding.help("give `values` and `sum` three entries each, in the order of `barycentric` of the slider");
        if values > ends {
            finding = finding.effect("stops with an IndexError at the first value without an entry");
        } else if has_fourth(base, component, sum) {
            finding = finding.effect("stops with a TypeError at the fourth value: a triangle gives three weights");
        } else {
            let effect = "never reads the surplus, or the corners without a value";
            finding = finding.level(Level::Warning).effect(effect);
        }
        out.push(weigh(finding, macros, component));
    }
}

/// Whether a fourth value resolves, for which there is no weight.
fn has_fourth(base: &Base<'_>, component: &Component, sum: &[String]) -> bool {
    let pattern = component.pattern.as_deref().unwrap_or_default();
    let mut surplus = sum.iter().take(component.values.len()).skip(CORNERS);
    surplus.any(|end| base.slider(&format!("{pattern}{end}")).is_some())
}
