//! A component of a triangle slider has three values and three entries in `sum`.

use super::super::{Check, Rule, RuleCx, counted};
use super::component::sound_components;
use super::component::weigh;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_formats::macro_json::Component;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `IndexError` if `sum` is shorter than `values`, and with `TypeError` at a \
         fourth value; never reads corners without a value",
    )],
    docs: include_str!("sum_arity.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-sum-arity",
        Level::Error,
        "`sum` of a component does not have three entries, or not as many as `values`",
    )
});

/// Corners of a triangle slider.
const CORNERS: usize = 3;

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    for component in sound_components(file, macros) {
        let (None, Some(sum)) = (&component.steps, &component.sum) else {
            continue;
        };
        let (values, ends) = (component.values.len(), sum.len());
        // Two values of two corners work, but for the weight of the third corner:
        // `numeric-weights-sum` says how much.
        if values == ends && (CORNERS - 1..=CORNERS).contains(&ends) {
            continue;
        }
        let name = &component.name;
        let (all, of_sum) = (
            counted(values, "value"),
            if ends == 1 { "entry" } else { "entries" },
        );
        let message = format!(
            "component `{name}` has {all} and {ends} {of_sum} in `sum`, but a triangle has 3 \
                corners"
        );
        let mut finding = RULE
            .at(file, Place::pointer(["components", name, "sum"]), message)
            .key(name);
        finding = finding.help(
            "give `values` and `sum` three entries each, in the order of \
                `barycentric` of the slider",
        );
        if values > ends {
            finding =
                finding.effect("crashes with `IndexError` at the first value without an entry");
        } else if has_fourth(base, component, sum) {
            finding = finding.effect(
                "crashes with `TypeError` at the fourth value: a triangle has three weights",
            );
        } else {
            let effect = "never reads surplus entries, or corners without a value";
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
