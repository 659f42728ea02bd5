//! The presets of a triangle must sum to 1.

use super::super::cause::overlay::has_sliders;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::makehuman2::{Base, Pattern, View};

/// Rounding of decimals like 0.33 + 0.33 + 0.34 in double precision is far below this.
const TOLERANCE: f64 = 1e-6;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "starts with a mixture that the triangle slider cannot produce",
    )],
    docs: include_str!("barycentric_presets.md").trim_ascii_end(),
    counts: "presets",
    ..RuleInfo::new(
        "base-barycentric-presets",
        Level::Warning,
        "the presets of a triangle slider do not sum to 1",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings().filter(|_| has_sliders(base)) else {
        return;
    };
    // Loading the start model resets the mixture.
    if settings.mhm.is_some() {
        return;
    }
    let presets = settings.presets.iter();
    let presets = grouped(presets.map(|(name, value)| (name, *value)));
    for bound in &base.sliders {
        let Pattern::Barycentric(corners) = &bound.pattern else {
            continue;
        };
        let value = |corner: &String| *presets.get(corner)?.first()?;
        let values: Option<Vec<f64>> = corners.iter().map(value).collect();
        // Another number of corners is a finding of its own.
        let Some(values) = values.filter(|values| values.len() == 3) else {
            continue;
        };
        let sum: f64 = values.iter().sum();
        // Written so that a sum that is no number is reported.
        if (sum - 1.0).abs() <= TOLERANCE {
            continue;
        }
        let Some(first) = corners.first() else {
            continue;
        };
        let shown = (sum * 1e6).round() / 1e6;
        let message = format!(
            "the presets of `{}` sum to {shown}, not 1",
            bound.slider.key
        );
        let each = corners
            .iter()
            .zip(&values)
            .map(|(corner, value)| format!("{corner}: {value}"));
        out.push(
            RULE.at(file, Place::pointer(["modifier-presets", first]), message)
                .key(&bound.slider.key)
                .help("change the presets so that they sum to 1, such as 0.33, 0.33 and 0.34")
                .evidence(Evidence::of_unnamed(each)),
        );
    }
}
