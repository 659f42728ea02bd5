//! A triangle has three corners and three colours.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, BoundSlider, View};

const CANNOT_MIX: &str =
    "stops with a ValueError at every move of the triangle: colours mix only three by three numbers";
const MIXES_OTHERS: &str = "mixes the skin colour without the corners that have none";
/// Corners of the triangle slider; also parts of a colour.
const THREE: usize = 3;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with an IndexError at start")],
        docs: "`barycentric` makes a triangle slider: exactly three patterns, one for each corner. `barycentric_diffuse` gives each corner a \
            colour: three colours of three numbers.\n\nWith any other number of patterns MakeHuman 2 stops at start. Where a colour has not three \
            numbers, one for transparency say, every move of the triangle raises a ValueError. A colour that is missing is left out of the \
            mixture, and surplus ones are never used (warnings).\n\nGive exactly three of each.",
        ..RuleInfo::new("modelling-barycentric-arity", Level::Error, "`barycentric` or its colours are not three")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let slider = bound.slider;
        if slider.barycentric.is_some() && slider.barycentric_len != THREE {
            let message =
                format!("`barycentric` of `{}` has {} patterns instead of 3", slider.key, slider.barycentric_len);
            out.push(finding(bound, "barycentric", message));
        }
        // What is no list of colours is reported by the schema.
        let Some(colours) = &slider.barycentric_colours else { continue };
        if colours.len() != THREE {
            let message =
                format!("`barycentric_diffuse` of `{}` has {} colours instead of 3", slider.key, colours.len());
            let effect = if colours.len() > THREE { "never uses what is beyond three" } else { MIXES_OTHERS };
            out.push(finding(bound, "barycentric_diffuse", message).level(Level::Warning).effect(effect));
        } else if let Some(parts) = colours.iter().find(|parts| **parts != THREE) {
            let message = format!("a colour of `{}` has {parts} numbers instead of 3", slider.key);
            out.push(finding(bound, "barycentric_diffuse", message).effect(CANNOT_MIX));
        }
    }
}

fn finding(bound: &BoundSlider<'_>, member: &str, message: String) -> Finding {
    let key = bound.slider.key.as_str();
    RULE.at(bound.file, Place::pointer([key, member]), message)
        .key(format!("{key} {member}"))
        .help("give exactly three")
}
